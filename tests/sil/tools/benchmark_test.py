"""The benchmark's page, from small campaigns: its figures and intervals are those of the campaign's own report."""

import contextlib
import io
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(PROJECT / "sil/studies/benchmark")]

import page  # noqa: E402

RUNS = 80


class Benchmark(unittest.TestCase):
    program = None

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = pathlib.Path(scratch.name)
        cls.vehicles = []
        for number in range(page.judge.fewest_vehicles() + 2):  # as many as it takes for intervals that count vehicles
            name = ("large_suv", "ordinary_suv", "van")[number % 3]
            vehicle = cls.scratch / f"{name}_{number}.toml"
            shutil.copy(PROJECT / f"sil/vehicles/{name}.toml", vehicle)
            cls.vehicles += ["--vehicle", f"{vehicle}:{PROJECT}/firmware/calibrations/{name}.toml"]
        cls.chosen, cls.reported = cls.drive("choose", 1), cls.drive("report", 2)
        entries = cls.scratch / "entries"
        entries.mkdir()
        (entries / "never_warns.csv").write_text("run,time_s,side\n0,1,none\n", encoding="utf-8")
        with contextlib.redirect_stderr(io.StringIO()):
            page.main([cls.program, cls.chosen, cls.reported, entries, cls.scratch / "page.md", cls.scratch / "data"])
        cls.text = (cls.scratch / "page.md").read_text(encoding="utf-8")
        cls.indices = json.loads((cls.reported / "report.json").read_text(encoding="utf-8"))["all"]["indices"]

    @classmethod
    def drive(cls, name, seed):
        subprocess.run([cls.program, "campaign", "run", *cls.vehicles, "--runs", str(RUNS), "--seed", str(seed), "--set",
                        "warning_on=0.85", "--set", "forecast_share=0", "--traces", "--output", cls.scratch / name],
                       cwd=PROJECT, check=True, capture_output=True, timeout=300)
        return cls.scratch / name

    def rows(self, section):
        lines = self.text.split(f"## {section}")[1].split("\n## ")[0].splitlines()
        split = ([cell.strip() for cell in line.split("|")] for line in lines)
        return {cells[1]: cells[2:-1] for cells in split if len(cells) > 8}

    def test_figures_and_intervals_are_those_of_the_report(self):
        rows = self.rows("As each says itself")
        self.assertEqual(set(rows) - {"", "---"}, {page.FIRMWARE, *self.indices} - {"warning"})
        for name, index in self.indices.items():
            row = rows[page.FIRMWARE if name == "warning" else name]
            for cell, key in zip(row, ("warned", "warned_100ms_before", "warned_200ms_before")):
                low, high = index[key]["confidence_95"]
                self.assertEqual(cell, f"{100 * index[key]['share']:.1f} ({100 * low:.1f} to {100 * high:.1f})", (name, key))

    def test_thresholds_are_of_the_other_half(self):
        row = self.rows("At equal alarms")["predicted_load_transfer"]
        connection = page.query.open_rows(self.chosen, self.program)
        alarms, runs = connection.execute("SELECT count(*) FILTER (warnings > 0), count(*) FROM drawn WHERE band = '0.8 to 0.9'"
                                          ).fetchone()
        reached = connection.execute("SELECT count(*) FROM drawn WHERE band = '0.8 to 0.9' AND "
                                     f"predicted_load_transfer_threshold >= {row[0]} - 0.0005").fetchone()[0]
        self.assertGreater(alarms, 0)
        self.assertLess(alarms, runs)
        self.assertGreaterEqual(reached, alarms)

    def test_another_entry_stands_in_table_and_picture(self):
        self.assertTrue(self.rows("At equal alarms")["never warns"][1].startswith("0.0 ("))
        self.assertIn('"never warns"\n0.00 0.00\n', (self.scratch / "data.points").read_text(encoding="utf-8"))
        self.assertIn('"published"\n', (self.scratch / "data.curves").read_text(encoding="utf-8"))
        self.assertNotIn("@", self.text.replace("@{", ""))

    def test_the_series_are_those_that_were_driven(self):
        connection = page.query.duckdb.connect()
        series = f"read_parquet('{self.reported / 'series.parquet'}')"
        self.assertEqual(connection.execute(f"SELECT count(DISTINCT run) FROM {series}").fetchone()[0], RUNS)
        lines = (self.reported / "traces/7.csv").read_text(encoding="utf-8").splitlines()
        self.assertEqual(connection.execute(f"SELECT count(*) FROM {series} WHERE run = 7").fetchone()[0], len(lines) - 3)


if __name__ == "__main__":
    Benchmark.program = pathlib.Path(sys.argv.pop(1)).resolve()
    page.judge.use(Benchmark.program)
    unittest.main()
