"""The report of a run in a browser: what it shows at a time is that row of signals.csv.

Use: report_test.py RSI_SIL
"""
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import screens
from browser import browser

PROJECT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = sys.argv.pop(1)
LARGEST_REPORT_BYTES = 1_500_000  # of ten seconds
STANDARD_GRAVITY = 9.80665

# Display of a quantity: the column, the factor, the digits, and the unit.
SHOWN = {
    "speed": ("true_speed_mps", 3.6, 1, " km/h"),
    "steering": ("true_steering_wheel_angle_deg", 1, 1, " deg"),
    "acceleration": ("true_lateral_acceleration_mps2", 1 / STANDARD_GRAVITY, 3, " g"),
    "threshold": ("ecu_lateral_acceleration_threshold_mps2", 1 / STANDARD_GRAVITY, 3, " g"),
    "level": ("ecu_warning_level", 1, 3, ""),
    "rsi": ("ecu_rsi", 1, 3, ""),
    "roll": ("true_roll_angle_deg", 1, 2, " deg"),
    "rollRate": ("true_roll_rate_degps", 1, 1, " deg/s"),
}
WHEELS = ("front_left", "front_right", "rear_left", "rear_right")


def run(folder, manoeuvre, *options):
    """Drives it in one process; its rows and its summary."""
    subprocess.run([PROGRAM, "run", manoeuvre, "--in-process", "--vehicle", PROJECT / "sil/vehicles/large_suv.toml",
                    "--parameters", PROJECT / "firmware/calibrations/large_suv.toml", "--output", folder, *options],
                   check=True, stdout=subprocess.DEVNULL)
    with open(folder / "signals.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    return rows, json.loads((folder / "summary.json").read_text(encoding="utf-8"))


class Report(unittest.TestCase):
    """A turn to the left that ends in a rollover to the right, and its mirror image."""

    @classmethod
    def setUpClass(cls):
        scratch = cls.enterClassContext(tempfile.TemporaryDirectory())
        cls.folder = pathlib.Path(scratch, "turn")
        cls.rows, cls.summary = run(cls.folder, "j-turn-110")
        cls.mirror = pathlib.Path(scratch, "mirror")
        cls.mirror_rows, cls.mirror_summary = run(cls.mirror, "j-turn-110", "--mirror")
        cls.tab = cls.enterClassContext(browser())

    def setUp(self):
        self.tab.complaints.clear()
        self.tab.size(1360, 900)
        self.tab.theme("light")

    def tearDown(self):
        self.assertEqual(self.tab.complaints, [])

    def open(self, folder=None, moment=""):
        self.tab.open((folder or self.folder).as_uri() + "/report.html" + moment)

    def seek(self, row):
        self.tab.run(f"(() => {{ const slider = document.getElementById('time'); slider.value = {row};"
                     "slider.dispatchEvent(new Event('input')); })()")

    def seen(self):
        """All texts and values that the page shows."""
        return json.loads(self.tab.run("""JSON.stringify({
            time: document.getElementById('time-text').textContent,
            lamp: document.getElementById('lamp-text').textContent,
            state: document.getElementById('lamp').dataset.state,
            side: document.getElementById('lamp').dataset.side,
            announced: document.getElementById('announcement').textContent,
            lead: document.getElementById('lead').textContent,
            degradation: document.getElementById('degradation').textContent,
            values: Object.fromEntries([...document.querySelectorAll('#values td, #loads .wheel')].map((each) =>
                [each.dataset.quantity, [each.dataset.column, each.dataset.value,
                                         (each.querySelector('.amount') ?? each).textContent]])),
        })"""))

    def expect_row(self, rows, number):
        """The visible row, as it was written and as it is read."""
        row = rows[number]
        seen = self.seen()
        self.assertEqual(seen["time"], f"{float(row['time_s']):.2f} s")
        self.assertEqual((seen["state"], seen["side"]), (row["ecu_state"], row["ecu_side"]))
        for quantity, (column, factor, digits, unit) in SHOWN.items():
            named, value, text = seen["values"][quantity]
            self.assertEqual(named, column)
            if row[column] == "":
                self.assertEqual((value, text), ("", "\u2013"))
                continue
            self.assertEqual(float(value), float(row[column]), f"{quantity} in row {number}")
            shown = float(text.removesuffix(unit).replace("\u2212", "-"))
            self.assertLessEqual(abs(shown - factor * float(row[column])), 0.5001 * 10 ** -digits, quantity)
        for wheel in WHEELS:
            named, value, text = seen["values"]["load_" + wheel]
            load = float(row[f"true_wheel_load_{wheel}_n"])
            self.assertEqual((named, float(value)), (f"true_wheel_load_{wheel}_n", load))
            self.assertEqual(text, "lifted" if load <= 0 else f"{load / 1000:.1f} kN")

    def test_each_row_is_that_of_the_file(self):
        self.open()
        self.assertEqual(self.tab.run("document.getElementById('time').max"), str(len(self.rows) - 1))
        for row in [*range(0, len(self.rows), 9), len(self.rows) - 1]:
            self.seek(row)
            self.expect_row(self.rows, row)

    def test_the_mirror_image_names_the_other_side(self):
        self.open(self.mirror)
        row = next(number for number, each in enumerate(self.mirror_rows) if each["ecu_state"] == "warning")
        self.seek(row)
        self.expect_row(self.mirror_rows, row)
        self.assertEqual(self.seen()["lamp"], "warning, left side")

    def test_the_warning_its_lead_and_the_moments(self):
        self.open()
        moments = json.loads(self.tab.run("JSON.stringify(Object.fromEntries([...document.querySelectorAll("
                                          "'#events button')].map((each) => [each.dataset.event, each.dataset.value])))"))
        for event in ("warning", "one_wheel_lift", "two_wheel_lift", "ssf_crossing"):
            self.assertEqual(float(moments[event]), self.summary[event + "_time_s"])
        self.assertEqual(self.seen()["lead"],
                         f"warned of the right side {self.summary['lead_time_s']:.3f} s before two wheels lift at "
                         f"{self.summary['two_wheel_lift_time_s']:.3f} s")
        self.tab.key("Home")
        self.assertEqual((self.seen()["lamp"], self.seen()["announced"]), ("cannot warn", ""))
        self.tab.run("document.querySelector('[data-event=warning]').click()")
        self.assertEqual(self.seen()["announced"], "warning, right side")

    def test_ranges_go_on_after_a_lift_off_and_leave_out_a_fall(self):
        """A drive in which two wheels lift, the driver recovers, steers more than before, and then falls over."""
        self.open()
        self.tab.run("""(() => {
            const columns = ['time_s', 'true_steering_wheel_angle_deg', 'true_roll_angle_deg', 'true_lateral_acceleration_mps2'];
            const rows = [[0, 0, 0, 0], [1, 50, 25, 5], [9, -350, 1, -9], [9.5, 0, 30, 90], [10, 0, 50, 90]];
            page.show(new Recording({ ...page.recording.head, columns, rows,
                                      events: { two_wheel_lift: { time_s: 1, ay_g: 0.5, roll_deg: 25 } } }), false);
        })()""")
        ranges = json.loads(self.tab.run("JSON.stringify(Object.fromEntries(page.strips.filter((each) => !each.box.hidden)"
                                         ".map((each) => [each.name, each.frame.y])))"))
        self.assertLess(ranges["steering"]["from"], -350)
        self.assertLess(ranges["acceleration"]["from"], -9 / STANDARD_GRAVITY)
        self.assertLess(ranges["acceleration"]["to"], 2)
        self.assertGreater(ranges["roll"]["to"], 25)
        self.assertLess(ranges["roll"]["to"], 30)

    def test_axes_have_two_numbers_besides_zero(self):
        self.open()
        for low, high in ((-381.6, 381.6), (-360, 360), (-21.2, 21.2), (0, 1.22), (-0.9, 1), (-9.9, 0), (0.3, 1.1), (101, 102)):
            for wanted in (2, 3.3, 9):
                numbers = self.tab.run(f"ticks({low}, {high}, {wanted}).all")
                self.assertGreaterEqual(len([each for each in numbers if each != 0]), 2, (low, high, wanted))
                self.assertLessEqual(len(numbers), 2 * wanted + 3, (low, high, wanted))
                self.assertGreaterEqual(min(numbers), low - 1e-6)
                self.assertLessEqual(max(numbers), high + 1e-6)

    def test_opens_at_the_warning(self):
        for folder, rows, side in ((self.folder, self.rows, "right"), (self.mirror, self.mirror_rows, "left")):
            self.open(folder)
            self.expect_row(rows, next(number for number, each in enumerate(rows) if each["ecu_state"] == "warning"))
            self.assertEqual(self.seen()["lamp"], f"warning, {side} side")

    def show(self, columns, rows, events):
        self.tab.run(f"(() => {{ page.show(new Recording({{ ...page.recording.head, columns: {json.dumps(columns)}, "
                     f"rows: {json.dumps(rows)}, events: {json.dumps(events)} }}), false); page.goToHeart(); }})()")

    def test_opens_without_a_warning_where_wheels_lift_or_at_the_hardest_moment(self):
        self.open()
        columns = ["time_s", "true_lateral_acceleration_mps2", "ecu_state", "ecu_side"]
        rows = [[0, 0, "ready", "none"], [1, -5, "ready", "none"], [2, None, "ready", "none"], [3, 4, "ready", "none"]]
        for events, row in (({"two_wheel_lift": {"time_s": 2.5}}, 3), ({}, 1)):
            self.show(columns, rows, events)
            self.assertEqual(self.tab.run("page.view.row"), row)
        self.assertEqual(self.seen()["lead"], "no two wheels of a side have lifted")

    def test_a_warning_without_a_lift_off_names_its_side(self):
        self.open()
        self.show(["time_s", "ecu_state", "ecu_side"], [[0, "ready", "none"], [1, "warning", "left"], [2, "ready", "none"]],
                  {"warning": {"time_s": 1}})
        self.assertEqual(self.seen()["lead"], "warned of the left side; no two wheels of a side have lifted")
        self.show(["time_s", "true_speed_mps"], [[0, 1], [1, 1]], {"warning": {"time_s": 1}})
        self.assertEqual(self.seen()["lead"], "warned; no two wheels of a side have lifted")

    def test_on_a_straight_noise_does_not_move_the_threshold_to_the_other_side(self):
        self.open()
        self.show(["time_s", "true_lateral_acceleration_mps2", "ecu_lateral_acceleration_threshold_mps2"],
                  [[0, 0.1, 8], [1, -0.1, -8], [1.5, -0.1, -8], [2, 5, 8], [3, -0.1, -8], [4, -5, -8], [5, 0.1, 8]], {})
        self.assertEqual(self.tab.run("page.recording.rows.reduce((sides, _, row) =>"
                                      "[...sides, page.recording.sideAt(row, sides.at(-1))], [1]).join()"), "1,1,1,1,1,1,-1,-1")
        below = ("(() => { const { canvas, frame } = page.strips.find((each) => each.name === 'acceleration'); const zero = frame.toY(0);"
                 "const data = canvas.getContext('2d').getImageData(frame.toX(0.5), zero + 20, frame.toX(3) - frame.toX(0.5), 20).data;"
                 "return data.some((_, place) => place % 4 === 0 && data[place + 3] > 0 && data[place] > 180 && data[place + 1] < 110); })()")
        self.assertFalse(self.tab.run(below))
        self.assertTrue(self.tab.run(below.replace("zero + 20", "frame.top").replace(", 20).data", ", zero - 10).data")))

    def test_a_vehicle_that_falls_stays_in_its_panel(self):
        columns = ["time_s", "true_roll_angle_deg", "true_bank_angle_deg", *(f"true_wheel_gap_{wheel}_m" for wheel in WHEELS)]
        edges = ("(() => { const { canvas } = page.scene; const pen = canvas.getContext('2d');"
                 "const above = canvas.height * 0.7; return [[0, 0, 2, above], [canvas.width - 2, 0, 2, above], [0, 0, canvas.width, 2]]"
                 ".filter((box) => pen.getImageData(...box).data.some((byte) => byte > 0)).length; })()")
        self.open()
        for width, phone in ((1440, False), (390, True)):
            self.tab.size(width, 900, phone)
            for roll, bank in ((70, 0), (-70, 0), (45, 0), (-110, 0), (70, 8), (-30, -8)):
                gap = 1.6 * math.sin(math.radians(abs(roll)))
                gaps = [gap, 0, gap, 0] if roll > 0 else [0, gap, 0, gap]
                self.show(columns, [[0, roll, bank, *gaps], [1, roll, bank, *gaps]], {})
                self.tab.run("page.render()")
                self.assertEqual(self.tab.run(edges), 0, (width, roll, bank))

    def test_lines_of_indices_are_those_of_all_pictures(self):
        self.open()
        with open(PROJECT / "sil/results/index_styles.csv", encoding="utf-8", newline="") as file:
            styles = {row["index"]: row for row in csv.DictReader(file)}
        lines = json.loads(self.tab.run("JSON.stringify(STRIPS.find((each) => each.name === 'level').lines)"))
        for line, index in zip(lines, ("published", "predicted_load_transfer"), strict=True):
            self.assertEqual((line["colour"], "dash" in line), ("--" + styles[index]["colour"], styles[index]["dash"] == "2"))

    def test_opens_at_the_moment_in_the_address(self):
        self.open(moment=f"#{self.rows[200]['time_s']}")
        self.expect_row(self.rows, 200)

    def test_the_ecus_own_reports(self):
        self.open()
        self.seek(len(self.rows) - 1)
        self.assertIn(self.seen()["degradation"], ("works fully", "works without the roll sensor"))
        dbc = (PROJECT / "can_dbc/rollover_warning.dbc").read_text(encoding="utf-8")
        names = re.findall('"([^"]+)"', re.search(r"^VAL_ \d+ Degradation (.*);", dbc, re.MULTILINE).group(1))
        self.assertEqual(sorted(json.loads(self.tab.run("JSON.stringify(Object.keys(DEGRADATION_WORDS))"))), sorted(names))

    def test_by_keyboard_alone(self):
        self.open()
        for key, row in (("End", len(self.rows) - 1), ("ArrowLeft", len(self.rows) - 2), ("Home", 0), ("ArrowRight", 1)):
            self.tab.key(key)
            self.expect_row(self.rows, row)
        self.tab.key("1")
        self.assertEqual(self.seen()["state"], "warning")
        self.tab.key("Home")
        focused = []
        for _ in range(4):
            self.tab.key("Tab")
            focused.append(self.tab.run("document.activeElement.id || document.activeElement.className"))
        self.assertEqual(focused[:3], ["skip", "theme", "help"])
        self.assertNotEqual(self.tab.run("getComputedStyle(document.activeElement).outlineStyle"), "none")

    def test_plays_in_both_directions(self):
        self.open()
        last = len(self.rows) - 1
        self.tab.run("document.getElementById('pace').value = '10';"
                     "document.getElementById('pace').dispatchEvent(new Event('change'))")
        self.tab.key(" ")
        self.tab.wait_for("document.getElementById('play').textContent === 'Play'")
        self.expect_row(self.rows, last)
        self.tab.key("r")
        self.tab.key(" ")
        self.tab.wait_for("document.getElementById('play').textContent === 'Play'")
        self.expect_row(self.rows, 0)

    def test_lamp_sentence_scene_and_controls_are_in_sight_together(self):
        self.open()
        for width in screens.each_screen(self.tab):
            self.tab.run("window.scrollTo(0, 0)")
            wide = ["#plane", "#strips", "#values"] if width == 1440 else []
            screens.expect_layout(self, self.tab, ["#lamp", "#lead", "#events", "#scene", "#play", "#time", *wide], "#controls")

    def test_fits_a_phone_and_both_themes(self):
        for theme, ground in (("light", "rgb(244, 245, 246)"), ("dark", "rgb(16, 19, 22)")):
            self.tab.theme(theme)
            self.tab.size(390, 844, phone=True)
            self.open()
            self.assertEqual(self.tab.run("getComputedStyle(document.body).backgroundColor"), ground)
            self.assertLessEqual(self.tab.run("document.documentElement.scrollWidth"), 390)
            self.assertEqual(self.tab.run("[...document.querySelectorAll('canvas')].filter((each) =>"
                                          "!each.getContext('2d').getImageData(0, 0, each.width, each.height)"
                                          ".data.some((byte) => byte > 0)).length"), 0)

    def test_loads_nothing_and_runs_nothing_else(self):
        text = (self.folder / "report.html").read_text(encoding="utf-8")
        for outside in ("http:", "https:", "src=\"", "@import", "url("):
            self.assertNotIn(outside, text)
        self.open()
        self.assertEqual(self.tab.run("performance.getEntriesByType('resource').length"), 0)
        self.tab.run("(() => { const other = document.createElement('script');"
                     "other.textContent = 'document.body.dataset.intruder = 1'; document.body.append(other); })()")
        self.assertIsNone(self.tab.run("document.body.dataset.intruder ?? null"))
        self.tab.call("Runtime.evaluate", expression="0")
        self.assertTrue(any("Content Security Policy" in each for each in self.tab.complaints), self.tab.complaints)
        self.tab.complaints.clear()

    def test_ten_seconds_are_small(self):
        with tempfile.TemporaryDirectory() as scratch:
            rows, _ = run(pathlib.Path(scratch), "slalom", "--duration", "10")
            self.assertEqual(len(rows), 1001)
            self.assertLess(pathlib.Path(scratch, "report.html").stat().st_size, LARGEST_REPORT_BYTES)


if __name__ == "__main__":
    unittest.main(verbosity=1)
