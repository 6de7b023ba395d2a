"""Lift-offs that a reaction prevents, and its costs, from rows made by hand.

Use: report_test.py RSI_SIL
"""

import pathlib
import re
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(PROJECT / folder) for folder in ("sil/studies/prevention", "sil/studies/campaign", "sil/judge", "sil/page")]

import judge
import report
import study

COLUMNS = ("run", "vehicle", "class", "manoeuvre", "two_wheel_lift_time_s", "largest_ltr", "end_time_s", "distance_m", "warnings",
           "interventions", "published_threshold")


def row(number, vehicle="one", in_class="van", manoeuvre="slalom", lift="", ltr=0.5, end=10.0, way=200.0, warnings=0, reactions=0,
        published=0.0):
    return (number, vehicle, in_class, manoeuvre, lift, ltr, end, way, warnings, reactions, published)


# Without a reaction: three lift-offs, a close run, two calm ones.
WITHOUT = [row(0, lift=2.0, ltr=1.0, end=3.0, warnings=1), row(1, lift=2.5, ltr=1.0, end=3.5, warnings=1, manoeuvre="turn"),
           row(2, vehicle="two", in_class="bus", lift=3.0, ltr=1.0, end=4.0), row(3, ltr=0.95, warnings=1, published=1.05),
           row(4, ltr=0.85, warnings=1, published=0.99), row(5, vehicle="two", in_class="bus", manoeuvre="turn", ltr=0.4, published=0.5)]
# With one: the first is prevented, the close run becomes a lift-off, a calm one is braked.
WITH = [row(0, ltr=0.97, reactions=1, way=180.0, warnings=1), row(1, lift=2.6, ltr=1.0, end=3.6, warnings=1, reactions=1, manoeuvre="turn"),
        WITHOUT[2], row(3, lift=4.0, ltr=1.0, end=5.0, reactions=1, warnings=1), row(4, ltr=0.8, way=191.0, reactions=2, warnings=2),
        WITHOUT[5]]


def store(folder, rows):
    folder.mkdir(parents=True)
    lines = [",".join(COLUMNS), *(",".join(map(str, cells)) for cells in rows)]
    (folder / "runs.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return folder


class Report(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.without = store(self.folder / "without", WITHOUT)
        self.compared = report.compare(study.runs(self.without), study.runs(store(self.folder / "with", WITH)))

    def test_a_lift_off_that_does_not_happen_is_prevented_and_one_that_happens_only_then_is_caused(self):
        prevented, caused = self.compared.prevented(), self.compared.caused()
        self.assertEqual((prevented.count, prevented.total), (1, 3))
        self.assertEqual((caused.count, caused.total), (1, 3))
        self.assertEqual(report.cells(self.compared, 0.905)[0], "0.905")
        self.assertTrue(report.cells(self.compared, None)[1].startswith("33.3 ("))
        self.assertEqual(report.cells(None, None), ["-", "-", "-"])

    def test_campaigns_of_other_runs_are_not_compared(self):
        runs = study.runs(self.without)
        with self.assertRaises(ValueError):
            report.compare(runs, {number: run for number, run in runs.items() if number})

    def test_groups_have_their_lift_offs_and_what_is_prevented_of_them(self):
        table = report.groups([("default warning", self.compared)], "in_class").splitlines()
        self.assertEqual(table[0], "| | lift-offs | default warning, % |")
        self.assertTrue(table[2].startswith("| bus | 1 | 0.0 ("))
        self.assertTrue(table[3].startswith("| van | 2 | 50.0 ("))
        table = report.groups([("a", self.compared), ("b", self.compared)], "manoeuvre").splitlines()
        self.assertEqual([line.split(" | ")[:2] for line in table[2:]], [["| slalom", "2"], ["| turn", "1"]])

    def test_false_reactions_are_those_of_calm_runs_and_lose_way(self):
        calm = self.compared.calm()
        self.assertEqual((calm.reacted().count, calm.reacted().total), (1, 2))
        self.assertEqual(calm.lost_m(), 9.0)
        self.assertAlmostEqual(calm.lost_kmh(), 3.6 * 9.0 / 20.0)
        self.assertAlmostEqual(calm.interventions_per_hour(), 2 * 3600 / 20.0)
        self.assertIsNone(report.Compared([]).lost_m())
        self.assertIn("| a | 50.00 (", report.costs([("a", self.compared, calm)]))
        self.assertIn(" | 9.0 | 360.00 | 1.620 |", report.costs([("a", self.compared, calm)]))

    def test_rows_of_runs_without_a_warning_are_taken_over_and_no_others(self):
        def taken(warning):
            folder = self.folder / f"{warning.index}{warning.level}"
            folder.mkdir()
            left = study.take_over(self.without, folder, warning)
            lines = (folder / "runs.csv").read_text(encoding="utf-8").splitlines()
            self.assertEqual(lines[0], ",".join(COLUMNS))
            self.assertEqual(left, len(WITHOUT) - (len(lines) - 1))
            self.assertTrue(set(lines) <= set((self.without / "runs.csv").read_text(encoding="utf-8").splitlines()))
            return [int(line.split(",")[0]) for line in lines[1:]]

        self.assertEqual(taken(study.Warning("", "warning")), [5])
        self.assertEqual(taken(study.Warning("", "published", 1.0)), [5], "0.99 may have warned at the next step of its ladder")
        self.assertEqual(taken(study.Warning("", "published", 1.01)), [4, 5])
        self.assertEqual(taken(study.Warning("", "published", 1.2)), [3, 4, 5])
        self.assertEqual(taken(study.Warning("", "published", 0.3)), [])

    def test_rows_that_are_there_stay_when_rows_are_taken_over_for_more_runs(self):
        driven = "0" + ",driven" * (len(COLUMNS) - 1)
        folder = store(self.folder / "grown", [])
        with (folder / "runs.csv").open("a", encoding="utf-8") as file:
            file.write(driven + "\n")
        self.assertEqual(study.take_over(self.without, folder, study.Warning("", "warning")), 4)
        lines = (folder / "runs.csv").read_text(encoding="utf-8").splitlines()
        self.assertEqual([line.split(",")[0] for line in lines[1:]], ["0", "5"])
        self.assertEqual(lines[1], driven)

    def test_the_live_drive_has_the_same_stability_function(self):
        header = (PROJECT / "sil/world/manoeuvres/intervention.hpp").read_text(encoding="utf-8")
        numbers = re.search(r"stability_function\{InterventionKind::brake, ([\d., ]+)\}", header)[1]
        self.assertEqual([float(number) for number in numbers.split(",")], [*study.BRAKE[1:], 0.0])

    def test_settings_say_all_of_a_reaction(self):
        brake = study.Variant(study.Warning("", "published", 0.75), study.Reaction("brake", 0.1, 0.2, 4.0))
        self.assertEqual(brake.toml(), '\n[intervention]\nindex = "published"\nlevel = 0.75\nkind = "brake"\ndelay_s = 0.1\nramp_s = 0.2\n'
                                       'deceleration_mps2 = 4.0\n')
        driver = study.Variant(study.Warning("", "warning"), study.Reaction("driver", 0.75, 0.2, 0.5))
        self.assertEqual(driver.toml(), '\n[intervention]\nindex = "warning"\nkind = "driver"\ndelay_s = 0.75\nramp_s = 0.2\n'
                                        'steer_back_share = 0.5\n')
        self.assertNotEqual(brake.folder(), driver.folder())


if __name__ == "__main__":
    judge.use(sys.argv.pop(1))
    unittest.main()
