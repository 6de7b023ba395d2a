"""Learns the predictors on one half of the vehicles and judges them on the other, beside the firmware.

Use: study.py PROGRAM CHOSEN REPORTED DOCUMENT PICTURE_DATA

CHOSEN and REPORTED are folders of campaigns with traces, that PROGRAM drove. Writes the page and what its picture is drawn from. Called by
sil/studies/predictors/run.
"""

import pathlib
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path += [str(PROJECT / folder) for folder in ("sil/judge", "sil/page", "cmake/environment")]

import comparison  # noqa: E402
import importance  # noqa: E402
import judge  # noqa: E402
import learners  # noqa: E402
import recorded_runs  # noqa: E402
import report  # noqa: E402
import samples  # noqa: E402
import file_io  # noqa: E402

FOLDS = 2
# Manoeuvres that begin alike; all others are turns, or drives straight on.
KINDS = {"fishhook-1a": "fishhooks", "fishhook-1b": "fishhooks", "double-lane-change": "lane changes",
         "sine-with-dwell": "lane changes", "slalom": "lane changes"}
PERFECT_S = 0.3
FIRMWARE, FIRMWARE_INDEX, PERFECT = "the firmware's warning", "its predicted load transfer", "perfect forecast"
# Shares of alarms in the band at which the curves have their points.
CURVE = [0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.8]
# Shares of alarms in calm runs at which the table of equal alarms compares.
EQUAL_ALARMS = (0.01, 0.05)


def say(text):
    print(f"predictors: {text}", file=sys.stderr, flush=True)


def firmware_predictions(runs):
    result = {}
    for run in runs:
        end = samples.until_lift(run)
        right, left = samples.firmware_risks(run)
        result[run] = (right[:end].tolist(), left[:end].tolist())
    return result


def perfect_predictions(runs):
    """Not available in a vehicle: the true load transfer of the time to come."""
    return {run: tuple(side[:samples.until_lift(run)].tolist() for side in samples.coming(run, PERFECT_S))
            for run in runs}


def kind_of(run):
    return KINDS.get(run.row["manoeuvre"], "turns")


def fold_of(vehicles, run):
    return vehicles.index(run.vehicle) % FOLDS


def unseen_predictions(name, runs, wanted):
    """Predictions of the `wanted` runs of the half that is learned from, each by a predictor that has not seen its vehicle."""
    vehicles = sorted({run.vehicle for run in runs})
    result = {}
    for fold in range(FOLDS):
        say(f"{name}: learning, without part {fold + 1} of {FOLDS}")
        predictor = learners.learned(name, [run for run in runs if fold_of(vehicles, run) != fold])
        of_fold = [run for run in wanted if fold_of(vehicles, run) == fold]
        result.update(learners.predictions(predictor, of_fold))
    return result


def unseen_manoeuvre_predictions(name, runs, wanted):
    """Predictions of the `wanted` runs, each by a predictor that has not seen a manoeuvre of its kind."""
    result = {}
    for kind in sorted({kind_of(run) for run in wanted}):
        say(f"{name}: learning, without {kind}")
        predictor = learners.learned(name, [run for run in runs if kind_of(run) != kind])
        result.update(learners.predictions(predictor, [run for run in wanted if kind_of(run) == kind]))
    return result


def main(arguments):
    program, chosen, reported, page, data = map(pathlib.Path, arguments)
    judge.use(program)
    say("reading the runs")
    chosen, reported = recorded_runs.load(chosen), recorded_runs.load(reported)
    level_runs = comparison.level_runs(chosen)
    wanted = comparison.alarm_share(level_runs)
    rows, curves, equal = [(FIRMWARE, None, comparison.firmware_verdict(reported))], {}, {}

    def add(name, of_level_runs, of_reported):
        threshold = comparison.matched_threshold(comparison.alarm_thresholds(level_runs, of_level_runs), wanted)
        thresholds = comparison.alarm_thresholds(reported, of_reported)
        rows.append((name, threshold, comparison.verdict_at(reported, of_reported, thresholds, threshold)))
        curves[name] = [
            comparison.verdict_at(reported, of_reported, thresholds, comparison.matched_threshold(thresholds, share))
            for share in CURVE
        ]
        for share in EQUAL_ALARMS:
            at = comparison.threshold_with_alarms_at_most(share, thresholds)
            equal[share, name] = comparison.verdict_at(reported, of_reported, thresholds, at)
        say(report.line(*rows[-1]))

    add(FIRMWARE_INDEX, firmware_predictions(level_runs), firmware_predictions(reported))
    groups = {}
    for name in learners.LEARNED:
        unseen = unseen_predictions(name, chosen, level_runs)
        say(f"{name}: learning")
        predictor = learners.learned(name, chosen)
        add(name, unseen, learners.predictions(predictor, reported))
        if name == learners.TREES:
            groups = importance.by_group(predictor, reported)
        if name in (learners.FORECAST, learners.TREES):
            of_unseen = unseen_manoeuvre_predictions(name, chosen, level_runs + reported)
            add(f"{name}, unseen manoeuvres", of_unseen, of_unseen)
    add(PERFECT, perfect_predictions(level_runs), perfect_predictions(reported))
    file_io.write(page, report.page(chosen, reported, rows, equal, learners.LEARNED, groups, PERFECT_S))
    file_io.write(data, report.curve_data(rows[0], curves))
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except OSError as error:
        sys.exit(f"study.py: {error.filename}: {error.strerror}; sil/studies/predictors/run makes what is read here")
