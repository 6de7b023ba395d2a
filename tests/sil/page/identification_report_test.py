"""The report of an identification in a browser: what it shows is what fit.csv, curve.csv, calibration.toml and report.txt say.

Use: identification_report_test.py RSI_SIL
"""
import csv
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest

from browser import browser
from study_tab import StudyTab, expect_plain_page

PROJECT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = sys.argv.pop(1)
HOSTILE = "<img src=x onerror=document.body.dataset.intruder=1>"
# The lines of a chart by name, with the column of fit.csv and the factor.
CHARTS = {
    "roll": {"measured": ("roll_angle_deg", 1), "predicted": ("predicted_roll_angle_deg", 1)},
    "load": {"of the wheels": ("load_moment_nm", 0.001), "as the component has it": ("fitted_load_moment_nm", 0.001)},
    "response": {"A, measured": ("road_parallel_force_mps2", 1), "asked for by the steering": ("steering_acceleration_mps2", 1),
                 "response to it, as fitted": ("response_acceleration_mps2", 1)},
    "moment": {"m_s H f, measured": ("moment_nm", 0.001), "M + c p + Ixx p', fitted": ("fitted_moment_nm", 0.001),
               "residual": ("residual_nm", 0.001)},
}


def rows_of(file):
    with open(file, encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(lines))


def without_columns(source, target, pattern):
    """A copy of a drive of which some columns are left out."""
    rows = rows_of(source)
    names = [name for name in rows[0] if not re.search(pattern, name)]
    with open(target, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, names, extrasaction="ignore", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


class IdentificationReport(unittest.TestCase):
    """Two simulated drives with noise, and the same under hostile names, without wheel loads and steering."""

    @classmethod
    def setUpClass(cls):
        scratch = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        data = ["--vehicle-data", PROJECT / "sil/vehicles/data/ordinary_suv.toml", "--no-pictures"]
        cls.whole = scratch / "whole"
        subprocess.run([PROGRAM, "identify", *data, "--simulate", PROJECT / "sil/vehicles/ordinary_suv.toml", "--noise",
                        "--output", cls.whole],
                       check=True, stdout=subprocess.DEVNULL)
        drives = []
        for name in ("slow-ramp", "step-steer"):
            drives.append(scratch / f"{name}{HOSTILE}.csv")
            without_columns(cls.whole / f"drives/{name}.csv", drives[-1], "wheel")
        cls.bare = scratch / "bare"
        subprocess.run([PROGRAM, "identify", *data, "--set", f"name={HOSTILE}", "--ramp", drives[0], "--dynamic", drives[1],
                        "--output", cls.bare],
                       check=True, stdout=subprocess.DEVNULL)
        cls.tab = cls.enterClassContext(browser())
        cls.tab.size(1360, 900)

    def setUp(self):
        self.tab.complaints.clear()

    def tearDown(self):
        self.assertEqual(self.tab.complaints, [])

    def page(self, folder):
        return StudyTab(self.tab, folder / "report.html")

    def expect_lines(self, page, rows, chart, lines):
        """Values read off at a few times are those of the file at these times."""
        by_time = {round(float(row["time_s"]), 4): row for row in rows}
        first, last = float(rows[0]["time_s"]), float(rows[-1]["time_s"])
        for share in (0.0, 0.13, 0.41, 0.77, 1.0):
            shown = page.read_off(chart, first + share * (last - first))
            self.assertEqual(set(shown), set(lines), chart)
            for words, (column, factor) in lines.items():
                at, value, _ = shown[words]
                self.assertAlmostEqual(at, first + share * (last - first), delta=0.06)
                of_file = factor * float(by_time[round(at, 4)][column])
                self.assertAlmostEqual(value, of_file, delta=2e-6 + 1e-6 * abs(value), msg=f"{chart}: {words}")

    def test_signals_are_those_of_the_file(self):
        page = self.page(self.whole)
        rows = rows_of(self.whole / "fit.csv")
        for drive in ("1", "2"):
            for chart, lines in CHARTS.items():
                self.expect_lines(page, [row for row in rows if row["drive"] == drive], f"{chart}_{drive}", lines)

    def test_the_model_alone_predicts_the_roll_angle(self):
        rows = [row for row in rows_of(self.whole / "fit.csv") if row["drive"] == "2"]
        error = max(abs(float(row["roll_angle_deg"]) - float(row["predicted_roll_angle_deg"])) for row in rows)
        largest = max(abs(float(row["roll_angle_deg"])) for row in rows)
        self.assertLess(error, 0.12 * largest)
        self.assertGreater(error, 0)

    def test_values_and_their_origins_are_those_of_the_calibration(self):
        text = (self.whole / "calibration.toml").read_text(encoding="utf-8")
        calibration = tomllib.loads(text)
        shown = self.page(self.whole).table("values")
        self.assertGreater(len(shown), 15)
        for key, value, origin in shown:
            self.assertEqual(tomllib.loads(f"value = {value}")["value"], calibration[key], key)
            self.assertIn(origin, next(line for line in text.splitlines() if line.startswith(key + " ")))

    def test_the_curve_is_that_of_the_file(self):
        page = self.page(self.whole)
        for row in rows_of(self.whole / "curve.csv")[::25]:
            shown = page.read_off("stiffness", row["roll_angle_deg"])
            delta = 1e-4 + 1e-5 * abs(shown["fitted"][1])
            self.assertAlmostEqual(shown["fitted"][1], 0.001 * float(row["moment_nm"]), delta=delta)
            self.assertAlmostEqual(shown["its linear part"][1], 0.001 * float(row["linear_moment_nm"]), delta=delta)

    def test_fit_and_warnings_are_those_of_the_report(self):
        for folder in (self.whole, self.bare):
            text = (folder / "report.txt").read_text(encoding="utf-8")
            page = self.page(folder)
            for name, _, _, _, _, _, _, explained, residual, *_ in page.table("drives"):
                self.assertIn(f"  {name}: R2 {explained}, residual {residual} N m rms", text)
            said = page.run("[...document.querySelectorAll('.sentences li')].map((each) => each.textContent)")
            self.assertEqual(said, [line.removeprefix("  - ") for line in text.splitlines() if line.startswith("  - ")])
        self.assertGreater(len(said), 1)

    def test_missing_signals_have_no_line(self):
        page = self.page(self.bare)
        rows = rows_of(self.bare / "fit.csv")
        self.expect_lines(page, [row for row in rows if row["drive"] == "2"], "roll_2", CHARTS["roll"])
        self.assertEqual(page.run("Object.keys(study.charts)"), ["stiffness", "roll_1", "moment_1", "roll_2", "moment_2"])
        self.assertEqual({row[10] for row in page.table("drives")}, {"\u2013"})

    def test_is_a_plain_page(self):
        self.assertIn(HOSTILE, self.page(self.bare).run("document.getElementById('title').textContent"))
        self.assertTrue(all(HOSTILE in row[0] for row in self.page(self.bare).table("drives")))
        expect_plain_page(self, self.tab, self.bare / "report.html")


if __name__ == "__main__":
    unittest.main(verbosity=1)
