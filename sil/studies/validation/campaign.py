"""The part of docs/reports/validation.md about a campaign, from its folder."""

import json
import re
import tomllib

import goals
import markdown
from figures import PAPERS


def goal_table(report):
    lines = []
    van = [group for group in report["vehicles"] if group["name"] == "van"]  # without hand tuning
    for group in [dict(report["all"], name="all vehicles"), *van]:
        for figure, limit in zip(goals.figures(group), goals.WITH_ERRORS):
            lines.append([group["name"], figure.name, figure.goal(limit), figure.text, figure.verdict(limit)])
    return markdown.table(["the default warning", "", "goal", "reached", ""], lines)


def curves(report, chosen):
    """The default index against the best of the paper's, at equal false alarms. The published RSI ends at 1, (25), and has
    no threshold beyond; the bank-free one is the same without that end."""
    indices = report["all"]["indices"]
    lines = []
    for k, own in enumerate(indices[chosen]["best"]):
        bests, above = [], own["threshold"] is not None
        for lead in ("warned_100ms_before", "warned_200ms_before"):
            others = [(indices[name]["best"][k][lead]["share"], name) for name in PAPERS if indices[name]["best"][k]["threshold"] is not None]
            share, name = max(others, default=(0.0, "none"))
            bests.append(f"{100 * share:.2f} % ({name})")
            above = above and own[lead]["share"] > share
        cell = "-" if own["threshold"] is None else ", ".join(goals.percent(own[key]) for key in ("warned", "warned_100ms_before", "warned_200ms_before"))
        lines.append([f"{100 * own['false_alarms_at_most']:g} %", cell, *bests, "yes" if above else "**no**"])
    return markdown.table(["alarms in calm runs, at most", f"{chosen}: warned, 0.1 s, 0.2 s before", "best of the paper's, 0.1 s before",
                           "best of the paper's, 0.2 s before", "above both"], lines)


def _ceiling(report):
    """Limit of a perfect measure of the present."""
    point = goals.best_point(report["all"], "true_load_transfer", 0.01)
    if point["threshold"] is None:
        return ""
    return (
        f"For comparison, the true |LTR| of the four wheel loads, which no vehicle has, at its best threshold with at most 1 % of alarms in calm runs ({point['threshold']:.3f}): "
        f"{goals.percent(point['warned'])} warned, {goals.percent(point['warned_100ms_before'])} 0.1 s and {goals.percent(point['warned_200ms_before'])} 0.2 s before. Only a prediction sees more in time."
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
        goal_table(report),
        "![Detection against false alarms](pictures/campaign_detection.png)\n![Lead times](pictures/campaign_leads.png)",
        curves(report, chosen),
        _ceiling(report),
        _markdown(folder),
        *([] if ordinary is None else [_markdown(ordinary)]),
    ])
