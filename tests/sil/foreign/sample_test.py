"""The study of foreign vehicles: the models of both families, their drives, and what some of the vehicles give.

Use: sample_test.py RSI_SIL
"""

import contextlib
import csv
import math
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(PROJECT / "sil/studies/foreign")]

import study  # its paths are those of the modules below
import commonroad
import conventions
import jointed
import judge
import manoeuvres
import mujoco
import quantities
import report
import ways

PROGRAM = ""
SEED = 1
GRAVITY = conventions.GRAVITY_MPS2
# Drives of the first two vehicles that lift two wheels; lift-offs warned of, 0.1 s and 0.2 s before; alarms of how many, by band.
LIFTED = [True, True, True, True, True, False, True, False]
WARNED = {ways.CLEAN: (6, 6, 6), ways.ERRORS: (6, 6, 6)}
ALARMS = [(0, 1), (0, 0), (0, 0), (1, 1)]
JOINTED = 10  # on swing arms
JOINTED_WITHOUT_INERTIA = 7  # a frame that twists
JOINTED_LIFTED = [False, True, True, True]
JOINTED_WARNED = {ways.CLEAN: (3, 3, 3), ways.ERRORS: (3, 3, 3)}
JOINTED_ALARMS = [(0, 0), (0, 1), (0, 0), (0, 0)]


def column(rows, name):
    place = manoeuvres.COLUMNS.index(name)
    return [row[place] for row in rows]


def step_steer(vehicle, angle_deg, duration_s):
    course = manoeuvres.corners([(angle_deg, duration_s)], 500.0)
    return manoeuvres.drive(vehicle, 80.0, lambda time_s: manoeuvres.at(course, time_s), course[-1][0])


@contextlib.contextmanager
def half_the_step(motion):
    step, motion.STEP_S = motion.STEP_S, 0.5 * motion.STEP_S
    try:
        yield
    finally:
        motion.STEP_S = step


