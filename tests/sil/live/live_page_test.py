"""A live drive in a browser: by keyboard alone to the rollover, and what is seen is what the files say.

Use: live_page_test.py RSI_SIL
"""
import csv
import json
import pathlib
import sys
import tempfile
import unittest

from live_program import PROJECT, live_drive

sys.path.insert(0, str(PROJECT / "tests/sil/page"))

import screens  # noqa: E402
from browser import browser  # noqa: E402

PROGRAM = sys.argv.pop(1)
LONG_S = 300  # on a machine that does other things, too
STATE = "document.getElementById('lamp').dataset.state"
SIDE = "document.getElementById('lamp').dataset.side"


class LivePage(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.drive = live_drive(PROGRAM, self.folder, "--speed", "80")
        self.port = self.drive.__enter__()
        self.driving = True
        self.tab = self.enterContext(browser())
        self.tab.size(1360, 900)
        self.open()

    def open(self):
        self.tab.open(f"http://127.0.0.1:{self.port}/")
        self.tab.wait_for("document.body.dataset.mode === 'live' && page.recording.length > 20")

    def end(self):
        """The drive, by SIGINT; its files are whole then."""
        if self.driving:
            self.driving = False
            self.drive.__exit__(None, None, None)

    def tearDown(self):
        self.end()

    def rows(self):
        with open(self.folder / "signals.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def time(self):
        return self.tab.run("page.recording.lastTime")

    def begin_again(self, load):
        self.tab.run(f"(() => {{ const load = document.getElementById('load'); load.value = {load};"
                     "load.dispatchEvent(new Event('input')); })()")
        self.tab.key("n")
        self.tab.wait_for(f"page.recording.head.vehicle.roof_load_kg === {load} && page.recording.length > 20", LONG_S)

    def test_a_drive_by_keyboard_warns_before_the_vehicle_rolls_over(self):
        self.begin_again(150)
        self.tab.key("ArrowRight", "down")
        self.tab.wait_for(f"{STATE} === 'warning'", LONG_S)
        self.assertEqual(self.tab.run(SIDE), "left")
        self.tab.wait_for("document.getElementById('notice').textContent.includes('rolled over')", LONG_S)
        self.tab.key("ArrowRight", "up")
        events = json.loads(self.tab.run("JSON.stringify(page.recording.events)"))
        lead = self.tab.run("page.recording.judgement.lead_time_s")
        self.assertLess(events["warning"]["time_s"], events["two_wheel_lift"]["time_s"])
        self.assertGreater(lead, 0.0)
        seen = json.loads(self.tab.run("JSON.stringify({columns: page.recording.head.columns, rows: page.recording.rows})"))
        self.end()
        summary = json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))
        self.assertEqual(summary["lead_time_s"], lead)
        self.assertEqual(summary["noise"], "noise")
        self.assertEqual(summary["warning_time_s"], events["warning"]["time_s"])
        written = self.rows()
        self.assertEqual(float(written[-1]["time_s"]), seen["rows"][-1][0])
        of_time = {float(row["time_s"]): row for row in written}
        for row in seen["rows"]:
            for column, value in zip(seen["columns"], row):
                cell = of_time[row[0]][column]
                self.assertEqual("" if value is None else value, cell if isinstance(value, str) or cell == "" else float(cell), column)
        self.assertTrue((self.folder / "report.html").is_file())
        self.assertEqual(self.tab.complaints, [])

    def test_sensors_break_and_mend_by_keyboard(self):
        choose = ("(() => {{ const list = document.getElementById('{0}');"
                  "list.value = [...list.options].find((each) => each.textContent === '{1}').value;"
                  "list.dispatchEvent(new Event('change')); }})()")
        self.tab.run(choose.format("fault-place", "roll angle"))
        self.tab.run(choose.format("fault-kind", "not available"))
        self.tab.run("document.activeElement.blur()")
        self.tab.key("f")
        self.tab.wait_for("document.getElementById('fault-now').textContent === 'roll angle: not available'", LONG_S)
        self.tab.wait_for("document.getElementById('codes').textContent.includes('roll angle')", LONG_S)
        self.tab.wait_for("document.getElementById('degradation').textContent.includes('without the roll sensor')", LONG_S)
        self.tab.key("g")
        self.tab.wait_for("document.getElementById('fault-now').textContent === 'all sensors good'", LONG_S)
        self.tab.wait_for("document.getElementById('degradation').textContent.includes('works fully')", LONG_S)
        self.assertEqual(self.tab.run("document.getElementById('heals').textContent"), "3")
        self.assertEqual(self.tab.complaints, [])

    def test_brakes_on_a_warning_by_key_and_button(self):
        pressed = "document.getElementById('brake').getAttribute('aria-pressed')"
        self.assertEqual(self.tab.run(pressed), "false")
        self.tab.key("b")
        self.tab.wait_for(f"{pressed} === 'true'", LONG_S)
        self.tab.run("document.getElementById('brake').click()")
        self.tab.wait_for(f"{pressed} === 'false'", LONG_S)
        self.assertEqual(self.tab.complaints, [])

    def test_steers_by_slider_and_key_pauses_and_looks_back(self):
        self.tab.key("ArrowUp")
        self.assertEqual(self.tab.run("document.getElementById('speed-text').textContent"), "85 km/h")
        self.tab.run("(() => { const wheel = document.getElementById('steering'); wheel.value = -30;"
                     "wheel.dispatchEvent(new Event('input')); })()")
        self.tab.wait_for("page.recording.value('steering', page.recording.length - 1) === 30", LONG_S)
        self.tab.wait_for("page.recording.value('speed', page.recording.length - 1) > 84", LONG_S)
        self.tab.key("p")
        self.tab.wait_for("document.getElementById('hold').getAttribute('aria-pressed') === 'true'", LONG_S)
        before = self.time()
        self.tab.wait_for("page.view.to === page.recording.lastTime && page.view.from === page.recording.firstTime", LONG_S)
        self.tab.run("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        self.assertEqual(self.time(), before)
        self.tab.run("(() => { const time = document.getElementById('time'); time.value = 3;"
                     "time.dispatchEvent(new Event('input')); })()")
        self.assertEqual(self.tab.run("page.view.row"), 3)
        self.assertEqual(self.tab.run("document.getElementById('follow').getAttribute('aria-pressed')"), "false")
        self.tab.key("p")
        self.tab.wait_for(f"page.recording.lastTime > {before}", LONG_S)
        self.assertEqual(self.tab.run("page.view.row"), 3)
        self.tab.key("l")
        self.tab.wait_for("page.view.time === page.recording.lastTime", LONG_S)
        self.assertEqual(self.tab.complaints, [])

    def test_lamp_faults_and_keys_are_in_sight_together(self):
        self.tab.run("(() => { const list = document.getElementById('fault-place'); list.selectedIndex = 3;"
                     "list.dispatchEvent(new Event('change')); list.blur(); })()")
        self.tab.key("f")
        self.tab.wait_for("document.getElementById('degradation').textContent.includes('without the roll sensor')", LONG_S)
        for width in screens.each_screen(self.tab):
            self.tab.wait_for(f"innerWidth === {width}")
            self.tab.wait_for("page.recording.length > 20")
            more = ["#degradation"] if width > 390 else []
            screens.expect_layout(self, self.tab, ["#lamp", "#lead", "#scene", "#fault-place", "#fault-kind", "#fault-set",
                                                   "#fault-clear", "#fault-now", "#heals", "#brake", "#hint", "#steering", "#again",
                                                   *more], "#controls")
            for key in "\u2190\u2192\u2191\u2193":
                self.assertIn(key, self.tab.run("document.getElementById('hint').innerText"))
        self.assertEqual(self.tab.complaints, [])

    def test_fits_a_phone(self):
        self.tab.size(390, 844, phone=True)
        self.open()
        self.assertLessEqual(self.tab.run("document.documentElement.scrollWidth"), 390)
        self.assertNotEqual(self.tab.run("getComputedStyle(document.getElementById('steering')).display"), "none")
        # Panels of the past are folded away while driving, and only then.
        folded = "getComputedStyle(document.getElementById('transport')).display === 'none'"
        self.tab.wait_for(folded, LONG_S)
        self.tab.run("document.getElementById('follow').click()")
        self.assertFalse(self.tab.run(folded))
        self.tab.key("l")
        self.assertTrue(self.tab.run(folded))
        self.tab.key("p")
        self.tab.wait_for(f"!({folded})", LONG_S)
        self.tab.key("p")
        self.tab.wait_for(folded, LONG_S)
        self.tab.size(1360, 900)
        self.assertFalse(self.tab.run(folded))
        self.assertEqual(self.tab.complaints, [])

    def test_says_when_the_vehicle_is_gone(self):
        self.tab.wait_for(f"{STATE} === 'ready'", LONG_S)
        self.end()
        self.tab.wait_for(f"{STATE} === 'lost'", LONG_S)
        self.assertEqual(self.tab.run("document.getElementById('lamp-text').textContent"), "no connection")
        self.assertRegex(self.tab.run("document.getElementById('notice').textContent"), "program .* has ended.*sil/run --watch")
        self.assertEqual(self.tab.run("document.getElementById('follow').getAttribute('aria-pressed')"), "false")
        self.assertTrue(self.tab.run("['follow', 'again', 'steering', 'fault-set'].every((id) =>"
                                     "document.getElementById(id).disabled)"))
        self.tab.key("ArrowLeft")
        self.assertEqual(self.tab.run(STATE), "ready")
        self.assertEqual(self.tab.run("page.view.row"), self.tab.run("page.recording.length - 2"))
        self.tab.key("End")
        self.assertEqual(self.tab.run(STATE), "lost")
        self.assertEqual(self.tab.complaints, [])


if __name__ == "__main__":
    unittest.main()
