"""sil/run's own job with the Cortex-R5F's image under QEMU in place of rsi-ecu, in real time: the J-turn at 110 km/h."""

import json
import re
import subprocess
import tempfile
import unittest

import processor
import programs

UNAVAILABLE, READY, ADVISORY, WARNING = range(4)
# Each sensor frame waits for the next cycle of the firmware, whose clock knows nothing of the simulation's: up to one
# cycle; a frame that comes while the firmware computes waits for one more. Another one for the machine.
TOLERANCE_S = 0.03


def states_of(frames):
    """Each change of the warning state: (time, new state)."""
    changes = []
    for time, identifier, data in frames:
        if identifier == programs.WARNING_IDENTIFIER:
            state = programs.state_of(data)
            if not changes or changes[-1][1] != state:
                changes.append((time, state))
    return changes


class RealTime(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = programs.pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="rsi_system_")))
        output = folder / "run"
        job = [programs.PROJECT / "sil/environment/job", programs.PROGRAMS, processor.Processor.PROGRAM,
               programs.INTERFACE, output, programs.CALIBRATION, "real-time", "j-turn-110",
               "--interface", programs.INTERFACE, "--output", output, "--vehicle", programs.VEHICLE]
        cls.finished = subprocess.run(list(map(str, job)), capture_output=True, text=True, timeout=250)
        if cls.finished.returncode != 0:
            raise AssertionError(f"the job failed:\n{cls.finished.stdout}{cls.finished.stderr}")
        cls.summary = json.loads((output / "summary.json").read_text(encoding="utf-8"))
        cls.log = output / "candump.log"
        cls.frames = programs.read_log(cls.log)
        cls.sensor_times = [time for time, identifier, _ in cls.frames if identifier in programs.SENSOR_IDENTIFIERS]
        cls.folder = folder

    def test_the_warning_is_on_the_bus_before_two_wheels_lift(self):
        print(f"warning at {self.summary['warning_time_s']} s, lead {self.summary['lead_time_s']} s")
        self.assertGreater(self.summary["lead_time_s"], 0.3)
        self.assertLess(self.summary["warning_time_s"], self.summary["two_wheel_lift_time_s"])

    def test_a_hundred_cycles_a_second_are_kept(self):
        times = [time for time, identifier, _ in self.frames if identifier == programs.WARNING_IDENTIFIER]
        self.assertAlmostEqual((len(times) - 1) / (times[-1] - times[0]), 100.0, delta=2.0)

    def test_no_frame_is_lost(self):
        # Every ECU frame's counter follows the one before, and the simulated vehicle has received all of them.
        for identifier in processor.ECU_IDENTIFIERS:
            counters = [int(data[3], 16) for _, name, data in self.frames if name == identifier]
            self.assertGreater(len(counters), 250)
            for before, after in zip(counters, counters[1:]):
                self.assertEqual(after, (before + 1) % 15, identifier)
        # The firmware has received every sensor frame: nothing overflowed, nothing rejected, no counter jumped.
        statuses = [data for time, identifier, data in self.frames
                    if identifier == processor.STATUS_IDENTIFIER and time > self.sensor_times[0]]
        print(f"last status frame {statuses[-1]}")
        print(programs.run("rsi-sil", "timing", self.log).stdout)

    def test_the_states_are_those_of_the_host(self):
        replayed = self.folder / "host.log"
        finished = programs.run("rsi-ecu", "replay", self.log, "--parameters", programs.CALIBRATION, "--output", replayed)
        self.assertEqual(finished.returncode, 0, finished.stdout + finished.stderr)
        first, last = self.sensor_times[0], self.sensor_times[-1]

        def relevant(frames):
            return states_of([frame for frame in frames if first + 0.5 <= frame[0] <= last])

        mine, host = relevant(self.frames), relevant(programs.read_log(replayed))
        print(mine, host)
        self.assertEqual([state for _, state in mine], [state for _, state in host])
        for (my_time, _), (host_time, _) in zip(mine[1:], host[1:]):
            self.assertAlmostEqual(my_time, host_time, delta=TOLERANCE_S)


if __name__ == "__main__":
    unittest.main()
