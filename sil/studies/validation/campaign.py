"""The part of docs/reports/validation.md about a campaign, from its folder."""

import json
import re
import tomllib

from figures import PAPERS


def _percent(share):
    return "-" if share["of"] == 0 else f"{100.0 * share['share']:.2f} %"


def _goals(group):
    """What is aimed at, beside what came out."""
    warning = group["indices"]["warning"]
    median = warning["lead_time_median_s"]
    wrong_s = group["wrong_side_s_per_1000_runs"]
    alarms = warning["alarms"]
    goals = [
        ("warned, right side", "at least", 0.995, warning["warned"]),
        ("at least 0.1 s before", "at least", 0.99, warning["warned_100ms_before"]),
        ("at least 0.2 s before", "at least", 0.80, warning["warned_200ms_before"]),
        ("alarms, largest \\|LTR\\| below 0.7", "at most", 0.0, alarms["below 0.7"]),
        ("alarms, 0.7 to 0.8", "at most", 0.003, alarms["0.7 to 0.8"]),
        ("alarms, 0.8 to 0.9", "at most", 0.25, alarms["0.8 to 0.9"]),
    ]
    lines = []
    for what, bound, limit, share in goals:
        reached = -1.0 if share["of"] == 0 else share["share"]
        met = reached >= limit if bound == "at least" else 0.0 <= reached <= limit
        lines.append((what, f"{bound} {100 * limit:g} %", _percent(share), met))
    lines.insert(3, ("median lead", "at least 0.36 s", "-" if median is None else f"{median:.3f} s", median is not None and median >= 0.36))
    lines.append(("wrong side beyond 0.1 s after the swing, in 1,000 runs", "at most 0.1 s", f"{wrong_s:.2f} s", wrong_s <= 0.1))
    return [f"| {group['name']} | {what} | {goal} | {value} | {'yes' if met else '**no**'} |" for what, goal, value, met in lines]


def _goal_table(report):
    lines = ["| the default warning | | goal | reached | |", "|---|---|---|---|---|", *_goals(dict(report["all"], name="all vehicles"))]
    for group in report["vehicles"]:
        if group["name"] == "van":  # which nobody tuned for
            lines += _goals(group)
    return "\n".join(lines)


def curves(report, chosen):
    """The default index against the best of the paper's, at equal false alarms. The published RSI ends at 1, (25), and has
    no threshold beyond; the bank-free one is the same without that end."""
    indices = report["all"]["indices"]
    lines = [
        f"| alarms in calm runs, at most | {chosen}: warned, 0.1 s, 0.2 s before | best of the paper's, 0.1 s before | best of the paper's, 0.2 s before | above both |",
        "|---|---|---|---|---|",
    ]
    for k, own in enumerate(indices[chosen]["best"]):
        bests, above = [], own["threshold"] is not None
        for lead in ("warned_100ms_before", "warned_200ms_before"):
            others = [(indices[name]["best"][k][lead]["share"], name) for name in PAPERS if indices[name]["best"][k]["threshold"] is not None]
            share, name = max(others, default=(0.0, "none"))
            bests.append(f"{100 * share:.2f} % ({name})")
            above = above and own[lead]["share"] > share
        cell = "-" if own["threshold"] is None else ", ".join(_percent(own[key]) for key in ("warned", "warned_100ms_before", "warned_200ms_before"))
        lines.append(f"| {100 * own['false_alarms_at_most']:g} % | {cell} | {bests[0]} | {bests[1]} | {'yes' if above else '**no**'} |")
    return "\n".join(lines)


def _ceiling(report):
    """What a perfect measure of the present could do."""
    best = report["all"]["indices"]["true_load_transfer"]["best"]
    point = next(p for p in best if abs(p["false_alarms_at_most"] - 0.01) < 1e-9)
    if point["threshold"] is None:
        return ""
    return (
        f"For comparison, the true |LTR| of the four wheel loads, which no vehicle has, at its best threshold with at most 1 % of alarms in calm runs ({point['threshold']:.3f}): "
        f"{_percent(point['warned'])} warned, {_percent(point['warned_100ms_before'])} 0.1 s and {_percent(point['warned_200ms_before'])} 0.2 s before. Only a prediction sees more in time."
    )


def _markdown(folder):
    """The report of a campaign, to stand below a heading of the page."""
    text = (folder / "report.md").read_text(encoding="utf-8")
    text = re.sub(r"^# Campaign\n+", "", text)
    return re.sub(r"^## ", "### ", text, flags=re.M).strip("\n")


def section(folder, ordinary, chosen):
    """`ordinary`: the folder of the drives that are counted by the hour, or None; `chosen`: the index that drives the default warning."""
    report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
    settings = tomllib.loads((folder / "campaign.toml").read_text(encoding="utf-8"))
    vehicles = ", ".join(group["name"] for group in report["vehicles"])
    return "\n\n".join([
        f"{settings['runs']} runs, seed {settings['seed']}, vehicles {vehicles}; what is drawn and what counts: [drives and campaigns](../drives.md#campaigns). The firmware does not know sensor noise, biases, load, friction, "
        "nor the errors of its CG height (5 %), roll stiffness (10 %) and mass (5 %).",
        _goal_table(report),
        "![Detection against false alarms](pictures/campaign_detection.png)\n![Lead times](pictures/campaign_leads.png)",
        curves(report, chosen),
        _ceiling(report),
        _markdown(folder),
        *([] if ordinary is None else [_markdown(ordinary)]),
    ])
