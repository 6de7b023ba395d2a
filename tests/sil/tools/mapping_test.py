"""Bad mappings, DBC files and logs are refused by a sentence with the place; nothing is written."""

import math
import struct

import drive_support
import support

import foreign_recorder
from bus_logs import Frame

MAPPING = foreign_recorder.MAPPING


class Refusals(drive_support.WithDrives):
    def setUp(self):
        super().setUp()
        self.log = self.written("candump", foreign_recorder.frames(self.run_folder))

    def bad_mapping(self, text, expected):
        file = self.mapping(text)
        said = self.drive_refused(f"{file}{expected}", self.log, mapping=file)
        self.assertFalse((self.folder / "made/drive.csv").exists())
        return said

    def test_mappings(self):
        change = MAPPING.replace
        self.bad_mapping(change('"ESP_Dynamics.LatAcc_Raw"', "ESP_Dynamics.LatAcc_Raw"), ":2:10: this is no TOML (")
        self.bad_mapping("", ":1: there is no quantity; ")
        self.bad_mapping("yaw = 3\n", ":1: yaw is no quantity of a drive; ")
        self.bad_mapping("[roll_rat]\n", ":1: roll_rat is no quantity of a drive; close to it: roll_rate")
        self.bad_mapping("\nroll_rate = 3\n", ":2: roll_rate must be a table: ")
        self.bad_mapping(change("unit =", "units ="), ":15: roll_angle.units is not known; there are signal, unit, ")
        said = self.bad_mapping(change("LatAcc_Raw", "LatAc_Raw"), ":2: lateral_acceleration.signal is "
                                                                   "'ESP_Dynamics.LatAc_Raw', but ")
        self.assertIn(f"{foreign_recorder.DBC} has no such signal; close to it: ESP_Dynamics.LatAcc_Raw", said)
        self.bad_mapping(change("ESP_Dynamics.LatAcc_Raw", "LatAcc_Raw"), ":2: lateral_acceleration.signal is 'LatAcc_Raw', but ")
        self.bad_mapping(change("ESP_Dynamics.LatAcc_Raw", " "), ":2: lateral_acceleration.signal must be a text in quotation "
                                                                 "marks")
        self.bad_mapping(change('signal = "CLUSTER_3.GierRate"\n', "sign = 1\n"), ":22: yaw_rate has no key signal; add ")
        self.bad_mapping(change('"rad"', '"m/s"'), ":15: roll_angle.unit is 'm/s', but must be one of deg, rad, mrad; ")
        self.bad_mapping(change('unit = "rad"\n', ""), ":13: roll_angle.signal is ATTITUDE.BodyRoll, whose unit in the log or "
                                                       "DBC file (none) does not do; add unit = one of deg, rad, mrad")
        self.bad_mapping(change("sign = -1", "sign = 0", 1), ":3: lateral_acceleration.sign must be 1 ")
        self.bad_mapping(change("sign = -1", "sign = true", 1), ":3: lateral_acceleration.sign must be 1 ")
        self.bad_mapping(change("sign = -1", 'sign = "?"', 1), ":3: lateral_acceleration.sign is not answered yet: ")
        self.bad_mapping(change("factor = 0.0001", "factor = 0"), ":14: roll_angle.factor is 0: ")
        self.bad_mapping(change("factor = 0.0001", "factor = -1"), ":14: roll_angle.factor is negative; ")
        self.bad_mapping(change("factor = 0.0001", "factor = nan"), ":14: roll_angle.factor must be a finite number")
        self.bad_mapping(change("factor = 0.0001", "factor = 'a'"), ":14: roll_angle.factor must be a finite number")
        self.bad_mapping(change("factor = 0.0001", "factor = 1e300"), ":13: roll_angle.signal is ATTITUDE.BodyRoll, and "
                                                                      "roll_angle_deg becomes ")
        self.bad_mapping(change("factor = 0.0001", "factor = 1e306"), ":13: roll_angle.signal is ATTITUDE.BodyRoll, and "
                                                                      "roll_angle_deg becomes ")
        self.bad_mapping(change("lag_ms = 30", "lag_ms = -30"), ":17: roll_angle.lag_ms is -30, but must be from 0 to 1000: ")
        self.bad_mapping(change("bus = 2", "bus = 2.0"), ":28: steering_wheel_angle.bus must be the bus's number")
        self.bad_mapping(MAPPING.split("[roll_rate]")[0], ": there is no table [roll_rate], and every drive needs it")
        self.bad_mapping(MAPPING.split("[roll_angle]")[0], ": there is no table [roll_angle], nor both [speed] and [yaw_rate]; ")
        self.bad_mapping(MAPPING + '[wheel_load_rear_left]\nsignal = "a.b"\n', ": only 1 of the four wheel loads are mapped; "
                                                                               "add [")
        gear = change("WHEELSPEED.VehSpd", "WHEELSPEED.GearSelector")
        self.bad_mapping(gear, f":20: speed.signal is WHEELSPEED.GearSelector, whose values are texts ({foreign_recorder.DBC}: "
                               "P, R, N, ...)")
        file = self.mapping()
        file.write_bytes(b"\xff\xfe")
        self.drive_refused(f"{file}: is no text in UTF-8 (byte 0)", self.log, mapping=file)
        none = self.folder / "none.toml"
        self.drive_refused(f"{none}: cannot be read: No such file", self.log, mapping=none)

    def test_dbc_files(self):
        def bad_dbc(content, expected):
            file = self.folder / "bad.dbc"
            file.write_bytes(content)
            self.drive_refused(f"{file}{expected}", self.log, dbc=file)

        bad_dbc(b"", ": the file is empty; ")
        bad_dbc(b'VERSION ""\n', ": has no messages of a CAN bus; ")
        bad_dbc(b"BO_ 12 Message: 8 Node\n SG_ Broken : 0|8@1+ (1,0 [0|1] \"\" Node\n", ":2:27: this is no DBC file that can be "
                                                                                        "read: ")
        bad_dbc(bytes(range(256)), ":1:1: this is no DBC file that can be read: ")
        self.drive_refused(f"{self.folder}: cannot be read: it is no ordinary file", self.log, dbc=self.folder)
        self.drive_refused(f"{self.folder / 'none.dbc'}: cannot be read: No such file", self.log, dbc=self.folder / "none.dbc")

    def test_logs(self):
        frames = foreign_recorder.frames(self.run_folder)

        def bad_log(changed, expected):
            log = self.written("candump", changed)
            self.drive_refused(f"{log}: {expected}", log)

        bad_log([], "the file is empty; ")
        bad_log([frame._replace(identifier=0x77) for frame in frames],
                "there is no frame of ESP_Dynamics (0x18FEF3FE in ")
        back = [frame._replace(time_s=frame.time_s - 1.5) if frame.time_s > 2.0 else frame for frame in frames]
        bad_log(back, "the time runs back from 2.000000 s to 0.502000 s: ")
        bad_log(frames[:400] + [frame._replace(time_s=frame.time_s + 9000.0) for frame in frames[400:]], "a gap of 9000 s after ")
        slow = [frame for number, frame in enumerate(frames) if not frame.extended or round(frame.time_s * 100) % 5 == 0]
        log = self.written("candump", slow)
        self.drive_refused(f"{self.folder}/mapping.toml:2: lateral_acceleration.signal is ESP_Dynamics.LatAcc_Raw, which comes "
                           f"every 50 ms in {log}; the component needs it every 20 ms at least", log)
        once = [frame for frame in frames if not frame.extended] + [next(frame for frame in frames if frame.extended)]
        log = self.written("candump", sorted(once, key=lambda frame: frame.time_s))
        self.drive_refused(f"{self.folder}/mapping.toml:2: lateral_acceleration.signal is ESP_Dynamics.LatAcc_Raw, which comes "
                           "once in ", log)
        short = [frame._replace(data=frame.data[:1]) if frame.extended else frame for frame in frames]
        bad_log(short, "there is no value of ESP_Dynamics.LatAcc_Raw in 304 frames of ESP_Dynamics; ")
        outside = [frame._replace(data=b"\x7f\xff" + frame.data[2:]) if frame.extended else frame for frame in frames]
        bad_log(outside, "every value of ESP_Dynamics.LatAcc_Raw is outside -2 to 2, the DBC file's range: ")
        self.drive_refused(f"{self.folder / 'none.blf'}: cannot be read: No such file", self.folder / "none.blf")

    def test_two_buses(self):
        both = [frame._replace(bus=bus) for frame in foreign_recorder.frames(self.run_folder) for bus in (1, 2)]
        log = self.written("blf", both)
        self.drive_refused(f"{self.folder}/mapping.toml:2: lateral_acceleration.signal is of ESP_Dynamics, which comes on the "
                           f"buses 1 and 2 in {log}; choose one by a line bus = 1", log)
        on_bus_2 = MAPPING.replace("\nbus = 2", "").replace("signal =", "bus = 2\nsignal =")
        _, said = self.drive(log, mapping=self.mapping(on_bus_2))
        self.assertIn("304 rows over 3.03 s; none missing", said)
        file = self.mapping(on_bus_2.replace("bus = 2", "bus = 3", 1))
        self.drive_refused(f"{log}: there is no frame of ESP_Dynamics (0x18FEF3FE in {foreign_recorder.DBC}, bus 3); it comes "
                           f"on bus 1, 2, and {file}:3 maps it to lateral_acceleration, which every drive needs; ",
                           log, mapping=file)

    def test_optional_keys_may_be_missing(self):
        frames = [frame for frame in foreign_recorder.frames(self.run_folder) if frame.identifier != 0x402]
        drive, said = self.drive(self.written("asc", frames))
        self.assertIn(f"speed: none; there is no frame of WHEELSPEED (0x402 in {foreign_recorder.DBC})", said)
        self.assertNotIn("speed_kmh", self.rows(drive)[0])
        without_roll = [frame for frame in frames if frame.identifier != 0x403]
        log = self.written("asc", without_roll)
        self.drive_refused(f"{log}: there is neither roll_angle nor both speed and yaw_rate: there is no frame of ATTITUDE", log)

    def test_a_log_is_not_replaced_by_its_drive(self):
        content = self.log.read_bytes()
        arguments = ["drive", self.log, "--dbc", foreign_recorder.DBC, "--mapping", self.mapping(), "--output"]
        self.refused(f"{self.log}: the result would take its place; ", *arguments, self.log)
        self.assertEqual(self.log.read_bytes(), content)
        self.refused(f"{self.mapping()}: the result would take its place; ", *arguments, self.mapping())

    def test_j1939_messages_come_from_any_source_but_from_one(self):
        dbc = self.folder / "truck.dbc"
        dbc.write_text(TRUCK, encoding="utf-8")
        mapping = self.mapping(TRUCK_MAPPING)
        frames = [Frame(number / 100, 1, 0x0CF0_0921, True, bytes([number, 0, number, 0, 128, 0, 0xFF, 0xFF]), False, False,
                        False) for number in range(100)]
        _, said = self.drive(self.written("candump", frames), dbc=dbc, mapping=mapping)
        self.assertIn("100 rows over 0.99 s; none missing", said)
        others = frames + [frame._replace(identifier=0x0CF0_0933) for frame in frames]
        log = self.written("candump", sorted(others, key=lambda frame: frame.time_s))
        self.drive_refused(f"{mapping}:2: lateral_acceleration.signal is of VDC2, which several senders send (source addresses "
                           f"0x21 and 0x33) in {log}; ", log, dbc=dbc, mapping=mapping)


    def test_one_absurd_value_costs_no_log(self):
        dbc = self.folder / "float.dbc"
        dbc.write_text(FLOATS, encoding="utf-8")
        mapping = self.mapping('lateral_acceleration.signal = "F.Ay"\nroll_rate.signal = "F.P"\nroll_angle.signal = "G.Phi"\n')
        strange = {50: math.nan, 51: math.inf, 52: 1.0e30}
        frames = []
        for number in range(100):
            data = struct.pack("<ff", strange.get(number, 0.5), 1.0)
            frames += [Frame(number / 100, 1, identifier, False, content, False, False, False)
                       for identifier, content in ((6, data), (7, b"\x00\x64\x00\xff\x00\x00\x00\x00"))]
        drive, said = self.drive(self.written("candump", frames), dbc=dbc, mapping=mapping)
        self.assertIn("lateral_acceleration: 2 values left out: no finite number", said)
        self.assertIn("lateral_acceleration: 1 values left out: beyond anything possible", said)
        self.assertIn("97 rows over 0.99 s; 3 left out, ", said)
        # Phi is decoded by itself: the signals of G overlap.
        self.assertEqual({(row["lateral_acceleration_mps2"], row["roll_angle_deg"]) for row in self.rows(drive)}, {("0.5", "1")})


