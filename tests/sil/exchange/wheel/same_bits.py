"""The installed package against what rsi-sil wrote; and its refusals: same_bits.py FRAMES DRIVE CAMPAIGN CALIBRATION.

FRAMES and DRIVE are folders of replays of one drive: its frames, and its signals with wheel loads. CAMPAIGN has traces.
Started by installed_test.py, where this project is not.
"""

import csv
import json
import math
import pathlib
import sys
import unittest

import numpy as np

import rsi_component as rsi

CALIBRATION = ""
FRAMES = DRIVE = CAMPAIGN = pathlib.Path()
NUMBER = np.float32
DEGREES, KMH = NUMBER(0.017453293), NUMBER(1) / NUMBER(3.6)
# Input: column, factor to the frame's unit, step of the frame, and factor to the firmware's unit.
SIGNALS = {
    "lateral_specific_force_mps2": ("lateral_acceleration_mps2", 1, 0.002, NUMBER(1)),
    "vertical_specific_force_mps2": ("vertical_acceleration_mps2", 1, 0.002, NUMBER(1)),
    "roll_rate_radps": ("roll_rate_degps", 1, 0.01, DEGREES),
    "roll_angle_rad": ("roll_angle_deg", 1, 0.005, DEGREES),
    "bank_angle_rad": ("bank_angle_deg", 1, 0.005, DEGREES),
    "speed_mps": ("speed_mps", 3.6, 0.01, KMH),
    "yaw_rate_radps": ("yaw_rate_degps", 1, 0.01, DEGREES),
    "steering_wheel_angle_rad": ("steering_wheel_angle_deg", 1, 0.1, DEGREES),
}


def table(path):
    """Column: numbers, or words."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))

    def column(name):
        try:
            return np.array([float(row[name] or "nan") for row in rows])
        except ValueError:
            return np.array([row[name] for row in rows])

    return {name: column(name) for name in rows[0]}


def as_received(columns, prefix):
    """The component's inputs, as the ECU makes them of its frames."""
    return {
        name: NUMBER(np.round(columns[prefix + column] * factor / step) * step) * unit
        for name, (column, factor, step, unit) in SIGNALS.items()
    }


def bits(values):
    return np.where(np.isnan(values), -1, values.view(np.int32))


class Replay(unittest.TestCase):
    def setUp(self):
        self.columns = table(FRAMES / "indices.csv")
        self.calibration = rsi.Calibration.load(CALIBRATION)
        self.inputs = as_received(self.columns, "sensor_")
        self.run = rsi.run(self.calibration, self.columns["time_s"], **self.inputs)
        of_drive = table(DRIVE / "indices.csv")
        self.truth = rsi.Truth.of_wheel_loads(
            of_drive["time_s"],
            *(
                of_drive[f"measured_wheel_load_{wheel}_n"]
                for wheel in ("front_left", "front_right", "rear_left", "rear_right")
            ),
        )

    def test_every_output(self):
        compared = 0
        for name in rsi.outputs():
            values = self.run[name]
            self.assertEqual(values.shape, self.columns["time_s"].shape)
            if values.dtype == np.int32:
                column = self.columns[f"{name}_number" if f"{name}_number" in self.columns else name]
                np.testing.assert_array_equal(values, column, name)
            else:  # nine digits, so each stands for one float; angles in degrees
                in_degrees = name.endswith("_rad")
                column = self.columns[name[:-4] + "_deg" if in_degrees else name]
                np.testing.assert_array_equal(
                    bits(values), bits(NUMBER(column * (math.pi / 180) if in_degrees else column)), name
                )
            compared += 1
        self.assertEqual(compared, len(self.run.outputs.dtype))
        np.testing.assert_array_equal(self.run.states(), self.columns["state"])
        np.testing.assert_array_equal(self.run.sides(), self.columns["side"])

    def test_single_steps_and_parts_are_as_one(self):
        component = rsi.Component(self.calibration)
        first = [component.step(**{name: values[row] for name, values in self.inputs.items()}) for row in range(150)]
        rest = component.run(
            self.columns["time_s"][150:], **{name: values[150:] for name, values in self.inputs.items()}
        )
        for name in rsi.outputs():
            np.testing.assert_array_equal([row[name] for row in first], self.run[name][:150].tolist(), name)
            np.testing.assert_array_equal(rest[name], self.run[name][150:], name)
        component.reset()
        again = component.run(self.columns["time_s"], **self.inputs)
        self.assertEqual(again.outputs.tobytes(), self.run.outputs.tobytes())

    def test_the_judge(self):
        summary = json.loads((DRIVE / "summary.json").read_text(encoding="utf-8"))
        verdict = self.run.judge(self.truth)
        self.assertTrue(verdict.lifted)
        self.assertFalse(verdict.late)
        for mine, theirs in (
            (self.truth.two_wheel_lift_s, "two_wheel_lift_time_s"),
            (self.truth.one_wheel_lift_s, "one_wheel_lift_time_s"),
            (self.truth.falling_side, "falling_side"),
            (verdict.band, "load_transfer_band"),
            (verdict.largest_ltr, "max_load_transfer_ratio"),
            (verdict.lead_s, "lead_time_s"),
            (verdict.side_at_lift_off, "side_at_lift_off"),
            (verdict.wrong_side_s, "wrong_side_duration_s"),
            (verdict.warning_s, "warning_duration_s"),
            (verdict.advisory_s, "advisory_duration_s"),
            (verdict.unavailable_s, "unavailable_duration_s"),
            (verdict.warnings, "warnings"),
            (verdict.advisories, "advisories"),
        ):
            self.assertEqual(round(mine, 9) if isinstance(mine, float) else mine, summary[theirs], theirs)

    def test_levels_are_those_that_warn(self):
        np.testing.assert_array_equal(
            bits(self.run.level(self.calibration["warning_indicator"])), bits(self.run["warning_level"])
        )
        np.testing.assert_array_equal(self.run.level("published"), self.run["rsi"])


