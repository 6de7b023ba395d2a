"""The Cortex-R5F's image under QEMU in lock-step on a CAN interface: the same bytes as the host's firmware."""

import tempfile
import unittest

import processor
import programs


class LockStep(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.ecu = cls.enterClassContext(processor.Processor("--lock-step", "--parameters", programs.CALIBRATION))

    def test_a_simulated_manoeuvre_gives_the_log_of_the_host_byte_for_byte(self):
        with tempfile.TemporaryDirectory(prefix="rsi_system_") as folder:
            logs = []
            for name, program_options in (
                ("processor", ("--interface", programs.INTERFACE, "--lock-step")),
                ("host", ("--in-process", "--parameters", programs.CALIBRATION)),
            ):
                output = programs.pathlib.Path(folder) / name
                finished = programs.run(
                    "rsi-sil", "run", "j-turn-110", "--vehicle", programs.VEHICLE, "--output", output, "--noise",
                    "--seed", 5, "--duration", 2, *program_options,
                )
                self.assertEqual(finished.returncode, 0, finished.stdout + finished.stderr)
                logs.append((output / "candump.log").read_text(encoding="ascii"))
            self.assertGreater(len(logs[0].splitlines()), 2000)
            self.assertEqual(logs[0].replace(f" {programs.INTERFACE} ", " vcan0 "), logs[1])


if __name__ == "__main__":
    unittest.main()
