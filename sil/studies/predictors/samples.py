"""Inputs and target of a learned predictor at a moment: rows of numbers.

All inputs are seen from the side in question: for the left side signs are exchanged. One model thus serves both sides,
and left and right are treated alike.
"""

import functools
from collections import defaultdict

import numpy as np

import judge
from recorded_runs import CYCLE_S

G = 9.80665
STRIDE = 2  # a prediction every 20 ms; it holds until the next one
# Means over so many cycles back from now; the later ones as their difference from the first: what it was a moment ago.
WINDOWS = [(0, 3), (3, 8), (8, 16), (16, 30)]
LATERAL = ["acceleration", "roll rate", "roll angle", "yaw rate", "steering"]
OF_FIRMWARE = ["load transfer now", "load transfer predicted"]


def _calibrated(calibration):
    """The vehicle as the firmware knows it; without dimension where that is possible."""
    c = calibration
    weight_arm = c["sprung_mass_kg"] * G * c["sprung_cg_height_m"]
    return [
        c["track_width_m"] / (2 * c["sprung_cg_height_m"]),
        c["sprung_cg_height_m"],
        c["track_width_m"],
        c["fixed_roll_centre_height_m"] / c["sprung_cg_height_m"],
        c["roll_inertia_kgm2"] / (c["sprung_mass_kg"] * c["sprung_cg_height_m"] ** 2),
        c["roll_stiffness_nmprad"] / weight_arm,
        _stiffness(c, np.radians(5)) / weight_arm,
        c["roll_damping_nmsprad"] / weight_arm,
        c["unsprung_mass_kg"] / c["sprung_mass_kg"],
        c["wheelbase_m"],
        c["understeer_gradient_s2pm"],
        c["largest_lateral_acceleration_mps2"] / G,
        c["lateral_response_frequency_radps"],
        c["lateral_response_damping"],
    ]


def _stiffness(c, angle):
    return (c["roll_stiffness_nmprad"] + c["roll_stiffness_cubic_nmprad3"] * angle**2
            + c["roll_stiffness_quintic_nmprad5"] * angle**4)


def lateral_signals(run):
    """Name -> what changes its sign with the side, in shares of what lifts the wheels, as far as that is known."""
    c, s = run.calibration, {name: np.frombuffer(values, dtype=np.float32) for name, values in run.signals.items()}
    to_load = 2 * c["sprung_cg_height_m"] / (c["track_width_m"] * G)
    speed = s["speed_mps"]
    length = c["steering_ratio"] * np.maximum(c["wheelbase_m"] + c["understeer_gradient_s2pm"] * speed**2,
                                              0.1 * c["wheelbase_m"])
    steering = speed**2 * np.radians(s["steering_wheel_angle_deg"]) / length
    stiffness = c["roll_stiffness_nmprad"] * 2 / (c["sprung_mass_kg"] * G * c["track_width_m"])
    right, left = firmware_risks(run)
    return {
        "acceleration": to_load * s["lateral_acceleration_mps2"],
        "roll rate": np.radians(s["roll_rate_degps"]),
        "roll angle": stiffness * np.radians(s["roll_angle_deg"]),
        "yaw rate": to_load * speed * np.radians(s["yaw_rate_degps"]),
        "steering": to_load * np.clip(steering, -20.0, 20.0),
        "load transfer now": s["load_transfer_ratio"],
        "load transfer predicted": right - left,
    }


def firmware_risks(run):
    """(towards the right, towards the left): the load transfer that the firmware predicts."""
    signed, opposite = (np.frombuffer(run.signals[name], dtype=np.float32)
                        for name in ("predicted_load_transfer_ratio", "opposite_load_transfer_ratio"))
    larger = np.abs(signed)
    return np.where(signed >= 0, larger, opposite), np.where(signed >= 0, opposite, larger)


def _means(signal):
    """A column for each window: its mean, of the later ones the difference from the first."""
    known = np.nan_to_num(signal, nan=0.0)
    filled = np.concatenate([np.full(WINDOWS[-1][1], known[0]), known])
    sums = np.concatenate([[0.0], np.cumsum(filled, dtype=np.float64)])
    end = np.arange(len(signal)) + WINDOWS[-1][1] + 1
    means = [(sums[end - begin] - sums[end - until]) / (until - begin) for begin, until in WINDOWS]
    return np.stack([means[0]] + [means[0] - mean for mean in means[1:]], axis=1).astype(np.float32)


def groups():
    """Group of each number of a row."""
    calibration = ["calibration"] * len(_calibrated(defaultdict(lambda: 1.0)))
    return [name for name in LATERAL + OF_FIRMWARE for _ in WINDOWS] + ["speed"] + calibration


@functools.cache
def rows(run):
    """A row for every STRIDE-th cycle until lift-off, as seen from the right side."""
    end = until_lift(run)
    lateral = lateral_signals(run)
    told = np.hstack([_means(lateral[name])[:end:STRIDE] for name in LATERAL + OF_FIRMWARE])
    speed = np.nan_to_num(np.frombuffer(run.signals["speed_mps"], dtype=np.float32)[:end:STRIDE], nan=0.0)
    known = np.tile(np.array(_calibrated(run.calibration), dtype=np.float32), (len(speed), 1))
    return np.hstack([told, speed[:, None], known])


@functools.cache
def forecast_rows(run):
    """As rows(): the inputs of the firmware's linear forecast."""
    in_degrees = {"roll_rate_radps", "roll_angle_rad", "yaw_rate_radps", "steering_wheel_angle_rad"}

    def signal(name):
        values = run.signals[name.replace("rad", "deg") if name in in_degrees else name]
        values = np.frombuffer(values, dtype=np.float32).astype(float)
        return np.radians(values) if name in in_degrees else values

    inputs, count = judge.forecast_inputs(run.calibration, {name: signal(name) for name in judge.FORECAST_SIGNALS})
    return np.frombuffer(inputs).reshape(-1, count)[:until_lift(run):STRIDE]


def seen_from_left(told):
    mirrored = told.copy()
    mirrored[:, :len(WINDOWS) * len(LATERAL + OF_FIRMWARE)] *= -1
    return mirrored


def coming(run, horizon_s):
    """(right, left): the largest true load transfer from now to the horizon, for each cycle."""
    truth = np.nan_to_num(np.frombuffer(run.signals["true_load_transfer_ratio"], dtype=np.float32), nan=0.0)
    steps = int(horizon_s / CYCLE_S + 0.5)
    padded = np.concatenate([truth, np.full(steps, truth[-1], dtype=np.float32)])
    windows = np.lib.stride_tricks.sliding_window_view(padded, steps + 1)
    return np.maximum(windows.max(axis=1), 0.0), np.maximum(-windows.min(axis=1), 0.0)


def until_lift(run):
    """How many cycles of the run there are before two wheels have lifted."""
    return len(run) if run.lift_s is None else min(len(run), int(run.lift_s / CYCLE_S + judge.rounding_s()) + 1)
