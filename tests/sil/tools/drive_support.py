"""Shared by the tests of drives."""

import csv
import io
import unittest.mock

import support

import bus_log_writers
import foreign_recorder


class WithDrives(support.WithRun):
    def mapping(self, text=foreign_recorder.MAPPING):
        file = self.folder / "mapping.toml"
        file.write_text(text, encoding="utf-8")
        return file

    def written(self, kind, frames):
        file = self.folder / f"recorded.{kind}"
        getattr(bus_log_writers, f"write_{kind}")(file, iter(frames))
        return file

    def arguments(self, logs, dbc, mapping):
        file = self.folder / "made" / "drive.csv"
        file.parent.mkdir(exist_ok=True)
        return ["drive", *logs, *(["--dbc", dbc] if dbc else []), "--mapping", mapping or self.mapping(), "--output", file]

    def drive(self, *logs, dbc=foreign_recorder.DBC, mapping=None):
        """The drive of these logs, and what was said."""
        arguments = self.arguments(logs, dbc, mapping)
        return arguments[-1], self.logs(*arguments)

    def drive_refused(self, expected, *logs, dbc=foreign_recorder.DBC, mapping=None):
        """No drive of these logs: a sentence that begins so."""
        arguments = self.arguments(logs, dbc, mapping)
        said = self.refused(expected, *arguments)
        self.assertEqual(list(arguments[-1].parent.glob("*.tmp")), [])
        return said

    def unanswered(self, *arguments):
        """A verdict without a terminal and an answer: what was said."""
        said = io.StringIO()
        with self.assertRaises(SystemExit) as raised, unittest.mock.patch("sys.stderr", said), \
                unittest.mock.patch("sys.stdout", io.StringIO()), unittest.mock.patch("sys.stdin", io.StringIO("y\n")):
            support.command.main([str(argument) for argument in arguments])
        self.assertEqual(raised.exception.code, 3)
        return said.getvalue()

    @staticmethod
    def rows(drive):
        lines = [line for line in drive.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
        return list(csv.DictReader(lines))
