"""Comparison of the signals of a drive: a wrong sign or unit of one of them shows."""

import collections

import numpy

from drive_rows import STEP_US

G_MPS2 = 9.80665
LEAST_CORRELATION = 0.6  # below, nothing is said: the drive may have been straight
LEAST_ROWS = 50
TURN_SLOPES = (0.5, 2.0)
ROLL_SLOPES = (0.1, 10.0)  # the angle may be that against a road that is banked
NEAR_ONE = (0.8, 1.25)     # a bank, a slide and a load do no more in ordinary turns
CLEAR_CORRELATION = 0.9    # from here on the ratio is that of two signals, not of noise
WINDOW_ROWS = 50
UPRIGHT_ROWS = 100       # the first second
LARGEST_ROLL_DEG = 15.0

# `first` and `second` should rise together; where `slopes` are given, by about as much: the ratio is between them.
Link = collections.namedtuple("Link", "first second correlation slope slopes")


def links(times_us, columns):
    """Comparable pairs of a drive's columns (in their units, on the clock of its rows)."""
    known = collections.defaultdict(lambda: None, columns)
    lateral, yaw, speed = known["lateral_acceleration"], known["yaw_rate"], known["speed"]
    roll_rate, roll, steering = known["roll_rate"], known["roll_angle"], known["steering_wheel_angle"]
    found = []

    def compare(first, one, second, other, slopes=None):
        link = compared(first, one, second, other, slopes)
        if link:
            found.append(link)

    if yaw is not None and speed is not None:
        compare("lateral_acceleration", lateral, "yaw_rate times speed", numpy.radians(yaw) * speed / 3.6, TURN_SLOPES)
    elif yaw is not None:
        compare("lateral_acceleration", lateral, "yaw_rate", yaw)
    if steering is not None:
        other = ("yaw_rate", yaw) if yaw is not None else ("lateral_acceleration", lateral)
        compare("steering_wheel_angle", steering, *other)
    if roll is not None:
        compare("roll_rate", turned(times_us, roll_rate), "the change of roll_angle", change(times_us, roll), ROLL_SLOPES)
        compare("roll_angle", roll, "lateral_acceleration", lateral)
    else:
        compare("roll_rate", turned(times_us, roll_rate), "the change of lateral_acceleration", change(times_us, lateral))
    return found


def is_regular(times_us):
    """Whether there is no gap within the window of rows that ends there; the rows before have none."""
    return times_us[WINDOW_ROWS:] - times_us[:-WINDOW_ROWS] == WINDOW_ROWS * STEP_US


def change(times_us, values):
    """Over a window of rows."""
    result = numpy.full(len(values), numpy.nan)
    if len(values) > WINDOW_ROWS:
        result[WINDOW_ROWS:] = numpy.where(is_regular(times_us), values[WINDOW_ROWS:] - values[:-WINDOW_ROWS], numpy.nan)
    return result


def turned(times_us, rate):
    """The integral of a rate over a window of rows."""
    result = numpy.full(len(rate), numpy.nan)
    if len(rate) > WINDOW_ROWS:
        steps = 0.5 * (rate + numpy.concatenate([rate[:1], rate[:-1]])) * STEP_US / 1.0e6
        angle = numpy.cumsum(numpy.nan_to_num(steps))
        unknown = numpy.cumsum(numpy.isnan(steps))
        is_known = is_regular(times_us) & (unknown[WINDOW_ROWS:] == unknown[:-WINDOW_ROWS])
        result[WINDOW_ROWS:] = numpy.where(is_known, angle[WINDOW_ROWS:] - angle[:-WINDOW_ROWS], numpy.nan)
    return result