class Model(unittest.TestCase):
    def setUp(self):
        self.vehicle = commonroad.draw(SEED, 0)

    def test_a_vehicle_in_the_air_falls_freely(self):
        p = self.vehicle.parameters
        motion = self.vehicle.motion(20.0)
        for height in (commonroad.FRONT_HEIGHT, commonroad.REAR_HEIGHT):
            motion.state[height] = -0.05  # z points down
        f = commonroad.derivative(p, motion.state, 0.0, 0.0)
        self.assertEqual(motion.wheel_loads_n(), [0.0] * 4)
        fall = (p.m_s * f[commonroad.VERTICAL_SPEED] + p.m_uf * f[17] + p.m_ur * f[22]) / p.m
        self.assertAlmostEqual(fall, GRAVITY, places=9)

    def test_a_lifted_wheel_does_not_turn_its_axle(self):
        p, rates = self.vehicle.parameters, []
        for tyre in (p.K_zt, 2.0 * p.K_zt):  # the left front wheel is above the road, the right one touches it just not
            p.K_zt = tyre
            state = self.vehicle.motion(20.0).state
            state[commonroad.FRONT_ROLL], state[commonroad.FRONT_HEIGHT] = 0.1, -0.5 * p.T_f * math.sin(0.1) - 0.001
            state[commonroad.HEIGHT], state[commonroad.PITCH] = 0.0, 0.0
            state[commonroad.REAR_HEIGHT] = 0.0
            self.assertTrue(all(load <= 0.0 for load in commonroad._wheel_loads_n(p, state)))
            f = commonroad.derivative(p, state, 0.0, 0.0)
            rates.append((f[commonroad.FRONT_ROLL + 1], f[commonroad.FRONT_HEIGHT + 1]))
        self.assertAlmostEqual(rates[0][0], rates[1][0], places=6)
        self.assertAlmostEqual(rates[0][1], rates[1][1], places=6)

    def test_it_stands_on_its_wheels(self):
        motion = self.vehicle.motion(20.0)
        signals = motion.signals()
        self.assertAlmostEqual(sum(motion.wheel_loads_n()), self.vehicle.parameters.m * GRAVITY, delta=1e-6)
        self.assertAlmostEqual(signals["vertical_acceleration_mps2"], GRAVITY, delta=1e-9)
        for _ in range(200):
            motion.advance(0.0, 0.0)
        later = motion.signals()
        # The package's tyre jumps with the sign of the camber, so a straight drive drifts a little.
        for name, at_rest, delta in (("vertical_acceleration_mps2", GRAVITY, 0.01), ("lateral_acceleration_mps2", 0.0, 0.4),
                                     ("roll_angle_deg", 0.0, 0.4), ("yaw_rate_degps", 0.0, 1.0)):
            self.assertAlmostEqual(later[name], at_rest, delta=delta)

    def test_a_left_turn_has_the_signs_of_iso_8855(self):
        rows = step_steer(self.vehicle, 15.0, 3.0)
        last = dict(zip(manoeuvres.COLUMNS, rows[-1]))
        along_the_road = manoeuvres.on_the_road_mps2(rows[-1])
        self.assertGreater(along_the_road, 1.5)
        self.assertGreater(last["roll_angle_deg"], 1.0)
        self.assertAlmostEqual(math.radians(last["yaw_rate_degps"]) * last["speed_mps"], along_the_road, delta=0.1)
        self.assertGreater(last["wheel_load_front_right_n"], last["wheel_load_front_left_n"] + 500.0)
        self.assertGreater(last["wheel_load_rear_right_n"], last["wheel_load_rear_left_n"] + 500.0)
        # Load transfer of the whole vehicle about the road: a height in its middle over half its track, and the roll besides.
        loads = [last[name] for name in manoeuvres.LOADS]
        ratio = (loads[1] + loads[3] - loads[0] - loads[2]) / sum(loads)
        least = along_the_road / GRAVITY / self.vehicle.static_stability_factor()
        self.assertLess(least, ratio)
        self.assertLess(ratio, 1.25 * least)

    def test_the_inner_wheels_of_a_lifted_vehicle_carry_nothing(self):
        rows = step_steer(self.vehicle, 70.0, 3.0)
        self.assertLess(rows[-1][0], 3.0)
        up = [row for row in rows if row[-4] == row[-2] == 0.0]
        self.assertEqual(len(up), 11)  # then the drive ends
        self.assertEqual(up, rows[-11:])
        for row in up:
            self.assertAlmostEqual((row[-3] + row[-1]) / (self.vehicle.parameters.m * GRAVITY), 1.0, delta=0.2)

    def test_half_the_step_gives_the_same_drive(self):
        rows = step_steer(self.vehicle, 40.0, 1.5)
        with half_the_step(commonroad.Motion):
            finer = step_steer(self.vehicle, 40.0, 1.5)
        self.assertEqual(len(rows), len(finer))
        self.assertAlmostEqual(rows[-1][4], finer[-1][4], delta=0.02)  # deg of roll
        self.assertAlmostEqual(rows[-1][-1], finer[-1][-1], delta=20.0)  # N


def steady_turn(vehicle, lateral_g):
    """A motion in a left turn of about this lateral acceleration, at 20 m/s."""
    motion = vehicle.motion(20.0)
    d = vehicle.drawn
    radius = 20.0**2 / (lateral_g * GRAVITY)
    road_wheel = d["wheelbase_m"] / radius + d["understeer_s2pm"] * lateral_g * GRAVITY
    for step in range(5000):
        motion.advance(min(step / 1000.0, 1.0) * road_wheel * d["steering_ratio"], 20.0 - motion.speed_mps())
    return motion


def lateral_mps2(motion):
    """Along the road, in a steady turn."""
    signals = motion.signals()
    return math.radians(signals["yaw_rate_degps"]) * signals["speed_mps"] / math.cos(math.radians(signals["roll_angle_deg"]))


