"""A page of docs/reports: written whole by a command, never by hand."""

import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "cmake/environment"))

import file_io  # noqa: E402


class Report:
    def __init__(self, path, title, command, introduction, data=None):
        """`path` from the project's folder, as `data`, a CSV beside it; `command` writes them and is named at the top."""
        self.path = path
        self.data = data
        self.command = command
        self.head = f"<!-- Written by {command}; do not edit. -->\n# {title}\n\n{introduction.strip()}\n\n"

    def _files(self, text, data):
        return {self.path: self.head + text} | ({self.data: data} if self.data else {})

    def holds(self, project, text, data=None):
        return all((project / path).is_file() and (project / path).read_text(encoding="utf-8") == content
                   for path, content in self._files(text, data).items())

    def put(self, project, text, data=None):
        for path, content in self._files(text, data).items():
            file_io.write(project / path, content)

    def out_of_date(self):
        return f"{self.path} is not what was measured; run: {self.command}"
