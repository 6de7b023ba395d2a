"""What the programs say to a wrong command line or file. No CAN interface is needed."""

import pathlib
import tempfile
import unittest

import programs

MANOEUVRES = ("j-turn-110", "j-turn-45", "straight", "slalom")


class RsiSil(unittest.TestCase):
    def run_straight(self, *options):
        with tempfile.TemporaryDirectory() as folder:
            return programs.run("rsi-sil", "run", "straight", "--vehicle", programs.VEHICLE, "--output", folder, *options)

    def test_lists_its_manoeuvres(self):
        finished = programs.run("rsi-sil", "list")
        self.assertEqual(finished.returncode, 0)
        for name in MANOEUVRES:
            self.assertIn(name, finished.stdout)

    def test_names_the_manoeuvres_that_exist_when_it_does_not_know_one(self):
        with tempfile.TemporaryDirectory() as folder:
            finished = programs.run(
                "rsi-sil", "run", "looping", "--vehicle", programs.VEHICLE, "--output", folder
            )
        self.assertEqual(finished.returncode, 1)
        for name in ("looping", *MANOEUVRES):
            self.assertIn(name, finished.stderr)

    def test_names_the_options_that_exist_when_it_does_not_know_one(self):
        finished = self.run_straight("--looping")
        self.assertNotEqual(finished.returncode, 0)
        said = finished.stdout + finished.stderr
        for name in ("--looping", "--interface", "--seed", "--lock-step", "--mirror", "--noise", "--duration"):
            self.assertIn(name, said)

    def test_names_the_commands_that_exist_when_it_does_not_know_one(self):
        for arguments in ((), ("fly",)):
            finished = programs.run("rsi-sil", *arguments)
            self.assertNotEqual(finished.returncode, 0)
            for name in ("list", "run", "timing"):
                self.assertIn(name, finished.stdout + finished.stderr)

    def test_refuses_durations_that_are_no_positive_number(self):
        for value in ("0", "-1", "nan", "inf", "ten"):
            with self.subTest(value=value):
                finished = self.run_straight("--duration", value)
                self.assertNotEqual(finished.returncode, 0)
                self.assertIn("--duration", finished.stdout + finished.stderr)

    def test_refuses_seeds_that_are_no_natural_number(self):
        for value in ("-1", "1.5", "one"):
            with self.subTest(value=value):
                finished = self.run_straight("--seed", value)
                self.assertNotEqual(finished.returncode, 0)
                self.assertIn("--seed", finished.stdout + finished.stderr)

    def test_names_a_vehicle_file_that_is_missing(self):
        with tempfile.TemporaryDirectory() as folder:
            finished = programs.run(
                "rsi-sil", "run", "straight", "--vehicle", "/nowhere/car.toml", "--output", folder
            )
        self.assertEqual(finished.returncode, 1)
        self.assertIn("/nowhere/car.toml", finished.stderr)

    def test_names_a_log_that_is_missing(self):
        finished = programs.run("rsi-sil", "timing", "/nowhere/candump.log")
        self.assertEqual(finished.returncode, 1)
        self.assertIn("/nowhere/candump.log", finished.stderr)


class RsiEcu(unittest.TestCase):
    def test_asks_for_its_parameters(self):
        finished = programs.run("rsi-ecu")
        self.assertNotEqual(finished.returncode, 0)
        self.assertIn("--parameters", finished.stdout + finished.stderr)

    def test_names_the_options_that_exist_when_it_does_not_know_one(self):
        finished = programs.run("rsi-ecu", "--looping", "--parameters", programs.CALIBRATION)
        self.assertNotEqual(finished.returncode, 0)
        for name in ("--looping", "--interface", "--parameters", "--lock-step", "--priority", "--lock-memory"):
            self.assertIn(name, finished.stdout + finished.stderr)

    def test_names_a_parameter_file_that_is_missing(self):
        finished = programs.run("rsi-ecu", "--parameters", "/nowhere/calibration.toml")
        self.assertEqual(finished.returncode, 1)
        self.assertIn("/nowhere/calibration.toml", finished.stderr)

    def test_names_file_line_and_key_of_a_wrong_parameter(self):
        text = programs.CALIBRATION.read_text(encoding="utf-8")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "calibration.toml"
            path.write_text(text.replace("track_width_m = 1.60", "track_width_m = nan"), encoding="utf-8")
            finished = programs.run("rsi-ecu", "--parameters", path)
        line = 1 + text[: text.index("track_width_m")].count("\n")
        self.assertEqual(finished.returncode, 1)
        self.assertIn(f'{path}:{line}: "track_width_m"', finished.stderr)

    def test_replays_a_log_and_writes_three_frames_a_cycle(self):
        with tempfile.TemporaryDirectory() as folder:
            log, output = pathlib.Path(folder) / "in.log", pathlib.Path(folder) / "out.log"
            log.write_text("(1.000000) vcan0 120#0000000000000000\n(1.100000) vcan0 120#0000000000000000\n")
            finished = programs.run(
                "rsi-ecu", "replay", log, "--parameters", programs.CALIBRATION, "--output", output
            )
            self.assertEqual(finished.returncode, 0, finished.stderr)
            frames = programs.read_log(output)
        self.assertEqual(len(frames), 11 * 3)
        self.assertEqual({programs.state_of(data) for _, identifier, data in frames if identifier == "0D0"}, {0})

    def test_names_file_line_and_column_of_a_wrong_log(self):
        with tempfile.TemporaryDirectory() as folder:
            log = pathlib.Path(folder) / "in.log"
            log.write_text("(1.000000) vcan0 120#00\n(1.010000) vcan0 12X#00\n")
            finished = programs.run(
                "rsi-ecu", "replay", log, "--parameters", programs.CALIBRATION, "--output", log.with_name("out.log")
            )
        self.assertEqual(finished.returncode, 1)
        self.assertIn(f"{log}:2:", finished.stderr)


if __name__ == "__main__":
    unittest.main()
