"""A foreign recorder: the run's sensor values under other names, units, signs and rates, by foreign.dbc."""

import csv
import pathlib

import cantools

from bus_logs import Frame

DBC = pathlib.Path(__file__).resolve().parent / "foreign.dbc"
G_MPS2 = 9.80665
DEGREES = 57.29577951308232

MAPPING = """\
[lateral_acceleration]
signal = "ESP_Dynamics.LatAcc_Raw"
sign = -1

[roll_rate]
signal = "ESP_Dynamics.RollVelocity"

[vertical_acceleration]
signal = "ESP_Dynamics.VertAcc"
sign = -1

[roll_angle]
signal = "ATTITUDE.BodyRoll"
factor = 0.0001
unit = "rad"
sign = -1
lag_ms = 30

[speed]
signal = "WHEELSPEED.VehSpd"

[yaw_rate]
signal = "CLUSTER_3.GierRate"

[steering_wheel_angle]
signal = "CLUSTER_3.LenkradWinkel"
sign = -1
bus = 2
"""


def rows(run_folder):
    """Sensor values every 10 ms: a dictionary of column and number."""
    with (run_folder / "signals.csv").open(encoding="utf-8") as file:
        for row in csv.DictReader(file):
            yield {name[len("sensor_"):] if name.startswith("sensor_") else name: float(row[name])
                   for name in row if name == "time_s" or name.startswith("sensor_") and row[name]}


def frames(run_folder, start_s=0.0):
    """The frames in the order of time: the inertial sensor on bus 1 every 10 ms, the others on bus 2."""
    database = cantools.database.load_file(DBC)
    sent = []

    def send(time_s, bus, name, **values):
        message = database.get_message_by_name(name)
        data = message.encode(values, strict=False)
        time_s = round(start_s + time_s, 6)
        sent.append(Frame(time_s, bus, message.frame_id, message.is_extended_frame, data, False, False, False))

    for number, row in enumerate(rows(run_folder)):
        time_s = row["time_s"]
        send(time_s, 1, "ESP_Dynamics", LatAcc_Raw=-row["lateral_acceleration_mps2"] / G_MPS2, AliveCounter=number % 16,
             RollVelocity=row["roll_rate_degps"] / DEGREES, VertAcc=-row["vertical_acceleration_mps2"], QualityOfSensors=1)
        send(time_s + 0.03, 2, "ATTITUDE", BodyRoll=round(-row["roll_angle_deg"] / DEGREES / 0.0001), RoadBank=0.0)
        if number % 2 == 0:
            send(time_s, 2, "CLUSTER_3", Page=0, GierRate=row["yaw_rate_degps"])
        else:
            send(time_s, 2, "CLUSTER_3", Page=1, LenkradWinkel=-row["steering_wheel_angle_deg"])
        if number % 5 == 0:
            send(time_s, 2, "WHEELSPEED", VehSpd=row["speed_mps"], GearSelector=3)
            send(time_s + 0.002, 2, "CLUSTER_3", Page=2, OdoMeter=1234.5)
    return sorted(sent, key=lambda frame: frame.time_s)
