"""Shared by the tests of sil/tools: a run to start from, the command, and replays of what it writes."""

import contextlib
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
CALIBRATION = PROJECT / "firmware/calibrations/large_suv.toml"
sys.path[:0] = [str(PROJECT / "sil/tools"), str(PROJECT / "cmake/environment")]

import command


class WithFolder(unittest.TestCase):
    """A folder of its own for each test, in self.folder."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)


class WithRun(WithFolder):
    """One run for all tests of a class, in self.run_folder."""

    program = None

    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.TemporaryDirectory()
        cls.run_folder = pathlib.Path(cls.shared.name, "run")
        call(cls.program, "run", "j-turn-110", "--in-process", "--vehicle", PROJECT / "sil/vehicles/large_suv.toml",
             "--parameters", CALIBRATION, "--output", cls.run_folder)
        cls.original = cls.run_folder / "candump.log"

    @classmethod
    def tearDownClass(cls):
        cls.shared.cleanup()

    def replay(self, file):
        """Answers of `rsi-sil replay` to a drive: the lines of warnings.csv."""
        output = self.folder / "replayed" / file.parent.name
        call(self.program, "replay", file, "--parameters", CALIBRATION, "--no-pictures", "--output", output)
        return (output / file.stem / "warnings.csv").read_text(encoding="utf-8")

    def logs(self, *arguments):
        """Runs the command, which must succeed; what it said. In this process: libraries take long to load."""
        said = io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            command.main([str(argument) for argument in arguments])
        return said.getvalue()

    def refused(self, expected, *arguments):
        """Runs the command, which must fail with a sentence that begins so."""
        with self.assertRaises(SystemExit) as raised:
            self.logs(*arguments)
        said = str(raised.exception.code)
        self.assertTrue(said.startswith(f"sil/tools/logs: {expected}"), said)
        return said


def call(*parts):
    finished = subprocess.run([str(part) for part in parts], capture_output=True, text=True, check=False, timeout=600)
    if finished.returncode != 0:
        raise AssertionError(f"{parts} failed:\n{finished.stdout}{finished.stderr}")
    return finished


def main():
    WithRun.program = pathlib.Path(sys.argv.pop(1))
    unittest.main()
