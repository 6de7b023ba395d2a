"""The part of docs/validation.md about a campaign, from its folder."""

import json
import re
import tomllib

# The published RSI ends at 1, (25), and has no threshold beyond; the bank-free one is the same without that end.
PAPERS_INDICES = ("published", "bank_free", "static_stability_factor", "dynamic_stability", "dynamic_stability_late", "energy",
                  "rollover_index", "time_to_rollover")
DEFAULT_INDEX = "predicted_load_transfer"


def _percent(share):
    return f"{100.0 * share['share']:.2f} %"


def _goals(report):
    """What was aimed at, beside what came out."""
    warning = report["all"]["indices"]["warning"]
    median = warning["lead_time_median_s"]
    goals = [
        ("two-wheel lift-offs warned before they happen", "at least 99.5 %", warning["warned"]["share"] >= 0.995, _percent(warning["warned"])),
        ("0.1 s or more before", "at least 98 %", warning["warned_100ms_before"]["share"] >= 0.98, _percent(warning["warned_100ms_before"])),
        ("median lead", "at least 0.30 s", median >= 0.3, f"{median:.3f} s"),
        ("alarms in calm runs", "at most 1 %", warning["false_alarms"]["share"] <= 0.01, _percent(warning["false_alarms"])),
    ]
    lines = ["| the default warning | goal | reached | |", "|---|---|---|---|"]
    lines += [f"| {what} | {goal} | {value} | {'yes' if met else '**no**'} |" for what, goal, met, value in goals]
    return "\n".join(lines)


def _curves(report):
    """The default index against the best of the paper's, at equal false alarms."""
    indices = report["all"]["indices"]
    lines = ["| alarms in calm runs, at most | predicted load transfer: warned, 0.1 s before | best of the paper's, 0.1 s before | above it |", "|---|---|---|---|"]
    for k, own in enumerate(indices[DEFAULT_INDEX]["best"]):
        others = [(indices[name]["best"][k], name) for name in PAPERS_INDICES]
        others = [(best["warned_100ms_before"]["share"], name) for best, name in others if best["threshold"] is not None]
        share, name = max(others, default=(0.0, "none"))
        if own["threshold"] is None:
            cells = ("-", "no")
        else:
            cells = (f"{_percent(own['warned'])}, {_percent(own['warned_100ms_before'])}",
                     "yes" if own["warned_100ms_before"]["share"] > share else "**no**")
        lines.append(f"| {100 * own['false_alarms_at_most']:g} % | {cells[0]} | {100 * share:.2f} % ({name}) | {cells[1]} |")
    return "\n".join(lines)


def section(folder):
    report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
    settings = tomllib.loads((folder / "campaign.toml").read_text(encoding="utf-8"))
    text = (folder / "report.md").read_text(encoding="utf-8")
    text = re.sub(r"^# Campaign\n+", "", text)
    text = re.sub(r"^## ", "### ", text, flags=re.M).strip("\n")
    vehicles = ", ".join(group["name"] for group in report["vehicles"])
    return "\n\n".join([
        f"{settings['runs']} runs, seed {settings['seed']}, vehicles {vehicles}; what is drawn and what counts: [campaign.md](campaign.md). Without the firmware's being told: sensor noise, biases, load, friction, "
        "and errors of its CG height (5 %), roll stiffness (10 %) and mass (5 %).",
        _goals(report),
        "![Detection against false alarms](pictures/validation/campaign_detection.png)\n![Lead times](pictures/validation/campaign_leads.png)",
        _curves(report),
        text,
    ])
