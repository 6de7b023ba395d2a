"""The part of docs/reports/validation.md about a campaign, from its folder."""

import json
import re
import tomllib

from figures import PAPERS


def _percent(share):
    return "-" if share["of"] == 0 else f"{100.0 * share['share']:.2f} %"


def _goals(group, slack):
    """What was aimed at, beside what came out. The shares that fail may be `slack` times those of the goal."""
    warning = group["indices"]["warning"]
    median = warning["lead_time_median_s"]
    goals = [
        ("two-wheel lift-offs warned before they happen", "at least", 1.0 - 0.005 * slack, warning["warned"]),
        ("0.1 s or more before", "at least", 1.0 - 0.02 * slack, warning["warned_100ms_before"]),
        ("alarms in calm runs", "at most", 0.01 * slack, warning["false_alarms"]),
    ]
    lines = []
    for what, bound, limit, share in goals:
        reached = -1.0 if share["of"] == 0 else share["share"]
        met = reached >= limit if bound == "at least" else 0.0 <= reached <= limit
        lines.append((what, f"{bound} {100 * limit:g} %", _percent(share), met))
    lines.append(("median lead", f"at least {0.3 / slack:.2f} s", "-" if median is None else f"{median:.3f} s",
                  median is not None and median >= 0.3 / slack))
    return [f"| {group['name']} | {what} | {goal} | {value} | {'yes' if met else '**no**'} |" for what, goal, value, met in lines]


def _goal_table(report):
    every = dict(report["all"], name="all vehicles")
    lines = ["| the default warning | | goal | reached | |", "|---|---|---|---|---|", *_goals(every, 1.0)]
    for group in report["vehicles"]:
        if group["name"] == "van":  # which nobody tuned for
            lines += _goals(group, 2.0)
    return "\n".join(lines)


def _curves(report, chosen):
    """The default index against the best of the paper's, at equal false alarms. The published RSI ends at 1, (25), and has
    no threshold beyond; the bank-free one is the same without that end."""
    indices = report["all"]["indices"]
    lines = [f"| alarms in calm runs, at most | {chosen}: warned, 0.1 s before | best of the paper's, 0.1 s before | above it |", "|---|---|---|---|"]
    for k, own in enumerate(indices[chosen]["best"]):
        others = [(indices[name]["best"][k], name) for name in PAPERS]
        others = [(best["warned_100ms_before"]["share"], name) for best, name in others if best["threshold"] is not None]
        share, name = max(others, default=(0.0, "none"))
        if own["threshold"] is None:
            cells = ("-", "no")
        else:
            cells = (f"{_percent(own['warned'])}, {_percent(own['warned_100ms_before'])}",
                     "yes" if own["warned_100ms_before"]["share"] > share else "**no**")
        lines.append(f"| {100 * own['false_alarms_at_most']:g} % | {cells[0]} | {100 * share:.2f} % ({name}) | {cells[1]} |")
    return "\n".join(lines)


def _ceiling(report):
    """What a perfect measure of the present could do."""
    best = report["all"]["indices"]["true_load_transfer"]["best"]
    point = next(p for p in best if abs(p["false_alarms_at_most"] - 0.01) < 1e-9)
    if point["threshold"] is None:
        return ""
    return (
        f"For comparison, the true |LTR| of the four wheel loads, which no vehicle has, at its best threshold with at most 1 % of alarms in calm runs ({point['threshold']:.3f}): "
        f"{_percent(point['warned'])} warned, {_percent(point['warned_100ms_before'])} 0.1 s before. Only a prediction sees more in time."
    )


def section(folder, chosen):
    """`chosen`: the index that drives the default warning."""
    report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
    settings = tomllib.loads((folder / "campaign.toml").read_text(encoding="utf-8"))
    text = (folder / "report.md").read_text(encoding="utf-8")
    text = re.sub(r"^# Campaign\n+", "", text)
    text = re.sub(r"^## ", "### ", text, flags=re.M).strip("\n")
    vehicles = ", ".join(group["name"] for group in report["vehicles"])
    return "\n\n".join([
        f"{settings['runs']} runs, seed {settings['seed']}, vehicles {vehicles}; what is drawn and what counts: [drives and campaigns](../drives.md#campaigns). The firmware does not know sensor noise, biases, load, friction, "
        "nor the errors of its CG height (5 %), roll stiffness (10 %) and mass (5 %).",
        _goal_table(report),
        "![Detection against false alarms](pictures/campaign_detection.png)\n![Lead times](pictures/campaign_leads.png)",
        _curves(report, chosen),
        _ceiling(report),
        text,
    ])