FLOATS = """\
VERSION ""
NS_ :
BS_:
BU_: N
BO_ 6 F: 8 N
 SG_ Ay : 0|32@1- (1,0) [0|0] "m/s2" N
 SG_ P : 32|32@1- (1,0) [0|0] "deg/s" N
BO_ 7 G: 8 N
 SG_ Whole : 0|32@1- (1,0) [0|0] "" N
 SG_ Phi : 8|16@1- (0.01,0) [0|0] "deg" N
 SG_ Zero : 32|16@1- (0,0) [0|0] "" N
BO_ 7 Again: 8 N
 SG_ Other : 0|16@1- (0.01,0) [0|0] "" N
SIG_VALTYPE_ 6 Ay : 1;
SIG_VALTYPE_ 6 P : 1;
"""

TRUCK = """\
VERSION ""
NS_ :
BS_:
BU_: Vector__XXX
BO_ 2364541438 VDC2: 8 Vector__XXX
 SG_ LateralAcceleration : 0|16@1+ (0.0004883,-15.687) [-15.687|15.687] "m/s\u00b2" Vector__XXX
 SG_ RollRate : 16|16@1+ (0.01,0) [0|600] "deg/s" Vector__XXX
 SG_ RollAngle : 32|16@1+ (0.01,0) [0|600] "deg" Vector__XXX
BA_DEF_ BO_ "VFrameFormat" ENUM "StandardCAN","ExtendedCAN","reserved","J1939PG";
BA_DEF_ "ProtocolType" STRING ;
BA_DEF_DEF_ "VFrameFormat" "J1939PG";
BA_DEF_DEF_ "ProtocolType" "";
BA_ "ProtocolType" "J1939";
BA_ "VFrameFormat" BO_ 2364541438 3;
"""

TRUCK_MAPPING = """\
[lateral_acceleration]
signal = "VDC2.LateralAcceleration"
[roll_rate]
signal = "VDC2.RollRate"
[roll_angle]
signal = "VDC2.RollAngle"
"""


if __name__ == "__main__":
    support.main()
