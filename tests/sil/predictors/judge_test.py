"""The study of predictors judges as the campaign does: on runs that a campaign drove and judged, and by hand.

Use: judge_test.py RSI_SIL
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(PROJECT / "sil/studies/predictors"), str(PROJECT / "sil/judge")]

import comparison
import judge
import recorded_runs

PROGRAM = ""
RUNS = 60
INDEX = "predicted_load_transfer"  # the firmware's own; a trace has it
STEP = 1.01  # of the campaign's thresholds
STATES = {"advisory_on": 0.8, "advisory_off": 0.7, "warning_on": 0.9, "warning_off": 0.8,
          "warning_confirmation_s": 0.02, "advisory_hold_s": 0.05, "warning_hold_s": 0.1, "recovery_s": 0.0}


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
        for number in range(judge.fewest_vehicles()):
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

    def firmwares_lead(self, run):
        times_s = [cycle * recorded_runs.CYCLE_S for cycle in range(len(run))]
        sides = [side if state == "warning" else "none" for state, side in zip(run.states, run.sides)]
        return judge.lead_s(times_s, sides, run.lift_s, run.falling_side)

    def index_lead(self, run, threshold):
        times_s = [cycle * recorded_runs.CYCLE_S for cycle in range(len(run))]
        return judge.Index(run.calibration, times_s, *index_risks(run)).lead_s(threshold, run.lift_s, run.falling_side)

    def test_the_firmwares_lead_is_that_of_the_row(self):
        for run in self.runs:
            if run.lift_s is not None:
                lead = self.firmwares_lead(run)
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
                lead, of_row = self.index_lead(run, 1.0), run.row[f"{INDEX}_lead_time_s"]
                self.assertEqual(lead is None, of_row == "", f"run {run.row['run']}")
                if lead is not None:
                    self.assertAlmostEqual(lead, float(of_row), delta=6e-4)

    def test_an_index_warns_up_to_the_threshold_of_the_row(self):
        for run in self.runs:
            at = float(run.row[f"{INDEX}_threshold"])
            if run.lift_s is not None:
                for threshold, warned in ((at, True), (at * STEP, False)):
                    self.assertEqual(self.index_lead(run, threshold) is not None, warned)
            elif at > 0:
                largest = comparison.alarm_thresholds([run], {run: index_risks(run)})[run]
                self.assertLessEqual(at, largest * (1 + 1e-6), f"run {run.row['run']}")
                self.assertLess(largest, at * STEP * (1 + 1e-6), f"run {run.row['run']}")

    def expect_share(self, share, reported):
        self.assertEqual((share.count, share.total), (reported["count"], reported["of"]))
        if share.total:
            for here, there in zip(share.interval, reported["confidence_95"]):
                self.assertAlmostEqual(here, there, delta=1e-6)

    def expect_verdict(self, verdict, reported):
        verdict = verdict.detection
        self.expect_share(verdict.warned, reported["warned"])
        self.expect_share(verdict.warned_100ms, reported["warned_100ms_before"])
        self.expect_share(verdict.warned_200ms, reported["warned_200ms_before"])
        for band in judge.bands():
            self.expect_share(verdict.alarms[band], reported["alarms"][band])
        self.assertAlmostEqual(verdict.median_lead_s, reported["lead_time_median_s"], delta=6e-4)

    def test_the_verdict_is_that_of_the_campaigns_report(self):
        self.expect_verdict(comparison.firmware_verdict(self.runs), self.report["warning"])
        risks = {run: index_risks(run) for run in self.runs}
        thresholds = comparison.alarm_thresholds(self.runs, risks)
        self.expect_verdict(comparison.verdict_at(self.runs, risks, thresholds, 1.0), self.report[INDEX])


    def test_a_threshold_for_a_share_of_alarms_is_the_lowest_one(self):
        risks = {run: index_risks(run) for run in self.runs}
        thresholds = comparison.alarm_thresholds(self.runs, risks)
        for share in (0.0, 0.1, 0.3, 1.0):
            at = comparison.threshold_with_alarms_at_most(share, thresholds)
            alarms = comparison.verdict_at(self.runs, risks, thresholds, at).detection.false_alarms
            self.assertLessEqual(alarms.count, share * alarms.total)
            if share < 1.0:
                lower = comparison.verdict_at(self.runs, risks, thresholds, at * (1 - 1e-9)).detection.false_alarms
                self.assertGreater(lower.count, share * lower.total)


class Lead(unittest.TestCase):
    def lead_s(self, sides, lift_s):
        return judge.lead_s([0.01 * cycle for cycle in range(len(sides))], sides, lift_s, "left")

    def test_counts_from_the_cycle_in_which_the_side_is_named(self):
        self.assertAlmostEqual(self.lead_s(["none"] * 5 + ["left"] * 10, 0.1), 0.05)

    def test_needs_the_side_that_falls(self):
        self.assertIsNone(self.lead_s(["right"] * 15, 0.1))
        self.assertIsNone(self.lead_s([], 0.1))

    def test_begins_anew_after_a_break_and_after_a_change_of_side(self):
        self.assertAlmostEqual(self.lead_s(["left"] * 7 + ["none"] + ["left"] * 7, 0.1), 0.02)
        self.assertAlmostEqual(self.lead_s(["right"] * 9 + ["left"] * 9, 0.1), 0.01)

    def test_does_not_look_beyond_lift_off(self):
        self.assertIsNone(self.lead_s(["none"] * 11 + ["left"] * 5, 0.1))
        self.assertEqual(self.lead_s(["none"] * 10 + ["left"] * 5, 0.1), 0.0)
        self.assertAlmostEqual(self.lead_s(["left"] * 11 + ["none"] * 5, 0.104), 0.104)


class Runs(unittest.TestCase):
    def test_are_told_by_lift_off_lead_and_band(self):
        self.assertEqual((judge.early_s(), judge.very_early_s()), (0.1, 0.2))
        lifted = judge.each([3.0] * 5, [1.0] * 5, [None, 0.0, 0.099, 0.3 + 0.1 - 0.3, 0.3 + 0.2 - 0.3])
        self.assertEqual(list(lifted["lifted"]), [1] * 5)
        self.assertEqual(list(lifted["calm"]), [0] * 5)
        self.assertEqual(list(lifted["warned"]), [0, 1, 1, 1, 1])
        self.assertEqual(list(lifted["warned_100ms"]), [0, 0, 0, 1, 1])
        self.assertEqual(list(lifted["warned_200ms"]), [0, 0, 0, 0, 1])
        upright = judge.each([None] * 7, [0.699, 0.7, 0.799, 0.8, 0.899, 0.9, 1.0], [0.3] * 7)
        self.assertEqual(list(upright["band"]), [0, 1, 1, 2, 2, 3, 3])
        self.assertEqual(list(upright["calm"]), [1, 1, 1, 1, 1, 0, 0])
        self.assertEqual(list(upright["warned"]), [0] * 7)
        self.assertEqual(judge.bands(), ["below 0.7", "0.7 to 0.8", "0.8 to 0.9", "0.9 to lift"])
        self.assertEqual(list(judge.each([], [], [])["lifted"]), [])


class ShareOfRuns(unittest.TestCase):
    def test_counts_vehicles_as_the_campaign_does(self):
        # As twenty throws of a coin, less the one that finds the mean.
        share = judge.share_by_vehicle([(10 if vehicle % 2 else 0, 10) for vehicle in range(20)])
        self.assertEqual((share.count, share.total, share.value()), (100, 200, 0.5))
        self.assertAlmostEqual(share.interval[0], judge.wilson_interval(0.5, 19.0)[0])
        self.assertAlmostEqual(judge.wilson_interval(0.0, 20.0)[1], 0.1611, delta=0.00005)
        self.assertEqual(judge.share_by_vehicle([]).interval, (0.0, 1.0))


class Threshold(unittest.TestCase):
    def index(self, risks):
        return judge.Index(STATES, [0.01 * cycle for cycle in range(len(risks))], risks, [0.0] * len(risks))

    def test_needs_the_confirmation_of_a_warning(self):
        self.assertAlmostEqual(self.index([0.1, 0.9, 0.2, 0.5, 0.6, 0.4]).alarm_threshold(), 0.5, delta=1e-6)
        self.assertEqual(self.index([0.9]).alarm_threshold(), 0.0)
        self.assertEqual(self.index([]).alarm_threshold(), 0.0)
        self.assertTrue(self.index([0.0, 1.0, 1.0]).alarms(1.0))
        self.assertFalse(self.index([0.0, 1.0, 0.99]).alarms(1.0))

    def test_gives_as_many_alarms_as_wanted(self):
        near = [HandMadeRun(0.85) for _ in range(5)]
        thresholds = {HandMadeRun(0.75): 0.95, **dict(zip(near, (0.2, 0.9, 0.4, 0.7, 0.1)))}
        self.assertEqual(comparison.matched_threshold(thresholds, 0.4), 0.7)
        self.assertEqual(comparison.matched_threshold(thresholds, 0.41), 0.4)
        self.assertEqual(comparison.matched_threshold(thresholds, 0.0), float("inf"))


class HandMadeRun:
    lift_s = None

    def __init__(self, largest_ltr):
        self.largest_ltr = largest_ltr


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    judge.use(PROGRAM)
    unittest.main()
