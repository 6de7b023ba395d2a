"""A jointed vehicle as a model of MuJoCo: bodies on joints, springs and stops, and wheels that touch the road.

A vehicle stands on the road as it is drawn. A suspension is of the kind that its drawn quantities belong to.
"""

import math
import xml.etree.ElementTree

import mujoco

from conventions import GRAVITY_MPS2, WHEELS

STOP_STIFFNESS = 6.0  # of that of the spring
TYRE_DAMPING_RATIO = 0.05  # of an unsprung corner on its tyre
PENDULUM_DAMPING_RATIO = 0.05
TWIST_DAMPING_S = 0.005  # damping over stiffness of the frame
PROGRESSION_M = 0.08  # travel at which the spring's rate has grown by the share drawn
# Share of a constrained motion that the engine imposes: small, so that contacts and stops are springs and dampers; near 1
# for dry friction, or leaves would creep under a load that they hold.
SOFT, HOLDING = "0.02 0.02 0.001", "0.99 0.99 0.001"
SOFTNESS = 0.98
SIDES = (("left", 1.0), ("right", -1.0))
# The engine's sensors, three numbers each but for the load: those of the body, then those of each wheel.
BODY_SENSORS = ("accelerometer", "gyro", "velocimeter", "frameyaxis", "framezaxis")
WHEEL_SENSORS = ("touch", "framepos", "framexaxis", "frameyaxis", "framelinvel")
BODY_NUMBERS, WHEEL_NUMBERS = 15, 13


def build(vehicle):
    """Compiled. The engine scales the rates of contacts and stops by the inertia behind them, which only it knows."""
    model = mujoco.MjModel.from_xml_string(_text(vehicle))
    for wheel, load_n in zip(WHEELS, vehicle.static_loads_n):
        stiffness = load_n / vehicle.drawn["tyre_deflection_m"]
        damping = 2.0 * TYRE_DAMPING_RATIO * math.sqrt(stiffness * 0.5 * vehicle.axle_kg)
        model.geom(wheel).solref[:] = _rates(stiffness, damping, model.body_invweight0[model.body(wheel).id][0])
    for axle in _axles(vehicle):
        for side, _ in SIDES:
            stiffness = STOP_STIFFNESS * axle.spring_npm
            if axle.arm_m:
                joint, rate = model.joint(f"{axle.place}_{side}"), axle.arm_m**2
                model.jnt_solref[joint.id] = _rates(stiffness * rate, axle.damper_nspm * rate,
                                                    model.dof_invweight0[joint.dofadr[0]])
            else:
                tendon = model.tendon(f"{axle.place}_{side}").id
                model.tendon_solref_lim[tendon] = _rates(stiffness, axle.damper_nspm, model.tendon_invweight0[tendon])
    return model


def _rates(stiffness, damping, inverse_inertia):
    return [-stiffness * SOFTNESS * inverse_inertia, -damping * SOFTNESS * inverse_inertia]


