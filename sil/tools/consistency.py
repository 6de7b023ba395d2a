"""What the signals of a drive say of each other: a wrong sign or unit of one of them shows."""

import collections

import numpy

G_MPS2 = 9.80665
LEAST_CORRELATION = 0.6  # below, nothing is said: the drive may have been straight
LEAST_ROWS = 50
SLOPES = (0.5, 2.0)      # of quantities that should be alike
UPRIGHT_ROWS = 100       # the first second
LARGEST_ROLL_DEG = 15.0

# `first` and `second` should rise together; where `slope` is given, by about as much.
Link = collections.namedtuple("Link", "first second correlation slope")


def links(times_us, columns):
    """What can be compared of a drive's columns (in their units, on the clock of its rows)."""
    time_s = times_us / 1.0e6
    known = collections.defaultdict(lambda: None, columns)
    lateral, yaw, speed = known["lateral_acceleration"], known["yaw_rate"], known["speed"]
    roll_rate, roll, steering = known["roll_rate"], known["roll_angle"], known["steering_wheel_angle"]
    found = []

    def compare(first, one, second, other, alike=False):
        link = compared(first, one, second, other, alike)
        if link:
            found.append(link)

    if yaw is not None and speed is not None:
        compare("lateral_acceleration", lateral, "yaw_rate times speed", numpy.radians(yaw) * speed / 3.6, alike=True)
    elif yaw is not None:
        compare("lateral_acceleration", lateral, "yaw_rate", yaw)
    if steering is not None:
        other = ("yaw_rate", yaw) if yaw is not None else ("lateral_acceleration", lateral)
        compare("steering_wheel_angle", steering, *other)
    if roll is not None:
        compare("roll_rate", roll_rate, "the change of roll_angle", change(time_s, roll), alike=True)
        compare("roll_angle", roll, "lateral_acceleration", lateral)
    else:
        compare("roll_rate", roll_rate, "the change of lateral_acceleration", change(time_s, lateral))
    return found


def change(time_s, values):
    """Per second, over five rows."""
    result = numpy.full(len(values), numpy.nan)
    steps = time_s[4:] - time_s[:-4]
    result[2:-2] = numpy.where(steps < 0.1, (values[4:] - values[:-4]) / steps, numpy.nan)
    return result


def compared(first, one, second, other, alike):
    is_known = ~(numpy.isnan(one) | numpy.isnan(other))
    if numpy.sum(is_known) < LEAST_ROWS:
        return None
    one, other = one[is_known], other[is_known]
    one, other = one - numpy.median(one), other - numpy.median(other)
    energy = float(numpy.sum(one * one)), float(numpy.sum(other * other))
    if min(energy) <= 0.0:
        return None
    both = float(numpy.sum(one * other))
    return Link(first, second, both / (energy[0] * energy[1]) ** 0.5, (energy[0] / energy[1]) ** 0.5 if alike else None)


def upright_mps2(columns):
    """The vertical acceleration of the first second; None where it is not known."""
    values = columns.get("vertical_acceleration")
    if values is None:
        return None
    values = values[:UPRIGHT_ROWS]
    values = values[~numpy.isnan(values)]
    return float(numpy.median(values)) if len(values) else None


def upright_rows(columns):
    """How many rows there are before the vehicle goes over: afterwards nothing is proportional."""
    roll = columns.get("roll_angle")
    over = numpy.flatnonzero(numpy.abs(roll) > LARGEST_ROLL_DEG) if roll is not None else ()
    return int(over[0]) if len(over) and over[0] >= LEAST_ROWS else len(next(iter(columns.values())))


def told(times_us, columns):
    """A line for each comparison, and whether something speaks against the mapping."""
    lines, is_doubtful = [], False
    rows = upright_rows(columns)
    for link in links(times_us[:rows], {name: values[:rows] for name, values in columns.items()}):
        text = f"{link.first} and {link.second}: correlation {link.correlation:+.2f}"
        text += f", ratio {link.slope:.3g}" if link.slope is not None else ""
        if abs(link.correlation) < LEAST_CORRELATION:
            verdict = "says nothing"
        elif link.correlation < 0.0:
            verdict = "LOOK: they run against each other; one of the signs is wrong"
        elif link.slope is not None and not SLOPES[0] < link.slope < SLOPES[1]:
            verdict = "LOOK: the ratio should be near 1; one of the units is wrong"
        else:
            verdict = "agree"
        is_doubtful = is_doubtful or verdict.startswith("LOOK")
        lines.append(f"{text}: {verdict}")
    upright = upright_mps2(columns)
    if upright is not None and not 0.5 * G_MPS2 < upright < 2.0 * G_MPS2:
        is_doubtful = True
        lines.append(f"vertical_acceleration is {upright:.3g} m/s^2 in the first second: LOOK: it should be about "
                     f"+{G_MPS2:.2f}; is the sign or the unit wrong, or is gravity not in it (then offset = 1 g in its unit)?")
    return lines, is_doubtful
