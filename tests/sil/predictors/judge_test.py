"""The study of predictors judges as the campaign does: on runs that a campaign drove and judged, and by hand.

Use: judge_test.py RSI_SIL
"""

import json
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import types
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(PROJECT / "sil/studies/predictors"))

import comparison
import judge
import recorded_runs
import warning

PROGRAM = ""
RUNS = 60
INDEX = "predicted_load_transfer"  # the firmware's own; a trace has it
STEP = 1.01  # of the campaign's thresholds
STATES = {"advisory_on": 0.8, "advisory_off": 0.7, "warning_on": 0.9, "warning_off": 0.8,
          "warning_confirmation_s": 0.02, "advisory_hold_s": 0.05, "warning_hold_s": 0.1}


def index_risks(run):
    signed, opposite = run.signals["predicted_load_transfer_ratio"], run.signals["opposite_load_transfer_ratio"]
    pairs = [(abs(own), other) if own >= 0 else (other, abs(own)) for own, other in zip(signed, opposite)]
    return tuple(map(list, zip(*pairs)))


class AgreesWithTheCampaign(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.scratch.name)
        command = [PROGRAM, "campaign", "run", "--runs", str(RUNS), "--seed", "5", "--traces", "--output", folder / "campaign"]
        # As many vehicles as it takes for intervals that count vehicles.
        for number in range(judge.FEWEST_VEHICLES):
            name = ("large_suv", "ordinary_suv", "van")[number % 3]
            vehicle = folder / f"{name}_{number}.toml"
            shutil.copy(PROJECT / f"sil/vehicles/{name}.toml", vehicle)
            command += ["--vehicle", f"{vehicle}:{PROJECT}/firmware/calibrations/{name}.toml"]
        subprocess.run(command, check=True, capture_output=True)
        cls.runs = recorded_runs.load(folder / "campaign")
        cls.report = json.loads((folder / "campaign/report.json").read_text(encoding="utf-8"))["all"]["indices"]

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_the_runs_are_of_every_kind(self):
        self.assertEqual(len(self.runs), RUNS)
        self.assertGreater(sum(run.lift_s is not None for run in self.runs), 10)
        self.assertGreater(sum(run.lift_s is None and run.largest_ltr < 0.9 for run in self.runs), 10)

    def test_the_firmwares_lead_is_that_of_the_row(self):
        for run in self.runs:
            if run.lift_s is not None:
                lead = judge.lead_s(judge.firmware_warnings(run), run.lift_s, run.falling_side)
                of_row = run.row["lead_time_s"]
                self.assertEqual(lead is None, of_row == "", f"run {run.row['run']}")
                if lead is not None:
                    self.assertAlmostEqual(lead, float(of_row), delta=6e-4)

    def test_the_firmwares_alarms_are_those_of_the_row(self):
        for run in self.runs:
            self.assertEqual("warning" in run.states, int(run.row["warnings"]) > 0, f"run {run.row['run']}")

    def test_an_index_has_the_lead_of_the_row(self):
        for run in self.runs:
            if run.lift_s is not None:
                named = judge.warnings_by(run, *index_risks(run), 1.0)
                lead, of_row = judge.lead_s(named, run.lift_s, run.falling_side), run.row[f"{INDEX}_lead_time_s"]
                self.assertEqual(lead is None, of_row == "", f"run {run.row['run']}")
                if lead is not None:
                    self.assertAlmostEqual(lead, float(of_row), delta=6e-4)

    def test_an_index_warns_up_to_the_threshold_of_the_row(self):
        for run in self.runs:
            at = float(run.row[f"{INDEX}_threshold"])
            if run.lift_s is not None:
                for threshold, warned in ((at, True), (at * STEP, False)):
                    named = judge.warnings_by(run, *index_risks(run), threshold)
                    self.assertEqual(judge.lead_s(named, run.lift_s, run.falling_side) is not None, warned)
            elif at > 0:
                [(_, largest)] = comparison.alarm_thresholds([run], {run: index_risks(run)})
                self.assertLessEqual(at, largest * (1 + 1e-6), f"run {run.row['run']}")
                self.assertLess(largest, at * STEP * (1 + 1e-6), f"run {run.row['run']}")

    def expect_share(self, share, reported):
        self.assertEqual((share.count, share.total), (reported["count"], reported["of"]))
        if share.total:
            for here, there in zip(share.interval(), reported["confidence_95"]):
                self.assertAlmostEqual(here, there, delta=1e-6)

    def expect_verdict(self, verdict, reported):
        self.expect_share(verdict.warned, reported["warned"])
        self.expect_share(verdict.warned_100ms, reported["warned_100ms_before"])
        self.expect_share(verdict.warned_200ms, reported["warned_200ms_before"])
        for band in judge.BANDS:
            self.expect_share(verdict.alarms[band], reported["alarms"][band])
        self.assertAlmostEqual(statistics.median(verdict.leads_s.values()), reported["lead_time_median_s"], delta=6e-4)

    def test_the_verdict_is_that_of_the_campaigns_report(self):
        self.expect_verdict(comparison.firmware_verdict(self.runs), self.report["warning"])
        risks = {run: index_risks(run) for run in self.runs}
        thresholds = comparison.alarm_thresholds(self.runs, risks)
        self.expect_verdict(comparison.verdict_at(self.runs, risks, thresholds, 1.0), self.report[INDEX])


