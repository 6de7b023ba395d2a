"""Real time over a CAN interface: a warning frame in each of 100 cycles a second, and "unavailable" when the sensors fall silent."""

import statistics
import tempfile
import unittest

import programs

UNAVAILABLE, READY = 0, 1


class RealTime(unittest.TestCase):
    """One run of three seconds, recorded by candump, that all tests look at."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="rsi_system_")
        cls.addClassCleanup(cls.folder.cleanup)
        folder = programs.pathlib.Path(cls.folder.name)
        cls.log = folder / "candump.log"
        with programs.Candump(cls.log) as candump, programs.Ecu() as ecu:
            cls.finished = programs.run_manoeuvre("straight", folder / "run", "--duration", "3")
            cls.frames = candump.stop()
            cls.exit_status = ecu.stop()
            cls.ecu_output = ecu.output
        cls.warnings = [frame for frame in cls.frames if frame[1] == programs.WARNING_IDENTIFIER]
        sensor_times = [frame[0] for frame in cls.frames if frame[1] in programs.SENSOR_IDENTIFIERS]
        cls.first_sensor_time, cls.last_sensor_time = sensor_times[0], sensor_times[-1]

    def test_the_programs_end_well(self):
        self.assertEqual(self.finished.returncode, 0, self.finished.stderr)
        self.assertEqual(self.exit_status, 0, self.ecu_output)
        self.assertIn("cycles", self.ecu_output)

    def test_there_are_100_cycles_a_second_kept_or_counted_as_missed(self):
        cycles = programs.Cycles(self.frames)
        print(cycles)
        self.assertGreater(cycles.periods, 250.0)
        self.assertAlmostEqual(cycles.kept + cycles.missed, cycles.periods, delta=5.0)

    def test_each_cycle_has_its_warning_frame(self):
        statuses = [frame for frame in self.frames if frame[1] == programs.STATUS_IDENTIFIER]
        self.assertAlmostEqual(len(self.warnings), len(statuses), delta=1)
        self.assertGreater(len(self.warnings), 200)

    def test_the_ecu_is_ready_while_sensors_report(self):
        states = [
            programs.state_of(data)
            for time, _, data in self.warnings
            if self.first_sensor_time + 0.5 < time < self.last_sensor_time
        ]
        self.assertGreater(len(states), 200)
        ready = sum(state == READY for state in states)
        # A virtual machine may be held up for longer than the sensors' time limit; that must stay rare.
        self.assertGreater(ready / len(states), 0.9)

    def test_the_ecu_is_unavailable_soon_after_the_last_sensor_frame_and_stays_so(self):
        states = [programs.state_of(data) for time, _, data in self.warnings if time > self.last_sensor_time]
        self.assertGreater(len(states), 10)
        # Frames older than 35 ms do not count, so at most four cycles of 10 ms can still use the last one.
        self.assertEqual(set(states[4:]), {UNAVAILABLE})

    def test_no_warning_before_the_first_sensor_frame_says_anything_but_unavailable(self):
        states = {programs.state_of(data) for time, _, data in self.warnings if time < self.first_sensor_time}
        self.assertLessEqual(states, {UNAVAILABLE})

    def reactions_ms(self):
        """From the last sensor frame to the warning frame that follows it, once per group of sensor frames."""
        reactions, last_sensor = [], None
        for time, identifier, _ in self.frames:
            if identifier in programs.SENSOR_IDENTIFIERS:
                last_sensor = time
            elif identifier == programs.WARNING_IDENTIFIER and last_sensor is not None:
                reactions.append(1000.0 * (time - last_sensor))
                last_sensor = None
        return reactions

    def test_the_ecu_reacts_within_two_cycles_as_a_rule(self):
        # The ECU's cycle of 10 ms does not follow the world's: up to 10 ms by design. The median, and 10 ms more,
        # because a virtual machine may hold up single cycles for any time.
        self.assertLessEqual(statistics.median(self.reactions_ms()), 20.0)

    def test_the_timing_command_agrees_with_the_log(self):
        finished = programs.run("rsi-sil", "timing", self.log)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        self.assertIn(f"{len(self.warnings)} in", finished.stdout)
        reactions = self.reactions_ms()
        line = next(line for line in finished.stdout.splitlines() if "sensor frame to warning frame" in line)
        self.assertIn(f"largest {max(reactions):.3f} ms", line)
        print(finished.stdout)


if __name__ == "__main__":
    unittest.main()
