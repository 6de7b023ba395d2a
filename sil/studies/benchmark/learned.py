"""Entries of the benchmark that learn: on one half of the vehicles, shown on the other.

Use: learned.py PROGRAM CHOSEN REPORTED TARGET

CHOSEN and REPORTED are folders of campaigns with traces, that PROGRAM drove. Writes, into the folder TARGET, a file for each
learned predictor: a time series (run, time_s, right, left) as sil/tools/campaign score takes it. A level of 1 is the threshold at which, on runs of
CHOSEN whose vehicles it has not seen, alarms at a largest |LTR| of 0.8 to 0.9 are as frequent as the firmware's. Called by
sil/studies/benchmark/run.
"""

import pathlib
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(PROJECT / folder) for folder in ("sil/studies/predictors", "sil/judge", "sil/page", "cmake/environment")]

import comparison  # noqa: E402
import judge  # noqa: E402
import learners  # noqa: E402
import recorded_runs  # noqa: E402
import study  # noqa: E402
import file_io  # noqa: E402

ENTRIES = {learners.LINEAR: "linear", learners.TREES: "boosted_trees"}  # with the name of the file


def lines(predictions, threshold):
    yield "run,time_s,right,left\n"
    for run, sides in predictions.items():
        for cycle, (right, left) in enumerate(zip(*sides)):
            yield f"{run.row['run']},{cycle * recorded_runs.CYCLE_S:.2f},{right / threshold:.5f},{left / threshold:.5f}\n"


def main(arguments):
    program, chosen, reported, target = map(pathlib.Path, arguments)
    judge.use(program)
    study.say("reading the runs")
    chosen, reported = recorded_runs.load(chosen), recorded_runs.load(reported)
    level_runs = comparison.level_runs(chosen)
    wanted = comparison.alarm_share(level_runs)
    for name, file_name in ENTRIES.items():
        unseen = study.unseen_predictions(name, chosen, level_runs)
        threshold = comparison.matched_threshold(comparison.alarm_thresholds(level_runs, unseen), wanted)
        study.say(f"{name}: learning")
        predictions = learners.predictions(learners.learned(name, chosen), reported)
        with file_io.growing(target / f"{file_name}.csv") as file:
            file.writelines(line.encode() for line in lines(predictions, threshold))


if __name__ == "__main__":
    main(sys.argv[1:])