class Jointed(unittest.TestCase):
    """One vehicle of each class; what the engine computes against statics that this test computes."""

    @classmethod
    def setUpClass(cls):
        cls.vehicles = {vehicle.kind: vehicle for vehicle in (jointed.draw(SEED, number) for number in range(5))}

    def test_it_stands_still_on_its_wheels(self):
        for kind, vehicle in self.vehicles.items():
            with self.subTest(kind):
                weight = vehicle.drawn["mass_kg"] * GRAVITY
                self.assertAlmostEqual(vehicle.model.body_mass.sum() / vehicle.drawn["mass_kg"], 1.0, delta=1e-6)
                motion = vehicle.motion(25.0)
                for _ in range(500):
                    motion.advance(0.0, 0.0)
                    self.assertAlmostEqual(sum(motion.wheel_loads_n()) / weight, 1.0, delta=1e-4)
                for load, at_rest in zip(motion.wheel_loads_n(), vehicle.static_loads_n):
                    self.assertAlmostEqual(load / at_rest, 1.0, delta=1e-4)
                signals = motion.signals()
                self.assertAlmostEqual(signals["speed_mps"], 25.0, delta=1e-6)
                self.assertAlmostEqual(signals["vertical_acceleration_mps2"], GRAVITY, delta=1e-3)
                for name in ("lateral_acceleration_mps2", "roll_angle_deg", "roll_rate_degps", "yaw_rate_degps"):
                    self.assertAlmostEqual(signals[name], 0.0, delta=1e-6)

    def test_a_vehicle_in_the_air_falls_freely(self):
        for kind, vehicle in self.vehicles.items():
            with self.subTest(kind):
                motion = vehicle.motion(20.0)
                motion._data.qpos[2] += 1.0
                mujoco.mj_forward(motion._model, motion._data)
                for _ in range(100):
                    motion.advance(0.0, 0.0)
                self.assertEqual(motion.wheel_loads_n(), [0.0] * 4)
                mujoco.mj_subtreeVel(motion._model, motion._data)
                # The engine tells of the beginning of the last step.
                self.assertAlmostEqual(motion._data.subtree_linvel[1][2], -0.099 * GRAVITY, delta=1e-5)

    def test_the_load_transfer_of_a_steady_turn_is_that_of_statics(self):
        for kind, vehicle in self.vehicles.items():
            with self.subTest(kind):
                motion = steady_turn(vehicle, 0.3)
                data, model = motion._data, motion._model
                lateral = lateral_mps2(motion)
                self.assertAlmostEqual(lateral / GRAVITY, 0.3, delta=0.06)
                # Every body's centrifugal force and weight, and the road's forces where the engine has the contacts and the
                # tyres give way; distances across the heading, positive to the left.
                across = data.site("imu").xmat.reshape(3, 3)[:2, 1]
                across = across / math.hypot(*across)
                overturning = sum(mass * (GRAVITY * place[:2] @ across - lateral * place[2])
                                  for mass, place in zip(model.body_mass, data.xipos)) / vehicle.drawn["mass_kg"] / GRAVITY
                places = []
                for wheel, static_n in zip(conventions.WHEELS, vehicle.static_loads_n):
                    contact = next(each for each in data.contact if model.geom(wheel).id in each.geom)
                    force = data.xfrc_applied[model.body(wheel).id][:2] @ across
                    places.append(contact.pos[:2] @ across + vehicle.drawn["tyre_sideways_mpg"] * force / static_n)
                left, right = 0.5 * (places[0] + places[2]), 0.5 * (places[1] + places[3])
                expected = (0.5 * (left + right) - overturning) / (0.5 * (left - right))
                self.assertAlmostEqual(motion.load_transfer_ratio() / expected, 1.0, delta=0.005)
                # And near that of a rigid vehicle, of which it can only be more.
                rigid = lateral / GRAVITY / vehicle.static_stability_factor()
                self.assertTrue(1.0 < motion.load_transfer_ratio() / rigid < 1.35, motion.load_transfer_ratio() / rigid)

    def test_a_left_turn_has_the_signs_of_iso_8855(self):
        for kind, vehicle in self.vehicles.items():
            with self.subTest(kind):
                rows = step_steer(vehicle, 20.0, 2.0)
                last = dict(zip(manoeuvres.COLUMNS, rows[-1]))
                along_the_road = manoeuvres.on_the_road_mps2(rows[-1])
                self.assertGreater(along_the_road, 1.0)
                self.assertGreater(last["roll_angle_deg"], 0.3)
                self.assertGreater(last["yaw_rate_degps"], 0.0)
                self.assertGreater(last["wheel_load_front_right_n"], 1.1 * last["wheel_load_front_left_n"])
                self.assertGreater(last["wheel_load_rear_right_n"], 1.1 * last["wheel_load_rear_left_n"])

    def test_the_same_drive_gives_the_same_bits(self):
        for number in range(5):
            one, again = (step_steer(jointed.draw(SEED, number), 40.0, 1.0) for _ in range(2))
            self.assertEqual(one, again)

    def test_half_the_step_gives_the_same_drive(self):
        for number in range(5):
            rows = step_steer(jointed.draw(SEED, number), 40.0, 1.0)
            with half_the_step(jointed.Motion):
                finer = step_steer(jointed.draw(SEED, number), 40.0, 1.0)
            self.assertEqual(len(rows), len(finer))
            self.assertAlmostEqual(rows[-1][4], finer[-1][4], delta=0.02)  # deg of roll
            for load, other in zip(rows[-1][-4:], finer[-1][-4:]):
                self.assertAlmostEqual(load, other, delta=0.005 * sum(rows[-1][-4:]))

    def test_swing_arms_jack_the_body_up(self):
        rises = {}
        for kind in (jointed.SWING_ARMS, jointed.LEAF_SPRINGS):
            vehicle = self.vehicles[kind]
            motion = steady_turn(vehicle, 0.5)
            rises[kind] = motion._data.site("imu").xpos[2] - vehicle.drawn["cg_height_m"]
        self.assertGreater(rises[jointed.SWING_ARMS], 0.01)
        self.assertLess(rises[jointed.LEAF_SPRINGS], 0.003)

    def test_leaf_springs_hold_a_small_roll_moment(self):
        vehicle = self.vehicles[jointed.LEAF_SPRINGS]
        smooth = jointed.Vehicle("smooth", vehicle.kind, vehicle.drawn | {"dry_friction": 0.0})
        rolls = [steady_turn(each, 0.03).signals()["roll_angle_deg"] for each in (vehicle, smooth)]
        self.assertGreater(rolls[1], 0.1)
        self.assertLess(rolls[0], 0.6 * rolls[1])

    def test_a_frame_that_twists_carries_no_roll_moment_to_the_other_axle(self):
        vehicle = self.vehicles[jointed.TWISTING_FRAME]
        shares = []
        for stiffness in (0.02, 20.0):
            changed = jointed.Vehicle("changed", vehicle.kind, vehicle.drawn | {"frame_stiffness_share": stiffness,
                                                                                "front_roll_stiffness_share": 0.8})
            loads = steady_turn(changed, 0.3).wheel_loads_n()
            shares.append((loads[1] - loads[0]) / (loads[1] - loads[0] + loads[3] - loads[2]))
        self.assertLess(shares[0], shares[1] - 0.05)

    def test_the_load_hangs_along_the_apparent_weight(self):
        motion = steady_turn(self.vehicles[jointed.TANKER], 0.25)
        leans = math.degrees(math.atan2(lateral_mps2(motion), GRAVITY))
        swing = math.degrees(motion._data.joint("swing").qpos[0])
        self.assertAlmostEqual(motion.signals()["roll_angle_deg"] + swing, -leans, delta=0.3)


