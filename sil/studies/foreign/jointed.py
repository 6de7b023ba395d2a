"""Vehicles of joints and contacts in the physics engine MuJoCo: swing arms, rigid axles, a frame that twists, a swinging load.

Bodies, joints, springs, dry friction, stops and the contact of wheel and road are the engine's. Only the force along the road
is computed here, from slip: the engine's friction resists a sliding speed, while a rolling tyre resists an angle. A wheel is
an ellipsoid, which touches the road in one point that moves smoothly with its lean; it does not spin. Axes are those of
ISO 8855 (x forward, y to the left, z up).
"""

import functools
import math
import random

import mujoco

import conventions
import engine_model
from conventions import GRAVITY_MPS2, WHEELS
from engine_model import BODY_NUMBERS, WHEEL_NUMBERS

SWING_ARMS, LEAF_SPRINGS, TWISTING_FRAME = "swing arms", "leaf springs", "twisting frame"
TANKER, AIR_SPRINGS = "tanker", "air springs"

# Two ends of every quantity that is drawn.
_ANY = {"front_load_share": (0.46, 0.56), "understeer_s2pm": (0.3e-3, 3.0e-3), "steering_lag_s": (0.03, 0.12),
        "front_roll_stiffness_share": (0.45, 0.6), "roll_inertia_over_track": (0.36, 0.44), "yaw_inertia": (0.85, 1.15),
        "load_sensitivity": (0.05, 0.12), "camber_thrust": (0.03, 0.1), "progression": (0.1, 0.5)}
_CAR = {"steering_ratio": (14.0, 20.0), "tyre_deflection_m": (0.016, 0.026), "tyre_sideways_mpg": (0.006, 0.018),
        "relaxation_m": (0.2, 0.6), "friction": (0.9, 1.2)}
_TRUCK = {"steering_ratio": (16.0, 22.0), "tyre_deflection_m": (0.02, 0.032), "tyre_sideways_mpg": (0.008, 0.02),
          "relaxation_m": (0.3, 0.9), "friction": (0.8, 1.05)}
_RIGID = {"spring_base": (0.55, 0.7), "front_roll_steer": (-0.03, 0.03), "rear_roll_steer": (-0.02, 0.06)}
CLASSES = {
    SWING_ARMS: _ANY | _CAR | {
        "mass_kg": (1300.0, 2300.0), "unsprung_share": (0.1, 0.14), "wheelbase_m": (2.35, 2.9), "track_width_m": (1.4, 1.54),
        "cg_height_m": (0.74, 0.94), "wheel_radius_m": (0.31, 0.37), "front_roll_axis_m": (0.02, 0.14),
        "rear_roll_axis_m": (0.25, 0.42), "front_arm_m": (1.2, 2.6), "rear_arm_m": (0.55, 0.9), "roll_gradient_degpg": (3.5, 7.5),
        "ride_frequency_hz": (1.1, 1.6), "roll_damping_ratio": (0.12, 0.4), "cornering_per_rad": (15.0, 25.0),
        "travel_m": (0.07, 0.11), "dry_friction": (0.0, 0.01)},
    LEAF_SPRINGS: _ANY | _CAR | _RIGID | {
        "mass_kg": (1700.0, 3500.0), "unsprung_share": (0.14, 0.2), "wheelbase_m": (2.5, 3.5), "track_width_m": (1.42, 1.62),
        "cg_height_m": (0.9, 1.1), "wheel_radius_m": (0.34, 0.4), "front_roll_axis_m": (0.3, 0.42),
        "rear_roll_axis_m": (0.36, 0.5), "roll_gradient_degpg": (2.5, 6.0), "ride_frequency_hz": (1.3, 1.9),
        "roll_damping_ratio": (0.08, 0.25), "cornering_per_rad": (11.0, 18.0), "travel_m": (0.06, 0.09),
        "dry_friction": (0.03, 0.08)},
    TWISTING_FRAME: _ANY | _TRUCK | _RIGID | {
        "mass_kg": (3500.0, 8000.0), "unsprung_share": (0.13, 0.17), "wheelbase_m": (3.2, 4.5), "track_width_m": (1.62, 1.86),
        "cg_height_m": (1.1, 1.36), "wheel_radius_m": (0.38, 0.46), "front_roll_axis_m": (0.36, 0.5),
        "rear_roll_axis_m": (0.5, 0.7), "roll_gradient_degpg": (3.0, 6.5), "ride_frequency_hz": (1.4, 2.0),
        "roll_damping_ratio": (0.1, 0.25), "cornering_per_rad": (9.0, 14.0), "travel_m": (0.07, 0.1),
        "dry_friction": (0.02, 0.06), "frame_stiffness_share": (0.06, 0.3), "rear_mass_share": (0.5, 0.65)},
    TANKER: _ANY | _TRUCK | _RIGID | {
        "mass_kg": (8000.0, 16000.0), "unsprung_share": (0.11, 0.15), "wheelbase_m": (3.8, 5.2), "track_width_m": (1.84, 2.04),
        "cg_height_m": (1.2, 1.45), "wheel_radius_m": (0.46, 0.52), "front_roll_axis_m": (0.45, 0.55),
        "rear_roll_axis_m": (0.6, 0.8), "roll_gradient_degpg": (2.5, 5.5), "ride_frequency_hz": (1.4, 2.0),
        "roll_damping_ratio": (0.1, 0.25), "cornering_per_rad": (8.0, 12.0), "travel_m": (0.07, 0.1),
        "dry_friction": (0.01, 0.04), "swinging_share": (0.2, 0.4), "pendulum_m": (0.25, 0.5)},
    AIR_SPRINGS: _ANY | _TRUCK | _RIGID | {
        "mass_kg": (7000.0, 15000.0), "unsprung_share": (0.1, 0.14), "wheelbase_m": (4.2, 6.0), "track_width_m": (1.88, 2.08),
        "cg_height_m": (1.2, 1.5), "wheel_radius_m": (0.46, 0.52), "front_roll_axis_m": (0.45, 0.6),
        "rear_roll_axis_m": (0.55, 0.75), "roll_gradient_degpg": (3.5, 7.0), "ride_frequency_hz": (0.95, 1.25),
        "roll_damping_ratio": (0.15, 0.35), "cornering_per_rad": (8.0, 12.0), "travel_m": (0.08, 0.12),
        "dry_friction": (0.0, 0.005), "progression": (0.5, 1.0)},
}
DRIVE_LIMIT = 0.5  # largest drive force over friction


