"""The report of a campaign in a browser: what it shows is what runs.csv, report.json, leads.csv and curves.csv say.

Use: campaign_report_test.py RSI_SIL
"""
import csv
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from browser import browser
from study_tab import StudyTab, expect_plain_page, number_text

PROJECT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = sys.argv.pop(1)
HOSTILE = "<img src=x onerror=document.body.dataset.intruder=1>"
RUNS = 150


def rows_of(file):
    with open(file, encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(lines))


class CampaignReport(unittest.TestCase):
    """A few runs of one vehicle whose file has a hostile name, with a level so high that lift-offs are missed."""

    @classmethod
    def setUpClass(cls):
        scratch = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        home = scratch / "a user's home"
        vehicle = pathlib.Path("vehicles", f"{HOSTILE}.toml")  # of the user's folder
        (home / "vehicles").mkdir(parents=True)
        shutil.copy(PROJECT / "sil/vehicles/large_suv.toml", home / vehicle)
        cls.folder = home / "it's a campaign"
        subprocess.run([PROGRAM, "campaign", "run", "--runs", str(RUNS), "--seed", "5", "--vehicle",
                        f"{vehicle}:{PROJECT}/firmware/calibrations/large_suv.toml", "--set", "warning_on=1.15",
                        "--output", cls.folder.name],
                       cwd=home, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.report = json.loads((cls.folder / "report.json").read_text(encoding="utf-8"))
        cls.runs = rows_of(cls.folder / "runs.csv")
        cls.tab = cls.enterClassContext(browser())
        cls.tab.size(1360, 900)

    def setUp(self):
        self.tab.complaints.clear()
        self.page = StudyTab(self.tab, self.folder / "report.html")

    def tearDown(self):
        self.assertEqual(self.tab.complaints, [])

    def test_leads_are_those_of_the_file(self):
        leads = rows_of(self.folder / "leads.csv")
        self.assertIn("warning", {row["index"] for row in leads})
        for row in leads[::7]:
            of_lead = [float(each["share_with_at_least"]) for each in leads
                       if each["index"] == row["index"] and each["lead_time_s"] == row["lead_time_s"]]
            if float(row["lead_time_s"]) > 1.5:
                continue
            at, value, text = self.page.read_off("leads", row["lead_time_s"])[row["index"]]
            self.assertAlmostEqual(at, float(row["lead_time_s"]), 3)
            self.assertAlmostEqual(value, 100 * max(of_lead), 3)
            self.assertEqual(text, f"{value:.2f} %")

    def test_curves_are_those_of_the_file(self):
        curves = rows_of(self.folder / "curves.csv")
        for chart, column in (("detection", "warned_share"), ("detection_100ms", "warned_100ms_share"),
                              ("detection_200ms", "warned_200ms_share")):
            shown = [row for row in curves if float(row["false_alarm_share"]) <= 0.05]
            self.assertGreater(len(shown), 20)
            for row in shown[::19]:
                at_it = [float(each[column]) for each in shown
                         if (each["index"], each["false_alarm_share"]) == (row["index"], row["false_alarm_share"])]
                at, value, text = self.page.read_off(chart, 100 * float(row["false_alarm_share"]) + 1e-4)[row["index"]]
                self.assertAlmostEqual(at, 100 * float(row["false_alarm_share"]), 3)
                self.assertAlmostEqual(value, 100 * max(at_it), 3)
                self.assertRegex(text, r"% \(\d+\.\d{3}\)$")
        warning = self.report["all"]["indices"]["warning"]
        _, value, _ = self.page.read_off("detection_100ms", 100 * warning["false_alarms"]["share"])["warning"]
        self.assertAlmostEqual(value, 100 * warning["warned_100ms_before"]["share"], 3)

    def test_between_two_points_what_is_reached_is_read_off(self):
        for lead in (0.0555, 0.1505):
            longer = sum(bool(row["lead_time_s"]) and float(row["lead_time_s"]) >= lead for row in self.runs)
            lifted = sum(bool(row["two_wheel_lift_time_s"]) for row in self.runs)
            shown = self.page.read_off("leads", lead)["warning"][1]
            self.assertAlmostEqual(shown or 0, 100 * longer / lifted, 3)
        for index in ("published", "predicted_load_transfer"):
            for limit in self.report["all"]["indices"][index]["best"]:
                shown = self.page.read_off("detection", 100 * limit["false_alarms_at_most"])[index]
                self.assertAlmostEqual(shown[1], 100 * limit["warned"]["share"], 3)

    def test_the_line_is_drawn_as_it_is_read_off(self):
        """Between two points, the line's colour is at the value that is read off, and not on the straight way between them."""
        drawn = """((reading, range, x, y) => {
            const chart = new Chart(document.getElementById('sections'), { name: 'steps', heading: 'steps', reading,
                x: { words: 'x', from: 0, to: 10 }, y: { words: 'y', least: { from: 0, to: 100 } },
                series: [{ words: 'a', colour: '--blue', style: 'line', width: 3, points: [[2, 10], [6, 90]] }] });
            chart.showRange(range, true);
            const { frame } = chart;
            const ratio = devicePixelRatio || 1;
            const pixel = chart.canvas.getContext('2d').getImageData(ratio * frame.toX(x), ratio * frame.toY(y), 1, 1).data;
            chart.box.remove();
            return [...pixel].join() === '0,114,178,255';
        })"""
        whole = "{ from: 0, to: 10 }"
        for reading, range_, x, y, is_drawn in (
                ("last", whole, 5, 10, True), ("last", whole, 5, 70, False), ("last", whole, 9, 90, True),
                ("last", whole, 1, 10, False), ("nearest", whole, 3, 30, True), ("last", "{ from: 3, to: 5 }", 4, 10, True),
                ("next", whole, 3, 90, True), ("next", whole, 3, 30, False), ("next", whole, 1, 10, True),
                ("next", whole, 9, 90, False), ("next", "{ from: 3, to: 5 }", 4, 90, True)):
            self.assertEqual(self.page.run(f"{drawn}('{reading}', {range_}, {x}, {y})"), is_drawn, (reading, range_, x, y))
        self.assertEqual([self.page.run(f"study.charts.{name}.reading") for name in ("leads", "detection")], ["next", "last"])

    def test_tables_are_those_of_the_report(self):
        percent = lambda share: number_text(None if share["share"] is None else 100 * share["share"], 2)  # noqa: E731

        def with_interval(share):
            lowest, highest = (100 * each for each in share["confidence_95"])
            return percent(share) + ("" if share["share"] is None else f" ({lowest:.2f} to {highest:.2f})")

        shown = {row[0]: row for row in self.page.table("judgements")}
        for name, index in self.report["all"]["indices"].items():
            self.assertEqual(shown[name][1:7], [
                *(with_interval(index[key]) for key in ("warned", "warned_100ms_before", "warned_200ms_before")),
                number_text(index["lead_time_median_s"], 3), number_text(index["lead_time_10th_percentile_s"], 3),
                with_interval(index["false_alarms"])])
        for name in ("manoeuvres", "vehicles"):
            shown = {row[0]: row for row in self.page.table(name)}
            self.assertEqual(len(shown), len(self.report[name]))
            for group in self.report[name]:
                warning = group["indices"]["warning"]
                missed = warning["warned"]["of"] - warning["warned"]["count"]
                self.assertEqual(shown[group["name"]][1:6], [
                    str(group["runs"]), str(group["two_wheel_lift_offs"]), str(group["brief_two_wheel_lifts"]), str(missed),
                    percent(warning["warned"])])
        self.assertEqual(list(shown), [HOSTILE])

    def test_tables_sort_both_ways_and_keep_what_is_not_known_last(self):
        columns = self.page.columns("manoeuvres")
        for column, digits in ((columns.index("runs"), 0), (columns.index("median lead [s]"), 3)):
            for sign in (-1, 1):
                self.page.sort_by("manoeuvres", column)
                cells = [row[column] for row in self.page.table("manoeuvres")]
                known = [float(cell) for cell in cells if cell != "\u2013"]
                self.assertEqual(known, sorted(known, key=lambda value: sign * value))
                self.assertEqual(cells, [f"{value:.{digits}f}" for value in known] + ["\u2013"] * (len(cells) - len(known)))
                head = f"document.querySelectorAll('[data-table=manoeuvres] th')[{column}]"
                self.assertEqual(self.page.run(f"{head}.getAttribute('aria-sort')"), "descending" if sign < 0 else "ascending")
        self.page.sort_by("manoeuvres", 0)
        names = [row[0] for row in self.page.table("manoeuvres")]
        self.assertEqual(names[:3], sorted(names)[:3])
        self.assertLess(names.index("j-turn-45"), names.index("j-turn-110"))

    def test_missed_runs_and_the_command_that_drives_one_again(self):
        missed = [row for row in self.runs if row["two_wheel_lift_time_s"] and not row["lead_time_s"]]
        self.assertGreater(len(missed), 2)
        shown = self.page.table("missed")
        self.assertEqual([row[0] for row in shown], [row["run"] for row in missed])
        for row, of_file in zip(shown, missed):
            self.assertEqual(row[1:4], [HOSTILE, of_file["manoeuvre"], f"{float(of_file['two_wheel_lift_time_s']):.3f}"])
        elsewhere = self.enterContext(tempfile.TemporaryDirectory())
        subprocess.run(["/bin/sh", "-c", shown[0][-1]], cwd=elsewhere, check=True, stdout=subprocess.DEVNULL)
        again = self.folder / f"run-{missed[0]['run']}"
        self.assertEqual(rows_of(again / "row.csv"), [missed[0]])
        self.assertTrue((again / "report.html").is_file())

    def test_by_keyboard_and_by_pointer(self):
        self.page.run("study.charts.leads.canvas.focus()")
        self.tab.key("Home")
        self.assertEqual(self.page.run("study.charts.leads.readout.textContent"), "lead: 0.000 s")
        self.tab.key("ArrowRight", modifiers=8)
        self.assertEqual(self.page.run("study.charts.leads.readout.textContent"), "lead: 0.075 s")
        self.tab.key("+")
        self.assertAlmostEqual(self.page.run("study.charts.leads.range.to - study.charts.leads.range.from"), 0.75)
        self.tab.key("-")
        self.assertAlmostEqual(self.page.run("study.charts.leads.range.to"), 1.5)
        button = "document.querySelector('[data-chart=leads] [data-series=warning]')"
        self.page.run(f"{button}.click()")
        self.assertEqual(self.page.run(f"{button}.getAttribute('aria-pressed')"), "false")
        box = self.page.run("(() => { const box = study.charts.detection.canvas.getBoundingClientRect();"
                            "return [box.left, box.top, box.width]; })()")
        for kind, share in (("mousePressed", 0.3), ("mouseMoved", 0.6), ("mouseReleased", 0.6)):
            self.tab.call("Input.dispatchMouseEvent", type=kind, x=box[0] + share * box[2], y=box[1] + 90, button="left",
                          buttons=1, clickCount=1)
        chosen = self.page.run("study.charts.detection.range")
        self.assertAlmostEqual(chosen["to"] - chosen["from"], 5 * 0.3 * box[2] / (box[2] - 64), 2)
        self.page.run("document.querySelector('[data-chart=detection] .whole').click()")
        self.assertEqual(self.page.run("study.charts.detection.range"), {"from": 0, "to": 5})

    def test_is_a_plain_page(self):
        expect_plain_page(self, self.tab, self.folder / "report.html")

    def test_alarms_in_calm_runs(self):
        with tempfile.TemporaryDirectory() as scratch:
            levels = ("warning_on=0.7", "warning_off=0.6", "advisory_on=0.65", "advisory_off=0.6")
            options = [word for level in levels for word in ("--set", level)]
            subprocess.run([PROGRAM, "campaign", "run", "--runs", "40", "--output", scratch, *options],
                           cwd=PROJECT, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            calm = [row for row in rows_of(pathlib.Path(scratch, "runs.csv"))
                    if not row["two_wheel_lift_time_s"] and float(row["largest_ltr"]) < 0.9 and int(row["warnings"]) > 0]
            self.assertGreater(len(calm), 1)
            page = StudyTab(self.tab, pathlib.Path(scratch, "report.html"))
            report = json.loads(pathlib.Path(scratch, "report.json").read_text(encoding="utf-8"))
            alarms = 100 * report["all"]["indices"]["warning"]["false_alarms"]["share"]
            self.assertGreater(alarms, 5)
            for name in ("detection", "detection_100ms", "detection_200ms"):
                self.assertAlmostEqual(page.run(f"study.charts.{name}.series[0].points[0][0]"), alarms, 3)
                self.assertLess(alarms, page.run(f"study.charts.{name}.frame.x.to"))
            shown = page.table("false_alarms")
            self.assertEqual([(row[0], row[6]) for row in shown], [(row["run"], row["warnings"]) for row in calm])

    def test_without_lift_offs_there_is_a_page_too(self):
        with tempfile.TemporaryDirectory() as scratch:
            for runs, settings in (("1", []), ("1", ["--settings", PROJECT / "sil/studies/campaign/ordinary.toml"])):
                folder = pathlib.Path(scratch, str(len(settings)))
                subprocess.run([PROGRAM, "campaign", "run", "--runs", runs, "--output", folder, *settings], cwd=PROJECT, check=True,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                page = StudyTab(self.tab, folder / "report.html")
                self.assertEqual(page.table("missed"), [])
                self.assertIn("There are none.", page.text())


if __name__ == "__main__":
    unittest.main(verbosity=1)
