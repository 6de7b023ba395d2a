"""ECU and vehicle together in FMPy: what `rsi-sil run` shows, cycle by cycle, and what the example prints."""

import csv
import math
import subprocess
import sys

import support


def states_of(rows):
    return [(int(row["ecu_state_number"]), int(row["ecu_side_number"])) for row in rows]


class CoSimulation(support.WithFmus):
    def together(self, version, cycles, **parameters):
        """State and side of every cycle, what the sensors told in it, and when two wheels had lifted."""
        vehicle = self.instance("vehicle", version).started(manoeuvre="j-turn-110", **parameters)
        ecu = self.instance("ecu", version).started()
        signals = ecu.of.names("input")
        states, told = [], []
        for number in range(cycles):
            told.append(vehicle.numbers(signals))
            ecu.set_numbers(signals, told[-1])
            ecu.step(number)
            vehicle.step(number)
            states.append((ecu.get("state"), ecu.get("side")))
        return states, [dict(zip(signals, row)) for row in told], vehicle.get("true.two_wheel_lift_time_s")

    def compared(self, options=(), **parameters):
        summary, folder = self.run_of(*options)
        with (folder / "signals.csv").open(encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        for version in support.VERSIONS:
            with self.subTest(version=version):
                states, told, lift_s = self.together(version, len(rows), **parameters)
                both = enumerate(zip(states, states_of(rows)))
                different = [(number, ours, theirs) for number, (ours, theirs) in both if ours != theirs]
                self.assertEqual(different[:1], [])
                warning_s = states.index(next(state for state in states if state[0] == 3)) * support.STEP_S
                self.assertAlmostEqual(warning_s, summary["warning_time_s"], delta=1e-9)
                self.assertAlmostEqual(lift_s, summary["two_wheel_lift_time_s"], delta=1e-9)
                self.assertAlmostEqual(lift_s - warning_s, summary["lead_time_s"], delta=1e-9)
                for ours, theirs in zip(told, rows):
                    self.assertAlmostEqual(ours["lateral_specific_force_mps2"], float(theirs["sensor_lateral_acceleration_mps2"]),
                                           delta=1e-5)
                    self.assertAlmostEqual(math.degrees(ours["roll_angle_rad"]), float(theirs["sensor_roll_angle_deg"]),
                                           delta=1e-5)

    def test_every_cycle_says_what_rsi_sil_says(self):
        self.compared()

    def test_mirrored_with_noise(self):
        self.compared(("--mirror", "--noise", "--seed", "7"), mirrored=True, sensors__noise=True, sensors__seed=7)

    def test_driven_by_its_inputs(self):
        for version in support.VERSIONS:
            vehicle = self.instance("vehicle", version).started(initial_speed_mps=30.0)
            for number in range(150):
                vehicle.set_numbers(["driver.steering_wheel_angle_rad"], [0.0 if number < 20 else 2.0])
                vehicle.step(number)
            self.assertAlmostEqual(vehicle.get("steering_wheel_angle_rad"), 2.0, delta=1e-6)
            self.assertAlmostEqual(vehicle.get("speed_mps"), 30.0, delta=1.5)
            self.assertGreater(vehicle.get("true.load_transfer_ratio"), 0.3)
            before = vehicle.get("speed_mps")
            vehicle.set_numbers(["driver.steering_wheel_angle_rad", "driver.brake"], [0.0, 1.0])
            for number in range(150, 200):
                vehicle.step(number)
            self.assertLess(vehicle.get("speed_mps"), before - 2.0)

    def test_a_parameter_of_the_vehicle_matters(self):
        heavy = self.instance("vehicle", 3).started(manoeuvre="j-turn-110", mass__sprung_kg=3000.0)
        light = self.instance("vehicle", 3).started(manoeuvre="j-turn-110")
        load = "true.wheel_load_front_left_n"
        self.assertAlmostEqual(sum(heavy.numbers([load])) / sum(light.numbers([load])), 1.4, delta=0.2)

    def test_a_step_of_many_cycles_is_as_many_steps(self):
        for version in support.VERSIONS:
            one, many = (self.instance("vehicle", version).started(manoeuvre="fishhook-1b") for _ in range(2))
            for number in range(40):
                one.step(number)
            for number in range(0, 40, 5):
                many.step(number, 5 * support.STEP_S)
            self.assertEqual(one.bits(), many.bits())

    def test_steps_shorter_than_a_cycle_hold_the_outputs(self):
        for version in support.VERSIONS:
            with self.subTest(version=version):
                whole, parts = (self.instance("vehicle", version).started(manoeuvre="j-turn-110") for _ in range(2))
                ecu, other = (self.instance("ecu", version).started() for _ in range(2))
                signals = ecu.of.names("input")
                changed = 0
                for number in range(60):
                    ecu.set_numbers(signals, whole.numbers(signals))
                    before = other.bits()
                    ecu.step(number)
                    whole.step(number)
                    for part in range(10):
                        self.assertEqual(other.bits(), before)
                        other.set_numbers(signals, parts.numbers(signals) if part == 0 else [math.nan] * len(signals))
                        for each in (other, parts):
                            each.step(number + 0.1 * part, 0.1 * support.STEP_S)
                    self.assertEqual((other.bits(), parts.bits()), (ecu.bits(), whole.bits()))
                    changed += other.bits() != before
                self.assertGreater(changed, 30)

    def test_steps_of_any_length_are_as_many_cycles_as_they_pass(self):
        for version in support.VERSIONS:
            whole, odd = (self.instance("vehicle", version).started(manoeuvre="fishhook-1b") for _ in range(2))
            for number in range(20):
                whole.step(number)
            for number in range(28):
                odd.step(0.7 * number, 0.7 * support.STEP_S)
            odd.step(19.6, 0.4 * support.STEP_S)
            self.assertEqual(odd.bits(), whole.bits())
            self.assertAlmostEqual(odd.get("time"), 0.2, delta=1e-9)

    def test_without_inputs_the_ecu_says_unavailable(self):
        for version in support.VERSIONS:
            ecu = self.instance("ecu", version).started()
            for number in range(20):
                ecu.step(number)
            self.assertEqual((ecu.get("state"), ecu.get("side")), (0, 0))
            self.assertTrue(math.isnan(ecu.get("lateral_acceleration_mps2")))

    def test_the_example(self):
        example = support.PROJECT / "docs/examples/co_simulation/together.py"
        said = subprocess.run([sys.executable, "-B", str(example), str(self.folder)], capture_output=True, text=True, check=True)
        lines = said.stdout.splitlines()
        self.assertIn("  1.34 s  ECU: warning, right side", lines)
        self.assertEqual(lines[-1], " 2.004 s  two wheels of one side have lifted")


if __name__ == "__main__":
    support.main()
