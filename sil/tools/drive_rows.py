"""Signals of any rates on the common clock of a drive: a row every 10 ms, nothing invented in gaps."""

import collections

import numpy

STEP_US = 10_000
# As sil/studies/drives/resample.hpp: so long a silence is bridged, and a signal this fast is averaged.
LONGEST_BRIDGED_US = 35_000
FAST_US = 9_500
PERIODS_BRIDGED = 2.5  # of a signal that comes more rarely

# One signal of the log, for the account. Times in microseconds.
Found = collections.namedtuple("Found", "period_us missing gaps longest_us")


def examine(times_us):
    """How often the signal comes, and what is missing of it."""
    steps = numpy.diff(times_us)
    if not len(steps):
        return Found(0, 0, 0, 0)
    period_us = max(int(numpy.median(steps)), 1)
    longer = steps[steps > 1.5 * period_us]
    gaps = steps[steps > bridged_us(period_us)]
    return Found(period_us, int(numpy.sum(numpy.rint(longer / period_us) - 1)), len(gaps), int(steps.max()))


def bridged_us(period_us):
    return max(LONGEST_BRIDGED_US, PERIODS_BRIDGED * period_us)


def sampled(times_us, values, grid_us):
    """The signal at the times of the grid, NaN where it is not known."""
    period_us = examine(times_us).period_us
    if len(times_us) < 2:
        return numpy.full(len(grid_us), numpy.nan)
    linear, is_known = interpolated(times_us, values, grid_us, bridged_us(period_us), period_us)
    if period_us >= FAST_US:
        return numpy.where(is_known, linear, numpy.nan)
    return numpy.where(is_known, averaged(times_us, values, grid_us, linear), numpy.nan)


def interpolated(times_us, values, grid_us, longest_us, period_us):
    """Linear between neighbours. Before the first value and after the last one it is held for a period, as a receiver does until
    the next one is due."""
    after = numpy.clip(numpy.searchsorted(times_us, grid_us, side="left"), 1, len(times_us) - 1)
    before = after - 1
    share = (grid_us - times_us[before]) / (times_us[after] - times_us[before])
    inside = (grid_us > times_us[0] - period_us) & (grid_us < times_us[-1] + period_us)
    share = numpy.clip(share, 0.0, 1.0)
    result = values[before] * (1.0 - share) + values[after] * share
    is_gap = times_us[after] - times_us[before] > longest_us
    # Beside a gap a row has the value that was measured within half a step of it.
    nearest = numpy.where(share < 0.5, before, after)
    is_near = numpy.abs(times_us[nearest] - grid_us) <= STEP_US / 2
    return numpy.where(is_gap, values[nearest], result), inside & (~is_gap | is_near)


def averaged(times_us, values, grid_us, otherwise):
    """The mean within a step on either side, weighted by a triangle."""
    place = (times_us - grid_us[0]) / STEP_US
    left = numpy.floor(place).astype("i8")
    share = place - left
    sums, weights = numpy.zeros(len(grid_us)), numpy.zeros(len(grid_us))
    for index, weight in ((left, 1.0 - share), (left + 1, share)):
        inside = (index >= 0) & (index < len(grid_us))
        sums += numpy.bincount(index[inside], weights=(values * weight)[inside], minlength=len(grid_us))
        weights += numpy.bincount(index[inside], weights=weight[inside], minlength=len(grid_us))
    return numpy.where(weights > 0.5, sums / numpy.maximum(weights, 1.0e-9), otherwise)
