"""Goals of the warning beside the results: for a group in the report.json of a campaign."""

import typing

# In the order of `figures`.
WITHOUT_ERRORS = (1.0, 0.995, 0.85, 0.40, 0.0, 0.0, 0.10, 0.0)
WITH_ERRORS = (0.995, 0.99, 0.80, 0.36, 0.0, 0.003, 0.25, 0.1)


EQUAL_ALARMS = (0.01, 0.05)  # shares of the calm runs at which indices are compared


def best_point(group, index, limit):
    """The point of the index that warns most often with at most this share of alarms in calm runs; its threshold is None if no
    threshold has so few."""
    return next(best for best in group["indices"][index]["best"] if abs(best["false_alarms_at_most"] - limit) < 1e-9)


def percent(share):
    return "-" if share["of"] == 0 else f"{100.0 * share['share']:.2f} %"


class Figure(typing.NamedTuple):
    """The quantity of a goal."""

    name: str
    bound: str
    value: typing.Optional[float]  # None: there is nothing to measure it in
    unit: str
    text: str
    interval: str = ""  # 95 % confidence, to stand after the text

    def goal(self, limit):
        return f"{self.bound} {100.0 * limit if self.unit == '%' else limit:g} {self.unit}"

    def verdict(self, limit):
        met = self.value is not None and (self.value >= limit if self.bound == "at least" else self.value <= limit)
        return "yes" if met else "**no**"


def _of_share(name, bound, share):
    if share["of"] == 0:
        return Figure(name, bound, None, "%", percent(share))
    low, high = share["confidence_95"]
    interval = f" ({100.0 * low:.2f} to {100.0 * high:.2f})"
    return Figure(name, bound, share["share"], "%", percent(share), interval)


def figures(group, index="warning"):
    """Entry of the firmware's warning, or of an index at 1."""
    warning, wrong_s = group["indices"][index], group["wrong_side_s_per_1000_runs"]
    median, alarms = warning["lead_time_median_s"], warning["alarms"]
    return (
        _of_share("warned, right side", "at least", warning["warned"]),
        _of_share("at least 0.1 s before", "at least", warning["warned_100ms_before"]),
        _of_share("at least 0.2 s before", "at least", warning["warned_200ms_before"]),
        Figure("median lead", "at least", median, "s", "-" if median is None else f"{median:.3f} s"),
        _of_share("alarms, largest \\|LTR\\| below 0.7", "at most", alarms["below 0.7"]),
        _of_share("alarms, 0.7 to 0.8", "at most", alarms["0.7 to 0.8"]),
        _of_share("alarms, 0.8 to 0.9", "at most", alarms["0.8 to 0.9"]),
        Figure("wrong side beyond 0.1 s after the swing, in 1,000 runs", "at most", wrong_s, "s", f"{wrong_s:.2f} s"),
    )
