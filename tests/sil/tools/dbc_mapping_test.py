"""Others' DBC files and what a mapping says of them: ranges, several files, parameter groups, signs and differences."""

import math

import numpy

import drive_support
import support

from bus_logs import Frame

HEAD = 'VERSION ""\nNS_ :\nBS_:\nBU_: N\n'
CAR = HEAD + """\
BO_ 36 KIN: 8 N
 SG_ Ay : 0|16@1- (0.001,0) {range} "m/s^2" N
 SG_ RollRate : 16|16@1- (0.01,0) [-300|300] "deg/s" N
BO_ 37 BODY: 8 N
 SG_ Yaw : 0|14@1+ (0.01,0) [0|163.82] "deg/s" N
 SG_ YawSign : 14|1@1+ (1,0) [0|1] "" N
 SG_ HeightLeft : 16|16@1- (0.1,0) [-300|300] "mm" N
 SG_ Speed : 32|16@1+ (0.01,0) [0|300] "km/h" N
 SG_ SpeedRight : 48|16@1+ (0.01,0) [0|300] "km/h" N
BO_ 38 RIGHT: 8 N
 SG_ HeightRight : 0|16@1- (0.0001,0) [-0.3|0.3] "m" N
VAL_ 37 YawSign 0 "left" 1 "right";
"""
MAPPING = """\
[lateral_acceleration]
signal = "KIN.Ay"
[roll_rate]
signal = "KIN.RollRate"
[speed]
signal = "BODY.Speed"
[yaw_rate]
signal = "BODY.Yaw"
sign = "BODY.YawSign"
[roll_angle]
signal = "BODY.HeightLeft"
minus = "RIGHT.HeightRight"
distance_m = 1.6
"""
TRACK_M, STEPS = 1.6, 400
IMU = HEAD + "BO_ 50 IMU: 8 N\n SG_ RollRate : 0|16@1- (0.01,0) [-300|300] \"deg/s\" N\n"


def little(*numbers):
    return b"".join((round(number) & 0xFFFF).to_bytes(2, "little") for number in numbers)


def angle_deg(time_s):
    return 4.0 * math.sin(1.5 * time_s)


def yaw_degps(time_s):
    return 12.0 * math.sin(1.5 * time_s)


def frames(yaw=yaw_degps):
    """A slalom: lateral acceleration of both signs, a yaw rate with its sign apart, heights of two sides at their own times."""
    for number in range(STEPS):
        time_s = number / 100
        half_mm = 500.0 * TRACK_M * math.tan(math.radians(angle_deg(time_s)))
        rate = yaw(time_s)
        ay = math.radians(rate) * 20.0
        roll_rate = 6.0 * math.cos(1.5 * time_s)
        left, right = (20.0 - math.radians(rate) * TRACK_M / 2.0) * 3.6, (20.0 + math.radians(rate) * TRACK_M / 2.0) * 3.6
        sent = ((36, 0.0, little(ay * 1000, roll_rate * 100, 0, 0)),
                (37, 0.0, little(round(abs(rate) * 100) | (rate < 0) << 14, half_mm * 10, left * 100, right * 100)),
                (38, 0.003, little(-5000.0 * TRACK_M * math.tan(math.radians(angle_deg(time_s + 0.003))), 0, 0, 0)))
        for identifier, later_s, data in sent:
            yield Frame(round(time_s + later_s, 6), 1, identifier, False, data, False, False, False)