class Lead(unittest.TestCase):
    def test_counts_from_the_cycle_in_which_the_side_is_named(self):
        self.assertAlmostEqual(judge.lead_s([None] * 5 + ["left"] * 10, 0.1, "left"), 0.05)

    def test_needs_the_side_that_falls(self):
        self.assertIsNone(judge.lead_s(["right"] * 15, 0.1, "left"))

    def test_begins_anew_after_a_break_and_after_a_change_of_side(self):
        self.assertAlmostEqual(judge.lead_s(["left"] * 7 + [None] + ["left"] * 7, 0.1, "left"), 0.02)
        self.assertAlmostEqual(judge.lead_s(["right"] * 9 + ["left"] * 9, 0.1, "left"), 0.01)

    def test_does_not_look_beyond_lift_off(self):
        self.assertIsNone(judge.lead_s([None] * 11 + ["left"] * 5, 0.1, "left"))
        self.assertEqual(judge.lead_s([None] * 10 + ["left"] * 5, 0.1, "left"), 0.0)
        self.assertAlmostEqual(judge.lead_s(["left"] * 11 + [None] * 5, 0.104, "left"), 0.104)

    def test_is_early_enough_to_the_cycle(self):
        for wanted in (judge.EARLY_S, judge.VERY_EARLY_S):
            self.assertTrue(judge.is_warned(0.3 + wanted - 0.3, wanted))
            self.assertFalse(judge.is_warned(wanted - 0.001, wanted))
        self.assertEqual((judge.EARLY_S, judge.VERY_EARLY_S), (0.1, 0.2))
        self.assertFalse(judge.is_warned(None))


class Band(unittest.TestCase):
    def test_begins_with_its_lower_limit(self):
        for ltr, band in ((0.699, 0), (0.7, 1), (0.799, 1), (0.8, 2), (0.899, 2), (0.9, 3)):
            self.assertEqual(judge.band(types.SimpleNamespace(largest_ltr=ltr)), judge.BANDS[band])


class ShareOfRuns(unittest.TestCase):
    def test_counts_vehicles_as_the_campaign_does(self):
        share = judge.Share()
        for vehicle in range(20):
            for run in range(10):
                share.add(vehicle, run < (10 if vehicle % 2 else 0))
        # As twenty throws of a coin, less the one that finds the mean.
        self.assertAlmostEqual(share.interval()[0], judge.wilson_interval(0.5, 19.0)[0])
        self.assertAlmostEqual(judge.wilson_interval(0.0, 20.0)[1], 0.1611, delta=0.00005)


class States(unittest.TestCase):
    def named(self, *risks):
        """State and side after these risks, (right, left) of one cycle each."""
        states = warning.WarningStates(STATES)
        for right, left in risks:
            states.update(right, left)
        return states.state, states.side

    def test_advise_from_their_level_on(self):
        self.assertEqual(self.named((0.79, 0.0)), ("ready", None))
        self.assertEqual(self.named((0.8, 0.0)), ("advisory", "right"))
        self.assertEqual(self.named((0.8, 0.0), (0.1, 0.0)), ("advisory", None))
        self.assertEqual(self.named((0.8, 0.0), *[(0.1, 0.0)] * 5), ("ready", None))

    def test_warn_when_confirmed_and_hold(self):
        self.assertEqual(self.named((0.9, 0.0)), ("advisory", "right"))
        self.assertEqual(self.named((0.9, 0.0), (0.9, 0.0)), ("warning", "right"))
        self.assertEqual(self.named((0.9, 0.0), *[(0.1, 0.9)] * 2), ("warning", "left"))
        self.assertEqual(self.named(*[(0.9, 0.0)] * 2, *[(0.1, 0.0)] * 9), ("warning", None))
        self.assertEqual(self.named(*[(0.9, 0.0)] * 2, *[(0.1, 0.0)] * 10), ("ready", None))

    def test_keep_a_side_while_its_risk_lasts(self):
        warned = [(0.9, 0.0)] * 2
        self.assertEqual(self.named(*warned, (0.75, 0.78)), ("warning", "right"))
        self.assertEqual(self.named(*warned, (0.69, 0.78)), ("warning", "left"))
        self.assertEqual(self.named(*warned, (0.69, 0.8)), ("warning", "left"))
        self.assertEqual(self.named(*warned, (0.85, 0.89)), ("warning", "right"))
        self.assertEqual(self.named(*warned, (0.85, 0.9)), ("warning", "left"))


class Threshold(unittest.TestCase):
    def test_needs_the_confirmation_of_a_warning(self):
        self.assertEqual(warning.largest_threshold(STATES, [0.1, 0.9, 0.2, 0.5, 0.6, 0.4]), 0.5)
        self.assertEqual(warning.largest_threshold(STATES, [0.9]), 0.0)

    def test_gives_as_many_alarms_as_wanted(self):
        near = types.SimpleNamespace(largest_ltr=0.85)
        thresholds = [(near, at) for at in (0.2, 0.9, 0.4, 0.7, 0.1)]
        self.assertEqual(comparison.matched_threshold(thresholds, 0.4), 0.7)
        self.assertEqual(comparison.matched_threshold(thresholds, 0.41), 0.4)
        self.assertEqual(comparison.matched_threshold(thresholds, 0.0), float("inf"))


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
