"""The results of run_cases: signals, indices, lifts and events of one run, read from its folder."""

import bisect
import csv
import json
import math

import judge

G = 9.80665


def _number(text):
    return float(text) if text else math.nan


def _columns(path):
    """The columns of a CSV by name; what is no number stays text."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    columns = {}
    for name, cells in zip(rows[0], zip(*rows[1:])):
        try:
            columns[name] = [_number(cell) for cell in cells]
        except ValueError:
            columns[name] = list(cells)
    return columns


class Run:
    """One run. Columns are asked for by name; a_y is in g."""

    def __init__(self, folder):
        self.summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        self._columns = _columns(folder / "signals.csv")
        self._columns.update(_columns(folder / "firmware.csv"))
        with open(folder / "lifts.csv", newline="", encoding="utf-8") as file:
            self.lifts = [
                (row["what"], float(row["from_s"]), float(row["to_s"])) for row in csv.DictReader(file)
            ]
        self.time = self["time_s"]
        self.ay = [value / G for value in self["true_lateral_acceleration_mps2"]]

    def __getitem__(self, name):
        return self._columns[name]

    def names(self, prefix):
        return [name for name in self._columns if name.startswith(prefix)]

    def at(self, values, time_s):
        """Interpolated between the cycles."""
        k = min(max(bisect.bisect_right(self.time, time_s), 1), len(self.time) - 1)
        share = (time_s - self.time[k - 1]) / (self.time[k] - self.time[k - 1])
        return values[k - 1] + share * (values[k] - values[k - 1])

    def within(self, values, begin_s=-math.inf, end_s=math.inf):
        return [v for t, v in zip(self.time, values) if begin_s <= t <= end_s and not math.isnan(v)]

    def first(self, values, level=1.0, begin_s=-math.inf, end_s=math.inf):
        """Time of the first cycle at the level or above; None when there is none."""
        for t, v in zip(self.time, values):
            if begin_s <= t <= end_s and v >= level:
                return t
        return None

    def crossing(self, values, begin_s):
        """When values first pass from below zero to above after begin_s, between the cycles."""
        for k in range(1, len(values)):
            if self.time[k] > begin_s and values[k - 1] < 0.0 <= values[k]:
                share = -values[k - 1] / (values[k] - values[k - 1])
                return self.time[k - 1] + share * (self.time[k] - self.time[k - 1])
        return None

    def lift(self, *wheels, begin_s=-math.inf):
        """When the first of these came off the ground after begin_s; None when none did."""
        return min((begin for what, begin, _ in self.lifts if what in wheels and begin >= begin_s), default=None)

    def one_wheel(self, begin_s=-math.inf):
        return self.lift("front_left", "front_right", "rear_left", "rear_right", begin_s=begin_s)

    def two_wheels(self, begin_s=-math.inf):
        """Two-wheel lift-off: the first one that lasts."""
        return min((begin for what, begin, end in self.lifts
                    if what in ("left_side", "right_side") and begin >= begin_s and judge.lasts(begin, end)), default=None)


def mean(values):
    return sum(values) / len(values)


def largest(values):
    return max(abs(v) for v in values)


def rms(values):
    return math.sqrt(mean([v * v for v in values]))
