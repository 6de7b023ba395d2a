"""Drives of foreign logs: every container and a foreign DBC file give the warnings of the run; missing values are reported."""

import itertools
import json
import math
import random

import drive_support
import support

import bus_logs
import foreign_recorder
from drive_quantities import QUANTITIES
from own_mapping import OWN_DBC, OWN_MAPPING


class Drive(drive_support.WithDrives):
    def test_every_container_with_its_own_dbc_gives_the_warnings_of_the_run(self):
        warnings = self.replay(self.original)
        self.assertIn("warning,right", warnings)
        frames = list(bus_logs.BusLog(self.original).frames())
        for kind in ("blf", "asc", "mf4", "candump"):
            drive, said = self.drive(self.written(kind, frames), dbc=OWN_DBC, mapping=self.mapping(OWN_MAPPING))
            self.assertEqual(self.replay(drive), warnings, kind)
            self.assertIn("none missing", said)

    def test_a_foreign_dbc_gives_them_through_its_mapping(self):
        warnings = self.replay(self.original)
        for kind in ("blf", "asc", "mf4", "candump"):
            drive, said = self.drive(self.written(kind, foreign_recorder.frames(self.run_folder)))
            self.assertEqual(self.replay(drive), warnings, kind)
            self.assertRegex(said, r"speed_kmh +WHEELSPEED\.VehSpd +20 ")

    def test_calendar_times_become_those_since_the_first_value(self):
        frames = foreign_recorder.frames(self.run_folder, 1_700_000_000.123456)
        for kind in ("candump", "blf", "mf4"):
            drive, said = self.drive(self.written(kind, frames))
            self.assertEqual(self.replay(drive), self.replay(self.original), kind)
            start = "time_s is the time since 1700000000.123456 s in the log, 2023-11-14T22:13:20.123456+00:00"
            self.assertIn(f"\n{start}\n", said)
            self.assertIn(f"\n# {start}\n", drive.read_text(encoding="utf-8"))

    def test_jitter_losses_and_half_the_rate_move_the_warning_little(self):
        chance = random.Random(1)
        expected = [line.split(",") for line in self.replay(self.original).splitlines()[1:]]
        numbers = itertools.count()
        for name, change in (
                ("jitter", lambda frame: frame._replace(time_s=frame.time_s + chance.uniform(0.0, 0.003))),
                ("losses", lambda frame: frame if chance.random() > 0.02 else None),
                ("half the rate", lambda frame: frame if not frame.extended or next(numbers) % 2 == 0 else None)):
            frames = [changed for changed in map(change, foreign_recorder.frames(self.run_folder)) if changed]
            drive, _ = self.drive(self.written("candump", sorted(frames, key=lambda frame: frame.time_s)))
            replayed = [line.split(",") for line in self.replay(drive).splitlines()[1:]]
            self.assertEqual([row[1:] for row in replayed], [row[1:] for row in expected], name)
            for row, other in zip(replayed, expected):
                self.assertAlmostEqual(float(row[0]), float(other[0]), delta=0.021, msg=name)

    def test_a_lag_before_the_log_begins(self):
        lagging = foreign_recorder.MAPPING.replace("sign = -1", "sign = -1\nlag_ms = 15", 1).replace(
            'RollVelocity"', 'RollVelocity"\nlag_ms = 15')
        drive, _ = self.drive(self.written("candump", foreign_recorder.frames(self.run_folder)), mapping=self.mapping(lagging))
        self.assertEqual([row["time_s"] for row in self.rows(drive)][:3], ["-0.015000", "-0.005000", "0.005000"])
        self.replay(drive)

    def test_missing_frames_are_gaps_and_counted(self):
        def kept(frame):
            is_imu = frame.extended and 0.5 < frame.time_s < 0.7
            return not is_imu and not (frame.identifier == 0x402 and 0.9 < frame.time_s < 1.3)

        frames = [frame for frame in foreign_recorder.frames(self.run_folder) if kept(frame)]
        drive, said = self.drive(self.written("candump", frames))
        times_s = [float(row["time_s"]) for row in self.rows(drive)]
        self.assertEqual([time_s for time_s in times_s if 0.501 < time_s < 0.699], [])
        self.assertIn(0.5, times_s)
        self.assertIn(0.7, times_s)
        self.assertRegex(said, r"lateral_acceleration_mps2 .* 19 +1 +0\.200 +0 ")
        self.assertIn("; 19 left out, where lateral_acceleration or roll_rate is missing", said)
        empty = [row["time_s"] for row in self.rows(drive) if row["speed_kmh"] == ""]
        self.assertRegex(said, rf"speed_kmh .* 7 +1 +0\.400 +{len(empty)} ")
        self.assertEqual((empty[0], empty[-1]), ("0.910000", "1.290000"))
        self.replay(drive)
        summary = json.loads((self.folder / "replayed/made/drive/summary.json").read_text(encoding="utf-8"))
        self.assertGreater(summary["silent_cycles"], 15)

    def test_parts_of_a_recording_are_one_drive(self):
        frames = foreign_recorder.frames(self.run_folder)
        whole, _ = self.drive(self.written("candump", frames))
        rows = self.rows(whole)
        parts = [self.written(kind, part) for kind, part in (("candump", frames[:400]), ("blf", frames[400:]))]
        joined, _ = self.drive(*parts)
        self.assertEqual(self.rows(joined), rows)
        self.drive_refused(f"{parts[0]}: the time runs back from 3.060000 s to 0.000000 s: ", parts[1], parts[0])

    def test_every_quantity_is_a_column_that_replays_know(self):
        columns = ["time_s"] + [quantity.column for quantity in QUANTITIES.values()]
        value = {"vertical_acceleration_mps2": 9.81, "speed_kmh": 50.0, "vehicle_mass_kg": 2500.0}
        values = [str(value.get(column, 1000.0 if "load" in column else 0.0)) for column in columns[1:]]
        rows = [",".join([f"{number / 100:.2f}"] + values) for number in range(200)]
        file = self.folder / "all" / "drive.csv"
        file.parent.mkdir()
        file.write_text("\n".join([",".join(columns)] + rows) + "\n", encoding="utf-8")
        self.replay(file)
        summary = json.loads((self.folder / "replayed/all/drive/summary.json").read_text(encoding="utf-8"))
        self.assertEqual(summary["ignored_columns"], [])

    def test_signals_that_contradict_each_other_are_told(self):
        log = self.written("candump", foreign_recorder.frames(self.run_folder))
        _, said = self.drive(log)
        self.assertNotIn("LOOK", said)
        wrong_unit = foreign_recorder.MAPPING.replace('unit = "rad"', 'unit = "deg"')
        _, said = self.drive(log, mapping=self.mapping(wrong_unit))
        self.assertRegex(said, r"roll_rate and the change of roll_angle: correlation \+1\.00, ratio 5\d.*LOOK: the ratio")
        self.assertIn("signals contradict each other", said)
        wrong_sign = foreign_recorder.MAPPING.replace("sign = -1", "sign = 1", 1)
        _, said = self.drive(log, mapping=self.mapping(wrong_sign))
        self.assertRegex(said, r"lateral_acceleration and yaw_rate times speed: correlation -.*LOOK: they run against each other")
        downwards = foreign_recorder.MAPPING.replace('ESP_Dynamics.VertAcc"\nsign = -1', 'ESP_Dynamics.VertAcc"')
        _, said = self.drive(log, mapping=self.mapping(downwards))
        self.assertRegex(said, r"vertical_acceleration is -9\.8\d? m/s\^2 in the first second: LOOK")

    def test_unknown_options_are_refused_with_status_2(self):
        for command in ("convert", "draft", "drive", "decode"):
            with self.assertRaises(SystemExit) as raised:
                self.logs(command, "a", "--no-such-option")
            self.assertEqual(raised.exception.code, 2, command)

    def test_identify_takes_a_drive(self):
        columns = "time_s,lateral_acceleration_mps2,roll_rate_degps,roll_angle_deg,speed_kmh,yaw_rate_degps," \
                  "vertical_acceleration_mps2,steering_wheel_angle_deg"
        drive, _ = self.drive(self.written("candump", foreign_recorder.frames(self.run_folder)))
        lines = drive.read_text(encoding="utf-8").splitlines()
        self.assertEqual(lines[1], columns)
        self.assertTrue(all(math.isfinite(float(row["steering_wheel_angle_deg"] or 0.0)) for row in self.rows(drive)))
        data = support.PROJECT / "sil/vehicles/data/large_suv.toml"
        support.call(self.program, "identify", "--vehicle-data", data, "--ramp", drive, "--dynamic", drive, "--output",
                     self.folder / "identified")
        self.assertTrue((self.folder / "identified/calibration.toml").exists())


if __name__ == "__main__":
    support.main()