class DbcMapping(drive_support.WithDrives):
    def dbc(self, name="car.dbc", text=None, range_="[-20|20]"):
        file = self.folder / name
        file.write_text(text or CAR.replace("{range}", range_), encoding="utf-8")
        return file

    def column(self, drive, name):
        return numpy.array([float(row[name]) for row in self.rows(drive)])

    def test_a_sign_beside_a_magnitude_and_a_difference_of_heights(self):
        log, dbc = self.written("candump", frames()), self.dbc()
        drive, said = self.drive(log, dbc=dbc, mapping=self.mapping(MAPPING))
        self.assertNotIn("LOOK", said)
        times_s = self.column(drive, "time_s")
        numpy.testing.assert_allclose(self.column(drive, "yaw_rate_degps"), [yaw_degps(time_s) for time_s in times_s], atol=0.006)
        numpy.testing.assert_allclose(self.column(drive, "roll_angle_deg")[1:-1], [angle_deg(time_s) for time_s in times_s][1:-1],
                                      atol=0.02)
        # The other way round, and a rate of two speeds.
        drive, _ = self.drive(log, dbc=dbc, mapping=self.mapping(MAPPING.replace('"BODY.YawSign"', '"-BODY.YawSign"')))
        numpy.testing.assert_allclose(self.column(drive, "yaw_rate_degps"), [-yaw_degps(time_s) for time_s in times_s], atol=0.006)
        by_speeds = 'signal = "BODY.SpeedRight"\nminus = "BODY.Speed"\ndistance_m = 1.6\n'
        drive, _ = self.drive(log, dbc=dbc, mapping=self.mapping(MAPPING.replace(
            'signal = "BODY.Yaw"\nsign = "BODY.YawSign"\n', by_speeds)))
        numpy.testing.assert_allclose(self.column(drive, "yaw_rate_degps"), [yaw_degps(time_s) for time_s in times_s], atol=0.15)

    def test_columns_of_a_table_are_combined_likewise(self):
        table = self.folder / "table.csv"
        lines = ["t,ay,p,v,yaw,right,hl,hr"]
        for number in range(STEPS):
            time_s = number / 100
            height = 500.0 * TRACK_M * math.tan(math.radians(angle_deg(time_s)))
            rate = yaw_degps(time_s)
            values = (time_s, math.radians(rate) * 20.0, 6.0 * math.cos(1.5 * time_s), 72, abs(rate), int(rate < 0), height, -height)
            lines.append(",".join(str(value) for value in values))
        table.write_text("\n".join(lines) + "\n", encoding="utf-8")
        mapping = self.mapping('time = {signal = "t"}\nlateral_acceleration = {signal = "ay", unit = "m/s^2"}\n'
                               'roll_rate = {signal = "p", unit = "deg/s"}\nspeed = {signal = "v", unit = "km/h"}\n'
                               'yaw_rate = {signal = "yaw", sign = "right", unit = "deg/s"}\n'
                               'roll_angle = {signal = "hl", minus = "hr", unit = "mm", distance_m = 1.6}\n')
        drive, said = self.drive(table, dbc=None, mapping=mapping)
        self.assertNotIn("LOOK", said)
        times_s = self.column(drive, "time_s")
        numpy.testing.assert_allclose(self.column(drive, "yaw_rate_degps"), [yaw_degps(time_s) for time_s in times_s], atol=1e-6)
        numpy.testing.assert_allclose(self.column(drive, "roll_angle_deg"), [angle_deg(time_s) for time_s in times_s], atol=1e-6)

    def test_values_without_their_sign_are_left_out(self):
        apart = CAR.replace(' SG_ YawSign : 14|1@1+', ' SG_ Unused : 14|1@1+').replace("BO_ 38", "BO_ 39 SIGN: 1 N\n SG_ YawSign : "
                            '0|1@1+ (1,0) [0|1] "" N\nBO_ 38').replace("VAL_ 37", "VAL_ 39")
        sent = []
        for frame in frames():
            sent.append(frame)
            if frame.identifier == 37 and 1.0 <= frame.time_s < 3.0 and round(frame.time_s * 100) % 10 == 0:
                sent.append(frame._replace(identifier=39, data=bytes([frame.data[1] >> 6 & 1])))
        drive, said = self.drive(self.written("candump", sent), dbc=self.dbc(text=apart.replace("{range}", "[-20|20]")),
                                 mapping=self.mapping(MAPPING.replace("BODY.YawSign", "SIGN.YawSign")))
        self.assertIn("yaw_rate: 184 values left out: no sign at their time", said)
        known = [float(row["time_s"]) for row in self.rows(drive) if row["yaw_rate_degps"]]
        self.assertEqual((known[0], known[-1]), (1.0, 3.15))

    def test_bad_combinations_are_refused(self):
        log, dbc = self.written("candump", frames()), self.dbc()

        def refused(change, expected):
            mapping = self.mapping(MAPPING.replace(*change))
            self.drive_refused(f"{mapping}:{expected}", log, dbc=dbc, mapping=mapping)

        refused(('"BODY.YawSign"', '"BODY.Sign"'), "9: yaw_rate.sign is 'BODY.Sign', but ")
        refused(('"BODY.YawSign"', '"-"'), "9: yaw_rate.sign must be 1 ")
        refused(("distance_m = 1.6", ""), "12: roll_angle.minus needs the other one: ")
        refused(('minus = "RIGHT.HeightRight"', ""), "13: roll_angle.distance_m needs the other one: ")
        refused(("distance_m = 1.6", "distance_m = 0"), "13: roll_angle.distance_m is 0, but must be more than 0")
        refused(('"RIGHT.HeightRight"', '"BODY.Yaw"'), "12: roll_angle.minus is BODY.Yaw, whose unit in the log or DBC "
                                                       "file ('deg/s') does not do; add unit = one of m, ")
        refused(('"BODY.Speed"', '"BODY.Speed"\nminus = "BODY.Speed"\ndistance_m = 1'), "7: speed.minus makes an angle of ")
        for wrong in ('"all"', "[1]", "[2, 1]", "[true, 2]", '["a", 2]', "[0, inf]"):
            refused(('"KIN.Ay"', f'"KIN.Ay"\nrange = {wrong}'), "3: lateral_acceleration.range must be [least, largest] of ")

    def test_a_range_that_leaves_out_a_side_is_the_files_mistake(self):
        log = self.written("candump", frames())
        for turns, range_ in (("negative", "[0|65535]"), ("positive", "[-65535|0]"), ("a third or more", "[-0.5|20]")):
            dbc = self.dbc(range_=range_)
            drive, said = self.drive(log, dbc=dbc, mapping=self.mapping(MAPPING))
            self.assertRegex(said, r"lateral_acceleration: LOOK: the DBC file's range \S+ to \S+ of KIN.Ay would leave \d+ of 400 "
                                   rf"values out, (all that are )?{turns}: they are kept")
            self.assertIn("a range is not as the signal (LOOK above)", said)
            self.assertEqual(len(self.rows(drive)), STEPS)
            values = self.column(drive, "lateral_acceleration_mps2")
            self.assertTrue(min(values) < -4.0 and max(values) > 4.0)
            _, said = self.drive(log, dbc=dbc, mapping=self.mapping(MAPPING.replace('"KIN.Ay"', '"KIN.Ay"\nrange = "ignore"')))
            self.assertNotIn("LOOK", said)

    def test_a_range_in_the_mapping_is_kept_to(self):
        log, dbc = self.written("candump", frames()), self.dbc(range_="[0|65535]")
        drive, said = self.drive(log, dbc=dbc, mapping=self.mapping(MAPPING.replace('"KIN.Ay"', '"KIN.Ay"\nrange = [-4, 4]')))
        self.assertRegex(said, r"lateral_acceleration: \d+ values left out: outside the mapping's range")
        self.assertNotIn("LOOK", said)
        values = self.column(drive, "lateral_acceleration_mps2")
        self.assertTrue(-4.1 < min(values) < -3.9 and 3.9 < max(values) < 4.1)

    def test_codes_for_not_available_are_not_kept(self):
        """However often they come: they are few different values."""
        sent = [frame._replace(data=little(-32768 if frame.time_s < 3.0 else -32767, 0, 0, 0)) if
                frame.identifier == 36 and frame.time_s < 3.5 else frame for frame in frames()]
        drive, said = self.drive(self.written("candump", sent), dbc=self.dbc(), mapping=self.mapping(MAPPING))
        self.assertIn("lateral_acceleration: 350 values left out: outside the DBC file's range", said)
        self.assertNotIn("a third or more", said)
        self.assertGreater(min(self.column(drive, "lateral_acceleration_mps2")), -20.0)

    def test_two_files_are_used(self):
        car = self.dbc(text=CAR.replace("{range}", "[-20|20]").replace("SG_ RollRate", "SG_ Other"))
        imu = self.dbc("imu.dbc", IMU)
        sent = [part for frame in frames() for part in
                ([frame, frame._replace(identifier=50, data=frame.data[2:])] if frame.identifier == 36 else [frame])]
        log, mapping = self.written("candump", sent), self.mapping(MAPPING.replace("KIN.RollRate", "IMU.RollRate"))
        arguments = ["drive", log, "--dbc", car, "--dbc", imu, "--mapping", mapping, "--output", self.folder / "both.csv"]
        said = self.logs(*arguments)
        self.assertIn("400 rows over 3.99 s; none missing", said)
        drafted = self.folder / "drafted.toml"
        self.logs("draft", "--dbc", car, "--dbc", imu, "--log", log, "--output", drafted)
        text = drafted.read_text(encoding="utf-8")
        self.assertIn(f"of {car} and {imu} and {log}.", text)
        self.assertIn('signal = "IMU.RollRate"', text)
        self.assertIn('signal = "KIN.Ay"', text)
        # A signal that is likelier by its name, but not in the log, is no candidate.
        self.dbc("imu.dbc", IMU + 'BO_ 51 IMU2: 8 N\n SG_ RollRate : 0|16@1- (0.01,0) [-300|300] "deg/s" N\n')
        drafted.unlink()
        self.logs("draft", "--dbc", car, "--dbc", imu, "--log", log, "--output", drafted)
        self.assertIn('[roll_rate]\nsignal = "IMU.RollRate"', drafted.read_text(encoding="utf-8"))
        self.dbc("imu.dbc", IMU)
        decoded = self.logs("decode", log, "--dbc", car, "--dbc", imu, "--output", self.folder / "decoded")
        self.assertIn("400 KIN, 400 BODY, 400 RIGHT, 400 IMU", decoded)
        self.drive_refused(f"{mapping}:2: lateral_acceleration.signal is 'KIN.Ay', but {imu} has no such signal", log, dbc=imu,
                           mapping=mapping)

    def test_two_files_that_differ(self):
        car = self.dbc(text=CAR.replace("{range}", "[-20|20]").replace("SG_ RollRate", "SG_ Other"))
        imu = self.dbc("imu.dbc", IMU.replace("BO_ 50", "BO_ 38"))
        sent = [part for frame in frames() for part in
                ([frame, frame._replace(identifier=38, bus=2, data=frame.data[2:])] if frame.identifier == 36 else [frame])]
        log = self.written("candump", sent)
        text = MAPPING.replace("KIN.RollRate", "IMU.RollRate")
        arguments = ["drive", log, "--dbc", car, "--dbc", imu, "--output", self.folder / "both.csv", "--mapping"]
        mapping = self.mapping(text)
        self.refused(f"{mapping}:4: roll_rate.signal is IMU.RollRate, and 0x26 is another message in another DBC file; say on "
                     "which bus", *arguments, mapping)
        said = self.logs(*arguments, self.mapping(text.replace('"IMU.RollRate"', '"IMU.RollRate"\nbus = 2').replace(
            "distance_m", "bus = 1\ndistance_m")))
        self.assertIn(f"{imu}: has IMU (0x26), which is RIGHT in {car}: a mapping of either needs its bus", said)
        self.assertIn("400 rows over 3.99 s; none missing", said)
        drafted = self.folder / "drafted.toml"
        self.logs("draft", "--dbc", car, "--dbc", imu, "--log", log, "--output", drafted)
        self.assertRegex(drafted.read_text(encoding="utf-8"), r'signal = "IMU.RollRate"\n(.*\n)*?bus = "\?"')
        # The same message twice is one; of another one by the same name that of the first file is taken.
        twin = self.dbc("twin.dbc", CAR.replace("{range}", "[-20|20]"))
        again = self.dbc("again.dbc", CAR.replace("{range}", "[0|1]").replace("37 BODY", "77 BODY").replace("VAL_ 37", "VAL_ 77"))
        arguments = ["drive", self.written("candump", frames()), "--dbc", twin, "--dbc", again, "--output",
                     self.folder / "both.csv", "--mapping", self.mapping(MAPPING)]
        said = self.logs(*arguments)
        self.assertIn(f"{again}: has BODY, which is another one in {twin}: that one is taken\n", said)
        self.assertIn("400 rows over 3.99 s; none missing", said)

    def test_a_parameter_group_stands_in_for_an_identifier_that_never_comes(self):
        truck = CAR.replace("{range}", "[-20|20]").replace("BO_ 36", "BO_ 2566851838").replace("BO_ 37", "BO_ 2364539646")
        dbc = self.dbc(text=truck.replace("VAL_ 37", "VAL_ 2364539646"))
        identifiers = {36: 0x18FF_0C21, 37: 0x0CF0_0221}
        sent = [frame._replace(identifier=identifiers.get(frame.identifier, 38), extended=frame.identifier != 38)
                for frame in frames()]
        log = self.written("candump", sent)
        drive, said = self.drive(log, dbc=dbc, mapping=self.mapping(MAPPING))
        self.assertIn("no frame has the identifier 0x18FF0CFE of KIN: those of its J1939 parameter group 65292 are taken, from "
                      "source address 0x21", said)
        self.assertEqual(len(self.rows(drive)), STEPS)
        drafted = self.folder / "drafted.toml"
        said = self.logs("draft", "--dbc", dbc, "--log", log, "--output", drafted)
        self.assertIn("of KIN: those of its J1939 parameter group 65292 are taken", said)
        self.assertIn('signal = "KIN.Ay"\nunit = "m/s^2"  # as it says there\nsign = "?"', drafted.read_text(encoding="utf-8"))
        # A frame that has the identifier is enough for no other to be taken.
        def beside(identifier):
            return self.written("candump", [part for frame in sent for part in (
                (frame, frame._replace(identifier=identifier)) if frame.identifier == 0x18FF_0C21 else (frame,))])

        _, said = self.drive(beside(0x18FF_0CFE), dbc=dbc, mapping=self.mapping(MAPPING))
        self.assertNotIn("identifier 0x18FF0CFE", said)
        log = beside(0x18FF_0C33)
        self.drive_refused(f"{self.mapping(MAPPING)}:2: lateral_acceleration.signal is of KIN, which several senders send (source "
                           "addresses 0x21 and 0x33)", log, dbc=dbc, mapping=self.mapping(MAPPING))


if __name__ == "__main__":
    support.main()
