"""Folders of others' logs, each from its files to the verdict with one answer: sides, warnings and leads are those of the
simulated drives."""

import collections
import csv
import json
import re

import can
import cantools
import numpy

import drive_support
import support

import bus_log_writers
import foreign_recorder
from bus_logs import Frame

VEHICLE = support.PROJECT / "sil/vehicles/large_suv.toml"
DATA = support.PROJECT / "sil/vehicles/data/large_suv.toml"
RUNS = {"fall": ("j-turn-110", "--mirror"), "fishhook": ("fishhook-1a",), "slow": ("slow-ramp",), "step": ("step-steer",),
        "near": ("j-turn-45",)}
CYCLES_S = 0.035  # which a log's own instants and rates may cost
HEAD = 'VERSION ""\nNS_ :\nBS_:\nBU_: N\n'

# A yaw rate and a steering-wheel angle as magnitudes, each with its sign beside it.
SIGN_BITS = HEAD + """\
BO_ 257 ESP_02: 8 N
 SG_ ESP_02_CHK : 0|8@1+ (1,0) [0|255] "" N
 SG_ ESP_02_BZ : 8|4@1+ (1,0) [0|15] "" N
 SG_ ESP_Querbeschleunigung : 16|12@1+ (0.001,-2.048) [-2.048|2.046] "Unit_ForceOfGravi" N
 SG_ ESP_Gierrate : 40|14@1+ (0.02,0) [0|327.64] "Unit_DegreOfArcPerSecon" N
 SG_ ESP_VZ_Gierrate : 54|1@1+ (1,0) [0|1] "" N
BO_ 134 LWI_01: 8 N
 SG_ LWI_Lenkradwinkel : 16|13@1+ (0.1,0) [0|800] "Unit_DegreOfArc" N
 SG_ LWI_VZ_Lenkradwinkel : 29|1@1+ (1,0) [0|1] "" N
 SG_ LWI_Lenkradw_Geschw : 32|9@1+ (5,0) [0|2500] "Unit_DegreOfArcPerSecon" N
BO_ 259 ESP_21: 8 N
 SG_ ESP_v_Signal : 32|16@1+ (0.01,0) [0|655.32] "Unit_KiloMeterPerHour" N
BO_ 1500 Zusatz_IMU: 8 N
 SG_ IMU_Wankrate : 0|16@1- (0.02,0) [0|0] "deg/s" N
 SG_ IMU_Wankwinkel : 16|16@1- (0.02,0) [0|0] "deg" N
 SG_ IMU_Hochbeschleunigung : 32|16@1- (0.001,0) [0|0] "g" N
"""

# The messages of a truck, with offsets in place of signs, and an added sensor.
TRUCK = HEAD + """\
BO_ 2565865790 VDC2: 8 N
 SG_ SteeringWheelAngle : 0|16@1+ (0.0009765625,-31.374) [-31.374|31.374] "rad" N
 SG_ YawRate : 24|16@1+ (0.0001220703125,-3.92) [-3.92|3.92] "rad/s" N
 SG_ LateralAcceleration : 40|16@1+ (0.00048828125,-15.687) [-15.687|15.687] "m/s^2" N
BO_ 2566844926 CCVS1: 8 N
 SG_ WheelBasedVehicleSpeed : 8|16@1+ (0.00390625,0) [0|250.996] "km/h" N
BO_ 2566856958 BODY: 8 N
 SG_ RollRate : 7|16@0- (0.0002,0) [0|0] "rad/s" N
 SG_ RollAngle : 23|16@0- (0.0002,0) [0|0] "rad" N
 SG_ VerticalAcceleration : 39|16@0- (0.002,0) [0|0] "m/s^2" N
"""

GERMAN = {"Zeit": ("s", "time_s", 1.0), "Querbeschl.": ("m/s\u00b2", "sensor_lateral_acceleration_mps2", -1.0),
          "Vertikalbeschl.": ("m/s\u00b2", "sensor_vertical_acceleration_mps2", 1.0),
          "Wankgeschw.": ("Grad/s", "sensor_roll_rate_degps", 1.0), "Wankwinkel": ("Grad", "sensor_roll_angle_deg", 1.0),
          "Gierrate": ("Grad/s", "sensor_yaw_rate_degps", -1.0), "Fahrgeschwindigkeit": ("km/h", "sensor_speed_mps", 3.6),
          "Lenkradwinkel": ("Grad", "sensor_steering_wheel_angle_deg", 1.0),
          **{f"Radlast {text}": ("kN", f"true_wheel_load_{corner}_n", 1.0e-3) for text, corner in
             (("VL", "front_left"), ("VR", "front_right"), ("HL", "rear_left"), ("HR", "rear_right"))}}