def draw(seed, number):
    """The vehicle of this number; the same seed gives the same."""
    source = random.Random(f"jointed {seed} {number}")
    kind = list(CLASSES)[number % len(CLASSES)]
    drawn = {name: source.uniform(*ends) for name, ends in CLASSES[kind].items()}
    return Vehicle(f"j{number:02}", kind, drawn)


def ends():
    """Both ends of every quantity that is drawn, by class and name."""
    return CLASSES


class Vehicle:
    """A drawn vehicle. `drawn` holds its quantities under the names of CLASSES."""

    def __init__(self, name, kind, drawn):
        self.name, self.kind, self.drawn = name, kind, drawn
        d = drawn
        self.sprung_kg = d["mass_kg"] * (1.0 - d["unsprung_share"])
        self.axle_kg = 0.5 * d["mass_kg"] * d["unsprung_share"]
        self.front_m = d["wheelbase_m"] * (1.0 - d["front_load_share"])
        self.rear_m = d["wheelbase_m"] * d["front_load_share"]
        self.hub_height_m = d["wheel_radius_m"] - d["tyre_deflection_m"]
        front_n = GRAVITY_MPS2 * (self.sprung_kg * d["front_load_share"] + self.axle_kg)
        self.static_loads_n = [0.5 * load for load in (front_n, front_n, *[d["mass_kg"] * GRAVITY_MPS2 - front_n] * 2)]

    def grip(self):
        """With all the load on two wheels, each then carrying twice its static load."""
        return self.drawn["friction"] * (1.0 - self.drawn["load_sensitivity"])

    def data(self):
        """Contents of a vehicle-data file for `rsi-sil identify`; the IMU is at the sprung CG, the load at rest."""
        d = self.drawn
        return {"total_mass_kg": d["mass_kg"], "sprung_mass_kg": self.sprung_kg, "sprung_cg_height_m": d["cg_height_m"],
                "wheel_radius_m": self.hub_height_m, "track_width_m": d["track_width_m"],
                "wheelbase_m": d["wheelbase_m"], "steering_ratio": d["steering_ratio"]}

    def roll_inertia_kgm2(self):
        """That of the sprung mass about its CG; a data sheet may have it."""
        return self.sprung_kg * (self.drawn["roll_inertia_over_track"] * self.drawn["track_width_m"])**2

    def static_stability_factor(self):
        """The whole vehicle's, unsprung masses included."""
        d = self.drawn
        height = (self.sprung_kg * d["cg_height_m"] + 2.0 * self.axle_kg * self.hub_height_m) / d["mass_kg"]
        return 0.5 * d["track_width_m"] / height

    def motion(self, speed_mps):
        return Motion(self, speed_mps)

    @functools.cached_property
    def model(self):
        return engine_model.build(self)

    @functools.cached_property
    def tyres(self):
        """Cornering stiffness over load at the static load, and that load, wheel by wheel."""
        rear = self.drawn["cornering_per_rad"]
        front = 1.0 / (1.0 / rear + GRAVITY_MPS2 * self.drawn["understeer_s2pm"])
        return list(zip((front, front, rear, rear), self.static_loads_n))


