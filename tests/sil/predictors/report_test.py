"""The page of the study of predictors and its picture, from verdicts made by hand.

Use: report_test.py RSI_SIL
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(PROJECT / folder) for folder in ("sil/studies/predictors", "sil/judge", "sil/page")]

import comparison
import judge
import report


class HandMadeRun:
    row = {"manoeuvre": "slalom", "class": "van"}

    def __init__(self, vehicle, lift_s, largest_ltr):
        self.vehicle, self.lift_s, self.largest_ltr = vehicle, lift_s, largest_ltr


RUNS = [HandMadeRun("one", 2.0, 1.0), HandMadeRun("two", 2.0, 1.0), HandMadeRun("two", None, 0.85),
        HandMadeRun("one", None, 0.75)]


def verdict(lead, alarm):
    return comparison.Verdict(RUNS, [lead if run.lift_s and run.vehicle == "one" else None for run in RUNS], [alarm] * len(RUNS))


class Report(unittest.TestCase):
    def test_a_row_has_shares_median_and_alarms(self):
        cells = report.line("a", 0.9, verdict(0.15, True)).split(" | ")
        self.assertEqual(cells[:2], ["| a", "0.900"])
        self.assertEqual([cell.split(" ")[0] for cell in cells[2:]],
                         ["50.0", "50.0", "0.0", "0.07", "-", "100.0", "100.0", "-"])

    def test_the_page_has_a_row_for_each_prediction_and_group(self):
        page = report.page(RUNS[:1], RUNS, [("a", None, verdict(0.25, False))],
                           {(0.05, name): verdict(lead, False) for name, lead in (("a", 0.15), ("b", 0.05), ("c", 0.25))}, ["a", "b"],
                           {"steering": 1.5}, 0.3)
        self.assertIn("1 runs of 1 vehicles are learned from", page)
        self.assertIn("4 runs of the\n2 vehicles of the other half, with 2 two-wheel lift-offs", page)
        self.assertIn("| | slalom |\n|---|---:|\n| lift-offs | 2 |\n| a | 50.0 |\n", page)
        self.assertIn("| | van |\n", page)
        rows = [line.split(" | ") for line in page.splitlines() if line.startswith("| 5 %, ")]
        self.assertEqual([(row[0], row[1], row[3].split(" ")[0]) for row in rows],
                         [("| 5 %, a", "0.0", "50.0"), ("| 5 %, b", "0.0", "0.0"), ("| 5 %, c", "0.0", "50.0"),
                          ("| 5 %, best learned: a", "0.0", "50.0")])
        self.assertIn("| steering | 1.50 |\n", page)

    def test_the_picture_takes_more_curves_than_there_are_colours(self):
        curves = {f"curve {number}": [verdict(0.15, False), verdict(0.25, True)] for number in range(9)}
        with tempfile.TemporaryDirectory() as scratch:
            data, picture = pathlib.Path(scratch, "curves.dat"), pathlib.Path(scratch, "picture.png")
            data.write_text(report.curve_data(("firmware", None, verdict(0.25, False)), curves), encoding="utf-8")
            self.assertEqual(len(data.read_text(encoding="utf-8").split("\n\n\n")), 10)
            drawn = subprocess.run(
                ["gnuplot", "-e", "scripts = 'sil/results'; format = 'png'", "-e",
                 f"output_file = '{picture}'; curves = '{data}'", "sil/studies/predictors/predictors.gp"],
                cwd=PROJECT, capture_output=True, text=True, check=False, env={**os.environ, "LC_ALL": "C.UTF-8"})
            self.assertEqual((drawn.returncode, drawn.stderr), (0, ""))
            self.assertGreater(picture.stat().st_size, 1000)


if __name__ == "__main__":
    judge.use(sys.argv.pop(1))
    unittest.main()
