"""The runs of a campaign that was driven with --traces: a run's row, its calibration and its course in time."""

import array
import csv
import math
import tomllib

CYCLE_S = 0.01
# Columns of a trace; angles in degrees, as there.
SIGNALS = ["lateral_acceleration_mps2", "roll_rate_degps", "roll_angle_deg", "speed_mps", "yaw_rate_degps",
           "steering_wheel_angle_deg", "road_parallel_force_mps2", "predicted_load_transfer_ratio", "opposite_load_transfer_ratio",
           "load_transfer_ratio", "true_load_transfer_ratio"]


def _number(text):
    return float(text) if text else math.nan


class Run:
    """One run; a signal is a list of numbers, one a cycle of 10 ms, NaN where there is none."""

    def __init__(self, row, traces):
        self.row = row
        self.vehicle = row["vehicle"]
        self.largest_ltr = float(row["largest_ltr"])
        self.lift_s = float(row["two_wheel_lift_time_s"]) if row["two_wheel_lift_time_s"] else None
        self.falling_side = row["falling_side"] or None
        self.calibration = tomllib.loads((traces / f"{row['run']}.toml").read_text(encoding="utf-8"))
        self.states, self.sides, self.signals = _course(traces / f"{row['run']}.csv")

    def __len__(self):
        return len(self.states)


def _course(path):
    with open(path, encoding="utf-8", newline="") as file:
        lines = csv.reader(line for line in file if not line.startswith("#"))
        names = next(lines)
        columns = list(zip(*lines))
    course = dict(zip(names, columns))
    return (list(course["state"]), list(course["side"]),
            {name: array.array("f", map(_number, course[name])) for name in SIGNALS})


def load(folder):
    """All runs of the campaign in `folder`, by number."""
    with open(folder / "runs.csv", encoding="utf-8", newline="") as file:
        return [Run(row, folder / "traces") for row in csv.DictReader(file)]
