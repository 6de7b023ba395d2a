"""Makes predictions comparable: each at the threshold at which it raises as many alarms as the firmware."""

import math

import judge
import warning

LEVEL_BAND = "0.8 to 0.9"  # in which alarms are to be as frequent; below it nothing should be warned of


def alarm_thresholds(runs, predictions):
    """(run, the largest threshold at which the prediction raises an alarm) for every run without lift-off."""
    return [(run, warning.largest_threshold(run.calibration, [max(pair) for pair in zip(*predictions[run])]))
            for run in runs if run.lift_s is None]


def matched_threshold(thresholds, firmware_share):
    """The largest threshold with at least this share of alarms in the band."""
    of_band = sorted((at for run, at in thresholds if judge.band(run) == LEVEL_BAND), reverse=True)
    wanted = math.ceil(firmware_share * len(of_band) - 1e-9)
    return of_band[wanted - 1] if wanted else math.inf


def firmware_verdict(runs):
    """Of the warning that was on the bus."""
    verdict = judge.Verdict()
    for run in runs:
        if run.lift_s is None:
            verdict.add_other(run, int(run.row["warnings"]) > 0)
        else:
            verdict.add_lift_off(run, judge.lead_s(judge.firmware_warnings(run), run.lift_s, run.falling_side))
    return verdict


def verdict_at(runs, predictions, thresholds, threshold):
    """Of a prediction that warns at this threshold."""
    verdict = judge.Verdict()
    for run, at in thresholds:
        verdict.add_other(run, at >= threshold)
    for run in runs:
        if run.lift_s is not None:
            named = judge.warnings_by(run, *predictions[run], threshold)
            verdict.add_lift_off(run, judge.lead_s(named, run.lift_s, run.falling_side))
    return verdict
