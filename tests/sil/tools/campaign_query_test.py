"""Parts planned, converted and asked: what is missing, units in the metadata, and the same figures as the report's."""

import contextlib
import csv
import io
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(PROJECT / "sil/tools/campaigns"), str(PROJECT / "cmake/environment")]

import command  # noqa: E402
import parts  # noqa: E402
import query  # noqa: E402
from parts import Part  # noqa: E402

RUNS = 60


class Missing(unittest.TestCase):
    def test_all_is_missing_at_first(self):
        self.assertEqual(parts.missing([], 25, 10), [Part(0, 10), Part(10, 10), Part(20, 5)])

    def test_cuts_are_those_of_the_first_call(self):
        self.assertEqual(parts.missing([Part(10, 10)], 25, 10), [Part(0, 10), Part(20, 5)])
        self.assertEqual(parts.missing([Part(0, 10), Part(10, 10), Part(20, 5)], 25, 10), [])
        self.assertEqual(parts.missing([Part(0, 10), Part(10, 10), Part(20, 5)], 40, 10), [Part(25, 5), Part(30, 10)])

    def test_parts_of_another_size_are_kept(self):
        self.assertEqual(parts.missing([Part(3, 4), Part(12, 1)], 20, 10), [Part(0, 3), Part(7, 3), Part(10, 2), Part(13, 7)])


def write_settings(path, changes, manoeuvres):
    """Two vehicles of a class each."""
    changes = ", ".join(json.dumps(change) for change in changes)
    drives = "".join(f'\n[[manoeuvre]]\nname = "{name}"\nspeed_factor = {speed}\nsteering_factor = {steering}\n'
                     for name, speed, steering in manoeuvres)
    vehicles = "".join(f'\n[[vehicle]]\nparameters = "{PROJECT}/sil/vehicles/{name}.toml"\ncalibration = "{PROJECT}/'
                       f'firmware/calibrations/{name}.toml"\nclass = "{name} class"\n'
                       for name in ("large_suv", "ordinary_suv"))
    path.write_text(f"changes = [{changes}]\n{vehicles}{drives}", encoding="utf-8")


class Asked(unittest.TestCase):
    program = None

    @classmethod
    def scratch_folder(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        return pathlib.Path(scratch.name)

    @classmethod
    def drive(cls, settings, runs, first, count):
        cls.run_program("part", "--settings", settings, "--runs", runs, "--first", first, "--count", count, "--output",
                        cls.folder / f"part-{first}.csv")

    @classmethod
    def reported(cls):
        cls.run_program("report", "--output", cls.folder)
        return json.loads((cls.folder / "report.json").read_text(encoding="utf-8"))

    @classmethod
    def run_program(cls, *arguments):
        subprocess.run([cls.program, "campaign", *map(str, arguments)], cwd=PROJECT, check=True, capture_output=True, timeout=300)

    def command(self, *arguments):
        said = io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(io.StringIO()):
            command.main([*map(str, arguments), *(["--program", str(self.program)] if "--list" not in arguments else [])])
        return said.getvalue()

    def rows(self, name):
        target = self.folder.parent / "answer.csv"
        self.command("query", self.folder, name, "--csv", target)
        with target.open(encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))


class NoAnswerIsEmpty(Asked):
    """Early and wrong warnings, lift-offs by a kerb that are not warned of, vehicles that lift often."""

    RUNS = 150

    @classmethod
    def setUpClass(cls):
        scratch = cls.scratch_folder()
        cls.folder, settings = scratch / "campaign", scratch / "settings.toml"
        write_settings(settings, ['warning_indicator="published"', "warning_on=0.6", "warning_off=0.5", "advisory_on=0.5", "advisory_off=0.4"],
                       [(name, [0.5, 1.2], [0.3, 1.4]) for name in ("j-turn-110", "fishhook-1a", "kerb-trip")])
        cls.drive(settings, cls.RUNS, 0, cls.RUNS)
        cls.report = cls.reported()["all"]

    def test_every_question_has_rows(self):
        for name in query.names():
            self.assertTrue(self.rows(name), name)

    def test_alarms_below_0_7_are_those_of_the_report(self):
        rows = self.rows("alarms_below_0_7")
        self.assertEqual(len(rows), self.report["indices"]["warning"]["alarms"]["below 0.7"]["count"])
        self.assertTrue(all(float(row["largest |LTR|"]) < 0.7 for row in rows))

    def test_the_worst_vehicles_are_those_with_the_fewest_early_warnings(self):
        rows = self.rows("worst_vehicles")
        shares = [float(row["0.1 s before, %"]) for row in rows]
        self.assertEqual(shares, sorted(shares))
        self.assertTrue(all(int(row["lift_offs"]) >= 20 for row in rows))

    def test_a_wrong_side_was_named_for_a_time_or_at_lift_off(self):
        for row in self.rows("wrong_side"):
            self.assertTrue(float(row["wrong side, s"]) > 0.0 or row["side_at_lift_off"] not in ("", row["falling_side"]), row)


