"""Tables in Markdown, as sil/page/table.cpp renders those of the programs; and templates of pages."""

import re


def filled(template, values):
    """The text of a template file, with each {{name}} replaced by its value."""
    return re.sub(r"\{\{(\w+)\}\}", lambda found: values[found.group(1)], template.read_text(encoding="utf-8"))


def percent(share, digits=1):
    """A share of the judge with its interval."""
    if not share.total:
        return "-"
    low, high = share.interval
    return f"{100 * share.value():.{digits}f} ({100 * low:.{digits}f} to {100 * high:.{digits}f})"


def line(cells):
    return "|" + "".join(f" {cell} |" if cell else " |" for cell in cells)


def table(head, rows, right=()):
    """`right`: the places of columns that are aligned to the right. Without the last line end."""
    rule = "|" + "".join("---:|" if place in right else "---|" for place in range(len(head)))
    return "\n".join([line(head), rule, *map(line, rows)])
