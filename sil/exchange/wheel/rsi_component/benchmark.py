"""All indices over many drives, at equal alarms."""

from __future__ import annotations

import math
import typing
from collections.abc import Mapping, Sequence
from itertools import compress

import numpy as np
import numpy.typing as npt

from . import judge, rows
from .component import Run, indices
from .refused import Refused
from .truth import Truth

WARNING = "warning"


class Drive(typing.NamedTuple):
    """A run, its true outcome, and the vehicle's name: runs of one vehicle are alike, which intervals count.

    others: indices of your own, by name: levels of the risk of falling to the right and to the left, each of shape (n,),
            0 without risk, 1 where the index says "warn"
    """

    run: Run
    truth: Truth
    vehicle: str = ""
    others: Mapping[str, tuple[npt.ArrayLike, npt.ArrayLike]] = {}


class _OfComponent(typing.NamedTuple):
    """An index of the component in one drive."""

    name: str
    drive: Drive

    def lead_s(self, threshold: float) -> float | None:
        return self.drive.run.lead_s(self.name, threshold, self.drive.truth)

    def alarms(self, threshold: float) -> bool:
        return self.drive.run.alarms(self.name, threshold)

    def alarm_threshold(self) -> float:
        return self.drive.run.alarm_threshold(self.name)


class _OfOthers:
    """An index of the user in one drive, behind the same warning states."""

    def __init__(self, name: str, drive: Drive) -> None:
        run, truth = drive.run, drive.truth
        right, left = (rows.series(name, level, len(run)) for level in drive.others[name])
        if not np.all(np.isfinite([right, left])):
            raise Refused(f"{name} has rows without a number; give 0 where the index sees no risk")
        self._index = judge.Index(run.calibration, run.time_s, right, left)
        self._truth = truth

    def lead_s(self, threshold: float) -> float | None:
        lift_s = self._truth.two_wheel_lift_s
        return None if lift_s is None else self._index.lead_s(threshold, lift_s, self._truth.falling_side)

    def alarms(self, threshold: float) -> bool:
        return self._index.alarms(threshold)

    def alarm_threshold(self) -> float:
        return self._index.alarm_threshold()


class Entry(typing.NamedTuple):
    """An index, or the component's own warning."""

    threshold: float  # at which it was compared; inf: it never alarms; of the component's own warning NaN
    detection: judge.Detection


class Benchmark(typing.NamedTuple):
    """Entries by name, the component's own warning under "warning"; each index at the threshold of as many alarms."""

    entries: dict[str, Entry]
    band: str  # of the drives in which alarms are equally frequent
    alarm_share: float  # of these drives that every index alarms in, at least

    def __str__(self) -> str:
        """A table: warned of two-wheel lift-offs, at all, 0.1 s and 0.2 s before; alarms by band. Counts of drives."""
        heads = ["", "threshold", "warned", "0.1 s", "0.2 s", "lead s", *judge.bands()]
        lines = [heads]
        for name, (threshold, found) in self.entries.items():
            shares = [found.warned, found.warned_100ms, found.warned_200ms, *found.alarms.values()]
            counts = [f"{share.count}/{share.total}" for share in shares]
            lines.append([name, f"{threshold:.3f}", *counts[:3], f"{found.median_lead_s:.2f}", *counts[3:]])
        widths = [max(len(line[column]) for line in lines) for column in range(len(heads))]
        return "\n".join(
            "  ".join(
                cell.ljust(width) if column == 0 else cell.rjust(width)
                for column, (cell, width) in enumerate(zip(line, widths))
            ).rstrip()
            for line in lines
        )


def benchmark(drives: Sequence[Drive], alarm_share: float | None = None, band: str | None = None) -> Benchmark:
    """Compares the component's own warning with every index, and with yours, as the project's benchmark does.

    Each index stands behind a copy of the component's warning states, at the largest threshold at which it alarms in at
    least `alarm_share` (0 to 1; default: the share of the component's own warning) of the drives without two-wheel
    lift-off whose largest |LTR| is in `band` (one of rsi.bands(); default: "0.8 to 0.9").
    """
    band = judge.bands()[judge.LEVEL_BAND] if band is None else band
    rows.known("band", band, judge.bands())
    for place, drive in enumerate(drives):
        if drive.truth.two_wheel_lift_s is None and not np.any(np.isfinite(drive.truth.load_transfer_ratio)):
            raise Refused(
                f"drive {place} has no load transfer ratio, so its band is not known; give it, or leave it out"
            )
    own = [drive.run.judge(drive.truth) for drive in drives]
    alarms = [found.warnings > 0 for found in own]
    near = [found.band == band for found in own]
    if not any(near):
        raise Refused(
            f"no drive without two-wheel lift-off has its largest |LTR| in the band {band}, so alarms cannot be made "
            "equally frequent; give such drives, or another band"
        )
    if alarm_share is None:
        alarm_share = sum(compress(alarms, near)) / sum(near)
    elif not 0 <= alarm_share <= 1:
        raise Refused(f"alarm_share is {alarm_share}; give a share from 0 to 1")
    entries = {WARNING: Entry(math.nan, _detection(drives, own, [found.lead_s for found in own], alarms))}
    for name, everywhere in _indices(drives).items():
        threshold = judge.matched_threshold(
            [index.alarm_threshold() for index in compress(everywhere, near)], alarm_share
        )
        leads = [index.lead_s(threshold) for index in everywhere]
        raised = [index.alarms(threshold) for index in everywhere]
        entries[name] = Entry(threshold, _detection(drives, own, leads, raised))
    return Benchmark(entries, band, alarm_share)


def _indices(drives: Sequence[Drive]) -> dict[str, Sequence[_OfComponent | _OfOthers]]:
    """Each index in every drive."""
    found: dict[str, Sequence[_OfComponent | _OfOthers]] = {
        name: [_OfComponent(name, drive) for drive in drives] for name in indices()
    }
    for name in dict.fromkeys(name for drive in drives for name in drive.others):
        if name in found or name == WARNING:
            raise Refused(f"the component has an index {name}; give yours another name")
        for place, drive in enumerate(drives):
            if name not in drive.others:
                raise Refused(f"drive {place} has no index {name}, which others have; give it in every drive")
        found[name] = [_OfOthers(name, drive) for drive in drives]
    return found


def _detection(
    drives: Sequence[Drive], own: list[judge.Judgement], leads: list[float | None], alarms: list[bool]
) -> judge.Detection:
    return judge.detection(
        [drive.vehicle for drive in drives],
        [drive.truth.two_wheel_lift_s for drive in drives],
        [found.largest_ltr for found in own],
        leads,
        alarms,
    )
