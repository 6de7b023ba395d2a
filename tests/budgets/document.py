"""The table within a page of the documentation."""

BEGIN = "<!-- budgets: made by tests/budgets/measure --document -->\n"
END = "<!-- end of budgets -->\n"


def _parts(page):
    before, begun, rest = page.read_text().partition(BEGIN)
    held, ended, after = rest.partition(END)
    if not (begun and ended):
        raise SystemExit(f"budgets: {page} has no place for the table: {BEGIN.strip()} ... {END.strip()}")
    return before, held, after


def holds(page, text):
    return _parts(page)[1] == text


def put(page, text):
    before, _, after = _parts(page)
    page.write_text(before + BEGIN + text + END + after)
