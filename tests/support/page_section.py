"""A section of a page of the documentation that a command writes: what stands between two marks."""


class PageSection:
    def __init__(self, name, command):
        """`command` is what renews the section; the page's mark names it."""
        self.name = name
        self.begin = f"<!-- {name}: made by {command} -->\n"
        self.end = f"<!-- end of {name} -->\n"

    def _parts(self, page):
        before, begun, rest = page.read_text().partition(self.begin)
        held, ended, after = rest.partition(self.end)
        if not (begun and ended):
            raise SystemExit(f"{self.name}: {page} has no place for the table: {self.begin.strip()} ... {self.end.strip()}")
        return before, held, after

    def holds(self, page, text):
        return self._parts(page)[1] == text

    def put(self, page, text):
        before, _, after = self._parts(page)
        page.write_text(before + self.begin + text + self.end + after)