def compared(first, one, second, other, slopes=None):
    is_known = ~(numpy.isnan(one) | numpy.isnan(other))
    if numpy.sum(is_known) < LEAST_ROWS:
        return None
    one, other = one[is_known], other[is_known]
    one, other = one - numpy.median(one), other - numpy.median(other)
    energy = float(numpy.sum(one * one)), float(numpy.sum(other * other))
    if min(energy) <= 0.0:
        return None
    both = float(numpy.sum(one * other))
    return Link(first, second, both / (energy[0] * energy[1]) ** 0.5, (energy[0] / energy[1]) ** 0.5, slopes)


def upright_mps2(columns):
    """The vertical acceleration of the first second; None where it is not known."""
    values = columns.get("vertical_acceleration")
    if values is None:
        return None
    values = values[:UPRIGHT_ROWS]
    values = values[~numpy.isnan(values)]
    return float(numpy.median(values)) if len(values) else None


def upright_rows(columns, rows):
    """How many of the rows there are before the vehicle goes over: afterwards nothing is proportional."""
    roll = columns.get("roll_angle")
    over = numpy.flatnonzero(numpy.abs(roll) > LARGEST_ROLL_DEG) if roll is not None else ()
    return int(over[0]) if len(over) and over[0] >= LEAST_ROWS else rows


def verdict_on(link):
    if abs(link.correlation) < LEAST_CORRELATION:
        return "says nothing"
    if link.correlation < 0.0:
        return "LOOK: they run against each other; one of the signs is wrong"
    if link.slopes and not link.slopes[0] < link.slope < link.slopes[1]:
        return "LOOK: the ratio should be near 1; one of the units is wrong"
    if link.slopes and link.correlation > CLEAR_CORRELATION and not NEAR_ONE[0] < link.slope < NEAR_ONE[1]:
        return "the signs agree, but the ratio should be near 1: check the units (of km/h and mph it is 1.6, of deg/s and rpm 6)"
    return "agree"


def outvoted(found):
    """The signals that run against the most of those that they are linked to; none if neither side is the larger."""
    clear = [link for link in found if abs(link.correlation) >= LEAST_CORRELATION]
    sides, wrong = {}, []
    for start in (signal_of(link.first) for link in clear):
        if start in sides:
            continue
        sides[start], reached = 1, [start]
        for name in reached:
            for link in clear:
                ends = signal_of(link.first), signal_of(link.second)
                if name in ends:
                    other = ends[name == ends[0]]
                    if other not in sides:
                        sides[other] = sides[name] * (1 if link.correlation > 0.0 else -1)
                        reached.append(other)
        groups = [[name for name in reached if sides[name] == side] for side in (1, -1)]
        wrong += min(groups, key=len) if len(groups[0]) != len(groups[1]) else []
    return wrong


def signal_of(compared_with):
    """The signal that "yaw_rate times speed" or "the change of roll_angle" is of."""
    return compared_with.removesuffix(" times speed").removeprefix("the change of ")


def reported(times_us, columns):
    """A line for each comparison, and whether something speaks against the mapping."""
    lines, is_doubtful = [], False
    rows = upright_rows(columns, len(times_us))
    found = links(times_us[:rows], {name: values[:rows] for name, values in columns.items()})
    for link in found:
        text = f"{link.first} and {link.second}: correlation {link.correlation:+.2f}"
        text += f", ratio {link.slope:.3g}" if link.slopes else ""
        verdict = verdict_on(link)
        is_doubtful = is_doubtful or verdict.startswith("LOOK")
        lines.append(f"{text}: {verdict}")
    wrong = outvoted(found)
    if wrong:
        run = "runs" if len(wrong) == 1 else "run"
        lines.append(f"LOOK: {' and '.join(wrong)} {run} against the others: probably that sign is wrong")
    upright = upright_mps2(columns)
    if upright is not None and not 0.5 * G_MPS2 < upright < 2.0 * G_MPS2:
        is_doubtful = True
        lines.append(f"vertical_acceleration is {upright:.3g} m/s^2 in the first second: LOOK: it should be about "
                     f"+{G_MPS2:.2f}; is the sign or the unit wrong, or is gravity not in it (then offset = 1 g in its unit)?")
    return lines, is_doubtful