class Queries(Asked):
    @classmethod
    def setUpClass(cls):
        scratch = cls.scratch_folder()
        cls.folder, settings = scratch / "it's a campaign", scratch / "settings.toml"
        # Settings under which there are missed lift-offs to be asked for.
        write_settings(settings, ['warning_indicator="published"', "warning_on=0.95"],
                       [(name, [0.8, 1.2], [0.6, 1.4]) for name in ("j-turn-110", "fishhook-1a")])
        for first in range(0, RUNS, 30):
            cls.drive(settings, RUNS, first, 30)
        cls.report = cls.reported()

    def refused(self, expected, *arguments):
        with self.assertRaises(SystemExit) as raised:
            self.command(*arguments)
        self.assertIn(expected, str(raised.exception.code))

    def test_every_question_is_answered_and_listed(self):
        listed = self.command("query", "--list")
        self.assertEqual(len(query.names()), 10)
        for name, what in query.names().items():
            self.assertIn(f"{name} ", listed)
            self.assertGreater(len(what), 20)
            self.assertTrue(self.command("query", self.folder, name).strip(), name)

    def test_detection_is_that_of_the_report(self):
        rows = self.rows("detection_by_manoeuvre_and_class")
        self.assertEqual(sum(int(row["runs"]) for row in rows), RUNS)
        for key, column in (("manoeuvres", "manoeuvre"), ("classes", "class")):
            for group in self.report[key]:
                warned, early = group["indices"]["warning"]["warned"], group["indices"]["warning"]["warned_100ms_before"]
                mine = [row for row in rows if row[column] == group["name"]]
                self.assertEqual(sum(int(row["lift_offs"]) for row in mine), group["two_wheel_lift_offs"])
                self.assertEqual(sum(int(row["missed"]) for row in mine), warned["of"] - warned["count"])
                counted = sum(round(float(row["0.1 s before, %"] or 0) * int(row["lift_offs"]) / 100) for row in mine)
                self.assertEqual(counted, early["count"])

    def test_indices_and_bands_are_those_of_the_report(self):
        rows = {row["index_name"]: row for row in self.rows("index_comparison")}
        self.assertEqual(len(rows), len(self.report["all"]["indices"]))
        for name, index in self.report["all"]["indices"].items():
            row = rows["the firmware's warning" if name == "warning" else name]
            for column, key in (("warned, %", "warned"), ("0.1 s before, %", "warned_100ms_before"),
                                ("0.2 s before, %", "warned_200ms_before"), ("alarms in calm runs, %", "false_alarms")):
                self.assertAlmostEqual(float(row[column]), 100 * index[key]["share"], delta=0.006, msg=f"{name} {key}")
            self.assertAlmostEqual(float(row["median lead, s"]), index["lead_time_median_s"], delta=0.0006, msg=name)
        found = dict.fromkeys(self.report["all"]["runs_by_load_transfer"], 0)
        for row in self.rows("alarms_by_band"):
            if row["band"] in found:
                found[row["band"]] += int(row["runs"])
        self.assertEqual(found, self.report["all"]["runs_by_load_transfer"])

    def test_a_missed_run_comes_with_the_command_that_drives_it_again(self):
        warned = self.report["all"]["indices"]["warning"]["warned"]
        missed = self.rows("missed_runs")
        self.assertEqual(len(missed), warned["of"] - warned["count"])
        self.assertGreater(len(missed), 0, "the settings of this test let none be missed")
        row = missed[0]
        again = row["drives it again, and leaves its report.html"]
        subprocess.run(["bash", "-c", again], check=True, capture_output=True, cwd="/", timeout=300)
        made = self.folder / f"run-{row['run']}"
        self.assertTrue((made / "report.html").is_file())
        summary = json.loads((made / "summary.json").read_text(encoding="utf-8"))
        self.assertAlmostEqual(summary["two_wheel_lift_time_s"], float(row["two wheels lift, s"]), delta=6e-4)
        self.assertIn(shlex.quote(str(self.folder)), again)

    def test_a_column_has_unit_and_meaning(self):
        import pyarrow.parquet

        self.command("convert", self.folder)
        schema = pyarrow.parquet.read_schema(self.folder / "parquet/part-0.parquet")
        self.assertEqual(schema.field("speed_kmh").metadata, {b"unit": b"km/h", b"meaning": b"speed at the beginning, drawn"})
        self.assertEqual(str(schema.field("rolled_over").type), "bool")
        self.assertIn(b"large_suv", schema.metadata[b"rsi_sil.campaign"])
        table = pyarrow.parquet.read_table(self.folder / "parquet/part-30.parquet")
        with (self.folder / "part-30.csv").open(encoding="utf-8", newline="") as file:
            next(file)
            expected = list(csv.DictReader(file))
        self.assertEqual(table.num_rows, len(expected))
        for mine, theirs in zip(table.to_pylist(), expected):
            for name, text in theirs.items():
                value = mine[name]
                kind = type(value)
                self.assertEqual(text, "") if value is None else self.assertEqual(value, kind(int(text)) if kind is bool else
                                                                                  kind(text), name)

    def test_a_converted_file_follows_its_part(self):
        self.command("convert", self.folder)
        target = self.folder / "parquet/part-0.parquet"
        before = target.stat().st_mtime_ns
        (self.folder / "parquet/part-99.parquet").write_bytes(b"of a part that is gone")
        self.command("convert", self.folder)
        self.assertEqual(target.stat().st_mtime_ns, before)
        self.assertFalse((self.folder / "parquet/part-99.parquet").exists())
        part = self.folder / "part-0.csv"
        part.touch()
        self.command("convert", self.folder)
        self.assertNotEqual(target.stat().st_mtime_ns, before)

    def test_an_own_question(self):
        said = self.command("query", self.folder, "--sql", "SELECT count(*) AS all_runs FROM runs")
        self.assertEqual(said.split(), ["all_runs", str(RUNS)])
        self.refused("--sql: ", "query", self.folder, "--sql", "SELECT nothing FROM runs")
        self.refused("there is no question worst; there are: ", "query", self.folder, "worst")
        self.refused("there are no rows of a campaign in ", "query", self.folder / "none", "missed_runs")

    def test_rows_that_are_not_as_they_were_written_are_refused(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            for name in ("campaign.toml", "part-0.csv", "part-30.csv"):
                (folder / name).write_bytes((self.folder / name).read_bytes())
            self.command("query", folder, "missed_runs")
            good = (folder / "part-30.csv").read_text(encoding="utf-8")
            lines = good.splitlines(keepends=True)
            for changed, why in ((good.replace("\n31,", "\n13,", 1), "is not the fingerprint of this row"),
                                 ("".join(lines[:-1]), "has not the rows that its first line tells"),
                                 ("".join([*lines[:-1], lines[-2]]), "has not the rows that its first line tells"),
                                 (good.replace("fingerprint ", "fingerprint f", 1), "is of another campaign")):
                self.assertNotEqual(changed, good)
                (folder / "part-30.csv").write_text(changed, encoding="utf-8")
                self.refused(why, "query", folder, "missed_runs")
                self.refused(why, "convert", folder)
            (folder / "part-30.csv").write_text(good, encoding="utf-8")
            self.command("query", folder, "missed_runs")
            (folder / "part-40.csv").write_text(good, encoding="utf-8")
            self.refused("have the same runs", "query", folder, "missed_runs")

    def test_a_damaged_part_is_named(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            (folder / "campaign.toml").write_bytes((self.folder / "campaign.toml").read_bytes())
            text = (self.folder / "part-0.csv").read_text(encoding="utf-8")
            (folder / "part-0.csv").write_text(re.sub(r"\n0,", "\nzero,", text), encoding="utf-8")
            self.refused("part-0.csv:3:", "query", folder, "missed_runs")
            (folder / "part-0.csv").write_text(text.replace("speed_kmh", "speed_mph"), encoding="utf-8")
            self.refused("part-0.csv has other columns than ", "query", folder, "missed_runs")
            with self.assertRaises(Exception) as raised:
                (folder / "part-0.csv").write_text(text.replace("fingerprint ", "fingerprint f"), encoding="utf-8")
                parts.there(folder)
            self.assertIn("part-0.csv is of another campaign", str(raised.exception))


if __name__ == "__main__":
    Asked.program = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
