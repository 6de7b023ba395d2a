"""rsi-sil validate: a folder of drives gives a calibration and a report; a calibration that is wrong is found to be so.

Use: validate_test.py RSI_SIL
"""
import csv
import html
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(PROJECT / "tests/sil/page"))
from browser import browser  # noqa: E402
from study_tab import StudyTab, expect_plain_page, number_text  # noqa: E402

PROGRAM = sys.argv.pop(1)
HOSTILE = "<img src=x onerror=document.body.dataset.intruder=1>"
# The drives, by the names that say what they are for.
DRIVES = {"ramp": "slow-ramp", "dynamic": "step-steer", "slalom": "slalom", f"turn{HOSTILE}": "j-turn-45", "straight": "straight"}
TURN = f"turn{HOSTILE}"
QUANTITIES = ("roll_angle_deg", "load_transfer_ratio")


def rows_of(file):
    with open(file, encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(lines))


def validate(folder, output, *options):
    command = [PROGRAM, "validate", folder, "--output", output, *options]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def write_rows(file, rows):
    rows = list(rows)
    with open(file, "w", encoding="utf-8", newline="") as opened:
        writer = csv.DictWriter(opened, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def without_loads(row):
    return {name: value for name, value in row.items() if "wheel_load" not in name}


class Validate(unittest.TestCase):
    """A simulated van with noisy sensors, as if driven by hand."""

    @classmethod
    def setUpClass(cls):
        cls.scratch = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.drives = cls.scratch / "drives"
        cls.drives.mkdir()
        shutil.copy(PROJECT / "sil/vehicles/data/van.toml", cls.drives / "vehicle.toml")
        for seed, (name, manoeuvre) in enumerate(DRIVES.items(), 1):
            subprocess.run([PROGRAM, "run", manoeuvre, "--in-process", "--noise", "--seed", str(seed), "--vehicle",
                            PROJECT / "sil/vehicles/van.toml", "--parameters", PROJECT / "firmware/calibrations/van.toml",
                            "--output", cls.scratch / "run"], check=True, stdout=subprocess.DEVNULL)
            shutil.copy(cls.scratch / "run/signals.csv", cls.drives / f"{name}.csv")
        cls.output = cls.scratch / "output"
        cls.said = validate(cls.drives, cls.output)
        cls.calibration = (cls.output / "identification/calibration.toml").read_text(encoding="utf-8")

    def judged(self, name, **factors):
        """Drives and their comparison, with the calibration's values times these factors."""
        text = self.calibration
        for key, factor in factors.items():
            value = re.search(rf"(?m)^{key} = ([-\d.]+)", text)
            text = text.replace(value[0], f"{key} = {factor * float(value[1])!r}")
        calibration = self.scratch / f"{name}.toml"
        calibration.write_text(text, encoding="utf-8")
        result = validate(self.drives, self.scratch / name, "--parameters", calibration)
        self.assertEqual(result.returncode, 0, result.stderr)
        return {row["drive"]: row["comparison"] for row in rows_of(self.scratch / name / "drives.csv")}

    def test_the_vehicles_own_calibration_is_within(self):
        self.assertEqual(self.said.returncode, 0, self.said.stderr)
        rows = {row["drive"]: row for row in rows_of(self.output / "drives.csv")}
        self.assertEqual({name: row["comparison"] for name, row in rows.items()},
                         {"slalom": "within", TURN: "within", "straight": "too calm"})
        self.assertIn("3 drives: 1 too calm, 2 within\nThe calibration describes every drive that says anything of it.\n",
                      self.said.stdout)
        for row in rows.values():
            self.assertTrue((self.output / "replays" / row["drive"] / "report.html").is_file())
        table = {row["drive"]: row for row in rows_of(self.output / "replays/table.csv")}
        self.assertEqual({name: row["replay"] for name, row in rows.items()},
                         {name: row["verdict"] for name, row in table.items()})

    def test_a_wrong_calibration_is_outside(self):
        wrong = ({"roll_stiffness_nmprad": 0.8}, {"roll_stiffness_nmprad": 1.25}, {"sprung_cg_height_m": 1.2})
        for number, factors in enumerate(wrong):
            self.assertEqual(self.judged(f"wrong{number}", **factors),
                             {"slalom": "outside", TURN: "outside", "straight": "too calm"}, factors)

    def test_a_wrong_damping_shows_but_stays_within(self):
        self.assertEqual(self.judged("damping", roll_damping_nmsprad=0.4)["slalom"], "within")
        right = {row["drive"]: row for row in rows_of(self.output / "drives.csv")}
        wrong = {row["drive"]: row for row in rows_of(self.scratch / "damping/drives.csv")}
        self.assertGreater(float(wrong["slalom"]["roll_angle_rms_deg"]), float(right["slalom"]["roll_angle_rms_deg"]))

    def test_the_share_within_is_that_of_the_samples(self):
        self.judged("nearly", roll_stiffness_nmprad=1.15)
        outputs = (self.output, self.scratch / "nearly")
        for output, row in ((output, row) for output in outputs for row in rows_of(output / "drives.csv")):
            samples = rows_of(output / f"comparisons/{row['drive']}.csv")
            counted = [each["counts"] == "1" for each in samples]
            self.assertAlmostEqual(float(row["turn_s"]), 0.01 * sum(counted))
            self.assertEqual(float(row["turn_s"]) < 0.5, row["comparison"] == "too calm")
            if row["comparison"] == "too calm":
                continue
            shares = (float(row["roll_angle_within_share"]), float(row["load_transfer_within_share"]))
            self.assertEqual(min(shares) < 0.95, row["comparison"] == "outside")
            for quantity, column, least in (("roll_angle_deg", "roll_angle_within_share", 0.3),
                                            ("load_transfer_ratio", "load_transfer_within_share", 0.03)):
                numbers = [[float(each[f"{quantity}_{what}"]) for what in ("measured", "lower", "upper", "predicted")]
                           for each in samples]
                for measured, lower, upper, _ in numbers:
                    self.assertGreaterEqual(measured - lower, 0.999 * least)
                    self.assertGreaterEqual(upper - measured, 0.999 * least)
                within = sum(counts and lower <= predicted <= upper
                             for counts, (_, lower, upper, predicted) in zip(counted, numbers))
                self.assertAlmostEqual(float(row[column]), within / sum(counted), 3)

    def judged_slalom(self, name, change, calibration=None):
        return self.judged_alone(name, self.drives / "slalom.csv", change, calibration)

    def judged_alone(self, name, drive, change, calibration=None):
        """One drive alone, each row of it changed: its row of drives.csv, and what was printed."""
        folder = self.scratch / name
        folder.mkdir()
        shutil.copy(self.drives / "vehicle.toml", folder)
        write_rows(folder / "slalom.csv", map(change, rows_of(drive)))
        output = self.scratch / f"{name}_judged"
        result = validate(folder, output, "--parameters", calibration or self.output / "identification/calibration.toml")
        self.assertEqual(result.returncode, 0, result.stderr)
        judged, = rows_of(output / "drives.csv")
        return judged, result.stdout

    def test_a_drive_without_roll_angle_is_not_comparable(self):
        row, said = self.judged_slalom(
            "without", lambda row: {name: value for name, value in row.items() if "roll_angle" not in name})
        self.assertEqual((row["comparison"], row["roll_angle_within_share"]), ("not comparable", ""))
        self.assertIn("has no roll angle", row["reason"])
        self.assertIn("No drive says anything of the calibration.", said)

    def test_a_wrong_sign_is_named(self):
        def turned_over(row):
            return row | {name: repr(-float(value)) for name, value in row.items() if "roll_angle" in name and value}

        row, _ = self.judged_slalom("mirrored", turned_over)
        self.assertEqual(row["comparison"], "outside")
        self.assertIn("the roll angle runs against its prediction: check the signs", row["reason"])
        for right in rows_of(self.output / "drives.csv"):
            self.assertNotIn("check the signs", right["reason"])

    def test_without_wheel_loads_the_fall_is_not_judged(self):
        """Its first wheel lifts long before the lateral acceleration of the static rollover threshold."""
        subprocess.run([PROGRAM, "run", "sine-with-dwell", "--in-process", "--vehicle", PROJECT / "sil/vehicles/van.toml",
                        "--parameters", PROJECT / "firmware/calibrations/van.toml", "--output", self.scratch / "fall"],
                       check=True, stdout=subprocess.DEVNULL)
        drive = self.scratch / "fall/signals.csv"
        row, said = self.judged_alone("fall_without", drive, without_loads)
        summary = json.loads((self.scratch / "fall/summary.json").read_text(encoding="utf-8"))
        end_s = float(re.match(r"from (\S+) s on a first wheel may have lifted", row["reason"])[1])
        self.assertLess(end_s, summary["one_wheel_lift_time_s"])
        self.assertGreater(end_s, summary["one_wheel_lift_time_s"] - 0.3)
        compared = rows_of(self.scratch / "fall_without_judged/comparisons/slalom.csv")
        self.assertLess(float(compared[-1]["time_s"]), end_s)
        self.assertEqual(row["comparison"], "not comparable")
        self.assertIn("s of turns before it", row["reason"])
        self.assertEqual(row["roll_angle_within_share"], "1.0000")
        self.assertRegex(said, r"replay: warning, right at \d\.\d{3} s; left at \d\.\d{3} s\n")
        lifted_s = summary["one_wheel_lift_time_s"]
        whole = rows_of(drive)
        write_rows(self.scratch / "lifted.csv", [row for row in whole if float(row["time_s"]) >= lifted_s])
        row, _ = self.judged_alone("lifted", self.scratch / "lifted.csv", without_loads)
        self.assertEqual((row["comparison"], row["roll_angle_within_share"]), ("not comparable", ""))
        calm, _ = self.judged_slalom("slalom_without", without_loads)
        self.assertEqual((calm["comparison"], calm["reason"]), ("within", ""))

    def test_a_warning_where_no_wheel_can_lift_is_part_of_the_verdict(self):
        calibration = self.scratch / "eager.toml"
        levels = {"advisory_on": 0.3, "advisory_off": 0.2, "warning_on": 0.4, "warning_off": 0.3}
        text = self.calibration
        for key, level in levels.items():
            text = re.sub(rf"(?m)^{key} = \S+", f"{key} = {level}", text)
        calibration.write_text(text, encoding="utf-8")
        for name, change in (("eager", dict), ("eager_without", without_loads)):
            row, said = self.judged_slalom(name, change, calibration)
            self.assertEqual((row["comparison"], row["replay"]), ("within", "false alarm"))
            self.assertNotIn("describes every drive", said)
            self.assertIn("The warning was wrong in: slalom (false alarm).\n", said)
            sides = [warning.split()[0] for warning in row["warnings"].split("; ")]
            self.assertEqual(set(sides), {"left", "right"})
            page = (self.scratch / f"{name}_judged/replays/slalom/report.html").read_text(encoding="utf-8")
            self.assertIn("; ".join(row["warnings"].split("; ")[:4]), page)
            self.assertEqual("none can have: the accelerometers show" in page, change is without_loads)

    def test_the_doubts_of_the_identification_are_repeated(self):
        folder = self.scratch / "doubted"
        folder.mkdir()
        shutil.copy(self.drives / "vehicle.toml", folder)
        for name in ("ramp", "dynamic", "slalom"):
            write_rows(folder / f"{name}.csv", map(without_loads, rows_of(self.drives / f"{name}.csv")))
        first = validate(folder, self.scratch / "first").stdout
        calibration = self.scratch / "first/identification/calibration.toml"
        doubts = re.findall(r"(?m)^# Doubt: (.*)", calibration.read_text(encoding="utf-8"))
        self.assertIn("without wheel loads nothing checks these heights", "\n".join(doubts))
        again = validate(folder, self.scratch / "again", "--parameters", calibration).stdout
        for said, name in ((first, "first"), (again, "again")):
            self.assertEqual(re.findall(r"identify doubts: (.*)", said), doubts)
            page = (self.scratch / name / "report.html").read_text(encoding="utf-8")
            for doubt in doubts:
                self.assertIn(doubt, html.unescape(page))

    def test_a_drive_is_doubted_as_identify_would(self):
        def crooked(row):
            return row | {name: repr(float(value) + offset) for name, value in row.items() if value
                          for part, offset in (("sensor_roll_angle", 1.0), ("sensor_lateral_acceleration", 0.17)) if part in name}

        row, _ = self.judged_slalom("crooked", crooked)
        self.assertRegex(row["reason"], r"on the straight the sensors show \+0\.01\d g and \+1\.0\d deg of roll")
        self.assertIn("the roll angle seems to be one against the horizon, and the calibration says road", row["reason"])

    def test_missing_files_are_named(self):
        for names, text in (((), "there is no vehicle.toml"), (("vehicle.toml", "ramp.csv"), "there is no drive to check with"),
                            (("vehicle.toml", "slalom.csv"), "a slow ramp and a dynamic drive are both needed")):
            folder = self.scratch / f"lacks{len(names)}{len(text)}"
            folder.mkdir()
            for name in names:
                shutil.copy(self.drives / name, folder)
            result = validate(folder, self.scratch / "refused")
            self.assertEqual(result.returncode, 1)
            self.assertIn(text, result.stderr)
            self.assertFalse((self.scratch / "refused/report.html").exists())
        self.assertIn("is no folder", validate(self.scratch / "nothing", self.scratch / "refused").stderr)
        shutil.copy(self.drives / "vehicle.toml", self.scratch / "refused")
        (self.scratch / "refused/bad.csv").write_text("time_s\n0\n", encoding="utf-8")
        self.assertIn("bad.csv:1:", validate(self.scratch / "refused", self.scratch / "refused2").stderr)

    def test_a_chart_alone_has_the_whole_width(self):
        self.judged_slalom("lone", lambda row: {name: value for name, value in row.items() if "wheel_load" not in name})
        with browser() as tab:
            tab.size(1360, 900)
            page = StudyTab(tab, self.scratch / "lone_judged/report.html")
            widths = page.run("[...document.querySelectorAll('.charts')].map((each) => each.firstChild.offsetWidth / each.offsetWidth)")
            self.assertTrue(widths)
            self.assertGreater(min(widths), 0.95)

    def test_the_page_shows_the_files(self):
        with browser() as tab:
            tab.size(1360, 900)
            page = StudyTab(tab, self.output / "report.html")
            files = rows_of(self.output / "drives.csv")
            shown = page.table("drives")
            known = lambda text, factor, digits: number_text(factor * float(text) if text else None, digits)  # noqa: E731
            for row, file in zip(shown, files):
                self.assertEqual(row[:3], [file["drive"], file["comparison"], known(file["roll_angle_within_share"], 100, 1)])
                self.assertEqual(row[4], known(file["load_transfer_within_share"], 100, 1))
                self.assertEqual(row[8:10], [file["replay"], file["warnings"] or "none"])
            for number, file in enumerate(files, 1):
                rows = rows_of(self.output / f"comparisons/{file['drive']}.csv")
                samples = {round(float(each["time_s"]), 4): each for each in rows}
                for quantity in QUANTITIES:
                    for words, what in (("measured", "measured"), ("corridor", "lower"), ("predicted", "predicted")):
                        at, value, text = page.read_off(f"{quantity}_{number}", 1.8)[words]
                        self.assertAlmostEqual(at, 1.8, delta=0.1)
                        self.assertAlmostEqual(value, float(samples[round(at, 4)][f"{quantity}_{what}"]), delta=2e-6)
                        if words == "corridor":
                            upper = number_text(float(samples[round(at, 4)][f"{quantity}_upper"]), 3)
                            self.assertRegex(text, f" to {upper}( deg)?$")
                    # The predicted line lies on top, and the measured one is seen between its dashes.
                    lines = json.loads(page.run(f"JSON.stringify(study.charts.{quantity}_{number}.series.map((each) =>"
                                                "[each.words, each.dash.length, each.width]))"))
                    self.assertEqual([words for words, _, _ in lines], ["corridor", "measured", "predicted"])
                    self.assertGreater(lines[2][1], 0)
                    self.assertLessEqual(lines[1][2], 2.5)
                    self.assertTrue(page.run(f"(() => {{ const {{ canvas, frame, series }} = study.charts.{quantity}_{number};"
                                             "const [x, low, high] = series[0].points.find(([at]) => at > 1.8);"
                                             "return canvas.getContext('2d').getImageData(frame.toX(x), frame.toY(high) + 1, 1,"
                                             "Math.max(frame.toY(low) - frame.toY(high) - 2, 1)).data.every((each, place) =>"
                                             "place % 4 < 3 || each > 0); })()"), "the corridor is filled")
            expect_plain_page(self, tab, self.output / "report.html")


if __name__ == "__main__":
    unittest.main(verbosity=1)
