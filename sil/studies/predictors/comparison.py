"""Makes predictions comparable: each at the threshold at which it raises as many alarms as the firmware."""

import math

import judge
from recorded_runs import CYCLE_S


class Verdict:
    """Value of one warning over these runs: the leads, and whether the others have an alarm."""

    def __init__(self, runs, leads_s, alarms):
        self.runs = runs
        lifts, ltrs = [run.lift_s for run in runs], [run.largest_ltr for run in runs]
        self.detection = judge.detection([run.vehicle for run in runs], lifts, ltrs, leads_s, alarms)
        self.very_early = judge.each(lifts, ltrs, leads_s)["warned_200ms"]


def _index(run, prediction):
    return judge.Index(run.calibration, [cycle * CYCLE_S for cycle in range(len(prediction[0]))], *prediction)


def level_runs(runs):
    """Those of the band in which alarms are to be as frequent; below it nothing should be warned of."""
    bands = judge.each([run.lift_s for run in runs], [run.largest_ltr for run in runs], [None] * len(runs))["band"]
    return [run for run, band in zip(runs, bands) if run.lift_s is None and band == judge.LEVEL_BAND]


def alarm_thresholds(runs, predictions):
    """The largest threshold at which the prediction raises an alarm, for every run without lift-off."""
    return {run: _index(run, predictions[run]).alarm_threshold() for run in runs if run.lift_s is None}


def matched_threshold(thresholds, firmware_share):
    """The largest threshold with at least this share of alarms in the band."""
    return judge.matched_threshold([thresholds[run] for run in level_runs(list(thresholds))], firmware_share)


def threshold_with_alarms_at_most(share, thresholds):
    """The smallest threshold with alarms in at most this share of the calm runs."""
    runs = list(thresholds)
    calm = judge.each([run.lift_s for run in runs], [run.largest_ltr for run in runs], [None] * len(runs))["calm"]
    of_calm = sorted((thresholds[run] for run, is_calm in zip(runs, calm) if is_calm), reverse=True)
    allowed = math.floor(share * len(of_calm) + 1e-9)
    return math.nextafter(of_calm[allowed], math.inf) if allowed < len(of_calm) else 0.0


def firmware_verdict(runs):
    """Value of the warning that was on the bus."""
    leads_s = [None if run.lift_s is None else judge.lead_s(
        [cycle * CYCLE_S for cycle in range(len(run))],
        [side if state == "warning" else "none" for state, side in zip(run.states, run.sides)], run.lift_s, run.falling_side)
        for run in runs]
    return Verdict(runs, leads_s, [int(run.row["warnings"]) > 0 for run in runs])


def alarm_share(runs):
    """For runs of one band: in how many of them the firmware raised an alarm."""
    return sum(int(run.row["warnings"]) > 0 for run in runs) / len(runs)


def verdict_at(runs, predictions, thresholds, threshold):
    """Value of a prediction that warns at this threshold."""
    leads_s = [None if run.lift_s is None else _index(run, predictions[run]).lead_s(threshold, run.lift_s, run.falling_side)
               for run in runs]
    return Verdict(runs, leads_s, [run in thresholds and thresholds[run] >= threshold for run in runs])