def sent(run_folder, database, values):
    """Frames of these values every 10 ms; a value beyond its bits is the largest that they have."""
    messages = {message.name: message for message in database.messages}
    for row in foreign_recorder.rows(run_folder):
        for number, (name, signals) in enumerate(values(row).items()):
            message = messages[name]
            data = {signal.name: 0 for signal in message.signals}
            for signal in message.signals:
                if signal.name in signals:
                    low = -(2**(signal.length - 1)) if signal.is_signed else 0
                    high = low + 2**signal.length - 1
                    raw = round((signals[signal.name] - signal.offset) / signal.scale)
                    data[signal.name] = min(max(raw, low), high)
            yield Frame(round(row["time_s"] + 0.0005 * number, 6), 1, message.frame_id, message.is_extended_frame,
                        message.encode(data, scaling=False, strict=False), False, False, False)


def with_sign_bits(row):
    yaw, steering = row["yaw_rate_degps"], row["steering_wheel_angle_deg"]
    return {"ESP_02": {"ESP_Querbeschleunigung": row["lateral_acceleration_mps2"] / foreign_recorder.G_MPS2,
                       "ESP_Gierrate": abs(yaw), "ESP_VZ_Gierrate": yaw < 0.0},
            "LWI_01": {"LWI_Lenkradwinkel": abs(steering), "LWI_VZ_Lenkradwinkel": steering > 0.0},
            "ESP_21": {"ESP_v_Signal": 3.6 * row["speed_mps"]},
            "Zusatz_IMU": {"IMU_Wankrate": -row["roll_rate_degps"], "IMU_Wankwinkel": -row["roll_angle_deg"],
                           "IMU_Hochbeschleunigung": row["vertical_acceleration_mps2"] / foreign_recorder.G_MPS2}}


def of_a_truck(row):
    radians = {name: value / foreign_recorder.DEGREES for name, value in row.items()}
    return {"VDC2": {"SteeringWheelAngle": radians["steering_wheel_angle_deg"], "YawRate": radians["yaw_rate_degps"],
                     "LateralAcceleration": row["lateral_acceleration_mps2"]},
            "CCVS1": {"WheelBasedVehicleSpeed": 3.6 * row["speed_mps"]},
            "BODY": {"RollRate": -radians["roll_rate_degps"], "RollAngle": radians["roll_angle_deg"],
                     "VerticalAcceleration": -row["vertical_acceleration_mps2"]}}


def write_mf4_without_length(path, frames):
    """As recorders that write the length code alone."""
    import asammdf

    frames = list(frames)
    bus_log_writers.write_mf4(path, iter(frames))
    with asammdf.MDF(path) as mdf:
        whole = mdf.get("CAN_DataFrame")
        source = whole.source
    kept = [name for name in bus_log_writers.FRAME_TYPE.names if not name.endswith("DataLength")]
    samples = numpy.zeros(len(frames), dtype=[(name, bus_log_writers.FRAME_TYPE[name]) for name in kept])
    for name in kept:
        samples[name] = whole.samples[name]
    mdf = asammdf.MDF(version="4.10")
    mdf.append(asammdf.Signal(samples, whole.timestamps, name="CAN_DataFrame", source=source), comment="frames")
    mdf.save(path, overwrite=True)
    mdf.close()


def write_trc(path, frames):
    with can.TRCWriter(path) as writer:
        for frame in frames:
            writer.on_message_received(bus_log_writers.message(frame))


