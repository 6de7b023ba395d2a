#!/usr/bin/python3
"""The page of a population's campaigns: a missed goal is marked, a met one is not, and no campaign may be unfinished."""

import csv
import importlib.machinery
import importlib.util
import json
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
SCRIPT = pathlib.Path(__file__).resolve().parents[3] / "sil/studies/population/document"
LOADER = importlib.machinery.SourceFileLoader("population_document", str(SCRIPT))
document = importlib.util.module_from_spec(importlib.util.spec_from_loader("population_document", LOADER))
LOADER.exec_module(document)


def share(count, of):
    return {"count": count, "of": of, "share": count / of if of else 0.0, "confidence_95": [0.0, 1.0]}


def group(warned=1000, early=995, earlier=850, median=0.4, alarms=(0, 0, 100), wrong_s=0.0):
    """One that just meets every goal without errors."""
    return {
        "runs": 4000,
        "two_wheel_lift_offs": 1000,
        "wrong_side_s_per_1000_runs": wrong_s,
        "unavailable_s_per_1000_runs": 0.0,
        "runs_with_diagnostic_code": 3,
        "indices": {
            "warning": {
                "warned": share(warned, 1000),
                "warned_100ms_before": share(early, 1000),
                "warned_200ms_before": share(earlier, 1000),
                "lead_time_median_s": median,
                "alarms": dict(zip(("below 0.7", "0.7 to 0.8", "0.8 to 0.9"), (share(count, 1000) for count in alarms))),
            }
        },
    }


def verdicts(**changes):
    table = document.goal_table({"clean": {"all": group(**changes)}, "errors": {"all": group()}})
    return [line.split(" | ")[3].strip(" |") for line in table.splitlines()[2:]]


class Goals(unittest.TestCase):
    def test_results_at_every_goal_meet_them(self):
        self.assertEqual(verdicts(), ["yes"] * 8)

    def test_one_step_less_misses_the_goal_and_no_other(self):
        for index, change in enumerate((
            {"warned": 999}, {"early": 994}, {"earlier": 849}, {"median": 0.399},
            {"alarms": (1, 0, 100)}, {"alarms": (0, 1, 100)}, {"alarms": (0, 0, 101)}, {"wrong_s": 0.01},
        )):  # fmt: skip
            expected = ["yes"] * 8
            expected[index] = "**no**"
            self.assertEqual(verdicts(**change), expected, change)

    def test_nothing_measured_is_no_goal_reached(self):
        self.assertEqual(verdicts(median=None)[3], "**no**")

    def test_goals_with_errors_are_their_own(self):
        table = document.goal_table({"clean": {"all": group()}, "errors": {"all": group(warned=995, early=990, earlier=800, median=0.36, alarms=(0, 3, 250), wrong_s=0.1)}})
        self.assertEqual([line.split(" | ")[6].strip(" |") for line in table.splitlines()[2:]], ["yes"] * 8)

    def test_nothing_to_measure_a_share_in_is_no_goal_reached(self):
        nothing = group()
        nothing["indices"]["warning"]["alarms"]["0.7 to 0.8"] = share(0, 0)
        line = document.goal_table({"clean": {"all": nothing}, "errors": {"all": group()}}).splitlines()[7]
        self.assertEqual(line.split(" | ")[:4], ["| alarms, 0.7 to 0.8", "at most 0 %", "-", "**no**"])

    def test_the_validation_judges_by_the_goals_with_errors_all_vehicles_and_the_van(self):
        just_met = group(warned=995, early=990, earlier=800, median=0.36, alarms=(0, 3, 250), wrong_s=0.1)
        missed = group(warned=994, early=989, earlier=799, median=0.359, alarms=(1, 4, 251), wrong_s=0.11)
        named = [dict(missed, name="van"), dict(missed, name="other")]
        lines = document.campaign.goal_table({"all": just_met, "vehicles": named}).splitlines()[2:]
        self.assertEqual([line.split(" | ")[-1] for line in lines], ["yes |"] * 8 + ["**no** |"] * 8)
        self.assertEqual(lines[0], "| all vehicles | warned, right side | at least 99.5 % | 99.50 % | yes |")
        self.assertEqual(lines[11], "| van | median lead | at least 0.36 s | 0.359 s | **no** |")