class Drawing(unittest.TestCase):
    def test_is_the_same_for_the_same_seed_and_within_its_ends(self):
        for number in range(6):
            one, again, other = commonroad.draw(SEED, number), commonroad.draw(SEED, number), commonroad.draw(SEED + 1, number)
            self.assertEqual((one.kind, one.drawn, vars(one.parameters)["m_s"]), (again.kind, again.drawn, again.parameters.m_s))
            self.assertNotEqual(one.drawn, other.drawn)
            for name, (low, high) in (commonroad.FACTORS | commonroad.DRAWN | commonroad.CLASSES[one.kind]).items():
                self.assertTrue(low <= one.drawn[name] <= high, name)
        self.assertEqual([commonroad.draw(SEED, number).kind for number in range(4)], ["van", "SUV", "pick-up", "van"])

    def test_every_fourth_round_is_gentle(self):
        plans = manoeuvres.plans(SEED, commonroad.draw(SEED, 0), 4)
        self.assertEqual([plan.kind for plan in plans[:4]], list(manoeuvres.KINDS))
        self.assertTrue(all(abs(plan.amplitude) >= manoeuvres.AMPLITUDES[0] for plan in plans[:12]))
        self.assertTrue(all(abs(plan.amplitude) <= manoeuvres.GENTLE_AMPLITUDES[1] for plan in plans[12:]))

    def test_the_handwheel_keeps_its_rate_and_holds(self):
        course = manoeuvres.corners([(50.0, 0.25), (-50.0, 1.0)], 500.0)
        for time_s, angle_deg in ((0.5, 0.0), (1.05, 25.0), (1.2, 50.0), (1.45, 0.0), (2.0, -50.0), (9.0, -50.0)):
            self.assertAlmostEqual(manoeuvres.at(course, time_s), angle_deg)

    def test_noise_is_that_which_is_stated(self):
        rows = [(0.01 * cycle, *[0.0] * 11) for cycle in range(4000)]
        noisy = manoeuvres.noisy(rows, "a name")
        self.assertEqual(noisy, manoeuvres.noisy(rows, "a name"))
        self.assertNotEqual(noisy, manoeuvres.noisy(rows, "another"))
        for name, deviation in manoeuvres.NOISE.items():
            self.assertAlmostEqual(statistics.pstdev(column(noisy, name)) / deviation, 1.0, delta=0.05)
        for name in ("time_s", *manoeuvres.LOADS):
            self.assertEqual(column(noisy, name), column(rows, name))

    def test_errors_change_height_and_stiffness_alone(self):
        calibration = {"sprung_cg_height_m": 1.0, ways.TYRE_LIMIT: 8.0, **dict.fromkeys(ways.STIFFNESSES, 100.0)}
        changes = ways.changes(calibration, SEED, "000")
        self.assertEqual(changes[ways.CLEAN], {})
        self.assertEqual(changes[ways.CLEAN_OPEN], {ways.TYRE_LIMIT: 8.0 * ways.OPEN_LIMIT})
        errors = changes[ways.ERRORS]
        self.assertEqual(set(errors), {"sprung_cg_height_m", *ways.STIFFNESSES})
        self.assertEqual(len({errors[key] for key in ways.STIFFNESSES}), 1)
        self.assertNotEqual(errors, ways.changes(calibration, SEED, "001")[ways.ERRORS])
        drawn = [ways.changes(calibration, SEED, str(number))[ways.ERRORS] for number in range(200)]
        for key, right, off in (("sprung_cg_height_m", 1.0, 0.05), ("roll_stiffness_nmprad", 100.0, 10.0)):
            values = [each[key] for each in drawn]
            self.assertLess(right - off, min(values))
            self.assertLess(min(values), right - 0.9 * off)
            self.assertLess(max(values), right + off)
            self.assertLess(right + 0.9 * off, max(values))


