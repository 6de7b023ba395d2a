"""Recorded values of a signal, from any kind of log."""

import array
import collections
import math

import numpy

import drive_rows
from log_error import LogError
from mapping import IGNORED, ROLES

# A signal as it was recorded: ascending microseconds, numbers, its unit there, how many values were not to be had by
# their reason, and what is doubtful of it.
Recorded = collections.namedtuple("Recorded", "times_us values unit left_out doubts", defaults=((),))

OUTSIDE = "outside the DBC file's range"
TEXTS = "texts"
MOST_CODES = 4             # that a sender has for "not available": so many values beyond a range speak for the range
LARGEST_SHARE = 1.0 / 3.0  # of the values; a range that leaves more out is none
LONGEST_STEP_BACK_S = 0.2  # recorders of several buses write that much out of order
LATEST_S = 1.0e10          # the year 2286
LONGEST_GAP_S = 3600.0     # as rsi-sil replay has it
LONGEST_DRIVE_S = 12 * 3600.0


class Collected:
    """The values of one signal of a mapped quantity while the logs are read. `role` is its key in the mapping."""

    def __init__(self, entry, signal, role="signal"):
        self.entry = entry
        self.signal = signal
        self.role = role
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
        else:
            self.times_us.append(time_us)
            self.values.append(value)

    def limits(self):
        """The range that the mapping sets, or the DBC file's; None where there is none."""
        if self.role == "sign" or self.entry.range == IGNORED:
            return None
        low, high = self.entry.range or (self.signal.minimum, self.signal.maximum)
        if low is None or high is None or not low < high:
            return None
        room = 0.5 * abs(self.signal.scale) if not self.signal.is_float else 1.0e-6 * (high - low)
        return float(low) - room, float(high) + room

    def recorded(self):
        times_us = numpy.frombuffer(self.times_us, dtype="i8") if self.times_us else numpy.empty(0, dtype="i8")
        values = numpy.frombuffer(self.values, dtype="f8") if self.values else numpy.empty(0)
        left_out = {f"{reason}, such as '{self.examples[0]}'" if reason == TEXTS else reason: count
                    for reason, count in self.left_out.items()}
        limits, doubts = self.limits(), ()
        if limits:
            outside = (values < limits[0]) | (values > limits[1])
            count = int(numpy.sum(outside))
            why = contradiction(values, outside) if count and not self.entry.range else None
            if why:
                doubts = (f"the DBC file's range {self.signal.minimum:g} to {self.signal.maximum:g} of {self.name()} would leave "
                          f"{count} of {len(values)} values out, {why}: they are kept; range = \"{IGNORED}\" in the mapping "
                          "confirms it, range = [least, largest] sets another",)
            elif count:
                left_out["outside the mapping's range" if self.entry.range else OUTSIDE] = count
                times_us, values = times_us[~outside], values[~outside]
        return Recorded(*in_order(times_us, values), self.signal.unit, left_out, doubts)

    def name(self):
        return getattr(self.entry, ROLES[self.role])


def contradiction(values, outside):
    """Why a range that leaves these values out is a mistake; None where they are codes for "not available"."""
    if len(numpy.unique(values[outside])) <= MOST_CODES:
        return None
    for word, of_sign in (("negative", values < 0.0), ("positive", values > 0.0)):
        if numpy.any(of_sign) and numpy.all(outside[of_sign]):
            return f"all that are {word}"
    return "a third or more" if numpy.mean(outside) >= LARGEST_SHARE else None


def combined(parts, mapping):
    """The values of a quantity from those of its signals, by their roles."""
    main, entry = parts["signal"].recorded(), parts["signal"].entry
    for role in ("sign", "minus"):
        if role in parts:
            other = parts[role].recorded()
            main = (signed if role == "sign" else difference)(main, other, entry, mapping)
            main = main._replace(doubts=main.doubts + other.doubts)
    return main


def signed(magnitude, sign, *_):
    """Negative where the sign is 1, as it was last sent."""
    last = numpy.searchsorted(sign.times_us, magnitude.times_us, side="right") - 1
    age_us = magnitude.times_us - sign.times_us[numpy.maximum(last, 0)] if len(sign.times_us) else magnitude.times_us
    is_known = (last >= 0) & (age_us <= drive_rows.bridged_us(drive_rows.examine(sign.times_us).period_us))
    values = magnitude.values[is_known] * numpy.where(sign.values[last[is_known]] > 0.5, -1.0, 1.0)
    return known_part(magnitude, is_known, values, "no sign at their time")


def difference(first, second, entry, mapping):
    """The first less the second, in the unit of the first."""
    reason = "nothing to subtract at their time"
    if len(second.times_us) < 2:
        return known_part(first, numpy.zeros(len(first.times_us), dtype=bool), first.values[:0], reason)
    factor = mapping.unit_factor(entry, second.unit) / mapping.unit_factor(entry, first.unit)
    period_us = drive_rows.examine(second.times_us).period_us
    other, is_known = drive_rows.interpolated(second.times_us, second.values * factor, first.times_us,
                                              drive_rows.bridged_us(period_us), period_us)
    return known_part(first, is_known, (first.values - other)[is_known], reason)


def known_part(recorded, is_known, values, reason):
    count = len(is_known) - int(numpy.sum(is_known))
    left_out = {**recorded.left_out, **({reason: count} if count else {})}
    return recorded._replace(times_us=recorded.times_us[is_known], values=values, left_out=left_out)


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
