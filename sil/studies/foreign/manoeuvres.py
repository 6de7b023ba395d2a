"""Drives of these vehicles, and the same as files (docs/drives.md)."""

import math
import random
import typing

from conventions import GRAVITY_MPS2, WHEELS

ROW_S = 0.01
STRAIGHT_S = 1.0  # at the beginning, for the sensors' offsets
RAMP_SPEED_KMH = 80.0
RAMP_DEGPS = 13.5
RAMP_STOP = 0.85  # |LTR| at which the driver of the ramp has enough
RAMP_LONGEST_S = 25.0
REFERENCE_MPS2 = 0.3 * GRAVITY_MPS2
LIFTED_S = 0.1  # both wheels of a side up: the drive has shown what it can show
KINDS = ("step steer", "fishhook", "double lane change", "slalom")
SPEEDS_KMH = (60.0, 100.0)
RATES_DEGPS = (400.0, 1000.0)
# Handwheel angle as a multiple of the one at 0.3 g in the ramp; every GENTLE_EACH-th round is gentle.
AMPLITUDES, GENTLE_AMPLITUDES, GENTLE_EACH = (1.6, 5.0), (0.7, 1.5), 4

# Standard deviations of the white noise of ordinary automotive sensors, as of noisy_sensors() in sil/world/sensors.
NOISE = {"lateral_acceleration_mps2": 0.02 * GRAVITY_MPS2, "vertical_acceleration_mps2": 0.02 * GRAVITY_MPS2,
         "roll_rate_degps": 0.3, "roll_angle_deg": 0.2, "speed_mps": 0.1 / 3.6, "yaw_rate_degps": 0.3,
         "steering_wheel_angle_deg": 0.1}
LOADS = tuple(f"wheel_load_{wheel}_n" for wheel in WHEELS)
COLUMNS = ("time_s", *NOISE, *LOADS)
# Signals that change their sign when left and right are exchanged.
LATERAL = ("lateral_acceleration_mps2", "roll_rate_degps", "roll_angle_deg", "yaw_rate_degps", "steering_wheel_angle_deg")


class Plan(typing.NamedTuple):
    """An evaluation drive as drawn."""

    kind: str
    speed_kmh: float
    amplitude: float  # of the handwheel, as a multiple; left first if positive
    rate_degps: float
    pace: float  # duration of a lane change in s, frequency of a slalom in Hz


def plans(seed, vehicle, rounds):
    """Each kind once a round."""
    result = []
    for number in range(rounds):
        for kind in KINDS:
            source = random.Random(f"drive {seed} {vehicle.name} {number} {kind}")
            ends = GENTLE_AMPLITUDES if number % GENTLE_EACH == GENTLE_EACH - 1 else AMPLITUDES
            pace = source.uniform(*((0.35, 0.7) if kind == "slalom" else (1.4, 2.4)))
            result.append(Plan(kind, source.uniform(*SPEEDS_KMH), source.choice((-1.0, 1.0)) * source.uniform(*ends),
                               source.uniform(*RATES_DEGPS), pace))
    return result


def corners(points, rate_degps):
    """Course of a handwheel that goes to each (angle in deg, time held in s) as fast as the rate allows."""
    time_s, angle_deg = STRAIGHT_S, 0.0
    course = [(0.0, 0.0), (time_s, angle_deg)]
    for wanted_deg, held_s in points:
        time_s += abs(wanted_deg - angle_deg) / rate_degps
        angle_deg = wanted_deg
        course += [(time_s, angle_deg), (time_s + held_s, angle_deg)]
        time_s += held_s
    return course


def at(course, time_s):
    for (begin_s, from_deg), (end_s, to_deg) in zip(course, course[1:]):
        if time_s < end_s:
            return from_deg + (to_deg - from_deg) * (time_s - begin_s) / (end_s - begin_s) if time_s > begin_s else from_deg
    return course[-1][1]


def handwheel_of(plan, reference_deg):
    """Angle over time, and how long the drive is."""
    angle = plan.amplitude * reference_deg
    if plan.kind == "slalom":
        turns_s = 4.0 / plan.pace

        def weave(time_s):
            phase = time_s - STRAIGHT_S
            return angle * math.sin(2.0 * math.pi * plan.pace * phase) if 0.0 < phase < turns_s else 0.0

        return weave, STRAIGHT_S + turns_s + 1.0
    if plan.kind == "double lane change":
        quarter_s = plan.pace / 4.0
        points = [(angle, quarter_s), (-angle, quarter_s), (0.0, 2.0 * quarter_s), (-angle, quarter_s),
                  (angle, quarter_s), (0.0, 1.5)]
    elif plan.kind == "fishhook":
        points = [(angle, 0.25), (-angle, 3.0)]
    else:
        points = [(angle, 3.0)]
    course = corners(points, plan.rate_degps)
    return lambda time_s: at(course, time_s), course[-1][0]


