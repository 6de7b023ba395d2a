"""Vehicles that this project did not write: the multi-body model of commonroad-vehicle-models, its parameter set 3 varied.

The model has 29 states and the axes of SAE (y to the right, z down); everything that leaves this file has those of ISO 8855.
A tyre without load gives no force here; that of the package holds a lifted wheel down.
"""

import math
import pathlib
import random
import types
import typing

import vehiclemodels
import yaml
from vehiclemodels import init_mb, vehicle_dynamics_mb
from vehiclemodels.utils import tire_model

import conventions
from conventions import GRAVITY_MPS2  # the package's too

# Places in the state.
STEERING, SPEED, YAW_RATE, ROLL, ROLL_RATE, PITCH, LATERAL_SPEED, HEIGHT, VERTICAL_SPEED = 2, 3, 5, 6, 7, 8, 10, 11, 12
FRONT_ROLL, FRONT_HEIGHT, REAR_ROLL, REAR_HEIGHT = 13, 16, 18, 21  # of the axles; each with its rate behind it

# Two ends of every quantity that is drawn, alike for all classes. Factors are those on parameter set 3, a van.
FACTORS = {"wheelbase": (0.95, 1.25), "roll_inertia": (0.85, 1.2), "yaw_inertia": (0.85, 1.2), "unsprung_mass": (0.9, 1.4),
           "front_spring": (0.75, 1.3), "rear_spring": (0.75, 1.3), "front_bar": (0.4, 1.8), "rear_bar": (0.4, 1.8),
           "damping": (0.5, 1.4), "tyre_spring": (0.8, 1.2), "tyre_compliance": (0.3, 1.1), "cornering_stiffness": (0.7, 1.3)}
DRAWN = {"friction": (0.85, 1.15), "steering_lag_s": (0.03, 0.15), "steering_ratio": (14.0, 20.0),
         "front_load_share": (0.48, 0.58)}
# Those that make a class: mass as a factor, height of the sprung CG, track width, heights of the roll axis.
CLASSES = {
    "van": {"mass": (1.0, 1.6), "cg_height_m": (0.84, 1.05), "track_width_m": (1.5, 1.68), "front_roll_axis_m": (0.0, 0.12),
            "rear_roll_axis_m": (0.0, 0.3)},
    "SUV": {"mass": (1.1, 1.6), "cg_height_m": (0.78, 0.96), "track_width_m": (1.44, 1.6), "front_roll_axis_m": (0.0, 0.15),
            "rear_roll_axis_m": (0.05, 0.35)},
    "pick-up": {"mass": (1.0, 1.5), "cg_height_m": (0.76, 0.94), "track_width_m": (1.42, 1.58), "front_roll_axis_m": (0.0, 0.12),
                "rear_roll_axis_m": (0.25, 0.42)},
}


class _TyreModel:
    """The package's tyre, where the wheel stands on the road."""

    @staticmethod
    def formula_longitudinal(slip, camber, load, tyre):
        return tire_model.formula_longitudinal(slip, camber, load, tyre) if load > 0.0 else 0.0

    @staticmethod
    def formula_lateral(slip, camber, load, tyre):
        return tire_model.formula_lateral(slip, camber, load, tyre) if load > 0.0 else (0.0, 0.0)

    @staticmethod
    def formula_longitudinal_comb(slip, lateral_slip, force, tyre):
        return tire_model.formula_longitudinal_comb(slip, lateral_slip, force, tyre)

    @staticmethod
    def formula_lateral_comb(slip, lateral_slip, camber, friction, load, force, tyre):
        if load <= 0.0:
            return 0.0
        return tire_model.formula_lateral_comb(slip, lateral_slip, camber, friction, load, force, tyre)


vehicle_dynamics_mb.tireModel = _TyreModel  # the package's equations look it up under this name


def _namespace(table):
    return types.SimpleNamespace(
        **{key: _namespace(value) if isinstance(value, dict) else float(value) for key, value in table.items()})


def base_parameters():
    """Parameter set 3 of the package, with its tyre."""
    folder = pathlib.Path(vehiclemodels.__file__).parent / "parameters"
    tables = [yaml.safe_load((folder / f"parameters_{name}.yaml").read_text(encoding="utf-8")) for name in ("vehicle3", "tire")]
    return _namespace(tables[0] | tables[1])


