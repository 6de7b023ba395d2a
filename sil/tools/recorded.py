"""Recorded values of a signal, from any kind of log."""

import array
import collections
import math

import numpy

from log_error import LogError

# A signal as it was recorded: ascending microseconds, numbers, its unit there, and how many values were not to be had,
# by their reason.
Recorded = collections.namedtuple("Recorded", "times_us values unit left_out")

OUTSIDE = "outside the DBC file's range"
TEXTS = "texts"
LONGEST_STEP_BACK_S = 0.2  # recorders of several buses write that much out of order
LATEST_S = 1.0e10          # the year 2286
LONGEST_GAP_S = 3600.0     # as rsi-sil replay has it
LONGEST_DRIVE_S = 12 * 3600.0


class Collected:
    """The values of one mapped signal while the logs are read."""

    def __init__(self, entry, signal):
        self.entry = entry
        self.signal = signal
        self.times_us = array.array("q")
        self.values = array.array("d")
        self.left_out = collections.Counter()
        self.examples = []
        self.clock = Clock()  # for logs in which every signal has times of its own

    def take_text(self, text):
        """A value that has no number: "not available", or one of an enumeration."""
        self.left_out[TEXTS] += 1
        if len(self.examples) < 3 and text not in self.examples:
            self.examples.append(text)

    def take(self, time_us, value):
        if not math.isfinite(value):
            self.left_out["no finite number"] += 1
        elif self.is_outside(value):
            self.left_out[OUTSIDE] += 1
        else:
            self.times_us.append(time_us)
            self.values.append(value)

    def is_outside(self, value):
        """Many senders say "not available" with a value beyond the range."""
        low, high = self.signal.minimum, self.signal.maximum
        if low is None or high is None or not low < high:
            return False
        room = 0.5 * abs(self.signal.scale) if not self.signal.is_float else 1.0e-6 * (high - low)
        return value < low - room or value > high + room

    def recorded(self):
        times_us = numpy.frombuffer(self.times_us, dtype="i8") if self.times_us else numpy.empty(0, dtype="i8")
        values = numpy.frombuffer(self.values, dtype="f8") if self.values else numpy.empty(0)
        left_out = {f"{reason}, such as '{self.examples[0]}'" if reason == TEXTS else reason: count
                    for reason, count in self.left_out.items()}
        return Recorded(*in_order(times_us, values), self.signal.unit, left_out)


def in_order(times_us, values):
    """Sorted by time; of several values at one instant the last."""
    order = numpy.argsort(times_us, kind="stable")
    times_us, values = times_us[order], values[order]
    is_last = numpy.append(numpy.diff(times_us) > 0, True)[:len(times_us)]
    return times_us[is_last], values[is_last]


class Clock:
    """Refuses times that are not those of one recording."""

    def __init__(self, earliest_s=-LATEST_S, longest_gap_s=LONGEST_GAP_S, longest_s=LONGEST_DRIVE_S):
        self.earliest_s = earliest_s
        self.longest_gap_s, self.longest_s = longest_gap_s, longest_s
        self.first_s = self.latest_s = None

    def take(self, place, time_s):
        """`place` is the log, or its line."""
        if not self.earliest_s <= time_s < LATEST_S:
            raise LogError(f"{place}: the time is {time_s:.6g} s, which no clock shows; export the log again")
        if self.latest_s is None:
            self.first_s = self.latest_s = time_s
        if time_s < self.latest_s - LONGEST_STEP_BACK_S:
            raise LogError(f"{place}: the time runs back from {self.latest_s:.6f} s to {time_s:.6f} s: two recordings in one, "
                           "logs that are not given in their order, or a clock that was set; cut or sort them, each recording "
                           "by itself")
        if time_s - self.latest_s > self.longest_gap_s:
            raise LogError(f"{place}: a gap of {time_s - self.latest_s:.0f} s after {self.latest_s:.6f} s: two recordings, or a "
                           "clock that was set; cut the log there")
        if time_s - self.first_s > self.longest_s:
            raise LogError(f"{place}: is longer than {self.longest_s / 3600:.0f} h; cut it, `rsi-sil replay` takes no longer "
                           "drive")
        self.latest_s = max(self.latest_s, time_s)