def drive(vehicle, speed_kmh, handwheel_deg, duration_s, holds_speed=False, has_enough=None):
    """Rows of a drive under COLUMNS; it ends early after a lift-off, a spin, or when the driver has enough."""
    speed_mps = speed_kmh / 3.6
    motion = vehicle.motion(speed_mps)
    steps = round(ROW_S / motion.STEP_S)
    rows, lifted_s = [], 0.0
    for cycle in range(round(duration_s / ROW_S) + 1):
        time_s = cycle * ROW_S
        loads = motion.wheel_loads_n()
        signals = motion.signals() | {"steering_wheel_angle_deg": handwheel_deg(time_s)}
        rows.append((time_s, *(signals[name] for name in NOISE), *loads))
        lifted_s = lifted_s + ROW_S if loads[0] + loads[2] == 0.0 or loads[1] + loads[3] == 0.0 else 0.0
        if lifted_s > LIFTED_S or not motion.is_still_a_drive() or (has_enough and has_enough(motion)):
            break
        for step in range(steps):
            # The driver of a ramp holds the speed; else the throttle is released.
            acceleration = speed_mps - motion.speed_mps() if holds_speed else 0.0
            motion.advance(math.radians(handwheel_deg(time_s + step * motion.STEP_S)), acceleration)
    return rows


def ramp(vehicle):
    """Slowly increasing steer to the left, until the driver has enough."""
    return drive(vehicle, RAMP_SPEED_KMH, lambda time_s: max(time_s - STRAIGHT_S, 0.0) * RAMP_DEGPS, RAMP_LONGEST_S,
                 holds_speed=True, has_enough=lambda motion: abs(motion.load_transfer_ratio()) >= RAMP_STOP)


def reference_deg(ramp_rows):
    """Handwheel angle at 0.3 g."""
    lateral, angle = COLUMNS.index("lateral_acceleration_mps2"), COLUMNS.index("steering_wheel_angle_deg")
    return next(row[angle] for row in ramp_rows if row[lateral] >= REFERENCE_MPS2)


def lane_change(vehicle, reference):
    """A calm one, at 0.3 to 0.4 g."""
    angle = 1.2 * reference
    course = corners([(angle, 0.6), (-angle, 0.6), (0.0, 2.0), (-angle, 0.6), (angle, 0.6), (0.0, 2.0)], 250.0)
    return drive(vehicle, RAMP_SPEED_KMH, lambda time_s: at(course, time_s), course[-1][0], holds_speed=True)


def evaluation(vehicle, plan, reference):
    handwheel_deg, duration_s = handwheel_of(plan, reference)
    return drive(vehicle, plan.speed_kmh, handwheel_deg, duration_s, holds_speed=plan.kind == "slalom")


def on_the_road_mps2(row):
    """Lateral acceleration along the road, as the component has it."""
    values = dict(zip(COLUMNS, row))
    roll = math.radians(values["roll_angle_deg"])
    return values["lateral_acceleration_mps2"] * math.cos(roll) - values["vertical_acceleration_mps2"] * math.sin(roll)


def mirrored(rows):
    """The same drive with left and right exchanged."""
    result = []
    for row in rows:
        values = dict(zip(COLUMNS, row))
        values |= {name: -values[name] for name in LATERAL}
        loads = [values[name] for name in LOADS]
        values |= dict(zip(LOADS, (loads[1], loads[0], loads[3], loads[2])))
        result.append(tuple(values[name] for name in COLUMNS))
    return result


def noisy(rows, name):
    """With the noise of ordinary sensors; the same name gives the same noise."""
    source = random.Random(f"noise {name}")
    deviations = (0.0, *NOISE.values(), *[0.0] * len(LOADS))
    return [tuple(value + source.gauss(0.0, deviation) if deviation else value for value, deviation in zip(row, deviations))
            for row in rows]


def csv_text(rows):
    return "\n".join([",".join(COLUMNS), *(",".join(f"{value:.7g}" for value in row) for row in rows)]) + "\n"
