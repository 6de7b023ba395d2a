#!/usr/bin/python3
"""The page of distributions is that of its data; outside is counted right; a wrong published value is refused."""

import importlib.machinery
import importlib.util
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
PROJECT = pathlib.Path(__file__).resolve().parents[3]
SCRIPT = PROJECT / "sil/studies/population/distributions"
LOADER = importlib.machinery.SourceFileLoader("distributions", str(SCRIPT))
distributions = importlib.util.module_from_spec(importlib.util.spec_from_loader("distributions", LOADER))
LOADER.exec_module(distributions)
import published  # noqa: E402
import vehicle_quantities  # noqa: E402

REPORTS = PROJECT / "docs/reports"
CONTENT = (REPORTS / "data/population_vehicles.csv", REPORTS / "data/foreign_vehicles.csv",
           PROJECT / "sil/studies/population/published.toml")


class Stored(unittest.TestCase):
    def test_the_page_is_what_the_script_writes_from_its_data(self):
        page = distributions.page(*distributions.read(*CONTENT))
        self.assertEqual((REPORTS / "distributions.md").read_text(encoding="utf-8"), page)

    def test_every_picture_is_there_and_no_other(self):
        asked_for = set(re.findall(r"\(pictures/(distribution_\w+\.png)\)", (REPORTS / "distributions.md").read_text(encoding="utf-8")))
        self.assertEqual(asked_for, {file.name for file in (REPORTS / "pictures").glob("distribution_*.png")})


def of(kind, values, family=distributions.POPULATION):
    return [(family, kind, {"roll gradient": value}) for value in values]


def value(low=None, middle=None, high=None, classes=("van",)):
    source = published.Source("a", "An author", "A title", 1999, "a page", "text")
    return published.Value("roll gradient", list(classes), "some vans", low, middle, high, "ends", source)


# The population has roll gradients of 2 to 9, its vans of 4 to 6.
POPULATION = of("bus", [2.0, 3.0, 9.0]) + of("van", [4.0, 5.0, 5.5, 6.0])
FOREIGN = of("van", [1.9, 2.0, 5.0, 9.0, 9.1], "commonroad") + of("tanker", [9.5], "jointed")


def compared(*values):
    return distributions.Quantity("roll gradient", POPULATION, FOREIGN, list(values))


class Outside(unittest.TestCase):
    def test_vehicles_below_the_least_and_above_the_largest_are_counted(self):
        quantity = compared()
        self.assertEqual(quantity.outside("commonroad"), (2, 5))
        self.assertEqual(quantity.outside("jointed"), (1, 1))
        found = {row.label: row.outside for row in quantity.rows() if row.group in ("commonroad", "jointed")}
        self.assertEqual(found, {"van": "2 below and above", "tanker": "1 above"})

    def test_a_published_value_is_outside_if_an_end_is(self):
        values = [value(low=2.0, high=9.0), value(low=1.9, high=3.0), value(middle=9.1), value(low=3.0)]
        quantity = compared(*values)
        self.assertEqual(quantity.outside(distributions.PUBLISHED), (2, 4))
        self.assertEqual([quantity.range.beyond(each.numbers()) for each in values], ["-", "below", "above", "-"])

    def test_a_published_value_is_also_compared_with_its_own_class(self):
        inside_of_all = value(low=4.5, high=7.0)
        quantity = compared(inside_of_all)
        self.assertEqual(quantity.of_classes(inside_of_all), (4.0, 6.0))
        self.assertEqual(quantity.share_within(inside_of_all), (3, 4))
        self.assertEqual(quantity.share_within(value(low=5.5)), (2, 4))
        self.assertEqual(quantity.share_within(value(high=4.0)), (1, 4))
        self.assertIsNone(quantity.share_within(value(middle=5.0)))
        self.assertEqual(distributions.published_outside([quantity]), "- none")
        self.assertEqual(distributions.published_outside_class([quantity]), "- **roll gradient**, some vans: 4.5 to 7 deg/g (ends); "
                         "above the largest of the class van, 6; 3 of 4 of class van within [[a](#sources)]")

    def test_the_page_says_it_and_what_has_no_published_value(self):
        values = [value(low=1.0, high=3.0)]
        page = distributions.page(POPULATION, FOREIGN, values, [values[0].source])
        self.assertIn("| roll gradient | deg/g | 2 to 9 | 2 of 5 | 1 of 1 | 1 of 1 |", page)
        self.assertIn("- **roll gradient**, some vans: 1 to 3 deg/g (ends); below the least of the population, 2; 0 of 4 of class van "
                      "within [[a](#sources)]", page)
        self.assertIn("- **roll gradient**, tanker (jointed): 1 of 1 above", page)
        self.assertIn("No published value was found for the classes: bus.", page)
        self.assertIn("| some vans | 1 | - | 3 | ends | van | 4 to 6 | 0 of 4 | below | below | a |", page)
        without = distributions.page(POPULATION, FOREIGN, [], [])
        self.assertIn("No published values with a source that can be cited were found for: roll gradient.", without)


    def test_a_class_without_the_quantity_cannot_be_compared(self):
        with self.assertRaisesRegex(published.Wrong, "no tram of the population has a roll gradient, with which published.toml "
                                                     "compares some vans"):
            distributions.compared(POPULATION, FOREIGN, [value(low=1.0, classes=("tram",))])


