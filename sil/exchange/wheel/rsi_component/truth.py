"""True outcome of a drive."""

from __future__ import annotations

import ctypes
import math

import numpy as np
import numpy.typing as npt

from . import interface, rows
from .component import SIDES
from .refused import Refused


class Truth:
    """True outcome of a drive of n rows.

    load_transfer_ratio: (26) of the wheel loads, float64 of shape (n,), positive in a left turn; NaN: not known
    two_wheel_lift_s:    both wheels of one side began to carry nothing for 50 ms or longer, in s; None: they did not
    one_wheel_lift_s:    the same of any wheel, of any length
    falling_side:        "left" or "right": the side to which the vehicle then falls; "none" without two-wheel lift-off
    """

    def __init__(
        self,
        load_transfer_ratio: npt.ArrayLike,
        two_wheel_lift_s: float | None = None,
        falling_side: str = "none",
        one_wheel_lift_s: float | None = None,
    ) -> None:
        """As you know it: a lift-off that was seen, with its side."""
        rows.known("side", falling_side, SIDES)
        if (two_wheel_lift_s is None) != (falling_side == "none"):
            raise Refused("two_wheel_lift_s and falling_side belong together: give both, or neither")
        if two_wheel_lift_s is not None and not math.isfinite(two_wheel_lift_s):
            raise Refused(f"two_wheel_lift_s is {two_wheel_lift_s}; give a time in s, or None")
        self.load_transfer_ratio = rows.series("load_transfer_ratio", load_transfer_ratio)
        self.two_wheel_lift_s = two_wheel_lift_s
        self.one_wheel_lift_s = one_wheel_lift_s
        self.falling_side = falling_side

    @classmethod
    def of_wheel_loads(
        cls,
        time_s: npt.ArrayLike,
        front_left_n: npt.ArrayLike,
        front_right_n: npt.ArrayLike,
        rear_left_n: npt.ArrayLike,
        rear_right_n: npt.ArrayLike,
        lateral_acceleration_mps2: npt.ArrayLike | None = None,
    ) -> Truth:
        """By measured wheel loads in N, each of shape (n,), of a drive that begins with all wheels on the road.

        A wheel is up where it carries less than 1 % of its static load, a quarter of the vehicle's weight. The lateral
        acceleration (positive to the left) decides the side if both sides lift at once.
        """
        times = rows.times(time_s)
        loads = [
            rows.series(name, values, len(times))
            for name, values in (
                ("front_left_n", front_left_n),
                ("front_right_n", front_right_n),
                ("rear_left_n", rear_left_n),
                ("rear_right_n", rear_right_n),
            )
        ]
        force = (
            None
            if lateral_acceleration_mps2 is None
            else rows.series("lateral_acceleration_mps2", lateral_acceleration_mps2, len(times))
        )
        ratios = np.empty(len(times))
        found = interface.library().component_find_lift_off(
            len(times),
            times.ctypes.data,
            (ctypes.c_void_p * 4)(*(load.ctypes.data for load in loads)),
            None if force is None else force.ctypes.data,
            ratios.ctypes.data,
        )
        if math.isnan(found.up_below_n):
            raise Refused("no row has all four wheel loads, so lift-off is not known; give Truth(...) instead")
        lift_s, one_s = (None if math.isnan(value) else value for value in (found.two_wheel_s, found.one_wheel_s))
        return cls(ratios, lift_s, SIDES[found.falling_side] if lift_s is not None else "none", one_s)

    @property
    def lift_s_or_nan(self) -> float:
        return math.nan if self.two_wheel_lift_s is None else self.two_wheel_lift_s

    def belongs_to(self, time_s: npt.NDArray[np.float64]) -> None:
        if len(self.load_transfer_ratio) != len(time_s):
            raise Refused(
                f"load_transfer_ratio has {len(self.load_transfer_ratio)} rows, the run has {len(time_s)}; give as many"
            )
        if self.two_wheel_lift_s is not None and not time_s[0] <= self.two_wheel_lift_s <= time_s[-1]:
            raise Refused(
                f"two wheels lift at {self.two_wheel_lift_s:.6g} s, but the run is from {time_s[0]:.6g} to "
                f"{time_s[-1]:.6g} s; give both on one clock"
            )
