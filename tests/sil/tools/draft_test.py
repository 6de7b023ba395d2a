"""A drafted mapping: what it finds by names and units, what it asks, what a log shows of the signs."""

import re
import struct
import tomllib

import drive_support
import support

import foreign_recorder
import signal_names
from bus_logs import Frame
from drive_quantities import QUANTITIES, factor_of
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
        self.assertEqual(best("bank_angle", ("BankAngle", "rad"), ("Cell_Bank_Nr", "")), ("BankAngle", True))
        self.assertEqual(best("vertical_acceleration", ("VerticalAcceleration", "m/s^2")), ("VerticalAcceleration", True))

    def test_impossible_signals_are_not_drafted(self):
        """Units of other dimensions, and names of pressures, speeds of wheels, checksums, counters, faults and objects."""
        def found(quantity, name, unit="", message="M"):
            candidate = Candidate(f"{message}.{name}", name, unit, "")
            return [signal.name for signal in signal_names.candidates(quantity, [candidate])[0]]

        load = "wheel_load_front_left"
        for quantity, name, unit in (
                (load, "TyrePressFL", ""), (load, "WheelLoadFL", "kPa"), (load, "WheelLoadFL", "kph"), (load, "WheelSpdFL", ""),
                (load, "WheelRpmFL", "rpm"), (load, "FL", ""), (load, "Obd_Flag_FL", ""), (load, "WheelPulseFL", ""),
                (load, "WheelBrakeForceFL", "N"), ("roll_angle", "BodyRoll_Cs", ""), ("roll_angle", "RollAngleCks", "deg"),
                ("roll_angle", "RollAngle_Counter", ""), ("roll_angle", "RollAngle", "%"), ("roll_rate", "RollRateErr", "deg/s"),
                ("yaw_rate", "YawRateObj", "deg/s"), ("yaw_rate", "YawRate", "deg/s^2"), ("speed", "VehSpd_Rel", "m/s"),
                ("speed", "TargetVehSpd", "m/s"), ("speed", "v_veh", "1/min"), ("lateral_acceleration", "LatAccCrc", ""),
                ("lateral_acceleration", "LatAcc_Pruefsumme", ""), ("lateral_acceleration", "FrontDistanceAccumulator", "")):
            self.assertEqual(found(quantity, name, unit), [], (quantity, name, unit))
        self.assertEqual(found("speed", "VehSpd", "m/s"), ["VehSpd"])
        self.assertEqual(found("speed", "VehSpd", "m/s", "Radar_Obj_1"), [])

    def test_names_and_units_of_other_makers_and_in_german(self):
        for quantity, name, unit in (
                ("yaw_rate", "Gierrate", "Grad/s"), ("yaw_rate", "Giergeschwindigkeit", "Grad/sek"),
                ("yaw_rate", "VehYaw_W_Actl", "rad/s"),
                ("yaw_rate", "IMU_Yaw", "deg/sec"), ("yaw_rate", "YawRte", "\u00ba/s"),
                ("yaw_rate", "YawRt", "Unit_DegreOfArcPerSecon"),
                ("lateral_acceleration", "Querbeschleunigung", "Unit_ForceOfGravi"), ("lateral_acceleration", "Acc_Lat", "m/s**2"),
                ("lateral_acceleration", "VehLat_A_Actl", "m/s^2"), ("lateral_acceleration", "Lateral", "m/s2"),
                ("roll_rate", "Wankrate", "Grad/s"), ("roll_rate", "VehRol_W_Actl", "rad/s"),
                ("roll_rate", "Inertial1RollRte", "deg/s"),
                ("roll_rate", "IMU_Roll", "deg/s"), ("roll_angle", "Wankwinkel", "Grad"), ("roll_angle", "IMU_Roll", "deg"),
                ("steering_wheel_angle", "Lenkradwinkel", "Unit_DegreOfArc"), ("steering_wheel_angle", "SteWhl_An_Est", "deg"),
                ("speed", "Fahrzeuggeschwindigkeit", "km/h"), ("speed", "Geschwindigkeit", "Km / h"),
                ("speed", "Veh_V_Actl", "kph"),
                ("speed", "v_Fzg", "km/Std"), ("vertical_acceleration", "Hochbeschleunigung", "m/s\u00b2"),
                ("wheel_load_rear_left", "Radlast HL", "kN"), ("wheel_load_front_right", "Fz_FR", "N"),
                ("vehicle_mass", "Gesamtmasse", "kg")):
            signals = [Candidate(f"M.{name}", name, unit, "")]
            self.assertEqual(signal_names.candidates(quantity, signals), (signals, True), (quantity, name))
            self.assertIsNotNone(factor_of(unit, QUANTITIES[quantity].dimension), unit)

    def test_short_names_with_units(self):
        for name, unit, quantity in (("v_mps", "m/s", "speed"), ("vx", "km/h", "speed"), ("vy_mps", "m/s", None),
                                     ("steer_hw_deg", "deg", "steering_wheel_angle"), ("steer_rw_deg", "deg", None),
                                     ("SWA", "deg", "steering_wheel_angle"), ("LWI", "Grad", "steering_wheel_angle")):
            signals = [Candidate(name, name, unit, "")]
            found = [each for each in signal_names.QUANTITIES if signal_names.candidates(each, signals)[0]]
            self.assertEqual(found, [quantity] if quantity else [], name)

    def test_unsure_signals_are_asked_for(self):
        def is_clear(quantity, name, unit="", comment="", message="M"):
            found, clear = signal_names.candidates(quantity, [Candidate(f"{message}.{name}", name, unit, comment)])
            self.assertEqual(len(found), 1, name)
            return clear

        self.assertTrue(is_clear("speed", "VehSpd", "km/h"))
        self.assertFalse(is_clear("speed", "VehSpd_Displayed", "km/h"))
        self.assertFalse(is_clear("speed", "Angez_Geschw", "km/h"))
        self.assertFalse(is_clear("yaw_rate", "Signal_1", "deg/s", "yaw rate of the vehicle"))
        self.assertFalse(is_clear("steering_wheel_angle", "Angle", "deg", message="Steering"))

    def test_a_sign_beside_a_magnitude_is_found(self):
        self.assertEqual(signal_names.sign_of("ESP_Gierrate", ["ESP_VZ_Gierrate", "ESP_VZ_Lenkw", "ESP_QBit"]), "ESP_VZ_Gierrate")
        self.assertEqual(signal_names.sign_of("Gierrate", ["Fehler", "Vorzeichen_der_Gierrate"]), "Vorzeichen_der_Gierrate")
        self.assertEqual(signal_names.sign_of("STEER_ANGLE", ["STEER_ANGLE_SIGN", "STEER_ANGLE_RATE_SIGN"]), "STEER_ANGLE_SIGN")
        self.assertEqual(signal_names.sign_of("BR5_Giergeschw", ["BR5_Vorzeichen", "BR5_Fehler"]), "BR5_Vorzeichen")
        self.assertIsNone(signal_names.sign_of("YawRate", ["SpeedSign", "AccSign", "Valid"]))
        dbc = self.folder / "magnitude.dbc"
        dbc.write_text(MAGNITUDES, encoding="utf-8")
        frames = []
        for number in range(600):  # at rest, then a ramp to the right
            degps = 2.5 * max(number - 200, 0) / 100
            data = struct.pack("<HhBHB", round(degps * 100) | (0x8000 if degps else 0), round(-degps * 350), 0, 0, 0)
            frames.append(Frame(1_700_000_000.0 + number / 100, 1, 0x101, False, data, False, False, False))
        file, _ = self.drafted("--dbc", dbc, "--log", self.written("candump", frames))
        text = file.read_text(encoding="utf-8")
        turn = re.search(r'signal = "ESP.Gierrate"\n.*\nsign = "\?"  # it is a magnitude, with its sign beside it: .*\n.* '
                         r"hardest at (\S+) s of the drive: (.*)", text)
        self.assertIsNotNone(turn, text)
        self.assertEqual(turn[2], '"-ESP.VZ_Gierrate" if that was to the left, "ESP.VZ_Gierrate" if to the right')
        self.assertTrue(5.5 < float(turn[1]) < 6.0, turn[1])
        self.assertIn("of the drive: -1 if that was to the left, 1 if to the right", text)
        # Without it, the magnitude tells no side: the lateral acceleration does.
        dbc.write_text(MAGNITUDES.replace("VZ_Gierrate", "Bit"), encoding="utf-8")
        file, _ = self.drafted("--dbc", dbc, "--log", self.folder / "recorded.candump")
        other = file.read_text(encoding="utf-8")
        self.assertRegex(other, r'signal = "ESP.Gierrate"\n.*\n# LOOK: its bits have .*\nsign = .*; the log does not show it')
        self.assertRegex(other, r'signal = "ESP.QuerBeschl"\n(#.*\n)*unit.*\nsign.*\n.*: -1 if that was to the left')
        # A magnitude without a sign beside it is asked about, and a range that leaves a side out.
        self.assertRegex(text, r'signal = "ESP.LenkradWinkel"\n(.*\n)*?# LOOK: its bits have no room for negative values; ')
        self.assertIn("# LOOK: the DBC file's range 0 to 65535 of ESP.QuerBeschl would leave ", text)

    def test_a_german_table_is_drafted(self):
        table = self.folder / "fahrt.csv"
        lines = ["Zeit [s];Geschwindigkeit [km/h];Querbeschleunigung [m/s\u00b2];Gierrate [Grad/s];Reifendruck VL [bar];"
                 "Radlast VL [N]"]
        for number in range(500):
            ay = 0.01 * number
            lines.append(f"{number / 50};72,0;{-ay};{ay * 2.865:.3f};2,2;4000".replace(".", ","))
        table.write_bytes(("\n".join(lines) + "\n").encode("cp1252"))
        file, said = self.drafted("--log", table)
        text = file.read_text(encoding="utf-8")
        self.assertIn('[time]\nsignal = "Zeit [s]"\nunit = "s"', text)
        self.assertRegex(text, r'signal = "Querbeschleunigung \[m/s\u00b2\]"\nunit = .*\nsign = "\?".*\n'
                               r"#.*: -1 if that was to the left")
        self.assertRegex(text, r'signal = "Gierrate \[Grad/s\]"\nunit = "Grad/s".*\nsign = "\?".*\n#.*: 1 if that was to the left')
        # One wheel's load alone is of no use.
        self.assertIn("3 of 13 quantities drafted", said)
        # A table whose time is not found is not said to have no values.
        table.write_bytes(table.read_bytes().replace(b"Zeit [s]", b"Nr"))
        file, _ = self.drafted("--log", table)
        self.assertNotIn("the log has no value", file.read_text(encoding="utf-8"))


MAGNITUDES = """\
VERSION ""
NS_ :
BS_:
BU_: N
BO_ 257 ESP: 8 N
 SG_ Gierrate : 0|15@1+ (0.01,0) [0|163.82] "Grad/s" N
 SG_ VZ_Gierrate : 15|1@1+ (1,0) [0|1] "" N
 SG_ QuerBeschl : 16|16@1- (0.001,0) [0|65535] "m/s^2" N
 SG_ LenkradWinkel : 40|16@1+ (0.1,0) [0|800] "Grad" N
"""

if __name__ == "__main__":
    support.main()
