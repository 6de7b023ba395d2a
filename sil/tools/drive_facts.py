"""Turns and sizes of a drive, for a person to compare with the driving, and its use in a calibration."""

import collections

import numpy

import drive_rows
from drive_quantities import QUANTITIES, WHEEL_LOADS

TURN_MPS2, TURN_ROWS, SHOWN_TURNS = 2.0, 50, 4  # a turn is as rsi-sil validate has it
SMOOTHED_ROWS = 31
SLOW_MPS3, HARD_MPS2 = 3.0, 3.5  # a slow ramp grows no faster, and to no less

Turn = collections.namedtuple("Turn", "start_s end_s side largest_mps2")


def smooth(values):
    known = numpy.where(numpy.isnan(values), 0.0, values)
    return numpy.convolve(known, numpy.ones(SMOOTHED_ROWS) / SMOOTHED_ROWS, mode="same")


def turns(drive):
    """By the yaw rate where there is one: a slide or a bank has lateral acceleration, too."""
    lateral = smooth(drive.columns["lateral_acceleration"])
    yaw = smooth(drive.columns["yaw_rate"]) if "yaw_rate" in drive.columns else lateral
    times_s, found = drive.times_us / 1.0e6, []
    side = numpy.where(numpy.abs(lateral) < TURN_MPS2, 0, numpy.sign(yaw)).astype(int)
    edges = [0, *(numpy.flatnonzero(numpy.diff(side)) + 1).tolist(), len(side)]
    for first, end in zip(edges, edges[1:]):
        if side[first] and end - first >= TURN_ROWS:
            found.append(Turn(times_s[first], times_s[end - 1], "left" if side[first] > 0 else "right",
                              float(numpy.max(numpy.abs(lateral[first:end])))))
    return found


def facts(drive):
    """Lines to compare with the driving."""
    times_s, found = drive.times_us / 1.0e6, turns(drive)
    lateral = numpy.nan_to_num(drive.columns["lateral_acceleration"])
    hardest = int(numpy.argmax(numpy.abs(lateral)))
    shown = sorted(sorted(found, key=lambda turn: -turn.largest_mps2)[:SHOWN_TURNS])
    listed = ", ".join(f"{turn.side} {turn.start_s:.1f} to {turn.end_s:.1f} s" for turn in shown)
    lefts = sum(turn.side == "left" for turn in found)
    lines = [f"{times_s[-1] - times_s[0]:.1f} s from {times_s[0]:.1f} s; largest lateral acceleration "
             f"{abs(lateral[hardest]):.2f} m/s^2 at {times_s[hardest]:.2f} s",
             f"{len(found)} turn{'' if len(found) == 1 else 's'}, {lefts} to the left and {len(found) - lefts} to the right"
             + (f"{'; the hardest' if len(found) > len(shown) else ''}: {listed}" if found else "")]
    missing = [name for name in QUANTITIES if name not in (*drive.columns, *WHEEL_LOADS)]
    missing += ["wheel loads"] if WHEEL_LOADS[0] not in drive.columns else []
    return lines + ([f"missing: {', '.join(missing)}"] if missing else [])


def hardest_mps2(drive):
    return float(numpy.abs(smooth(drive.columns["lateral_acceleration"])).max())


def purpose(drive):
    """The use of a drive in a calibration, "ramp" or "dynamic" as rsi-sil validate reads it from a name, or "": by how fast the
    lateral acceleration grows to a hard turn, or to the hardest."""
    size = numpy.abs(smooth(drive.columns["lateral_acceleration"]))
    if size.max() < TURN_MPS2:
        return ""
    until = int(numpy.argmax(size >= min(HARD_MPS2, size.max()))) + 1
    size = numpy.concatenate([numpy.full(TURN_ROWS, size[0]), size[:until]])
    growth_mps3 = float(numpy.max(size[TURN_ROWS:] - size[:-TURN_ROWS])) / (TURN_ROWS * drive_rows.STEP_US / 1.0e6)
    return "dynamic" if growth_mps3 > SLOW_MPS3 else "ramp" if size.max() >= HARD_MPS2 else ""


def is_to_both_sides(drive):
    return len({turn.side for turn in turns(drive)}) == 2