def holding_forces(model):
    """Constant force of each degree of freedom that holds the vehicle up as it is drawn, where its springs have none."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    data.qacc[:] = 0.0
    mujoco.mj_inverse(model, data)
    forces = data.qfrc_inverse.copy()
    forces[:6] = 0.0  # the tyres hold the whole
    return forces


class _Axle:
    """Springs, dampers and dry friction of an axle. Rates of independent wheels are those at the wheel."""

    def __init__(self, vehicle, place, roll_stiffness_nmprad, roll_damping_nmsprad):
        d, front = vehicle.drawn, place == "front"
        self.place, self.mass_kg = place, vehicle.axle_kg
        self.x_m = vehicle.front_m if front else -vehicle.rear_m
        self.hub_m = vehicle.hub_height_m
        self.roll_axis_m = d[f"{place}_roll_axis_m"]
        self.arm_m = d.get(f"{place}_arm_m")  # of a swing arm
        self.half_track_m = 0.5 * d["track_width_m"]
        self.half_base_m = self.half_track_m * d.get("spring_base", 1.0)
        share = d["front_load_share"] if front else 1.0 - d["front_load_share"]
        corner_kg = 0.5 * vehicle.sprung_kg * share
        springs = 2.0 * self.half_base_m**2
        self.roll_stiffness_nmprad = roll_stiffness_nmprad
        self.spring_npm = min(corner_kg * (2.0 * math.pi * d["ride_frequency_hz"])**2, roll_stiffness_nmprad / springs)
        self.cubic_npm3 = self.spring_npm * d["progression"] / PROGRESSION_M**2
        self.bar_nmprad = roll_stiffness_nmprad - springs * self.spring_npm
        self.damper_nspm = roll_damping_nmsprad / springs
        self.friction_n = d["dry_friction"] * corner_kg * GRAVITY_MPS2


def _axles(vehicle):
    d = vehicle.drawn
    axis_m = d["front_roll_axis_m"] + (d["rear_roll_axis_m"] - d["front_roll_axis_m"]) * vehicle.front_m / d["wheelbase_m"]
    arm_m = d["cg_height_m"] - axis_m
    tipping = vehicle.sprung_kg * GRAVITY_MPS2 * arm_m
    net = tipping / math.radians(d["roll_gradient_degpg"])
    inertia = vehicle.sprung_kg * ((d["roll_inertia_over_track"] * d["track_width_m"])**2 + arm_m**2)
    damping = 2.0 * d["roll_damping_ratio"] * math.sqrt(net * inertia)
    share = d["front_roll_stiffness_share"]
    return [_Axle(vehicle, "front", share * (net + tipping), 0.5 * damping),
            _Axle(vehicle, "rear", (1.0 - share) * (net + tipping), 0.5 * damping)]


def _add(parent, tag, **attributes):
    def text(value):
        if isinstance(value, str):
            return value
        return " ".join(f"{each:.9g}" for each in value) if isinstance(value, (tuple, list)) else f"{value:.9g}"

    return xml.etree.ElementTree.SubElement(parent, tag, {name: text(value) for name, value in attributes.items()})


class _Body:
    """A body of the model, placed by its centre of gravity on the road's axes."""

    def __init__(self, parent, name, place, mass_kg, inertias):
        """`parent` is another body, or the element of the world."""
        origin = parent.place if isinstance(parent, _Body) else (0.0, 0.0, 0.0)
        self.place = place
        self.element = _add(getattr(parent, "element", parent), "body", name=name, pos=[a - b for a, b in zip(place, origin)])
        _add(self.element, "inertial", pos=(0.0, 0.0, 0.0), mass=mass_kg, diaginertia=inertias)

    def add(self, tag, place=None, **attributes):
        if place:
            attributes["pos"] = [a - b for a, b in zip(place, self.place)]
        return _add(self.element, tag, **attributes)


def _wheel(vehicle, parent, name, place, mass_kg):
    """A wheel, the lowest point of its middle, and a sphere that feels everything that touches it."""
    radius = vehicle.drawn["wheel_radius_m"]
    body = _Body(parent, name, place, mass_kg, [share * mass_kg * radius**2 for share in (0.3, 0.5, 0.3)])
    body.add("geom", name=name, type="ellipsoid", size=(radius, 0.35 * radius, radius), mass="0", contype="0", condim="1",
             priority="1", solimp=SOFT)
    body.add("site", name=name, size=(2.0 * radius,))
    body.add("site", name=f"{name}_bottom", pos=(0.0, 0.0, -radius))
    return body


def _swing_arms(vehicle, axle, carrier, tendons):
    """Each wheel on a hinge along the vehicle. The line from its contact to the hinge meets the middle at the roll axis."""
    rate, travel = axle.arm_m**2, vehicle.drawn["travel_m"] / axle.arm_m
    bar = _add(tendons, "fixed", name=f"{axle.place}_bar", stiffness=axle.bar_nmprad * rate / (2.0 * axle.half_track_m)**2)
    for side, sign in SIDES:
        name = f"{axle.place}_{side}"
        hub = (axle.x_m, sign * axle.half_track_m, axle.hub_m)
        hinge = (axle.x_m, sign * (axle.half_track_m - axle.arm_m), axle.roll_axis_m * axle.arm_m / axle.half_track_m)
        _wheel(vehicle, carrier, name, hub, 0.5 * axle.mass_kg).add(
            "joint", hinge, name=name, axis=(sign, 0.0, 0.0), stiffness=(axle.spring_npm * rate, 0.0, axle.cubic_npm3 * rate**2),
            damping=axle.damper_nspm * rate, frictionloss=axle.friction_n * axle.arm_m, range=(-travel, travel),
            solimplimit=SOFT, solimpfriction=HOLDING)
        _add(bar, "joint", joint=name, coef=sign)


def _rigid_axle(vehicle, axle, carrier, tendons):
    """Both wheels on a beam that heaves and rolls; a spring on each side, with the friction of its leaves and with stops."""
    wheel_kg, travel = 0.25 * axle.mass_kg, vehicle.drawn["travel_m"]
    beam_kg = axle.mass_kg - 2.0 * wheel_kg
    across = beam_kg * axle.half_track_m**2 / 3.0
    beam = _Body(carrier, f"{axle.place}_axle", (axle.x_m, 0.0, axle.hub_m), beam_kg, (across, 0.05 * beam_kg, across))
    heave, roll = f"{axle.place}_heave", f"{axle.place}_roll"
    beam.add("joint", name=heave, type="slide", axis=(0.0, 0.0, 1.0))
    beam.add("joint", (axle.x_m, 0.0, axle.roll_axis_m), name=roll, axis=(1.0, 0.0, vehicle.drawn[f"{axle.place}_roll_steer"]),
             stiffness=axle.bar_nmprad)
    for side, sign in SIDES:
        name = f"{axle.place}_{side}"
        _wheel(vehicle, beam, name, (axle.x_m, sign * axle.half_track_m, axle.hub_m), wheel_kg)
        spring = _add(tendons, "fixed", name=name, stiffness=(axle.spring_npm, 0.0, axle.cubic_npm3), damping=axle.damper_nspm,
                      frictionloss=axle.friction_n, range=(-travel, travel), solimplimit=SOFT, solimpfriction=HOLDING)
        _add(spring, "joint", joint=heave, coef=1.0)
        _add(spring, "joint", joint=roll, coef=sign * axle.half_base_m)