class Vehicle(typing.NamedTuple):
    name: str
    kind: str
    drawn: dict
    parameters: types.SimpleNamespace  # of the model, under the names of the package

    def grip(self):
        return self.drawn["friction"]  # under any load

    def motion(self, speed_mps):
        return Motion(self, speed_mps)

    def data(self):
        """Contents of a vehicle-data file for `rsi-sil identify`; the IMU is at the sprung CG."""
        p = self.parameters
        return {"total_mass_kg": p.m, "sprung_mass_kg": p.m_s, "sprung_cg_height_m": p.h_s, "wheel_radius_m": p.R_w,
                "track_width_front_m": p.T_f, "track_width_rear_m": p.T_r, "wheelbase_m": p.a + p.b,
                "steering_ratio": self.drawn["steering_ratio"]}

    def roll_inertia_kgm2(self):
        """That of the sprung mass about its CG; a data sheet may have it."""
        return self.parameters.I_Phi_s

    def static_stability_factor(self):
        """The whole vehicle's, unsprung masses included."""
        p = self.parameters
        height = (p.m_s * p.h_s + (p.m_uf + p.m_ur) * p.R_w) / p.m
        return (p.T_f + p.T_r) / 4.0 / height


def draw(seed, number):
    """The vehicle of this number; the same seed gives the same."""
    source = random.Random(f"vehicle {seed} {number}")
    kind = list(CLASSES)[number % len(CLASSES)]
    drawn = {name: source.uniform(*ends) for name, ends in (FACTORS | DRAWN | CLASSES[kind]).items()}
    return Vehicle(f"{number:03}", kind, drawn, _varied(base_parameters(), drawn))


def ends():
    """Both ends of every quantity that is drawn, by class and name."""
    def label(name):
        return f"{name}, factor" if name in FACTORS or name == "mass" else name

    return {kind: {label(name): both for name, both in (FACTORS | DRAWN | own).items()} for kind, own in CLASSES.items()}


def _varied(p, drawn):
    mass = drawn["mass"]
    base_track, base_friction = p.T_f, p.tire.p_dy1
    wide = drawn["track_width_m"] / base_track
    wheelbase = (p.a + p.b) * drawn["wheelbase"]
    p.m_s *= mass
    p.m_uf *= mass * drawn["unsprung_mass"]
    p.m_ur *= mass * drawn["unsprung_mass"]
    p.m = p.m_s + p.m_uf + p.m_ur
    p.a, p.b = wheelbase * (1.0 - drawn["front_load_share"]), wheelbase * drawn["front_load_share"]
    p.h_s, p.T_f, p.T_r = drawn["cg_height_m"], drawn["track_width_m"], drawn["track_width_m"] * p.T_r / base_track
    p.h_raf, p.h_rar = drawn["front_roll_axis_m"], drawn["rear_roll_axis_m"]
    p.I_Phi_s *= mass * wide**2 * drawn["roll_inertia"]
    p.I_y_s *= mass * drawn["wheelbase"]**2
    p.I_z *= mass * drawn["wheelbase"]**2 * drawn["yaw_inertia"]
    p.I_uf *= mass * wide**2 * drawn["unsprung_mass"]
    p.I_ur *= mass * wide**2 * drawn["unsprung_mass"]
    p.I_y_w *= mass
    p.K_sf *= mass * drawn["front_spring"]
    p.K_sr *= mass * drawn["rear_spring"]
    p.K_sdf *= mass * drawn["damping"]
    p.K_sdr *= mass * drawn["damping"]
    p.K_tsf *= mass * drawn["front_bar"]
    p.K_tsr *= mass * drawn["rear_bar"]
    p.K_ras *= mass
    p.K_rad *= mass
    p.K_zt *= mass * drawn["tyre_spring"]
    p.K_lt *= drawn["tyre_compliance"] / mass
    p.tire.p_dy1 = drawn["friction"]
    p.tire.p_dx1 *= drawn["friction"] / base_friction
    p.tire.p_ky1 *= drawn["cornering_stiffness"]
    p.steering.v_min, p.steering.v_max = -math.inf, math.inf  # the driver of this study has limits of his own
    return p


def _wheel_loads_n(p, x):
    """As the package computes them: negative above the road."""
    loads = []
    for roll, height, track in ((FRONT_ROLL, FRONT_HEIGHT, p.T_f), (REAR_ROLL, REAR_HEIGHT, p.T_r)):
        middle = x[height] + p.R_w * (math.cos(x[roll]) - 1.0)
        lean = 0.5 * track * math.sin(x[roll])
        loads += [(middle - lean) * p.K_zt, (middle + lean) * p.K_zt]
    return loads


