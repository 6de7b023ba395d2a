"""The study of vehicles of others' equations: its model, its drives, and what two of its vehicles give.

Use: sample_test.py RSI_SIL
"""

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
import judge
import manoeuvres
import report
import vehicle as vehicles
import ways

PROGRAM = ""
SEED = 1
GRAVITY = vehicles.GRAVITY_MPS2
# Drives of the two vehicles that lift two wheels; lift-offs warned of, 0.1 s and 0.2 s before; alarms of how many, by band.
LIFTED = [True, True, True, True, True, False, True, False]
WARNED = {ways.CLEAN: (6, 6, 6), ways.ERRORS: (6, 6, 5)}
ALARMS = [(0, 1), (0, 0), (0, 0), (1, 1)]


def column(rows, name):
    place = manoeuvres.COLUMNS.index(name)
    return [row[place] for row in rows]


def step_steer(vehicle, angle_deg, duration_s):
    course = manoeuvres.corners([(angle_deg, duration_s)], 500.0)
    return manoeuvres.drive(vehicle, 80.0, lambda time_s: manoeuvres.at(course, time_s), course[-1][0])


class Model(unittest.TestCase):
    def setUp(self):
        self.vehicle = vehicles.draw(SEED, 0)

    def test_a_vehicle_in_the_air_falls_freely(self):
        p = self.vehicle.parameters
        motion = vehicles.Motion(self.vehicle, 20.0)
        for height in (vehicles.FRONT_HEIGHT, vehicles.REAR_HEIGHT):
            motion.state[height] = -0.05  # z points down
        f = vehicles.derivative(p, motion.state, 0.0, 0.0)
        self.assertEqual(motion.wheel_loads_n(), [0.0] * 4)
        fall = (p.m_s * f[vehicles.VERTICAL_SPEED] + p.m_uf * f[17] + p.m_ur * f[22]) / p.m
        self.assertAlmostEqual(fall, GRAVITY, places=9)

    def test_a_lifted_wheel_does_not_turn_its_axle(self):
        p, rates = self.vehicle.parameters, []
        for tyre in (p.K_zt, 2.0 * p.K_zt):  # the left front wheel is above the road, the right one touches it just not
            p.K_zt = tyre
            state = vehicles.Motion(self.vehicle, 20.0).state
            state[vehicles.FRONT_ROLL], state[vehicles.FRONT_HEIGHT] = 0.1, -0.5 * p.T_f * math.sin(0.1) - 0.001
            state[vehicles.HEIGHT], state[vehicles.PITCH] = 0.0, 0.0
            state[vehicles.REAR_HEIGHT] = 0.0
            self.assertTrue(all(load <= 0.0 for load in vehicles._wheel_loads_n(p, state)))
            f = vehicles.derivative(p, state, 0.0, 0.0)
            rates.append((f[vehicles.FRONT_ROLL + 1], f[vehicles.FRONT_HEIGHT + 1]))
        self.assertAlmostEqual(rates[0][0], rates[1][0], places=6)
        self.assertAlmostEqual(rates[0][1], rates[1][1], places=6)

    def test_it_stands_on_its_wheels(self):
        motion = vehicles.Motion(self.vehicle, 20.0)
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
        step, vehicles.STEP_S = vehicles.STEP_S, 0.5 * vehicles.STEP_S
        try:
            finer = step_steer(self.vehicle, 40.0, 1.5)
        finally:
            vehicles.STEP_S = step
        self.assertEqual(len(rows), len(finer))
        self.assertAlmostEqual(rows[-1][4], finer[-1][4], delta=0.02)  # deg of roll
        self.assertAlmostEqual(rows[-1][-1], finer[-1][-1], delta=20.0)  # N


class Drawing(unittest.TestCase):
    def test_is_the_same_for_the_same_seed_and_within_its_ends(self):
        for number in range(6):
            one, again, other = vehicles.draw(SEED, number), vehicles.draw(SEED, number), vehicles.draw(SEED + 1, number)
            self.assertEqual((one.kind, one.drawn, vars(one.parameters)["m_s"]), (again.kind, again.drawn, again.parameters.m_s))
            self.assertNotEqual(one.drawn, other.drawn)
            for name, (low, high) in (vehicles.FACTORS | vehicles.DRAWN | vehicles.CLASSES[one.kind]).items():
                self.assertTrue(low <= one.drawn[name] <= high, name)
        self.assertEqual([vehicles.draw(SEED, number).kind for number in range(4)], ["van", "SUV", "pick-up", "van"])

    def test_every_fourth_round_is_gentle(self):
        plans = manoeuvres.plans(SEED, vehicles.draw(SEED, 0), 4)
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
        cls.results = [study.of_vehicle(PROGRAM, cls.folder, SEED, 1, number) for number in range(2)]

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
            vehicle = vehicles.draw(SEED, number)
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
        rows = step_steer(vehicles.draw(SEED, 0), 70.0, 3.0)
        one, other = self.warnings(rows, "left_turn"), self.warnings(manoeuvres.mirrored(rows), "right_turn")
        self.assertIn("right", [row["side"] for row in one])
        swapped = {"left": "right", "right": "left"}
        self.assertEqual([row | {"side": swapped.get(row["side"], row["side"])} for row in one], other)

    def test_a_wrong_sign_is_refused(self):
        folder = self.folder / "wrong"
        shutil.copytree(self.folder / "000", folder)
        ramp = manoeuvres.ramp(vehicles.draw(SEED, 0))
        place = manoeuvres.COLUMNS.index("yaw_rate_degps")
        wrong = [(*row[:place], -row[place], *row[place + 1:]) for row in ramp]
        (folder / "ramp.csv").write_text(manoeuvres.csv_text(wrong), encoding="utf-8")
        with self.assertRaisesRegex(study.Refused, "yaw rate have opposite signs"):
            study.identify(PROGRAM, folder)

    def test_the_page_counts_the_runs(self):
        page = report.page(self.results, SEED)
        row = next(line for line in page.splitlines() if line.startswith("| clean | "))
        self.assertEqual(row.split(" | ")[1], str(sum(LIFTED)))
        self.assertIn("counting runs.", page)
        left_out = self.results[0]._replace(outcomes=self.results[0].outcomes | {ways.ERRORS: None})
        self.assertIn("does not admit their calibration: 1 with errors.",
                      report.page([left_out, self.results[1]], SEED))


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    judge.use(PROGRAM)
    unittest.main()