class WholeWay(drive_support.WithDrives):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name, (manoeuvre, *options) in RUNS.items():
            support.call(cls.program, "run", manoeuvre, *options, "--in-process", "--vehicle", VEHICLE, "--parameters",
                         support.CALIBRATION, "--output", cls.run_folder.parent / name)

    def setUp(self):
        super().setUp()
        self.drives = self.folder / "logs"
        self.drives.mkdir()

    def dbc(self, text):
        file = self.folder / "bus.dbc"
        file.write_text(text, encoding="utf-8")
        return cantools.database.load_string(text, "dbc"), file

    def record(self, write, ending, database, values, names):
        for name in names:
            write(self.drives / f"{name}.{ending}", sent(self.run_folder.parent / name, database, values))

    def truth(self, name):
        return json.loads((self.run_folder.parent / name / "summary.json").read_text(encoding="utf-8"))

    def verdict(self, *options):
        """The sections of the verdict by their titles, after the one answer."""
        output = self.folder / "output"
        arguments = ["verdict", self.drives, "--program", self.program, "--output", output, *options]
        asked = re.search(r"was the turn at (\S+) s of (\w+)\.\w+ to the left or to the right\?", self.unanswered(*arguments))
        rows = foreign_recorder.rows(self.run_folder.parent / asked[2])
        yaw = next(row["yaw_rate_degps"] for row in rows if row["time_s"] >= float(asked[1]))
        self.logs(*arguments, "--answer", "left" if yaw > 0.0 else "right")
        sections = collections.defaultdict(str)
        for part in (output / "verdict.md").read_text(encoding="utf-8").split("\n## ")[1:]:
            title, _, text = part.partition("\n")
            sections[title.partition(".")[0]] = text
        return sections

    def expect(self, sections, verdicts):
        """Each drive warned or not, with the side and the lead of its run, and with this verdict."""
        for name, verdict in verdicts.items():
            truth, text = self.truth(name), sections[name]
            self.assertIn(f"verdict: {verdict}\n", text)
            warned = [(side, float(time_s)) for side, time_s in re.findall(r"to the (\w+) at ([\d.]+) s", text)]
            self.assertEqual(bool(warned), bool(truth["warning_time_s"]), text)
            if warned:
                self.assertEqual(warned[0][0], truth["warning_side"])
                self.assertAlmostEqual(warned[0][1], truth["warning_time_s"], delta=CYCLES_S)
                lift_s = truth["two_wheel_lift_time_s"]
                in_force = next(time_s for _, time_s in reversed(warned) if time_s < lift_s)
                self.assertAlmostEqual(lift_s - in_force, truth["lead_time_s"], delta=CYCLES_S)

    def test_blf_with_the_sign_of_the_yaw_rate_beside_it(self):
        database, file = self.dbc(SIGN_BITS)
        self.record(bus_log_writers.write_blf, "blf", database, with_sign_bits, ("fall", "slow", "step", "near"))
        sections = self.verdict("--dbc", file, "--vehicle-data", DATA)
        signals = (self.folder / "output/mapping.toml").read_text(encoding="utf-8")
        self.assertIn('sign = "ESP_02.ESP_VZ_Gierrate"\n', re.sub(" +#.*", "", signals))
        self.assertIn('sign = "-LWI_01.LWI_VZ_Lenkradwinkel"\n', re.sub(" +#.*", "", signals))
        self.expect(sections, {"fall": "warning", "slow": "no warning", "step": "no warning"})
        self.assertRegex(sections["What validate found"], r"- fall: not comparable, roll angle 100\.0 % within")

    def test_german_csv_with_decimal_commas_at_50_hz(self):
        for name in ("fall", "slow", "step"):
            lines = [";".join(GERMAN), ";".join(unit for unit, _, _ in GERMAN.values())]
            with (self.run_folder.parent / name / "signals.csv").open(encoding="utf-8") as file:
                for row in list(csv.DictReader(file))[::2]:
                    if row["sensor_lateral_acceleration_mps2"]:
                        lines.append(";".join(f"{float(row[column]) * factor:.5f}".replace(".", ",")
                                              for _, column, factor in GERMAN.values()))
            (self.drives / f"{name}.csv").write_bytes("".join(f"{line}\r\n" for line in lines).encode("cp1252"))
        sections = self.verdict("--vehicle-data", DATA)
        self.expect(sections, {"fall": "ahead", "slow": "quiet", "step": "quiet"})
        self.assertIn("load transfer ratio 100.0 % within", sections["What validate found"])
        with (self.folder / "output/replays/table.csv").open(encoding="utf-8") as file:
            leads = {row["drive"]: row["lead_time_s"] for row in csv.DictReader(file)}
        self.assertAlmostEqual(float(leads["fall"]), self.truth("fall")["lead_time_s"], delta=CYCLES_S)

    def test_mf4_without_lengths(self):
        database, file = self.dbc(TRUCK)
        self.record(write_mf4_without_length, "mf4", database, of_a_truck, ("fishhook", "step"))
        self.expect(self.verdict("--dbc", file, "--parameters", "large_suv"), {"fishhook": "warning", "step": "no warning"})

    def test_trc_of_two_databases(self):
        database, _ = self.dbc(TRUCK)
        head, vehicle, added = HEAD, *re.split(r"(?=BO_ 2566856958)", TRUCK.removeprefix(HEAD))
        files = []
        for name, text in (("vehicle", vehicle), ("added", added)):
            files += ["--dbc", self.folder / f"{name}.dbc"]
            files[-1].write_text(head + text, encoding="utf-8")
        self.record(write_trc, "trc", database, of_a_truck, ("fall", "step"))
        self.expect(self.verdict(*files, "--parameters", "large_suv"), {"fall": "warning", "step": "no warning"})


if __name__ == "__main__":
    support.main()
