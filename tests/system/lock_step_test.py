"""Lock-step over a CAN interface: the same run gives the same bytes, and the log is what was on the bus."""

import tempfile
import unittest

import programs


class LockStep(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="rsi_system_")
        self.addCleanup(self.folder.cleanup)

    def output(self, name):
        return programs.pathlib.Path(self.folder.name) / name

    def drive(self, name, seed=5):
        """One noisy second and a half of a turn; the bytes of the log that the run writes."""
        finished = programs.run_manoeuvre(
            "j-turn-110", self.output(name), "--lock-step", "--noise", "--seed", seed, "--duration", "1.5"
        )
        self.assertEqual(finished.returncode, 0, finished.stdout + finished.stderr)
        return (self.output(name) / "candump.log").read_bytes()

    def test_the_same_run_twice_gives_the_same_log_byte_for_byte(self):
        logs = []
        for name in ("first", "second"):
            with programs.Ecu("--lock-step") as ecu:
                logs.append(self.drive(name))
                self.assertEqual(ecu.stop(), 0, ecu.output)
        self.assertGreater(len(logs[0]), 1000)
        self.assertEqual(logs[0], logs[1])

    def test_a_run_in_process_gives_the_same_log_byte_for_byte(self):
        with programs.Ecu("--lock-step"):
            log = self.drive("lock_step")
        finished = programs.run(
            "rsi-sil", "run", "j-turn-110", "--in-process", "--parameters", programs.CALIBRATION, "--vehicle",
            programs.VEHICLE, "--output", self.output("in_process"), "--noise", "--seed", 5, "--duration", "1.5",
        )
        self.assertEqual(finished.returncode, 0, finished.stdout + finished.stderr)
        written = (self.output("in_process") / "candump.log").read_bytes()
        interface = programs.INTERFACE.encode()
        self.assertEqual(log.replace(b" " + interface + b" ", b" vcan0 "), written)

    def test_another_seed_gives_another_log(self):
        logs = []
        for name, seed in (("first", 5), ("second", 6)):
            with programs.Ecu("--lock-step"):
                logs.append(self.drive(name, seed))
        self.assertNotEqual(logs[0], logs[1])

    def test_a_second_run_against_the_same_ecu_is_a_new_run(self):
        with programs.Ecu("--lock-step"):
            first = self.drive("first")
            second = self.drive("second")
        self.assertEqual(first, second)

    def test_the_log_is_what_candump_hears(self):
        with programs.Candump(self.output("outside.log")) as candump, programs.Ecu("--lock-step"):
            self.drive("run")
            received = candump.stop()
        logged = programs.read_log(self.output("run") / "candump.log")
        self.assertEqual(len(logged), 151 * 12)
        self.assertEqual([frame[1:] for frame in logged], [frame[1:] for frame in received])

    def test_the_log_bears_simulated_time(self):
        with programs.Ecu("--lock-step"):
            self.drive("run")
        logged = programs.read_log(self.output("run") / "candump.log")
        for index, (seconds, _, _) in enumerate(logged):
            self.assertAlmostEqual(seconds, (index // 12) * 0.01, places=6)

    def test_a_run_without_an_ecu_says_so(self):
        finished = programs.run_manoeuvre("straight", self.output("run"), "--lock-step", "--duration", "1")
        self.assertEqual(finished.returncode, 1)
        self.assertIn("no answer from the ECU", finished.stderr)
        self.assertIn("rsi-ecu --lock-step", finished.stderr)


if __name__ == "__main__":
    unittest.main()
