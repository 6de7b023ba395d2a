"""The component and the paper's indices on a drive, judged by its wheel loads.

Use: indices.py DRIVE.csv PICTURE.png [CALIBRATION]. DRIVE.csv is a table as `sil/run` leaves it, signals.csv;
CALIBRATION is a file, or the name of one that comes with the package that `sil/exchange/wheel/build` makes. Needs
matplotlib. The lines stand as well in a notebook.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np

import rsi_component as rsi

SHOWN = ("published", "extended", "load_transfer", "predicted_load_transfer", "rollover_index")


def main(drive: str, picture: str, calibration: str = "large_suv") -> None:
    table = np.genfromtxt(drive, delimiter=",", names=True)  # an empty cell becomes NaN: not available
    time_s = table["time_s"]
    run = rsi.run(
        rsi.Calibration.load(calibration),
        time_s,
        lateral_specific_force_mps2=table["sensor_lateral_acceleration_mps2"],
        vertical_specific_force_mps2=table["sensor_vertical_acceleration_mps2"],
        roll_rate_radps=np.radians(table["sensor_roll_rate_degps"]),
        roll_angle_rad=np.radians(table["sensor_roll_angle_deg"]),
        yaw_rate_radps=np.radians(table["sensor_yaw_rate_degps"]),
        speed_mps=table["sensor_speed_mps"],
        steering_wheel_angle_rad=np.radians(table["sensor_steering_wheel_angle_deg"]),
    )
    truth = rsi.Truth.of_wheel_loads(
        time_s,
        *(table[f"true_wheel_load_{wheel}_n"] for wheel in ("front_left", "front_right", "rear_left", "rear_right")),
    )
    verdict = run.judge(truth)
    if truth.two_wheel_lift_s is None:
        print(f"two wheels stay on the road, largest |LTR| {verdict.largest_ltr:.2f}; {verdict.warnings} warnings")
    else:
        lead = "no warning" if verdict.lead_s is None else f"warned {verdict.lead_s:.2f} s before"
        print(f"two wheels lift at {truth.two_wheel_lift_s:.2f} s, to the {truth.falling_side}; {lead}")

    figure, (above, below) = plt.subplots(2, sharex=True, figsize=(8, 6), layout="constrained")
    above.plot(time_s, np.abs(run["lateral_acceleration_mps2"]), label="|lateral acceleration|")
    above.plot(time_s, np.abs(run["lateral_acceleration_threshold_mps2"]), label="|its threshold|")
    above.set_ylabel("m/s²")
    for index in SHOWN:
        score = run.score(index, truth)
        below.plot(time_s, run.level(index), label=f"{index}: warns up to a threshold of {score.threshold:.2f}")
    below.axhline(1.0, color="black", linewidth=0.5)
    below.set(xlabel="s", ylabel="level", ylim=(0, 2))
    for axes in (above, below):
        axes.fill_between(
            time_s, 0, 1, where=run.states() == "warning", transform=axes.get_xaxis_transform(), color="red", alpha=0.1
        )
        if truth.two_wheel_lift_s is not None:
            axes.axvline(truth.two_wheel_lift_s, color="red", linestyle="--")
        axes.legend(loc="upper left", fontsize="small")
    figure.savefig(picture)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit("Use: indices.py DRIVE.csv PICTURE.png [CALIBRATION], DRIVE.csv being signals.csv of a run")
    main(*sys.argv[1:])