def _inertias(vehicle, mass_kg, length_share=1.0):
    d = vehicle.drawn
    roll = mass_kg * (d["roll_inertia_over_track"] * d["track_width_m"])**2
    yaw = max(mass_kg * vehicle.front_m * vehicle.rear_m * d["yaw_inertia"] * length_share**2, 0.5 * roll)
    return roll, 0.95 * yaw, yaw


def _sprung_mass(vehicle, world, axles):
    """The bodies that carry front and rear axle: the chassis, or both halves of a frame. A load that swings hangs on it."""
    d, height = vehicle.drawn, vehicle.drawn["cg_height_m"]
    twists, swings = "frame_stiffness_share" in d, "swinging_share" in d
    hung_kg = d["rear_mass_share"] * vehicle.sprung_kg if twists else d["swinging_share"] * d["mass_kg"] if swings else 0.0
    hung = (-0.5 * vehicle.rear_m if twists else -0.2 * vehicle.rear_m, 0.0, 1.05 * height)
    own_kg = vehicle.sprung_kg - hung_kg
    place = (-hung_kg * hung[0] / own_kg, 0.0, (vehicle.sprung_kg * height - hung_kg * hung[2]) / own_kg)
    half = 0.7 if twists else 1.0
    chassis = _Body(world, "chassis", place, own_kg, _inertias(vehicle, own_kg, half))
    chassis.add("freejoint")
    chassis.add("site", (0.0, 0.0, height), name="imu")
    if twists:
        stiffness = d["frame_stiffness_share"] * sum(axle.roll_stiffness_nmprad for axle in axles)
        rear = _Body(chassis, "rear_frame", hung, hung_kg, _inertias(vehicle, hung_kg, half))
        rear.add("joint", (0.0, 0.0, 0.6 * height), name="twist", axis=(1.0, 0.0, 0.0), stiffness=stiffness,
                 damping=stiffness * TWIST_DAMPING_S)
        return chassis, rear
    if swings:
        own = hung_kg * (0.2 * d["pendulum_m"])**2
        about_pivot = own + hung_kg * d["pendulum_m"]**2
        load = _Body(chassis, "load", hung, hung_kg, (own, 0.1 * hung_kg * vehicle.rear_m, 0.1 * hung_kg * vehicle.rear_m))
        load.add("joint", (hung[0], 0.0, hung[2] + d["pendulum_m"]), name="swing", axis=(1.0, 0.0, 0.0),
                 damping=2.0 * PENDULUM_DAMPING_RATIO * math.sqrt(hung_kg * GRAVITY_MPS2 * d["pendulum_m"] * about_pivot))
    return chassis, chassis


def _add_sensor(sensors, kind, site):
    _add(sensors, kind, **({"objtype": "site", "objname": site} if kind.startswith("frame") else {"site": site}))


def _text(vehicle):
    root = xml.etree.ElementTree.Element("mujoco")
    _add(root, "compiler", angle="radian", autolimits="true", inertiafromgeom="false")
    _add(root, "option", gravity=(0.0, 0.0, -GRAVITY_MPS2), integrator="implicitfast", solver="Newton",
         iterations="50", tolerance="1e-12")
    world, tendons, sensors = (_add(root, tag) for tag in ("worldbody", "tendon", "sensor"))
    _add(world, "geom", name="road", type="plane", size=(0.0, 0.0, 1.0), conaffinity="0", condim="1")
    axles = _axles(vehicle)
    for axle, carrier in zip(axles, _sprung_mass(vehicle, world, axles)):
        (_swing_arms if axle.arm_m else _rigid_axle)(vehicle, axle, carrier, tendons)
    for kind in BODY_SENSORS:
        _add_sensor(sensors, kind, "imu")
    for wheel in WHEELS:
        for kind in WHEEL_SENSORS:
            _add_sensor(sensors, kind, f"{wheel}_bottom" if kind == "framelinvel" else wheel)
    return xml.etree.ElementTree.tostring(root, encoding="unicode")
