"""Real time over a CAN interface, as it is on every machine, however busy: late frames are reported, and nothing is lost.

real_time/real_time_pace_test.py shows the pace of an idle machine."""

import tempfile
import time
import unittest

import programs

UNAVAILABLE, READY = 0, 1
# A machine that stands still for longer than the ECU's watchdog waits ends the ECU; then there is no run to look at.
MOST_RUNS = 10
# Frames older than 35 ms do not count, so at most four cycles of 10 ms can still use the last one; on a busy machine
# also the cycle that was due before it, and one that had read it and was held up before it answered.
MOST_CYCLES_BEHIND = 6
WATCHDOG_EXPIRED = "the watchdog expired"


class Run:
    """Three seconds straight ahead, recorded by candump, and the ECU's silence thereafter."""

    def __init__(self, folder):
        self.log = folder / "candump.log"
        with programs.Candump(self.log) as candump, programs.Ecu() as ecu:
            self.finished = programs.run_manoeuvre("straight", folder / "run", "--duration", "3")
            self._wait_for_the_end(ecu)
            self.exit_status = ecu.stop()
            self.frames = candump.stop()
            self.ecu_output = ecu.output
        self.warnings = self.frames_of(programs.WARNING_IDENTIFIER)
        self.statuses = self.frames_of(programs.STATUS_IDENTIFIER)
        sensor_times = [frame[0] for frame in self.frames if frame[1] in programs.SENSOR_IDENTIFIERS]
        self.first_sensor_time, self.last_sensor_time = (sensor_times or [float("inf")])[0], (sensor_times or [0.0])[-1]

    def _wait_for_the_end(self, ecu):
        """Until some cycles without sensors are on the bus, or the ECU has ended."""
        deadline = time.monotonic() + programs.LONGEST_S
        while time.monotonic() < deadline and ecu.process.poll() is None:
            identifiers = [frame.split("#")[0][-3:] for frame in self.log.read_text(encoding="ascii").splitlines()]
            last = max((place for place, name in enumerate(identifiers) if name in programs.SENSOR_IDENTIFIERS), default=0)
            if identifiers[last:].count(programs.STATUS_IDENTIFIER) > 30:
                return
            time.sleep(0.1)

    def frames_of(self, wanted):
        return [frame for frame in self.frames if frame[1] == wanted]

    def ended_by_watchdog(self):
        return WATCHDOG_EXPIRED in self.ecu_output

    def was_ready(self):
        return any(programs.state_of(data) == READY for _, _, data in self.warnings)

    def states(self, condition):
        return [programs.state_of(data) for time, _, data in self.warnings if condition(time)]

    def states_with_sensors(self):
        """From half a second behind the first sensor frame to the last one."""
        return self.states(lambda time: self.first_sensor_time + 0.5 < time < self.last_sensor_time)

    def states_without_sensors(self):
        return self.states(lambda time: time > self.last_sensor_time)


class RealTime(unittest.TestCase):
    """One run that all tests look at: the first that is whole, and those before it, which their ECU's watchdog ended."""

    @classmethod
    def setUpClass(cls):
        cls.runs = []
        folder = programs.pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="rsi_system_")))
        for number in range(MOST_RUNS):
            (folder / str(number)).mkdir()
            cls.run_ = Run(folder / str(number))
            cls.runs.append(cls.run_)
            cls.cycles = programs.Cycles(cls.run_.frames)
            print(cls.cycles, flush=True)
            if not cls.run_.ended_by_watchdog() and cls.cycles.enough and cls.run_.was_ready():
                return

    def test_the_programs_end_well(self):
        self.assertEqual(self.run_.finished.returncode, 0, self.run_.finished.stderr)
        self.assertEqual(self.run_.exit_status, 0, self.run_.ecu_output)
        self.assertIn("cycles", self.run_.ecu_output)

    def test_an_ecu_that_its_watchdog_ends_says_so_and_is_unavailable_at_last(self):
        for run in filter(Run.ended_by_watchdog, self.runs):
            self.assertEqual(run.exit_status, 1, run.ecu_output)
            self.assertEqual(programs.state_of(run.warnings[-1][2]), UNAVAILABLE)

    def test_each_cycle_is_kept_or_counted_as_missed(self):
        self.assertTrue(self.cycles.enough, "the count of missed cycles ended before there were enough cycles")
        self.assertLess(abs(self.cycles.drift), 2.0)

    def test_each_cycle_has_its_warning_frame(self):
        self.assertAlmostEqual(len(self.run_.warnings), len(self.run_.statuses), delta=1)

    def test_no_frame_is_lost(self):
        for identifier in sorted({name for _, name, _ in self.run_.frames}):
            counters = [int(data[3], 16) for _, _, data in self.run_.frames_of(identifier)]
            for before, after in zip(counters, counters[1:]):
                self.assertEqual(after, (before + 1) % 15, identifier)

    def test_the_ecu_becomes_ready_and_says_why_whenever_it_is_not_any_more(self):
        self.assertIn(READY, self.run_.states_with_sensors())
        pairs = list(zip(self.run_.warnings, self.run_.statuses))
        for (_, _, before), ((_, _, after), (_, _, status)) in zip(self.run_.warnings, pairs[1:]):
            if programs.state_of(before) != UNAVAILABLE and programs.state_of(after) == UNAVAILABLE:
                self.assertNotEqual(programs.flags_of(status), set(), f"warning {after}, status {status}")

    def test_the_ecu_is_unavailable_soon_after_the_last_sensor_frame_and_stays_so(self):
        states = self.run_.states_without_sensors()
        self.assertGreater(len(states), 10)
        self.assertEqual(set(states[MOST_CYCLES_BEHIND:]), {UNAVAILABLE})

    def test_no_warning_before_the_first_sensor_frame_says_anything_but_unavailable(self):
        states = self.run_.states(lambda time: time < self.run_.first_sensor_time)
        self.assertLessEqual(set(states), {UNAVAILABLE})

    def test_the_timing_command_agrees_with_the_log(self):
        finished = programs.run("rsi-sil", "timing", self.run_.log)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        self.assertIn(f"{len(self.run_.warnings)} in", finished.stdout)
        line = next(line for line in finished.stdout.splitlines() if "sensor frame to warning frame" in line)
        self.assertIn(f"largest {max(programs.reactions_ms(self.run_.frames)):.3f} ms", line)
        print(finished.stdout)


if __name__ == "__main__":
    unittest.main()