class Picture(unittest.TestCase):
    def test_a_name_may_have_an_apostrophe(self):
        name = "growth of the springs' stiffness"
        quantity = compared()
        quantity.name = name
        self.assertEqual(quantity.picture(), "distribution_growth_of_the_springs_stiffness.png")
        with tempfile.TemporaryDirectory() as scratch:
            distributions.draw(quantity, pathlib.Path(scratch, quantity.picture()))

    def test_it_is_drawn_with_values_that_lack_ends(self):
        quantity = compared(value(low=1.0), value(middle=3.0), value(low=1.0, high=4.0), value(low=1.0, middle=2.0, high=4.0))
        with tempfile.TemporaryDirectory() as scratch:
            file = pathlib.Path(scratch, quantity.picture())
            distributions.draw(quantity, file)
            self.assertGreater(file.stat().st_size, 1000)
        lines = [line.split("\t") for line in distributions.picture_rows(quantity).splitlines()]
        self.assertEqual(lines[1], ["2", "4", "4", "5.5", "6", "6", "1", "van"])
        self.assertEqual(lines[3], ["4", "9.5", "9.5", "9.5", "9.5", "9.5", "3", "tanker (jointed)"])
        self.assertEqual(lines[4], ["5", "1", "1", "-", "-", "-", "4", "some vans"])


RIGHT = """
[source.a]
author = "An author"
title = "A title"
place = "table 1"
read = "text"
[[value]]
quantity = "roll gradient"
classes = ["van"]
of = "some vans"
low = 3.0
high = 5.0
ends = "5 and 95 %"
source = "a"
"""


class WrongValues(unittest.TestCase):
    def read(self, text):
        with tempfile.TemporaryDirectory() as scratch:
            file = pathlib.Path(scratch, "published.toml")
            file.write_text(text, encoding="utf-8")
            return published.read(file, ["bus", "van"])

    def test_a_right_one_is_read(self):
        values, sources = self.read(RIGHT)
        self.assertEqual([(each.low, each.middle, each.high, each.source.year) for each in values], [(3.0, None, 5.0, None)])
        self.assertEqual([source.author for source in sources], ["An author"])

    def test_each_wrong_one_is_refused_in_a_sentence(self):
        for old, new, sentence in (
            ('source = "a"\n', "", r"value 1 \(roll gradient, some vans\) has no source; name one"),
            ('source = "a"', 'source = "b"', r"there is no table \[source.b\]; write it"),
            ("low = 3.0", "low = 6.0", "low, middle and high do not increase; put them in order"),
            ("low = 3.0", "low = 3.0\nmiddle = 5.5", "do not increase"),
            ("low = 3.0\nhigh = 5.0\n", "", "has no number; give low, middle or high"),
            ("low = 3.0", 'low = "3"', "low is no number"),
            ("high = 5.0", "high = nan", "high is no number"),
            ("roll gradient", "roll gradeint", "unknown quantity; there are mass, "),
            ('"van"', '"lorry"', "the population has no class lorry; there are bus, van"),
            ('["van"]', "[]", "has no classes; list"),
            ('of = "some vans"', 'of = ""', 'has no "of"'),
            ('ends = "5 and 95 %"\n', "", 'has no "ends"'),
            ('ends = "5', 'end = "5', "unknown key end; there are quantity, "),
            ('author = "An author"\n', "", r"\[source.a\] has no author; say it"),
            ('read = "text"', 'read = "skimmed"', 'was read "skimmed"; there are data, text, quoted, not read'),
            ("[[value]]", '[source.b]\nauthor = "b"\ntitle = "b"\nplace = "b"\nread = "text"\n[[value]]', r"no value is from \[source.b\]; remove it"),
            ("[[value]]", "[[value", "cannot be read as TOML"),
        ):
            self.assertIn(old, RIGHT)
            with self.assertRaisesRegex(published.Wrong, sentence):
                self.read(RIGHT.replace(old, new, 1))

    def test_the_command_says_it_and_writes_nothing(self):
        with tempfile.TemporaryDirectory() as scratch:
            wrong = pathlib.Path(scratch, "published.toml")
            wrong.write_text(CONTENT[2].read_text(encoding="utf-8").replace("low = 0.24", "low = 9.9", 1), encoding="utf-8")
            output = pathlib.Path(scratch, "output")
            for option, file, sentence in (("--published", wrong, "low, middle and high do not increase"),
                                           ("--population", output / "none.csv", "docs/renew_population writes it"),
                                           ("--foreign", output / "none.csv", "sil/studies/foreign/run --document writes it")):
                done = subprocess.run([SCRIPT, option, file, "--output", output], capture_output=True, text=True, check=False)
                self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (1, "", 1), done.stderr)
                self.assertIn(sentence, done.stderr)
            self.assertFalse(output.exists())


class Quantities(unittest.TestCase):
    def test_the_radius_of_gyration_is_that_of_a_body_and_two_wheels(self):
        # 800 kg whose inertia is 800 kg m2 at 0.8 m, 200 kg at 0.3 m and at half a track of 2 m: the CG is at 0.7 m.
        inertia = 800.0 + 800.0 * 0.1**2 + 200.0 * (1.0 + 0.4**2)
        found = vehicle_quantities.roll_gyration_over_track(800.0, 200.0, 0.8, 0.3, 2.0, 800.0)
        self.assertAlmostEqual(found, (inertia / 1000.0)**0.5 / 2.0)

    def test_only_an_understeering_vehicle_has_a_characteristic_speed(self):
        self.assertAlmostEqual(vehicle_quantities.characteristic_speed_kmh(2.5, 0.0025), 3.6 * 1000.0**0.5)
        self.assertIsNone(vehicle_quantities.characteristic_speed_kmh(2.5, 0.0))

    def test_a_line_is_written_for_each_vehicle(self):
        written = vehicle_quantities.csv_text({"vehicle": ["a", "b"]}, {"mass": [1234.5678, 2.0], "its lag": [None, 0.1]})
        self.assertEqual(written, "vehicle,mass,its lag\na,1234.57,\nb,2,0.1\n")


if __name__ == "__main__":
    unittest.main()
