"""A drafted mapping: what it finds by names and units, what it asks, what a log shows of the signs."""

import re
import tomllib

import drive_support
import support

import foreign_recorder
import signal_names
from own_mapping import OWN_DBC
from signal_names import Candidate


class Draft(drive_support.WithDrives):
    def drafted(self, *arguments):
        file = self.folder / "drafted.toml"
        file.unlink(missing_ok=True)
        said = self.logs("draft", *arguments, "--output", file)
        return file, said

    def test_names_and_units_find_the_signals(self):
        for dbc, expected in ((foreign_recorder.DBC, tomllib.loads(foreign_recorder.MAPPING)), (OWN_DBC, {
                "lateral_acceleration": {"signal": "Imu.LateralAcceleration"}, "speed": {"signal": "VehicleMotion.Speed"},
                "vehicle_mass": {"signal": "VehicleMass.Mass"}})):
            file, said = self.drafted("--dbc", dbc)
            tables = tomllib.loads(file.read_text(encoding="utf-8"))
            for quantity, table in expected.items():
                found = tables[quantity]["signal"]
                if found == "?":
                    candidates = re.search(rf"\[{quantity}\]\n# candidates: (.*)", file.read_text(encoding="utf-8"))[1]
                    self.assertIn(f"{table['signal']} [", candidates)
                else:
                    self.assertEqual(found, table["signal"])
            self.assertIn(f"{file}: ", said)

    def test_a_draft_is_refused_until_it_is_answered(self):
        file, said = self.drafted("--dbc", foreign_recorder.DBC)
        self.assertIn("8 of 13 quantities drafted, 8 questions", said)
        log = self.written("candump", foreign_recorder.frames(self.run_folder))
        text = file.read_text(encoding="utf-8")
        lines = text.splitlines()
        for number, line in enumerate(lines, 1):
            if '= "?"' not in line:
                continue
            file.write_text("\n".join(other if other == line else other.replace('sign = "?"', "sign = 1").replace(
                'unit = "?"', 'unit = "rad"') for other in lines), encoding="utf-8")
            first = next(place for place, other in enumerate(lines, 1) if other == line)
            said = self.drive_refused(f"{file}:{first}: ", log, mapping=file)
            self.assertIn("is not answered yet: ", said)
            self.assertLessEqual(first, number)

    def test_the_log_shows_the_signs_and_the_answers_give_the_warnings(self):
        slalom = self.folder / "slalom"
        support.call(self.program, "run", "slalom", "--in-process", "--vehicle", support.PROJECT / "sil/vehicles/large_suv.toml",
                     "--parameters", support.CALIBRATION, "--output", slalom)
        file, _ = self.drafted("--dbc", foreign_recorder.DBC, "--log", self.written("blf", foreign_recorder.frames(slalom)))
        text = file.read_text(encoding="utf-8")
        turn_s = float(re.search(r"the log turns hardest at (\S+) s of the drive: ", text)[1])
        is_left = next(row["yaw_rate_degps"] > 0.0 for row in foreign_recorder.rows(slalom) if row["time_s"] > turn_s)
        text, answered = re.subn(r'sign = "\?"(.*\n#.* hardest at \S+ s of the drive: (\S+) if that was to the left, (\S+) if to)',
                                 r"sign = \2\1" if is_left else r"sign = \3\1", text)
        self.assertEqual(answered, 5)
        log = self.written("blf", foreign_recorder.frames(self.run_folder))
        text = text.replace('unit = "?"', 'unit = "rad"\nfactor = 0.0001\nlag_ms = 30')
        self.drive_refused(f"{self.mapping(text)}:", log, mapping=self.mapping(text))  # the bank angle's sign
        text = text.replace('sign = "?"', "sign = 1")
        tables = tomllib.loads(text)
        for quantity, expected in tomllib.loads(foreign_recorder.MAPPING).items():
            self.assertEqual(tables[quantity].get("sign", 1), expected.get("sign", 1), quantity)
        drive, said = self.drive(log, mapping=self.mapping(text))
        self.assertNotIn("LOOK", said)
        self.assertEqual(self.replay(drive), self.replay(self.original))

    def test_the_columns_of_a_csv_are_drafted(self):
        file, _ = self.drafted("--log", self.run_folder / "signals.csv")
        text = file.read_text(encoding="utf-8")
        self.assertIn('[time]\nsignal = "time_s"\nunit = "s"', text)
        self.assertRegex(text, r"\[yaw_rate\]\n# candidates: .*sensor_yaw_rate_degps \[degps\]")
        self.assertRegex(text, r'\[yaw_rate\]\n.*\n.*\nunit = "degps".*\nsign = "\?".*\n#.*: 1 if that was to the left, -1 if '
                               r'to the right')

    def test_two_buses_are_asked_for(self):
        both = [frame._replace(bus=bus) for frame in foreign_recorder.frames(self.run_folder) for bus in (1, 2)]
        file, _ = self.drafted("--dbc", foreign_recorder.DBC, "--log", self.written("blf", both))
        self.assertEqual(file.read_text(encoding="utf-8").count('bus = "?"  # it comes on the buses 1, 2'), 8)

    def test_errors_are_reported(self):
        output = self.folder / "none.toml"
        self.refused("draft needs a DBC file (--dbc FILE), or a log", "draft", "--output", output)
        self.refused(f"{self.original}: has no frame of any message of {foreign_recorder.DBC}; ",
                     "draft", "--dbc", foreign_recorder.DBC, "--log", self.original, "--output", output)
        self.refused(f"{self.original}: holds frames (candump), so your DBC file is needed: --dbc FILE",
                     "draft", "--log", self.original, "--output", output)
        self.assertFalse(output.exists())
        output.write_text("answered", encoding="utf-8")
        self.refused(f"{output}: exists already, perhaps with answers in it; ",
                     "draft", "--dbc", foreign_recorder.DBC, "--output", output)
        self.assertEqual(output.read_text(encoding="utf-8"), "answered")

    def test_names(self):
        def best(quantity, *signals):
            known = [Candidate(f"M.{name}", name, unit, "") for name, unit in signals]
            found, is_clear = signal_names.candidates(quantity, known)
            return (found[0].name if found else None), is_clear

        self.assertEqual(best("lateral_acceleration", ("LongAcc", "m/s^2"), ("AY", "g"), ("YawRate", "deg/s")), ("AY", True))
        self.assertEqual(best("lateral_acceleration", ("LatAcc", "g"), ("LatAccQuality", ""), ("LatAccOffset", "g")),
                         ("LatAcc", True))
        self.assertEqual(best("lateral_acceleration", ("LatAcc", "g"), ("Lat_Accel", "m/s^2"))[1], False)
        self.assertEqual(best("yaw_rate", ("YawRate", "V")), ("YawRate", True))
        self.assertEqual(best("yaw_rate", ("YawRate", "m/s"), ("YawRate2", "kg")), (None, False))
        self.assertEqual(best("yaw_rate", ("YawAcceleration", "deg/s^2"), ("Yaw", "deg")), (None, False))
        self.assertEqual(best("speed", ("EngineSpeed", "rpm"), ("WheelSpeedFL", "km/h"), ("WheelBasedVehicleSpeed", "km/h")),
                         ("WheelBasedVehicleSpeed", True))
        self.assertEqual(best("steering_wheel_angle", ("SteeringWheelAngleSpeed", "deg/s"), ("SteeringWheelAngle", "deg")),
                         ("SteeringWheelAngle", True))
        self.assertEqual(best("roll_angle", ("RollRate", "deg/s"), ("RollAngle", "deg")), ("RollAngle", True))
        self.assertEqual(best("vehicle_mass", ("GrossCombinationVehicleWeight", "kg")), ("GrossCombinationVehicleWeight", True))
        self.assertEqual(best("wheel_load_rear_left", ("WheelLoadFL", "N"), ("WheelLoadRL", "N")), ("WheelLoadRL", True))
        self.assertEqual(best("bank_angle", ("BankAngle", "rad")), ("BankAngle", True))
        self.assertEqual(best("vertical_acceleration", ("VerticalAcceleration", "m/s^2")), ("VerticalAcceleration", True))


if __name__ == "__main__":
    support.main()