class Campaign(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(CAMPAIGN / "runs.csv", encoding="utf-8") as file:
            cls.rows = list(csv.DictReader(file))
        cls.drives = []
        for row in cls.rows:
            trace = CAMPAIGN / "traces" / f"{row['run']}.csv"
            columns = table(trace)
            run = rsi.run(
                rsi.Calibration.load(trace.with_suffix(".toml")), columns["time_s"], **as_received(columns, "")
            )
            lift_s = float(row["two_wheel_lift_time_s"]) if row["two_wheel_lift_time_s"] else None
            truth = rsi.Truth(columns["true_load_transfer_ratio"], lift_s, row["falling_side"] or "none")
            cls.drives.append(rsi.Drive(run, truth, row["vehicle"]))
            np.testing.assert_array_equal(run.states(), columns["state"])

    def test_scores_of_every_index(self):
        lifted = 0
        for row, drive in zip(self.rows, self.drives):
            lifted += drive.truth.two_wheel_lift_s is not None
            for index in rsi.indices():
                score = drive.run.score(index, drive.truth)
                for mine, ending in zip(score[:3], ("", "_100ms", "_200ms")):
                    self.assertEqual(
                        f"{mine:.6g}", f"{float(row[f'{index}_threshold{ending}']):.6g}", (row["run"], index)
                    )
                lead = row[f"{index}_lead_time_s"]
                self.assertEqual("" if score.lead_s is None else f"{score.lead_s:.3f}", lead and f"{float(lead):.3f}")
                self.assertEqual(score.lead_s, drive.run.lead_s(index, 1.0, drive.truth))
        self.assertGreater(lifted, 1)

    def test_the_benchmark(self):
        found = rsi.benchmark(self.drives)
        level = [drive for drive in self.drives if drive.run.judge(drive.truth).band == "0.8 to 0.9"]
        self.assertGreater(len(level), 2)
        warned = sum(drive.run.judge(drive.truth).warnings > 0 for drive in level)
        self.assertGreater(warned, 0)
        self.assertEqual(found.alarm_share, warned / len(level))
        self.assertEqual(list(found.entries), ["warning", *rsi.indices()])
        own = found.entries["warning"].detection
        self.assertEqual(
            (own.warned.count, own.warned.total),
            (
                sum(bool(row["lead_time_s"]) for row in self.rows),
                sum(bool(row["two_wheel_lift_time_s"]) for row in self.rows),
            ),
        )
        for index in rsi.indices():
            threshold, detection = found.entries[index]
            self.assertEqual(detection.alarms["0.8 to 0.9"].count, warned, index)
            self.assertEqual(
                threshold, sorted((drive.run.alarm_threshold(index) for drive in level), reverse=True)[warned - 1]
            )
            leads = [
                drive.run.lead_s(index, threshold, drive.truth) for drive in self.drives if drive.truth.two_wheel_lift_s
            ]
            self.assertEqual(detection.warned.count, sum(lead is not None for lead in leads))
        self.assertEqual(len(str(found).splitlines()), 2 + len(rsi.indices()))
        self.assertRaisesRegex(rsi.Refused, "alarm_share is 1.5", rsi.benchmark, self.drives, alarm_share=1.5)
        never = rsi.benchmark(self.drives, alarm_share=0.0, band="below 0.7").entries["published"]
        self.assertEqual((never.threshold, never.detection.warned.count), (math.inf, 0))
        with self.assertRaisesRegex(rsi.Refused, "in the band 0.7 to 0.8, so .* give such drives, or another band"):
            rsi.benchmark([drive for drive in self.drives if drive.truth.two_wheel_lift_s], band="0.7 to 0.8")
        unknown = self.drives[0]._replace(truth=rsi.Truth(np.full(len(self.drives[0].run), math.nan)))
        with self.assertRaisesRegex(rsi.Refused, "drive 1 has no load transfer ratio"):
            rsi.benchmark([level[0], unknown])

    def test_an_index_of_ones_own(self):
        def levels(run):  # of an index of the component, which has no side of its own
            level, to_the_right = run.level("static_stability_factor"), run["lateral_acceleration_mps2"] >= 0
            return np.where(to_the_right, level, 0), np.where(to_the_right, 0, level)

        available = [
            drive._replace(others={"mine": np.nan_to_num(levels(drive.run))})
            for drive in self.drives
            if not np.any(np.isnan(drive.run.level("static_stability_factor")))
        ]
        self.assertGreater(len(available), 10)
        entries = rsi.benchmark(available).entries
        self.assertEqual(list(entries)[-1], "mine")
        self.assertEqual(entries["mine"], entries["static_stability_factor"])
        self.assertGreater(entries["mine"].detection.warned.count, 0)
        first = available[0]
        for others, message in (
            ({"mine": (levels(first.run)[0] * math.nan, levels(first.run)[1])}, "mine has rows without a number"),
            ({"mine": ([0.0], [0.0])}, "mine has 1 rows, but time_s has"),
            ({"energy": levels(first.run)}, "the component has an index energy"),
            ({}, "drive 0 has no index mine"),
        ):
            with self.assertRaisesRegex(rsi.Refused, message):
                rsi.benchmark([first._replace(others=others), *available[1:]])


class Refusals(unittest.TestCase):
    def setUp(self):
        self.time_s = np.arange(100) * 0.01
        self.flat = np.zeros(100)

    def refused(self, message, call, *arguments, **series):
        with self.assertRaisesRegex(rsi.Refused, message):
            call(*arguments, **series)

    def run_of(self, time_s, **series):
        return rsi.run(
            rsi.Calibration.load("van"),
            time_s,
            **{
                "lateral_specific_force_mps2": np.zeros(len(time_s)),
                "roll_rate_radps": np.zeros(len(time_s)),
                **series,
            },
        )

    def test_a_calibration(self):
        self.refused("nowhere.toml: cannot be read", rsi.Calibration.load, "nowhere.toml")
        self.refused("there is no calibration larg_suv; there are: .*large_suv", rsi.Calibration.load, "larg_suv")
        self.refused(r'"sprung_mass_kg" .*range 100 to 60000', rsi.Calibration.load, "van", sprung_mass_kg=3)
        self.refused("sprung_mas_kg", rsi.Calibration.load, "van", sprung_mas_kg=3)
        self.refused('"warning_indicator"', rsi.Calibration.load, "van", warning_indicator="none")
        changed = rsi.Calibration.load(
            "van", warning_on=0.75, warning_off=0.7, advisory_on=0.5, advisory_off=0.25, warning_indicator="published"
        )
        self.assertEqual(
            (changed["warning_on"], changed["warning_indicator"], changed.name), (0.75, "published", "van")
        )
        self.assertEqual(dict(rsi.Calibration.load("large_suv")), dict(rsi.Calibration.load(CALIBRATION)))
        self.assertEqual(len(changed), len(rsi.parameters()))
        with self.assertRaises(KeyError):
            changed["nothing"]

    def test_another_rate_and_its_recipe(self):
        time_s = np.arange(50) * 0.02
        values = time_s**2
        with self.assertRaises(rsi.Refused) as refusal:
            self.run_of(time_s)
        message = str(refusal.exception)
        self.assertRegex(
            message,
            r"^time_s: row 1 comes 0\.02 s after the one before, and the component steps every 0\.01 s; resample",
        )
        there = {"numpy": np, "time_s": time_s}
        grid, newest = message.split("newest value: ")[1].split("; then")[0].split("; ")
        exec(f"{grid}\n{newest}", there)  # as it says
        resampled = values[there["newest"]]
        self.assertEqual(len(self.run_of(there["grid"], roll_angle_rad=resampled)), 98)
        np.testing.assert_array_equal(resampled[:5], values[[0, 0, 1, 1, 2]])

    def test_a_truth_of_another_run(self):
        run = self.run_of(self.time_s)
        short = rsi.Truth(np.zeros(5))
        later = rsi.Truth(np.zeros(100), 1000.0, "right")
        for ask in (run.judge, lambda truth: run.score("rsi", truth), lambda truth: run.lead_s("rsi", 1.0, truth)):
            self.refused("load_transfer_ratio has 5 rows, the run has 100", ask, short)
            self.refused("two wheels lift at 1000 s, but the run is from 0 to 0.99 s", ask, later)

    def test_times(self):
        self.refused("time_s: rows are 0.0101 s apart in the mean", self.run_of, np.arange(1000) * 0.0101)
        self.refused("time_s: row 50 comes 0.02 s", self.run_of, np.delete(self.time_s, 50))
        self.refused("time_s: rows are 10 apart, as in ms; give seconds: time_s / 1000", self.run_of, self.time_s * 1000)
        self.refused("does not increase at row 3: 0.02", self.run_of, [0.0, 0.01, 0.02, 0.02])
        self.refused("does not increase at row 1: nan", self.run_of, [0.0, math.nan, 0.02])
        self.refused("does not increase at row 0: nan", self.run_of, [math.nan])
        self.refused("time_s has no row", self.run_of, [])
        self.refused("it holds dates", self.run_of, self.time_s.astype("datetime64[s]"))
        late = self.time_s + np.where(np.arange(100) % 2, 0.001, 0.0)  # jitter
        self.assertEqual(len(self.run_of(late)), 100)
        self.assertEqual(len(self.run_of([0.0])), 1)

    def test_series(self):
        self.refused(
            "there is no input roll_angle; there are: lateral_specific_force_mps2, ",
            self.run_of,
            self.time_s,
            roll_angle=self.flat,
        )
        self.refused(
            "roll_angle_rad has 99 rows, but time_s has 100", self.run_of, self.time_s, roll_angle_rad=self.flat[1:]
        )
        self.refused(
            r"roll_angle_rad has the shape \(100, 1\)", self.run_of, self.time_s, roll_angle_rad=self.flat[:, None]
        )
        self.refused("roll_angle_rad is no array of numbers", self.run_of, self.time_s, roll_angle_rad=["low"] * 100)
        self.refused(
            "roll_rate_radps is missing: .* NaN where",
            rsi.run,
            rsi.Calibration.load("van"),
            self.time_s,
            lateral_specific_force_mps2=self.flat,
        )
        self.refused("there is no output speed", self.run_of(self.time_s).__getitem__, "speed")
        self.refused("there is no index rsi; there are: published", self.run_of(self.time_s).level, "rsi")
        self.refused("there is no input roll", rsi.Component(rsi.Calibration.load("van")).step, roll=1.0)

    def test_arrays_of_other_kinds_are_taken(self):
        angle = np.linspace(0.0, 0.1, 100)
        plain = self.run_of(self.time_s, roll_angle_rad=angle).outputs.tobytes()
        gaps = np.zeros((100, 3))
        gaps[:, 1] = angle
        gaps.flags.writeable = False
        for same in (list(angle), gaps[:, 1], np.ma.array(angle), angle.astype(">f8")):
            self.assertEqual(self.run_of(self.time_s, roll_angle_rad=same).outputs.tobytes(), plain)
        lost = angle.copy()
        lost[50:] = math.nan
        self.assertEqual(
            self.run_of(self.time_s, roll_angle_rad=np.ma.masked_greater(angle, angle[49])).outputs.tobytes(),
            self.run_of(self.time_s, roll_angle_rad=lost).outputs.tobytes(),
        )
        self.assertNotEqual(self.run_of(self.time_s, roll_angle_rad=lost).outputs.tobytes(), plain)
        self.assertEqual(
            self.run_of(self.time_s, lateral_specific_force_mps2=self.flat + 1e300).states()[-1], "unavailable"
        )

    def test_a_truth(self):
        self.refused("belong together", rsi.Truth, self.flat, 0.5)
        self.refused("two_wheel_lift_s is nan; give", rsi.Truth, self.flat, math.nan, "left")
        self.refused("there is no side up", rsi.Truth, self.flat, 0.5, "up")
        self.refused("has 100 rows, the run has 99", self.run_of(self.time_s[1:]).judge, rsi.Truth(self.flat))
        nothing = self.flat + math.nan
        self.refused(
            "no row has all four wheel loads", rsi.Truth.of_wheel_loads, self.time_s, nothing, nothing, nothing, nothing
        )
        full, up = self.flat + 4000.0, np.where(self.time_s < 0.5, 4000.0, 0.0)
        truth = rsi.Truth.of_wheel_loads(self.time_s, full, up, full, up)
        self.assertEqual((truth.two_wheel_lift_s, truth.one_wheel_lift_s, truth.falling_side), (0.5, 0.5, "left"))
        jump = rsi.Truth.of_wheel_loads(self.time_s, up, up, up, up, lateral_acceleration_mps2=self.flat + 1.0)
        self.assertEqual((jump.two_wheel_lift_s, jump.falling_side), (0.5, "right"))
        short = np.where(np.abs(self.time_s - 0.5) < 0.02, 0.0, 4000.0)
        self.assertEqual(rsi.Truth.of_wheel_loads(self.time_s, full, short, full, short).two_wheel_lift_s, None)
        self.assertEqual(
            [self.run_of([0.0]).judge(rsi.Truth([ltr])).band for ltr in (0.0, -0.75, 0.85, -0.95)],
            ["below 0.7", "0.7 to 0.8", "0.8 to 0.9", "0.9 to lift"],
        )

    def test_a_late_warning(self):
        force = np.where(self.time_s > 0.3, 9.0, 0.0)
        run = self.run_of(
            self.time_s,
            lateral_specific_force_mps2=force,
            vertical_specific_force_mps2=self.flat + 9.81,
            roll_angle_rad=0.02 * force,
            yaw_rate_radps=0.01 * force,
            speed_mps=self.flat + 30.0,
        )
        first = float(self.time_s[np.flatnonzero(run.states() == "warning")[0]])
        early, late = (run.judge(rsi.Truth(self.flat, lift_s, "right")) for lift_s in (first + 0.2, first - 0.05))
        self.assertAlmostEqual(early.lead_s, 0.2)
        self.assertEqual((late.lead_s, late.late), (None, True))
        self.assertEqual(run.judge(rsi.Truth(self.flat, first + 0.2, "left")).lead_s, None)

    def test_meanings(self):
        self.assertIn("[m/s^2]", rsi.outputs()["road_parallel_force_mps2"])
        self.assertEqual(rsi.indices()["energy"], "energy_margin")
        self.assertIn("needed", rsi.inputs()["roll_rate_radps"])
        self.assertTrue(all(value for value in rsi.outputs().values()))
        self.assertEqual(rsi.CALIBRATIONS, sorted(rsi.CALIBRATIONS))


if __name__ == "__main__":
    FRAMES, DRIVE, CAMPAIGN = map(pathlib.Path, sys.argv[1:4])
    CALIBRATION = sys.argv[4]
    unittest.main(argv=sys.argv[:1])
