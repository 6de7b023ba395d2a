"""What a warning was worth, by the rules of a campaign (docs/drives.md, What counts)."""

import math

from warning import CYCLE_S, WarningStates

EARLY_S, VERY_EARLY_S = 0.1, 0.2
ROUNDING_S = 1e-6
BANDS = ["below 0.7", "0.7 to 0.8", "0.8 to 0.9", "0.9 to lift"]
FEWEST_VEHICLES = 10  # from so many on, intervals count vehicles


def band(run):
    """Of a run without two-wheel lift-off, by its largest |LTR|."""
    return BANDS[sum(run.largest_ltr >= limit for limit in (0.7, 0.8, 0.9))]


def lead_s(warnings, lift_s, falling_side):
    """For how long, at lift-off, the falling side has been named; None if it is not. `warnings` has the named side of
    every cycle, None where there is no warning, from the first cycle on."""
    named, since_s = None, 0.0
    for cycle, side in enumerate(warnings):
        if cycle * CYCLE_S > lift_s + ROUNDING_S:
            break
        if side != named:
            named, since_s = side, cycle * CYCLE_S
    return max(0.0, lift_s - since_s) if named == falling_side else None


def firmware_warnings(run):
    """What the firmware's frames said."""
    return [side if state == "warning" and side != "none" else None for state, side in zip(run.states, run.sides)]


def warnings_by(run, right, left, threshold):
    """What the firmware's states make of these risks, until lift-off; at `threshold` they warn as at warning_on."""
    states = WarningStates(run.calibration)
    scale = run.calibration["warning_on"] / threshold
    cycles = len(run) if run.lift_s is None else min(len(run), int(run.lift_s / CYCLE_S + ROUNDING_S) + 1)
    named = []
    for cycle in range(cycles):
        states.update(scale * right[cycle], scale * left[cycle])
        named.append(states.side if states.state == "warning" else None)
    return named


def is_warned(lead, wanted_s=0.0):
    return lead is not None and lead >= wanted_s - ROUNDING_S


def wilson_interval(share, trials):
    z = 1.959963984540054  # 95 %
    centre = share + z * z / (2 * trials)
    half = z * math.sqrt(share * (1 - share) / trials + z * z / (4 * trials * trials))
    scale = 1 + z * z / trials
    return max(0.0, (centre - half) / scale), min(1.0, (centre + half) / scale)


class Share:
    """So many of so many runs, by vehicle; the intervals are those of sil/studies/campaign/statistics.cpp."""

    def __init__(self):
        self._vehicles = {}

    def add(self, vehicle, counts, of=1):
        if not of:
            return  # such a vehicle says nothing, and none of the intervals counts it
        cell = self._vehicles.setdefault(vehicle, [0, 0])
        cell[0] += int(counts)
        cell[1] += of

    @property
    def count(self):
        return sum(count for count, _ in self._vehicles.values())

    @property
    def total(self):
        return sum(total for _, total in self._vehicles.values())

    def value(self):
        return self.count / self.total if self.total else math.nan

    def interval(self):
        return wilson_interval(self.value(), self._independent()) if self.total else (0.0, 1.0)

    def _independent(self):
        vehicles, share = len(self._vehicles), self.value()
        if vehicles < FEWEST_VEHICLES:
            return self.total
        if self.count in (0, self.total):
            return vehicles
        squares = sum((count - share * total) ** 2 for count, total in self._vehicles.values())
        variance = vehicles / (vehicles - 1) * squares / self.total**2
        return min(max(share * (1 - share) / max(variance, 1e-300), 1.0), self.total)


class Verdict:
    """Of one warning over many runs."""

    def __init__(self):
        self.warned, self.warned_100ms, self.warned_200ms = Share(), Share(), Share()
        self.alarms = {name: Share() for name in BANDS}
        self.leads_s = {}  # of all runs with lift-off, 0 of those that were not warned of

    def add_lift_off(self, run, lead):
        self.warned.add(run.vehicle, is_warned(lead))
        self.warned_100ms.add(run.vehicle, is_warned(lead, EARLY_S))
        self.warned_200ms.add(run.vehicle, is_warned(lead, VERY_EARLY_S))
        self.leads_s[run] = lead or 0.0

    def add_other(self, run, alarm):
        self.alarms[band(run)].add(run.vehicle, alarm)