def derivative(p, x, steering_velocity_radps, acceleration_mps2):
    """The package's equations, without the pull of tyres above the road."""
    f = vehicle_dynamics_mb.vehicle_dynamics_mb(x, (steering_velocity_radps, acceleration_mps2), p)
    pulls = [min(load, 0.0) for load in _wheel_loads_n(p, x)]
    if any(pulls):
        for left, right, roll, height, track, mass, inertia in (
                (*pulls[:2], FRONT_ROLL, FRONT_HEIGHT, p.T_f, p.m_uf, p.I_uf),
                (*pulls[2:], REAR_ROLL, REAR_HEIGHT, p.T_r, p.m_ur, p.I_ur)):
            lean, half = p.R_w * math.sin(x[roll]), 0.5 * track * math.cos(x[roll])
            f[roll + 1] -= (left * (half + lean) - right * (half - lean)) / inertia
            f[height + 1] += (left + right) / mass
    return f


class Motion:
    """A vehicle on its way, on a level road."""

    STEP_S = 0.002  # of the integration; the fastest mode, a wheel's spin, wants less than 0.003 s

    def __init__(self, vehicle, speed_mps):
        self.vehicle = vehicle
        p = vehicle.parameters
        self.state = init_mb.init_mb([0.0, 0.0, 0.0, speed_mps, 0.0, 0.0, 0.0], p)
        # The package lets the axles sink into the tyres and leaves the body up, which would then bounce.
        front_m, rear_m = self.state[FRONT_HEIGHT], self.state[REAR_HEIGHT]
        self.state[PITCH] = (rear_m - front_m) / (p.a + p.b)
        self.state[HEIGHT] = front_m + p.a * self.state[PITCH]
        self._inputs = (0.0, 0.0)

    def advance(self, handwheel_rad, acceleration_mps2):
        """By STEP_S (Runge-Kutta of fourth order). The road wheels follow the handwheel, left positive, with a lag."""
        p, x, step = self.vehicle.parameters, self.state, self.STEP_S
        wanted = -handwheel_rad / self.vehicle.drawn["steering_ratio"]
        lag = self.vehicle.drawn["steering_lag_s"]

        def slope(state):
            return derivative(p, state, (wanted - state[STEERING]) / lag, acceleration_mps2)

        first = slope(x)
        second = slope([value + 0.5 * step * rate for value, rate in zip(x, first)])
        third = slope([value + 0.5 * step * rate for value, rate in zip(x, second)])
        fourth = slope([value + step * rate for value, rate in zip(x, third)])
        self.state = [value + step / 6.0 * (k1 + 2.0 * (k2 + k3) + k4)
                      for value, k1, k2, k3, k4 in zip(x, first, second, third, fourth)]
        self._inputs = ((wanted - self.state[STEERING]) / lag, acceleration_mps2)

    def wheel_loads_n(self):
        return [max(load, 0.0) for load in _wheel_loads_n(self.vehicle.parameters, self.state)]

    def load_transfer_ratio(self):
        return conventions.load_transfer_ratio(self.wheel_loads_n())

    def speed_mps(self):
        return self.state[SPEED]

    def is_still_a_drive(self):
        """Neither spun nor nearly at a standstill."""
        return self.state[SPEED] > 5.0 and abs(self.state[LATERAL_SPEED]) < self.state[SPEED]

    def signals(self):
        """As sensors at the sprung CG show them."""
        x = self.state
        f = derivative(self.vehicle.parameters, x, *self._inputs)
        lateral = -(f[LATERAL_SPEED] + x[YAW_RATE] * x[SPEED])
        normal = GRAVITY_MPS2 - f[VERTICAL_SPEED]
        sine, cosine = math.sin(x[ROLL]), math.cos(x[ROLL])
        return {"lateral_acceleration_mps2": lateral * cosine + normal * sine,
                "vertical_acceleration_mps2": normal * cosine - lateral * sine,
                "roll_rate_degps": math.degrees(x[ROLL_RATE]), "roll_angle_deg": math.degrees(x[ROLL]),
                "speed_mps": x[SPEED], "yaw_rate_degps": -math.degrees(x[YAW_RATE]) * cosine}
