"""The rollover-warning component on time series of your own: the firmware's bits, indices, and the judge of warnings.

    import rsi_component as rsi

    calibration = rsi.Calibration.load("my_car.toml")            # or the name of one of rsi.CALIBRATIONS
    run = rsi.run(calibration, time_s, lateral_specific_force_mps2=ay, roll_rate_radps=p, roll_angle_rad=phi)
    run["rsi"], run.level("rollover_index"), run.states()        # an output, an index, the warning; a value a row
    truth = rsi.Truth.of_wheel_loads(time_s, front_left_n, front_right_n, rear_left_n, rear_right_n)
    run.judge(truth).lead_s                                      # warned, lead, side, band
    print(rsi.benchmark([rsi.Drive(run, truth), ...]))           # all indices, at equal alarms

Every time series is one-dimensional, of one value a row, rows 0.01 s apart. NaN is "not available". SI units; a name
ends in its unit. Signs are those of ISO 8855: x forward, y left, z up; a left turn has positive lateral acceleration,
yaw rate and roll. Nothing is computed in Python: this package hands arrays to the C++ of the firmware and of the
simulation's judge.
"""

from .benchmark import Benchmark, Drive, Entry, benchmark
from .component import (
    CALIBRATIONS,
    Calibration,
    Component,
    Run,
    Score,
    indices,
    inputs,
    outputs,
    parameters,
    run,
    version,
)
from .judge import Detection, Judgement, JudgeError, Share, bands
from .refused import Refused
from .truth import Truth

__version__ = version()
__all__ = [
    "CALIBRATIONS",
    "Benchmark",
    "Calibration",
    "Component",
    "Detection",
    "Drive",
    "Entry",
    "JudgeError",
    "Judgement",
    "Refused",
    "Run",
    "Score",
    "Share",
    "Truth",
    "bands",
    "benchmark",
    "indices",
    "inputs",
    "outputs",
    "parameters",
    "run",
    "version",
]
