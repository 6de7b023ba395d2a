"""The page of the study, and the numbers behind its picture."""

import collections

import judge
import markdown

HEAD = """<!-- Written by sil/studies/predictors/run --document; do not edit. -->
# What a heavier predictor would gain

Predictors that are too heavy for the firmware learn from thousands of drawn runs what comes next, from the same
signals: lateral acceleration, roll rate, roll angle, yaw rate, speed and steering of the last 0.3 s, as the firmware
receives them, noise included, and the calibration with its errors. Some are also told the load transfer that
the firmware computes, now and ahead. They show how much a better prediction would still find in these signals.

{learned} runs of {learned_vehicles} vehicles are learned from: the half `choose` of a
[population](../drives.md#a-population-of-vehicles), settings `errors`. The figures are of {judged} runs of the
{judged_vehicles} vehicles of the other half, with {lifted} two-wheel lift-offs.

- **Same rules.** Every prediction drives a copy of the firmware's warning states, and
  [what counts](../drives.md#what-counts) is what counts in a campaign.
- **Same alarms.** The threshold of each prediction is chosen on the first half so that there, in the runs with a
  largest |LTR| of 0.8 to 0.9, alarms are as frequent as the firmware's. For that each run is judged by a predictor
  that has not seen its vehicle.
- **Known manoeuvres.** Both halves drive the same manoeuvres, and a learned predictor knows how they go on. No driver
  keeps to them. For the row *unseen manoeuvres* each run is judged by a predictor that has learned without its kind
  of manoeuvre: turns, fishhooks, lane changes. Its share of the gain over the firmware is understanding of the
  vehicle; the rest is knowledge of the test. (The threshold of that row comes from vehicles that it has seen.)
- **Target.** The largest load transfer of the next 0.3 s, or of what the row says, every 20 ms.
- **The linear forecast** is that of the firmware, [part of its prediction](../theory.md#prediction), here alone: a
  weighted sum of fifteen numbers, learnt from these runs anew.
- **Perfect forecast** is the true load transfer of the next {perfect} s, which no vehicle can have.

In brackets: 95 % confidence, counting vehicles.

"""


WARNED = ["warned, %", "0.1 s before, %", "0.2 s before, %"]


def alarm_columns():
    return [f"alarms {band}, %" for band in judge.bands()]


def alone(share):
    """A share without its interval."""
    return "-" if not share.total else f"{100 * share.value():.1f}"


def cells_of(name, threshold, verdict):
    cells = [name, "-" if threshold is None else f"{threshold:.3f}"]
    found = verdict.detection
    cells += [markdown.percent(share) for share in (found.warned, found.warned_100ms, found.warned_200ms)]
    cells += [f"{found.median_lead_s:.2f}"]
    return cells + [alone(share) for share in found.alarms.values()]


def line(name, threshold, verdict):
    return markdown.line(cells_of(name, threshold, verdict))


def _table(rows):
    head = ["", "threshold", *WARNED, "median lead, s", *alarm_columns()]
    return markdown.table(head, [cells_of(*row) for row in rows], (1, *range(5, len(head)))) + "\n"


def _at_equal_alarms(equal, learned):
    """Each share of alarms with a row of every prediction, and of the best of the `learned` ones."""
    lines = []
    for limit in sorted({share for share, _ in equal}):
        found = {name: verdict.detection for (share, name), verdict in equal.items() if share == limit}
        best = max((name for name in found if name in learned), key=lambda name: found[name].warned_100ms.value(), default=None)
        for text, name in [(name, name) for name in found] + [(f"best learned: {best}", best)] * (best is not None):
            detection = found[name]
            lines.append([f"{100 * limit:g} %, {text}", alone(detection.false_alarms),
                          *map(markdown.percent, (detection.warned, detection.warned_100ms, detection.warned_200ms))])
    head = ["alarms in calm runs at most", "alarms in calm runs, %", *WARNED]
    return markdown.table(head, lines, (1,)) + "\n"


def _by(title, group_of, rows):
    """Lift-offs warned of 0.2 s before, by a property of the run."""
    groups = collections.Counter(sorted(group_of(run) for run in rows[0][2].runs if run.lift_s is not None))
    lines = [["lift-offs", *map(str, groups.values())]]
    for name, _, verdict in rows:
        early = collections.Counter(group_of(run) for run, warned in zip(verdict.runs, verdict.very_early) if warned)
        lines.append([name, *(f"{100 * early[group] / groups[group]:.1f}" for group in groups)])
    table = markdown.table(["", *groups], lines, range(1, 1 + len(groups)))
    return f"\n## 0.2 s before, by {title}\nIn per cent of the lift-offs.\n\n{table}\n"


def _importance(groups):
    return ("\n## What it lives on\n"
            "Mean error of the boosted trees where wheels come close to lifting, when what is named is that of other\n"
            "moments, over their error with everything; 1: it is not missed.\n\n"
            + markdown.table(["", "error"], [[group, f"{factor:.2f}"] for group, factor in groups.items()], (1,)) + "\n")


def page(chosen, reported, rows, equal, learned, groups, perfect_s):
    text = HEAD.format(learned=len(chosen), learned_vehicles=len({run.vehicle for run in chosen}), judged=len(reported),
                       judged_vehicles=len({run.vehicle for run in reported}),
                       lifted=sum(run.lift_s is not None for run in reported), perfect=perfect_s)
    return (text + _table(rows)
            + "\n![Lift-offs warned of 0.2 s before over the alarms that this costs](pictures/predictors.png)\n\n"
            "The picture shows each prediction at other thresholds, all on the second half; the circle is the\n"
            "firmware as it is.\n\n## At equal alarms\nThe level of each prediction is the lowest with so many alarms in calm runs (largest |LTR| below 0.9), all on\n"
            "the second half. The firmware's line is that of its predicted load transfer.\n\n"
            + _at_equal_alarms(equal, learned) + _by("manoeuvre", lambda run: run.row["manoeuvre"], rows)
            + _by("class of vehicle", lambda run: run.row["class"], rows) + _importance(groups))


def curve_data(firmware, curves):
    """Blocks for gnuplot, one a curve: alarms and lift-offs warned of 0.2 s before, in per cent."""
    blocks = [(firmware[0], [firmware[2]])] + list(curves.items())
    return "\n\n".join(f'"{name}"\n' + "".join(map(_point, verdicts)) for name, verdicts in blocks)


def _point(verdict):
    found = verdict.detection
    return f"{100 * found.alarms[judge.bands()[judge.LEVEL_BAND]].value():.2f} {100 * found.warned_200ms.value():.2f}\n"
