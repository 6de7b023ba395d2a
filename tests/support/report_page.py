"""A page of docs/reports: written whole by a command, never by hand."""


class Report:
    def __init__(self, path, title, command, introduction):
        """`path` from the project's folder; `command` writes the page and is named at its top."""
        self.path = path
        self.command = command
        self.head = f"<!-- Written by {command}; do not edit. -->\n# {title}\n\n{introduction.strip()}\n\n"

    def holds(self, project, text):
        page = project / self.path
        return page.is_file() and page.read_text(encoding="utf-8") == self.head + text

    def put(self, project, text):
        (project / self.path).write_text(self.head + text, encoding="utf-8")

    def out_of_date(self):
        return f"{self.path} is not what was measured; run: {self.command}"