class Campaigns(unittest.TestCase):
    def test_a_row_has_a_cell_for_every_column_and_ends_with_the_runs_that_set_a_code(self):
        row = document.row("all", group())
        self.assertEqual(len(row), len(document.HEAD))
        self.assertEqual(row[-2:], ["0.00 s", "3"])

    def test_tripped_runs_are_told_by_when_they_are_warned_of(self):
        head = "manoeuvre,two_wheel_lift_time_s,lead_time_s,warning_time_s,warnings,unavailable_duration_s\n"
        with tempfile.TemporaryDirectory() as scratch:
            file = pathlib.Path(scratch) / "runs.csv"
            file.write_text("# note\n" + head + "kerb-trip,2.000,0.050,1.950,1,0.000\n"  # before
                            "kerb-trip,2.000,,2.100,1,0.000\n" "kerb-trip,2.000,,2.200,1,0.120\n"  # soon after
                            "kerb-trip,2.000,,2.500,1,0.000\n"  # late
                            "kerb-trip,2.000,,,0,0.300\n" "kerb-trip,2.000,,1.000,1,0.000\n"  # none; one that had ended
                            "kerb-trip,,,1.500,1,0.000\n" "kerb-trip,,,,0,0.010\n" "soil-trip,,,,0,0.000\n", encoding="utf-8")
            lines = document.tripping(file).splitlines()
        self.assertEqual(lines[2], "| kerb-trip | 8 | 6 | 1 | 2 | 1 | 2 | -0.150 | 2 | 1 |")
        self.assertEqual(lines[3], "| soil-trip | 1 | 0 | 0 | 0 | 0 | 0 | - | 0 | 0 |")

    def test_an_unfinished_one_is_refused(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            (folder / "report.json").write_text(json.dumps({"complete": False}), encoding="utf-8")
            with self.assertRaisesRegex(SystemExit, "is not finished"):
                document.read(folder)


class Vehicles(unittest.TestCase):
    ROW = {"mass_kg": "1000", "static_stability_factor": "1.1", "threshold_g": "1.0", "grip": "1.2", "roll_centre_height_m": "0.1",
           "cg_height_m": "0.6", "roll_gradient_degpg": "5", "roll_frequency_hz": "1.5", "roll_damping_ratio": "0.2",
           "understeer_gradient_s2pm": "0.0025", "wheelbase_m": "2.5", "relaxation_length_m": "0.4", "steering_lag_s": "0.05",
           "largest_ramp_ltr": "0.8", "spring_progression_pm2": "3", "dry_friction": "0", "frame_over_roll_stiffness": "0", "roll_inertia_kgm2": "300"}
    SHEET = "total_mass_kg = 1000.0\nunsprung_mass_kg = 100.0\nsprung_cg_height_m = 0.63\nwheel_radius_m = 0.3\ntrack_width_m = 1.4\n"
    CALIBRATION = ("largest_lateral_acceleration_mps2 = 9.80665\nlateral_response_frequency_radps = 8.0\n"
                   "lateral_response_damping = 0.8\n")

    def test_page_and_data_have_what_was_drawn_and_what_was_identified(self):
        rows = [self.ROW | {"vehicle": "v0", "class": "van", "with_wheel_loads": "calibrated"},
                self.ROW | {"vehicle": "v1", "class": "bus", "with_wheel_loads": "failed: no", "threshold_g": "0.5",
                            "understeer_gradient_s2pm": "-0.001"}]
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            for name in ("data", "calibrations"):
                (folder / name).mkdir()
            for vehicle in ("v0", "v1"):
                (folder / "data" / f"{vehicle}.toml").write_text(self.SHEET, encoding="utf-8")
            (folder / "calibrations/v0.toml").write_text(self.CALIBRATION, encoding="utf-8")
            columns = document.quantities(folder, rows)
            data = list(csv.DictReader(document.vehicle_data(folder, rows, columns).splitlines()))
        page = document.vehicles(columns, rows)
        self.assertIn("| rollover threshold | g | 0.5 | 0.5 | 1 | 1 | 1 |", page)
        self.assertIn("| its lag | s | 0.2 | 0.2 | 0.2 | 0.2 | 0.2 |", page)
        self.assertIn("| largest LTR of the ramp | | 0.8 |", page)
        self.assertIn("calibrated 1 of 2 vehicles", page)
        self.assertEqual([(line["vehicle"], line["class"], line["rollover threshold"], line["tyre limit over threshold"],
                           line["characteristic speed"]) for line in data],
                         [("v0", "van", "1", "1", "113.842"), ("v1", "bus", "0.5", "", "")])
        self.assertNotIn("largest LTR of the ramp", data[0])
        self.assertAlmostEqual(float(data[0]["roll radius of gyration over track"]), 0.42786, places=4)


if __name__ == "__main__":
    unittest.main()