class Sample(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.results = [study.of_vehicle(PROGRAM, cls.folder, SEED, 1, ("commonroad", number)) for number in range(2)]
        cls.jointed = study.of_vehicle(PROGRAM, cls.folder, SEED, 1, ("jointed", JOINTED))

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_the_judge_finds_these_lift_offs_and_warnings(self):
        clean = [each for result in self.results for each in result.outcomes[ways.CLEAN]]
        self.assertEqual([each.manoeuvre for each in clean], [*manoeuvres.KINDS] * 2)
        self.assertEqual([each.lift_s is not None for each in clean], LIFTED)
        for way, counts in WARNED.items():
            found = report.detection([each for result in self.results for each in result.outcomes[way]])
            self.assertEqual((found.warned.count, found.warned_100ms.count, found.warned_200ms.count), counts, way)
            self.assertEqual([(share.count, share.total) for share in found.alarms.values()], ALARMS, way)

    def test_the_ramp_ends_where_its_driver_has_enough(self):
        with open(self.folder / "000/ramp.csv", encoding="utf-8", newline="") as file:
            last = list(csv.DictReader(file))[-1]
        loads = [float(last[name]) for name in manoeuvres.LOADS]
        self.assertAlmostEqual((loads[1] + loads[3] - loads[0] - loads[2]) / sum(loads), manoeuvres.RAMP_STOP, delta=0.01)

    def test_the_calibration_is_that_of_the_drawn_vehicle(self):
        for number in range(2):
            vehicle = commonroad.draw(SEED, number)
            p = vehicle.parameters
            found = study.tomllib.loads((self.folder / vehicle.name / "calibration/calibration.toml").read_text(encoding="utf-8"))
            height = (found["sprung_mass_kg"] * found["sprung_cg_height_m"]
                      + found["unsprung_mass_kg"] * found["unsprung_cg_height_m"]) / p.m
            self.assertAlmostEqual(found["track_width_m"] / 2.0 / height / vehicle.static_stability_factor(), 1.0, delta=0.005)
            # Springs and anti-roll bars of both axles, each behind its tyres.
            stiffness = sum(1.0 / (1.0 / (spring * track**2 / 2.0 - bar) + 2.0 / (p.K_zt * track**2))
                            for spring, bar, track in ((p.K_sf, p.K_tsf, p.T_f), (p.K_sr, p.K_tsr, p.T_r)))
            self.assertAlmostEqual(found["roll_stiffness_nmprad"] / stiffness, 1.0, delta=0.15)

    def warnings(self, rows, name):
        folder = self.folder / name
        drive = self.folder / f"{name}.csv"
        drive.write_text(manoeuvres.csv_text(rows), encoding="utf-8")
        study.run(PROGRAM, "replay", drive, "--parameters", self.folder / "000/calibration/calibration.toml", "--output", folder,
                  "--no-pictures")
        with open(folder / name / "warnings.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def test_a_mirrored_drive_gives_the_mirrored_warning(self):
        rows = step_steer(commonroad.draw(SEED, 0), 70.0, 3.0)
        one, other = self.warnings(rows, "left_turn"), self.warnings(manoeuvres.mirrored(rows), "right_turn")
        self.assertIn("right", [row["side"] for row in one])
        swapped = {"left": "right", "right": "left"}
        self.assertEqual([row | {"side": swapped.get(row["side"], row["side"])} for row in one], other)

    def test_a_wrong_sign_is_refused(self):
        folder = self.folder / "wrong"
        shutil.copytree(self.folder / "000", folder)
        ramp = manoeuvres.ramp(commonroad.draw(SEED, 0))
        place = manoeuvres.COLUMNS.index("yaw_rate_degps")
        wrong = [(*row[:place], -row[place], *row[place + 1:]) for row in ramp]
        (folder / "ramp.csv").write_text(manoeuvres.csv_text(wrong), encoding="utf-8")
        with self.assertRaisesRegex(study.Refused, "yaw rate have opposite signs"):
            study.identify(PROGRAM, folder)

    def test_the_judge_finds_those_of_a_jointed_vehicle(self):
        outcomes = self.jointed.outcomes
        self.assertEqual([each.lift_s is not None for each in outcomes[ways.CLEAN]], JOINTED_LIFTED)
        for way, counts in JOINTED_WARNED.items():
            found = report.detection(outcomes[way])
            self.assertEqual((found.warned.count, found.warned_100ms.count, found.warned_200ms.count), counts, way)
            self.assertEqual([(share.count, share.total) for share in found.alarms.values()], JOINTED_ALARMS, way)

    def test_its_quantities_are_those_it_was_drawn_with(self):
        vehicle, found = jointed.draw(SEED, JOINTED), self.jointed.quantities
        self.assertEqual(set(found), {name for name, _ in quantities.NAMES})
        self.assertEqual(found["static stability factor"], vehicle.static_stability_factor())
        self.assertTrue(0.75 < found["rollover threshold"] / found["static stability factor"] < 1.0)
        self.assertAlmostEqual(found["grip over threshold"] * found["rollover threshold"], vehicle.grip())
        # Tyres, and what hangs on the body, give way besides the suspension.
        self.assertTrue(0.9 < found["roll gradient"] / vehicle.drawn["roll_gradient_degpg"] < 2.0)
        self.assertAlmostEqual(found["understeer gradient"], 1e3 * vehicle.drawn["understeer_s2pm"], delta=1.0)
        self.assertTrue(0.05 < found["its lag"] < 0.9)

    def test_a_roll_inertia_by_the_rule_of_thumb_is_counted(self):
        with tempfile.TemporaryDirectory() as scratch:
            study.write_drives(jointed.draw(SEED, JOINTED_WITHOUT_INERTIA), SEED, 0, pathlib.Path(scratch))
            study.identify(PROGRAM, pathlib.Path(scratch))
            self.assertIn(study.ASSUMED_INERTIA, pathlib.Path(scratch, "calibration/calibration.toml").read_text(encoding="utf-8"))
        self.assertFalse(self.jointed.inertia_assumed)
        assumed = self.jointed._replace(inertia_assumed=True)
        self.assertIn("that a body can have: 1 of swing arms.", report.page([*self.results, assumed], SEED))

    def test_the_population_s_page_has_the_quantities(self):
        names = {name for name, _ in quantities.NAMES} - {quantities.TRUE_OVER_COMPUTED}
        self.assertEqual(set(quantities.of_population()), names)
        with tempfile.NamedTemporaryFile("w", suffix=".md") as page:
            page.write("| roll gradient | deg/g | 1 | 2 | 3 | 4 | 5 |\n")
            page.flush()
            with self.assertRaisesRegex(LookupError, "no row of vehicles named static stability factor, "):
                quantities.of_population(pathlib.Path(page.name))

    def test_the_data_has_a_line_for_each_vehicle(self):
        results = [*self.results, self.jointed]
        rows = list(csv.DictReader(quantities.data(results).splitlines()))
        self.assertEqual([(row["vehicle"], row["family"], row["class"]) for row in rows],
                         [("000", "commonroad", "van"), ("001", "commonroad", "SUV"), ("j10", "jointed", jointed.SWING_ARMS)])
        for row, result in zip(rows, results):
            self.assertAlmostEqual(float(row["rollover threshold"]), result.quantities["rollover threshold"], places=4)
        drawn = jointed.draw(SEED, JOINTED).drawn
        self.assertAlmostEqual(float(rows[2]["mass"]), drawn["mass_kg"], delta=0.01)
        self.assertAlmostEqual(float(rows[2]["relaxation length"]), drawn["relaxation_m"], places=4)
        self.assertAlmostEqual(float(rows[2]["CG height"]) * 2.0 * float(rows[2]["static stability factor"]), drawn["track_width_m"],
                               places=4)
        self.assertTrue(drawn["roll_inertia_over_track"] < float(rows[2]["roll radius of gyration over track"]) < 0.5)
        self.assertEqual(rows[0]["relaxation length"], "")

    def test_the_page_counts_the_runs(self):
        page = report.page([*self.results, self.jointed], SEED)
        for family, lifted in (("commonroad", LIFTED), ("jointed", JOINTED_LIFTED), ("both", LIFTED + JOINTED_LIFTED)):
            row = next(line for line in page.splitlines() if line.startswith(f"| {family} | clean | "))
            self.assertEqual(row.split(" | ")[2], str(sum(lifted)))
        self.assertIn("counting runs.", page)
        low, high = quantities.of_population()["roll frequency"]
        row = next(line for line in page.splitlines() if line.startswith("| roll frequency | Hz | "))
        outside = [not low <= result.quantities["roll frequency"] <= high for result in (*self.results, self.jointed)]
        self.assertEqual(row.strip("| ").split(" | ")[4::2], [str(sum(outside[:2])), str(sum(outside[2:]))])
        left_out = self.results[0]._replace(outcomes=self.results[0].outcomes | {ways.ERRORS: None})
        self.assertIn("does not admit their calibration: 1 with errors.",
                      report.page([left_out, self.results[1], self.jointed], SEED))


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    judge.use(PROGRAM)
    unittest.main()