class Motion:
    """A vehicle on its way, on a level road. Signals and loads are those at the beginning of the last step."""

    STEP_S = 0.001  # half of it gives the same drive

    def __init__(self, vehicle, speed_mps):
        self._model, self._data = vehicle.model, mujoco.MjData(vehicle.model)
        self._model.opt.timestep = self.STEP_S
        self._drawn, self._tyres = vehicle.drawn, vehicle.tyres
        self._wheels = [self._model.body(wheel).id for wheel in WHEELS]
        self._steering_rad, self._slips = 0.0, [0.0] * 4
        self._data.qfrc_applied[:] = engine_model.holding_forces(self._model)
        self._data.qvel[0] = speed_mps
        mujoco.mj_forward(self._model, self._data)
        self._sense()

    def _sense(self):
        numbers = self._data.sensordata.tolist()
        self._body = numbers[:BODY_NUMBERS]
        self._wheel = [numbers[begin:begin + WHEEL_NUMBERS] for begin in range(BODY_NUMBERS, len(numbers), WHEEL_NUMBERS)]

    def advance(self, handwheel_rad, acceleration_mps2):
        """By STEP_S. The road wheels follow the handwheel, left positive, with a lag; the rear wheels drive."""
        wanted = handwheel_rad / self._drawn["steering_ratio"]
        self._steering_rad += (wanted - self._steering_rad) * self.STEP_S / self._drawn["steering_lag_s"]
        loads = self.wheel_loads_n()  # of the step before: the engine finds them together with the accelerations
        mujoco.mj_step1(self._model, self._data)
        self._sense()
        drive = acceleration_mps2 * self._drawn["mass_kg"] / max(loads[2] + loads[3], 1.0)
        for wheel in range(4):
            steering, share = (self._steering_rad, 0.0) if wheel < 2 else (0.0, drive)
            self._data.xfrc_applied[self._wheels[wheel]] = self._road_force(wheel, loads[wheel], steering, share)
        mujoco.mj_step2(self._model, self._data)
        self._sense()

    def _road_force(self, wheel, load, steering, drive):
        """Force and moment about the hub, in directions of the road: brush tyre, slip delayed by the relaxation length."""
        d = self._drawn
        _, _, _, hub_z, head_x, head_y, _, _, _, lean_z, velocity_x, velocity_y, _ = self._wheel[wheel]
        length = math.hypot(head_x, head_y)
        cosine, sine = math.cos(steering) / length, math.sin(steering) / length
        along_x, along_y = head_x * cosine - head_y * sine, head_y * cosine + head_x * sine
        forward, sideways = velocity_x * along_x + velocity_y * along_y, velocity_y * along_x - velocity_x * along_y
        slip = self._slips[wheel]
        slip += (math.atan2(sideways, abs(forward) + 0.1) - slip) * min(abs(forward) * self.STEP_S / d["relaxation_m"], 1.0)
        self._slips[wheel] = slip
        if load <= 0.0:
            return (0.0,) * 6
        cornering, static_n = self._tyres[wheel]
        over = load / static_n - 1.0
        friction = d["friction"] * max(1.0 - d["load_sensitivity"] * over, 0.3)
        drive = max(min(drive, DRIVE_LIMIT * friction), -DRIVE_LIMIT * friction)
        friction = math.sqrt(friction**2 - drive**2)
        tangent = math.tan(slip + d["camber_thrust"] * lean_z)
        stretch = min(cornering * max(1.0 - 2.0 * d["load_sensitivity"] * over, 0.3) * abs(tangent) / (3.0 * friction), 1.0)
        lateral = -math.copysign(friction * (1.0 - (1.0 - stretch)**3), tangent) * load
        force_x, force_y = drive * load * along_x - lateral * along_y, drive * load * along_y + lateral * along_x
        given = d["tyre_sideways_mpg"] * lateral / static_n  # by the tyre, which carries the load so far beside the rim
        return force_x, force_y, 0.0, hub_z * force_y + given * along_x * load, -hub_z * force_x + given * along_y * load, 0.0

    def wheel_loads_n(self):
        return [wheel[0] for wheel in self._wheel]

    def load_transfer_ratio(self):
        return conventions.load_transfer_ratio(self.wheel_loads_n())

    def speed_mps(self):
        return self._body[6]

    def is_still_a_drive(self):
        """Neither spun nor nearly at a standstill."""
        forward, sideways = self._body[6:8]
        return forward > 5.0 and abs(sideways) < forward

    def signals(self):
        """As sensors at the sprung CG show them."""
        _, lateral, vertical, roll_rate, _, yaw_rate, forward = self._body[:7]
        return {"lateral_acceleration_mps2": lateral, "vertical_acceleration_mps2": vertical,
                "roll_rate_degps": math.degrees(roll_rate),
                "roll_angle_deg": math.degrees(math.atan2(self._body[11], self._body[14])), "speed_mps": forward,
                "yaw_rate_degps": math.degrees(yaw_rate)}
