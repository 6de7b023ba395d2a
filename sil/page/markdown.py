"""Tables in Markdown, as sil/page/table.cpp renders those of the programs."""


def line(cells):
    return "|" + "".join(f" {cell} |" if cell else " |" for cell in cells)


def table(head, rows, right=()):
    """`right`: the places of columns that are aligned to the right. Without the last line end."""
    rule = "|" + "".join("---:|" if place in right else "---|" for place in range(len(head)))
    return "\n".join([line(head), rule, *map(line, rows)])
