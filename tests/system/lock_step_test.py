"""Lock-step over a CAN interface: the same run gives the same bytes, and the log is what was on the bus."""

import tempfile
import unittest

import programs


class LockStep(unittest.TestCase):
    """The runs are made once: where the interface needs an emulator, each start of a program takes seconds."""

    @classmethod
    def setUpClass(cls):
        cls.folder = programs.pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="rsi_system_")))
        with programs.Candump(cls.folder / "outside.log") as candump, programs.Ecu("--lock-step"):
            cls.first = cls.drive("first")
            cls.received = candump.stop()
            cls.against_the_same_ecu = cls.drive("again")
        with programs.Ecu("--lock-step") as ecu:
            cls.against_another_ecu = cls.drive("another_ecu")
            cls.exit_status = ecu.stop()
        with programs.Ecu("--lock-step"):
            cls.with_another_seed = cls.drive("another_seed", seed=6)

    @classmethod
    def drive(cls, name, seed=5):
        """One noisy second and a half of a turn; the bytes of the log that the run writes."""
        finished = programs.run_manoeuvre(
            "j-turn-110", cls.folder / name, "--lock-step", "--noise", "--seed", seed, "--duration", "1.5"
        )
        if finished.returncode != 0:
            raise AssertionError(finished.stdout + finished.stderr)
        return (cls.folder / name / "candump.log").read_bytes()

    def test_the_same_run_twice_gives_the_same_log_byte_for_byte(self):
        self.assertEqual(self.exit_status, 0)
        self.assertGreater(len(self.first), 1000)
        self.assertEqual(self.first, self.against_another_ecu)

    def test_a_run_in_process_gives_the_same_log_byte_for_byte(self):
        finished = programs.run(
            "rsi-sil", "run", "j-turn-110", "--in-process", "--parameters", programs.CALIBRATION, "--vehicle",
            programs.VEHICLE, "--output", self.folder / "in_process", "--noise", "--seed", 5, "--duration", "1.5",
        )
        self.assertEqual(finished.returncode, 0, finished.stdout + finished.stderr)
        written = (self.folder / "in_process" / "candump.log").read_bytes()
        interface = programs.INTERFACE.encode()
        self.assertEqual(self.first.replace(b" " + interface + b" ", b" vcan0 "), written)

    def test_another_seed_gives_another_log(self):
        self.assertNotEqual(self.first, self.with_another_seed)

    def test_a_second_run_against_the_same_ecu_is_a_new_run(self):
        self.assertEqual(self.first, self.against_the_same_ecu)

    def test_the_log_is_what_candump_hears(self):
        logged = programs.read_log(self.folder / "first" / "candump.log")
        self.assertEqual(len(logged), 151 * 12)
        self.assertEqual([frame[1:] for frame in logged], [frame[1:] for frame in self.received])

    def test_the_log_bears_simulated_time(self):
        logged = programs.read_log(self.folder / "first" / "candump.log")
        for index, (seconds, _, _) in enumerate(logged):
            self.assertAlmostEqual(seconds, (index // 12) * 0.01, places=6)

    def test_a_run_without_an_ecu_says_so(self):
        finished = programs.run_manoeuvre("straight", self.folder / "run", "--lock-step", "--duration", "1")
        self.assertEqual(finished.returncode, 1)
        self.assertIn("no answer from the ECU", finished.stderr)
        self.assertIn("rsi-ecu --lock-step", finished.stderr)


if __name__ == "__main__":
    unittest.main()
