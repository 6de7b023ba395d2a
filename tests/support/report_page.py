"""A page of docs/reports: written whole by a command, never by hand."""

import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "cmake/environment"))

import file_io  # noqa: E402


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
        file_io.write(project / self.path, self.head + text)

    def out_of_date(self):
        return f"{self.path} is not what was measured; run: {self.command}"
