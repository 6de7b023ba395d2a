"""Indicators of others are scored as the campaign's own report scores: its warnings and its indices, given as files, come out
with the report's own figures."""

import contextlib
import csv
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(PROJECT / "sil/tools/campaigns"), str(PROJECT / "cmake/environment")]

import command  # noqa: E402

RUNS = 60
EARLY = {"warned, %": "warned", "0.1 s before, %": "warned_100ms_before", "0.2 s before, %": "warned_200ms_before",
         "alarms in calm runs, %": "false_alarms"}


class Scores(unittest.TestCase):
    program = None

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = pathlib.Path(scratch.name)
        cls.folder = cls.scratch / "campaign"
        # A level at which calm runs have alarms, and a prediction that is late in some.
        settings = cls.scratch / "settings.toml"
        changes = 'changes = ["forecast_share=0", "warning_on=0.8", "warning_off=0.75", "advisory_on=0.7", "advisory_off=0.65"]\n'
        settings.write_text(changes + "".join(
            f'\n[[manoeuvre]]\nname = "{name}"\nspeed_factor = [0.8, 1.2]\nsteering_factor = [0.5, 1.2]\n'
            for name in ("j-turn-110", "fishhook-1a")), encoding="utf-8")
        subprocess.run([cls.program, "campaign", "run", "--settings", settings, "--runs", str(RUNS), "--traces", "--output", cls.folder],
                       cwd=PROJECT, check=True, capture_output=True, timeout=300)
        cls.report = json.loads((cls.folder / "report.json").read_text(encoding="utf-8"))["all"]["indices"]
        with (cls.folder / "runs.csv").open(encoding="utf-8", newline="") as file:
            cls.truth = {row["run"]: row for row in csv.DictReader(file)}
        cls.traces = {run: cls.trace(run) for run in cls.truth}

    @classmethod
    def trace(cls, run):
        with (cls.folder / f"traces/{run}.csv").open(encoding="utf-8", newline="") as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))

    def file(self, name, head, rows):
        path = self.scratch / name
        with path.open("w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([head, *rows])
        return path

    def score(self, *given):
        target = self.scratch / "scores.csv"
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            command.main(["score", str(self.folder), *given, "--csv", str(target), "--program", str(self.program)])
        with target.open(encoding="utf-8", newline="") as file:
            return {row["index_name"]: row for row in csv.DictReader(file)}

    def assert_is(self, row, index):
        for column, key in EARLY.items():
            self.assertAlmostEqual(float(row[column]), 100 * index[key]["share"], delta=0.006, msg=column)
        self.assertAlmostEqual(float(row["median lead, s"]), index["lead_time_median_s"], delta=0.0011)

    def refused(self, expected, head, rows, name="bad.csv"):
        path = self.file(name, head, rows)
        with self.assertRaises(SystemExit) as raised, contextlib.redirect_stderr(io.StringIO()):
            command.main(["score", str(self.folder), f"bad={path}", "--program", str(self.program)])
        self.assertIn(expected, str(raised.exception.code))
        self.assertIn(name, str(raised.exception.code))

    def test_the_firmwares_warning_given_as_changes(self):
        changes = []
        for run, trace in self.traces.items():
            before = "none"
            for moment in trace:
                side = moment["side"] if moment["state"] == "warning" else "none"
                if side != before:
                    changes.append((run, moment["time_s"], side))
                before = side
        scores = self.score(f"again={self.file('changes.csv', ('run', 'time_s', 'side'), changes)}")
        warning = self.report["warning"]
        self.assertGreater(warning["warned"]["count"], 5)
        self.assertGreater(warning["false_alarms"]["count"], 0, "the settings of this test let there be no alarms")
        self.assertLess(warning["warned_200ms_before"]["count"], warning["warned"]["of"])
        self.assert_is(scores["the firmware's warning"], warning)
        self.assert_is(scores["again"], warning)

    def test_an_index_given_as_levels(self):
        two_sided, one_sided, halved = [], [], []
        for run, trace in self.traces.items():
            for moment in trace:
                signed = float(moment["predicted_load_transfer_ratio"] or 0)
                sides = abs(signed), float(moment["opposite_load_transfer_ratio"] or 0)
                two_sided.append((run, moment["time_s"], *(sides if signed >= 0 else reversed(sides))))
                true = float(moment["true_load_transfer_ratio"] or 0)
                one_sided.append((run, moment["time_s"], abs(true), "right" if true >= 0 else "left"))
                halved.append((run, moment["time_s"], abs(true) / 2, "right" if true >= 0 else "left"))
        scores = self.score(f"forecast={self.file('sides.csv', ('run', 'time_s', 'right', 'left'), two_sided)}",
                            f"truth={self.file('level.csv', ('run', 'time_s', 'level', 'side'), one_sided)}",
                            f"half={self.file('half.csv', ('run', 'time_s', 'level', 'side'), halved)}")
        self.assert_is(scores["forecast"], self.report["predicted_load_transfer"])
        self.assert_is(scores["truth"], self.report["true_load_transfer"])
        self.assertEqual(float(scores["half"]["warned, %"]), 0)

    def test_side_and_break_count(self):
        lifted = [row for row in self.truth.values() if row["two_wheel_lift_time_s"]]
        other = {"left": "right", "right": "left"}

        def warned(of):
            rows = [(row["run"], *change) for row in lifted
                    for change in of(float(row["two_wheel_lift_time_s"]), row["falling_side"])]
            score = self.score(f"mine={self.file('mine.csv', ('run', 'time_s', 'side'), rows)}")["mine"]
            return [float(score[column]) for column in list(EARLY)[:3]]

        self.assertEqual(warned(lambda lift, side: [(lift - 0.3, side)]), [100, 100, 100])
        self.assertEqual(warned(lambda lift, side: [(lift - 0.3, other[side])]), [0, 0, 0])
        self.assertEqual(warned(lambda lift, side: [(lift - 0.3, other[side]), (lift - 0.15, side)]), [100, 100, 0])
        self.assertEqual(warned(lambda lift, side: [(lift - 0.3, side), (lift - 0.1, "none"), (lift - 0.05, side)]), [100, 0, 0])
        self.assertEqual(warned(lambda lift, side: [(lift - 0.3, side), (lift - 0.1, side)]), [100, 100, 100])
        self.assertEqual(warned(lambda lift, side: [(lift + 0.01, side)]), [0, 0, 0])

    def test_indicators_without_a_score_are_named(self):
        side = ("run", "time_s", "side")
        self.refused("run 60, time_s 1.0: there is no such run", side, [(RUNS, 1, "left")])
        self.refused("the times of a run must increase", side, [(0, 2, "left"), (0, 1, "none")])
        self.refused("side wants one of 'left', 'right', 'none'", side, [(0, 1, "up")])
        self.refused("has the columns run, side; wants", ("run", "side"), [(0, "left")])
        self.refused("level wants a number", ("run", "time_s", "level", "side"), [(0, 1, "nan", "left")])
        self.refused("run 1, time_s 0: is missing", ("run", "time_s", "right", "left"), [(0, 1, 0, 0)])
        self.refused("wants a file whose name ends in", side, [], "bad.txt")
        self.refused("Could not convert", side, [("zero", 1, "left")])


if __name__ == "__main__":
    Scores.program = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
