"""Time series of a user: what is accepted as one."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import numpy.typing as npt

from .refused import Refused

STEP_S = 0.01
LARGEST_JITTER_S = 0.003
LARGEST_DRIFT = 0.001  # of the mean step, as a share
HOLD = (
    "resample first, by holding the newest value: grid = numpy.arange(time_s[0], time_s[-1], 0.01); "
    'newest = numpy.searchsorted(time_s, grid + 1e-6, side="right") - 1; then give grid, and x[newest] for each x, '
    "NaN where grid - time_s[newest] is longer than your sensor may be silent"
)
MILLISECONDS = 1000.0 * STEP_S  # step of times that are in ms


def known(kind: str, name: str, names: Iterable[str]) -> None:
    if name not in names:
        raise Refused(f"there is no {kind} {name}; there are: {', '.join(names)}")


def series(name: str, values: npt.ArrayLike, count: int | None = None) -> npt.NDArray[np.float64]:
    """One value a row, a copy of what was given."""
    try:
        if getattr(values, "dtype", np.dtype(float)).kind in "mM":
            raise TypeError("it holds dates")
        array = np.array(np.ma.filled(np.ma.array(values, np.float64, ndmin=1), np.nan), order="C")  # without gaps
    except (TypeError, ValueError) as error:
        raise Refused(
            f"{name} is no array of numbers: {error}; give one number a row, NaN where it is not known"
        ) from None
    if array.ndim != 1:
        raise Refused(f"{name} has the shape {array.shape}; give one number a row, shape (n,)")
    if count is not None and len(array) != count:
        raise Refused(f"{name} has {len(array)} rows, but time_s has {count}; give as many")
    return array


def times(time_s: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """Rows 0.01 s apart, but for jitter."""
    array = series("time_s", time_s)
    if len(array) == 0:
        raise Refused("time_s has no row")
    steps = np.diff(array)
    if not np.all(np.isfinite(array)) or np.any(steps <= 0):
        row = int(np.flatnonzero(~(steps > 0))[0]) + 1 if len(steps) else 0
        raise Refused(
            f"time_s does not increase at row {row}: {array[row]}; give the rows in their order, each with a time in s"
        )
    if len(steps) and abs(float(np.median(steps)) - MILLISECONDS) < 0.5 * MILLISECONDS:
        raise Refused(f"time_s: rows are {np.median(steps):.6g} apart, as in ms; give seconds: time_s / 1000")
    odd = np.flatnonzero(np.abs(steps - STEP_S) > LARGEST_JITTER_S)
    if len(odd):
        row = int(odd[0]) + 1
        raise Refused(
            f"time_s: row {row} comes {steps[row - 1]:.6g} s after the one before, and the component steps every "
            f"{STEP_S} s; {HOLD}"
        )
    mean_s = float(array[-1] - array[0]) / len(steps) if len(steps) else STEP_S
    if abs(mean_s - STEP_S) > max(LARGEST_DRIFT * STEP_S, LARGEST_JITTER_S / max(len(steps), 1)):
        raise Refused(
            f"time_s: rows are {mean_s:.6g} s apart in the mean, and the component steps every {STEP_S} s; {HOLD}"
        )
    return array
