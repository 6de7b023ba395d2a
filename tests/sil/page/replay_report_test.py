"""The report of a replay in a browser: what it shows is that row of indices.csv, and what is not known is hidden and named.

Use: replay_report_test.py RSI_SIL
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from browser import browser

PROJECT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = sys.argv.pop(1)
STANDARD_GRAVITY = 9.80665
CALIBRATION = PROJECT / "firmware/calibrations/large_suv.toml"
HOSTILE = "<img src=x onerror=document.body.dataset.intruder=1>"
BARE = ("time_s", "sensor_lateral_acceleration_mps2", "sensor_roll_rate_degps", "sensor_roll_angle_deg")
WITHOUT_ROLL = ("time_s", "sensor_lateral_acceleration_mps2", "sensor_roll_rate_degps", "sensor_speed_mps",
                "sensor_yaw_rate_degps")
WHEELS = ("front_left", "front_right", "rear_left", "rear_right")
SHOWN = {
    "speed": ("sensor_speed_mps", 3.6, 1, " km/h"),
    "steering": ("sensor_steering_wheel_angle_deg", 1, 1, " deg"),
    "acceleration": ("lateral_acceleration_mps2", 1 / STANDARD_GRAVITY, 3, " g"),
    "threshold": ("lateral_acceleration_threshold_mps2", 1 / STANDARD_GRAVITY, 3, " g"),
    "level": ("warning_level", 1, 3, ""),
    "rsi": ("rsi", 1, 3, ""),
    "loadTransfer": ("measured_load_transfer_ratio", 1, 3, ""),
    "roll": ("sensor_roll_angle_deg", 1, 2, " deg"),
    "rollRate": ("sensor_roll_rate_degps", 1, 1, " deg/s"),
}


def rows_of(file):
    with open(file, encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(lines))


class ReplayReport(unittest.TestCase):
    """A simulated turn as if it had been recorded: with wheel loads, without a roll angle, and with hardly anything."""

    @classmethod
    def setUpClass(cls):
        scratch = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        subprocess.run([PROGRAM, "run", "j-turn-110", "--in-process", "--vehicle", PROJECT / "sil/vehicles/large_suv.toml",
                        "--parameters", CALIBRATION, "--output", scratch / "run"], check=True, stdout=subprocess.DEVNULL)
        drives = [scratch / "run/signals.csv"]
        rows = rows_of(drives[0])
        for name, columns in (("bare", BARE), ("without_roll", WITHOUT_ROLL)):
            drives.append(scratch / f"{name}.csv")
            with open(drives[-1], "w", encoding="utf-8", newline="") as file:
                writer = csv.DictWriter(file, (*columns, HOSTILE), extrasaction="ignore", lineterminator="\n")
                writer.writeheader()
                writer.writerows({**row, HOSTILE: "1"} for row in rows)
        cls.folder = scratch / HOSTILE.replace("/", "")
        subprocess.run([PROGRAM, "replay", *drives, "--parameters", CALIBRATION, "--output", cls.folder, "--no-pictures"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.tab = cls.enterClassContext(browser())
        cls.tab.size(1360, 900)

    def tearDown(self):
        self.assertEqual(self.tab.complaints, [])

    def setUp(self):
        self.tab.complaints.clear()

    def open(self, drive):
        self.tab.open((self.folder / drive / "report.html").as_uri())

    def seek(self, row):
        self.tab.run(f"(() => {{ const slider = document.getElementById('time'); slider.value = {row};"
                     "slider.dispatchEvent(new Event('input')); })()")

    def is_hidden(self, selector):
        return self.tab.run(f"document.querySelector({json.dumps(selector)}).closest('[hidden]') !== null")

    def text(self, name):
        return self.tab.run(f"document.getElementById({json.dumps(name)}).textContent")

    def facts(self):
        return dict(json.loads(self.tab.run("JSON.stringify([...document.querySelectorAll('#facts tr')].map((row) =>"
                                            "[row.firstChild.textContent, row.lastChild.textContent]))")))

    def expect_row(self, row, quantities):
        for quantity in quantities:
            column, factor, digits, unit = SHOWN[quantity]
            named, value, text = json.loads(self.tab.run(
                f"(() => {{ const cell = document.querySelector('#values [data-quantity={quantity}]');"
                "return JSON.stringify([cell.dataset.column, cell.dataset.value, cell.textContent]); })()"))
            self.assertEqual(named, column)
            if row[column] == "":
                self.assertEqual((value, text), ("", "\u2013"), quantity)
                continue
            self.assertEqual(float(value), float(row[column]), quantity)
            self.assertLessEqual(abs(float(text.removesuffix(unit).replace("\u2212", "-")) - factor * float(row[column])),
                                 0.5001 * 10 ** -digits, quantity)

    def test_each_row_is_that_of_the_file(self):
        self.open("signals")
        rows = rows_of(self.folder / "signals/indices.csv")
        self.assertEqual(self.text("lamp-text"), "warning, right side")
        self.tab.key("Home")
        self.assertEqual(self.text("time-text"), f"{float(rows[0]['time_s']):.2f} s")
        self.assertEqual(self.tab.run("document.getElementById('time').max"), str(len(rows) - 1))
        lifted = set()
        for number in [*range(0, len(rows), 17), len(rows) - 1]:
            self.seek(number)
            row = rows[number]
            self.expect_row(row, SHOWN)
            self.assertEqual(self.tab.run("document.getElementById('lamp').dataset.state"), row["state"])
            self.assertEqual(self.tab.run("document.getElementById('lamp').dataset.side"), row["side"])
            for wheel in WHEELS:
                load = float(row[f"measured_wheel_load_{wheel}_n"])
                text = self.tab.run(f"document.querySelector('#loads [data-quantity=load_{wheel}] .amount').textContent")
                if text == "lifted":
                    lifted.add(wheel)
                    self.assertLess(load, 300)
                else:
                    self.assertEqual(text, f"{load / 1000:.1f} kN")
        self.assertIn("front_left", lifted)

    def test_the_wheel_loads_are_those_of_the_drive(self):
        measured = rows_of(self.folder / "signals/indices.csv")
        for row, of_run in zip(measured[:100], rows_of(self.folder.parent / "run/signals.csv")):
            for wheel in WHEELS:
                self.assertAlmostEqual(float(row[f"measured_wheel_load_{wheel}_n"]),
                                       float(of_run[f"true_wheel_load_{wheel}_n"]), 4)

    def test_the_verdict_and_its_reasons(self):
        for drive in ("signals", "bare", "without_roll"):
            self.open(drive)
            summary = json.loads((self.folder / drive / "summary.json").read_text(encoding="utf-8"))
            facts = self.facts()
            self.assertEqual(facts["Verdict"], summary["verdict"])
            self.assertEqual(facts["Unavailable"], f"{summary['unavailable_duration_s']:.3f} s")
            self.assertEqual(facts["Confirmed codes"], "; ".join(summary["confirmed_codes"]) or "none")
            self.assertTrue(facts["Warnings"].startswith(f"{summary['warning_side']} at {summary['warning_time_s']:.3f} s"), facts["Warnings"])
            known = summary["lift_off_source"] != "unknown"
            self.assertEqual(facts["Two-wheel lift-off"], f"{summary['two_wheel_lift_time_s']:.3f} s" if known else "not known")
            self.assertIn(summary["verdict"], self.text("subtitle"))

    def test_unknown_values_are_named_and_not_drawn(self):
        self.open("bare")
        self.assertTrue(self.is_hidden("#loads"))
        self.assertTrue(self.is_hidden("[data-strip=steering]"))
        self.assertTrue(self.is_hidden("#values [data-quantity=speed]"))
        self.assertFalse(self.is_hidden("#scene"))
        self.assertEqual(self.text("lead"), "warned of the right side; whether wheels lifted is not known")
        self.assertIn("Not recorded, and not shown: steering wheel angle, speed, bank of the road, wheel loads.",
                      self.text("remarks"))
        self.assertIn("Whether wheels lifted is not known", self.text("remarks"))
        self.seek(0)
        self.expect_row(rows_of(self.folder / "bare/indices.csv")[0], ("acceleration", "level", "roll"))
        self.open("signals")
        self.assertFalse(self.is_hidden("#loads"))
        self.assertNotIn("wheel loads", self.text("remarks"))

    def test_without_a_roll_sensor_the_observers_angle_is_shown_as_such(self):
        self.open("without_roll")
        rows = rows_of(self.folder / "without_roll/indices.csv")
        self.seek(150)
        cell = "document.querySelector('#values [data-quantity=roll]').dataset"
        self.assertEqual(self.tab.run(f"{cell}.column"), "observed_roll_angle_deg")
        self.assertEqual(float(self.tab.run(f"{cell}.value")), float(rows[150]["observed_roll_angle_deg"]))
        self.assertIn("No roll angle was recorded. Shown is the angle to the road that the component observes.",
                      self.text("remarks"))
        self.assertIn("observer", self.tab.run("document.querySelector('[data-line=roll]').textContent"))

    def test_an_angle_against_the_horizon_is_not_shown_as_that_to_the_road(self):
        with tempfile.TemporaryDirectory() as scratch:
            subprocess.run([PROGRAM, "replay", self.folder.parent / "run/signals.csv", "--parameters", CALIBRATION, "--output",
                            scratch, "--set", "roll_angle_reference=horizon", "--no-pictures"], check=True, capture_output=True)
            self.tab.open(pathlib.Path(scratch, "signals/report.html").as_uri())
            self.assertEqual(self.tab.run("document.querySelector('#values [data-quantity=roll]').dataset.column"),
                             "observed_roll_angle_deg")
            self.assertTrue(self.tab.run("page.recording.head.columns.every((name) => name !== 'sensor_roll_angle_deg')"))
            self.assertIn("The recorded roll angle is relative to the horizon.", self.text("remarks"))

    def test_a_gap_draws_nothing_of_the_vehicle(self):
        with tempfile.TemporaryDirectory() as scratch:
            rows = [f"{count / 100:.2f},{'' if 100 <= count < 200 else 0.02}\n" for count in range(300)]
            drive = pathlib.Path(scratch, "gap.csv")
            drive.write_text("time_s,roll_angle_rad,lateral_acceleration_g,roll_rate_degps,speed_kmh,yaw_rate_degps\n" +
                             "".join(row.rstrip("\n") + ",0.02,0,50,0\n" for row in rows), encoding="utf-8")
            subprocess.run([PROGRAM, "replay", drive, "--parameters", CALIBRATION, "--output", scratch, "--no-pictures"],
                           check=True, capture_output=True)
            self.tab.open(pathlib.Path(scratch, "gap/report.html").as_uri())
            self.seek(150)
            cell = "document.querySelector('#values [data-quantity=roll]').textContent"
            self.assertEqual(self.tab.run(cell), "\u2013")
            # Neither the wheels nor the body in their colours: there is a sentence in grey.
            painted = ("(() => { const scene = document.getElementById('scene'); const { data } = scene.getContext('2d')"
                       ".getImageData(0, 0, scene.width, scene.height); let count = 0;"
                       "for (let place = 3; place < data.length; place += 4) { count += data[place] > 0 ? 1 : 0; }"
                       "return count; })()")
            without = self.tab.run(painted)
            self.seek(50)
            self.assertEqual(self.tab.run(cell), "+1.15 deg")
            self.assertGreater(self.tab.run(painted), 5 * without)

    def test_hostile_names_are_text(self):
        self.open("bare")
        self.assertEqual(self.facts()["Columns not used"], HOSTILE[:40] + "...")
        self.assertEqual(self.tab.run("document.querySelectorAll('img').length"), 0)
        self.assertIsNone(self.tab.run("document.body.dataset.intruder ?? null"))
        self.assertEqual(self.tab.run("performance.getEntriesByType('resource').length"), 0)

    def test_an_hour_is_thinned_out(self):
        with tempfile.TemporaryDirectory() as scratch:
            drive = pathlib.Path(scratch, "long.csv")
            drive.write_text("time_s,lateral_acceleration_g,roll_rate_degps,roll_angle_deg\n" +
                             "".join(f"{count / 100:.2f},0.01,0,0\n" for count in range(8002)), encoding="utf-8")
            subprocess.run([PROGRAM, "replay", drive, "--parameters", CALIBRATION, "--output", scratch, "--no-pictures"],
                           check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            self.tab.open(pathlib.Path(scratch, "long/report.html").as_uri())
            rows = rows_of(pathlib.Path(scratch, "long/indices.csv"))
            self.assertEqual(self.tab.run("document.getElementById('time').max"), str((len(rows) + 1) // 2 - 1))
            self.seek(1000)
            self.expect_row(rows[2000], ("acceleration",))


if __name__ == "__main__":
    unittest.main(verbosity=1)
