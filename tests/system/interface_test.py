"""Starting and ending on a CAN interface, and interfaces that are not there."""

import signal
import tempfile
import unittest

import programs


class Interface(unittest.TestCase):
    def test_rsi_ecu_ends_well_on_request_in_either_mode(self):
        for options in ((), ("--lock-step",)):
            for with_signal in (signal.SIGTERM, signal.SIGINT):
                with self.subTest(options=options, signal=with_signal), programs.Ecu(*options) as ecu:
                    self.assertEqual(ecu.stop(with_signal), 0, ecu.output)

    def test_rsi_ecu_goes_on_without_a_reader_of_its_messages_and_fails_at_the_end(self):
        with programs.Ecu() as ecu:
            ecu.process.stdout.close()
            ecu.process.stdout = None
            ecu.process.send_signal(signal.SIGTERM)
            self.assertEqual(ecu.process.wait(programs.LONGEST_S), 1)

    def test_rsi_ecu_without_its_interface_says_how_to_make_one(self):
        finished = programs.run("rsi-ecu", "--interface", "missing0", "--parameters", programs.CALIBRATION)
        self.assertEqual(finished.returncode, 1)
        self.assertIn("missing0", finished.stderr)
        self.assertIn("ip link add dev missing0 type vcan", finished.stderr)

    def test_rsi_ecu_refuses_what_is_no_can_interface(self):
        finished = programs.run("rsi-ecu", "--interface", "lo", "--parameters", programs.CALIBRATION)
        self.assertEqual(finished.returncode, 1)
        self.assertIn("not a CAN interface", finished.stderr)

    def test_rsi_sil_without_its_interface_says_how_to_make_one(self):
        with tempfile.TemporaryDirectory() as folder:
            finished = programs.run(
                "rsi-sil", "run", "straight", "--interface", "missing0", "--vehicle", programs.VEHICLE,
                "--output", folder,
            )
        self.assertEqual(finished.returncode, 1)
        self.assertIn("ip link add dev missing0 type vcan", finished.stderr)

    def test_rsi_sil_without_an_ecu_says_how_to_start_one(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("summary.json", "notes.txt"):
                (programs.pathlib.Path(folder) / name).write_text("of an earlier run", encoding="ascii")
            finished = programs.run_manoeuvre("straight", folder, "--duration", "1")
            left = [path.name for path in programs.pathlib.Path(folder).iterdir()]
        self.assertEqual(left, ["notes.txt"])
        self.assertEqual(finished.returncode, 1)
        self.assertIn(f"no ECU responds on {programs.INTERFACE}", finished.stderr)
        self.assertIn(f"rsi-ecu --interface {programs.INTERFACE}", finished.stderr)

    def test_a_lock_step_run_notices_an_ecu_that_runs_in_real_time(self):
        with tempfile.TemporaryDirectory() as folder, programs.Ecu() as ecu:
            finished = programs.run_manoeuvre("straight", folder, "--lock-step", "--duration", "1")
            self.assertEqual(ecu.stop(signal.SIGTERM), 0, ecu.output)
        self.assertEqual(finished.returncode, 1)
        self.assertIn("rsi-ecu --lock-step", finished.stderr)


if __name__ == "__main__":
    unittest.main()
