"""Messages of the programs on a wrong command line or file. No CAN interface is needed."""

import pathlib
import tempfile
import unittest

import programs

MANOEUVRES = ("j-turn-110", "j-turn-45", "straight", "slalom")


class Messages(unittest.TestCase):
    def assert_usage_error(self, finished, *words, help_of):
        """Status 2, and on stderr one line with the cause, all of `words` in it, and one that leads to the help."""
        self.assertEqual(finished.returncode, 2, finished.stderr)
        self.assertEqual(finished.stdout, "")
        lines = finished.stderr.splitlines()
        self.assertEqual(len(lines), 2, finished.stderr)
        self.assertTrue(lines[0].startswith(f"{help_of.split()[0]}: "), lines[0])
        for word in words:
            self.assertIn(word, lines[0])
        self.assertEqual(lines[1], f"Try: {help_of} --help")


class RsiSil(Messages):
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
        self.assert_usage_error(finished, "looping", *MANOEUVRES, help_of="rsi-sil run")

    def test_help_is_no_error(self):
        for arguments in (("--help",), ("run", "--help")):
            finished = programs.run("rsi-sil", *arguments)
            self.assertEqual((finished.returncode, finished.stderr), (0, ""))
            self.assertIn("--help", finished.stdout)

    def test_names_the_options_that_exist_when_it_does_not_know_one(self):
        names = ("unknown option --looping", "--interface", "--seed", "--lock-step", "--mirror", "--noise", "--duration")
        self.assert_usage_error(self.run_straight("--looping"), *names, help_of="rsi-sil run")
        finished = programs.run("rsi-sil", "run", "--looping")
        self.assert_usage_error(finished, *names, help_of="rsi-sil run")

    def test_names_the_commands_that_exist_when_it_does_not_know_one(self):
        finished = programs.run("rsi-sil", "fly")
        self.assert_usage_error(finished, "unknown command fly", "list", "run", "timing", help_of="rsi-sil")

    def test_names_the_commands_that_exist_when_there_is_none(self):
        finished = programs.run("rsi-sil")
        self.assert_usage_error(finished, "a command is missing", "list", "run", "timing", help_of="rsi-sil")

    def test_names_what_is_missing_or_too_much(self):
        finished = programs.run("rsi-sil", "run", "straight", "--output", "anywhere")
        self.assert_usage_error(finished, "--vehicle is required", help_of="rsi-sil run")
        self.assert_usage_error(self.run_straight("slalom"), "slalom is one argument too many", help_of="rsi-sil run")
        self.assert_usage_error(self.run_straight("--seed"), "option --seed needs one value", help_of="rsi-sil run")

    def test_refuses_numbers_out_of_range_or_none(self):
        for option, wanted, values in (
            ("--duration", "wants a number from 0.01", ("0", "-1", "nan", "inf", "ten")),
            ("--bias", "wants a number from -1", ("1.1", "-2", "nan", "little")),
            ("--quantisation", "wants a number from 0 to 1", ("-0.1", "1.1", "nan", "little")),
            (
                "--seed",
                "wants a whole number from 0 to 18446744073709551615",
                ("-1", "1.5", "abc", "0x10", " 5", "18446744073709551616"),
            ),
        ):
            for value in values:
                with self.subTest(option=option, value=value):
                    finished = self.run_straight(f"{option}={value}")
                    self.assert_usage_error(finished, option, wanted, help_of="rsi-sil run")

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

    def timing_of(self, text):
        with tempfile.TemporaryDirectory() as folder:
            log = pathlib.Path(folder) / "candump.log"
            log.write_text(text, encoding="ascii")
            finished = programs.run("rsi-sil", "timing", log)
        self.assertEqual(finished.stdout, "")
        self.assertEqual(finished.returncode, 1)
        self.assertIn(f"{log}: ", finished.stderr)
        return finished.stderr

    def test_tells_no_timing_of_a_log_without_warning_frames(self):
        self.assertIn("0x0D0", self.timing_of("(1.000000) vcan0 120#00\n"))

    def test_tells_no_timing_of_a_log_in_simulated_time(self):
        text = "(0.000000) vcan0 7F0#00\n(0.000000) vcan0 0D0#00\n(0.010000) vcan0 0D0#00\n"
        self.assertIn("no real times", self.timing_of(text))


class RsiEcu(Messages):
    def test_says_where_calibrations_are_when_it_has_none(self):
        words = ("--parameters FILE is missing", "firmware/calibrations/large_suv.toml")
        self.assertTrue(programs.CALIBRATION.match(words[1]))
        self.assert_usage_error(programs.run("rsi-ecu"), *words, help_of="rsi-ecu")
        finished = programs.run("rsi-ecu", "replay", "in.log", "--output", "out.log")
        self.assert_usage_error(finished, *words, help_of="rsi-ecu replay")

    def test_names_the_options_that_exist_when_it_does_not_know_one(self):
        finished = programs.run("rsi-ecu", "--looping", "--parameters", programs.CALIBRATION)
        names = ("--looping", "--interface", "--parameters", "--lock-step", "--priority", "--lock-memory")
        self.assert_usage_error(finished, *names, help_of="rsi-ecu")

    def test_names_the_command_that_exists_when_it_does_not_know_one(self):
        self.assert_usage_error(programs.run("rsi-ecu", "fly"), "unknown command fly", "replay", help_of="rsi-ecu")

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

    def test_replays_a_log_and_writes_all_frames_of_each_cycle(self):
        with tempfile.TemporaryDirectory() as folder:
            log, output = pathlib.Path(folder) / "in.log", pathlib.Path(folder) / "out.log"
            log.write_text("(1.000000) vcan0 120#0000000000000000\n(1.100000) vcan0 120#0000000000000000\n")
            finished = programs.run(
                "rsi-ecu", "replay", log, "--parameters", programs.CALIBRATION, "--output", output
            )
            self.assertEqual(finished.returncode, 0, finished.stderr)
            frames = programs.read_log(output)
        self.assertEqual(len(frames), 11 * programs.ECU_FRAMES_A_CYCLE)
        self.assertEqual({programs.state_of(data) for _, identifier, data in frames if identifier == "0D0"}, {0})

    def replay(self, text):
        """The error of a replay that must fail and leave no output; "LOG" stands for the log's path."""
        with tempfile.TemporaryDirectory() as folder:
            log, output = pathlib.Path(folder) / "in.log", pathlib.Path(folder) / "out.log"
            log.write_text(text, encoding="ascii")
            finished = programs.run(
                "rsi-ecu", "replay", log, "--parameters", programs.CALIBRATION, "--output", output
            )
            self.assertFalse(output.exists())
        self.assertEqual(finished.returncode, 1)
        return finished.stderr.replace(str(log), "LOG")

    def test_refuses_to_replay_a_log_without_sensor_frames(self):
        self.assertIn("LOG: there is no sensor frame", self.replay("(1.000000) vcan0 0D0#00\n"))
        self.assertIn("0x120, 0x121, 0x122", self.replay(""))

    def test_names_file_and_line_where_the_time_of_a_log_goes_back(self):
        said = self.replay("(3.000000) vcan0 120#00\n\n(1.000000) vcan0 120#00\n")
        self.assertIn("LOG:3: the time goes back from 3.000000 s to 1.000000 s", said)

    def test_refuses_to_write_the_answers_over_the_log(self):
        text = "(1.000000) vcan0 120#0000000000000000\n"
        with tempfile.TemporaryDirectory() as folder:
            log, link = pathlib.Path(folder) / "in.log", pathlib.Path(folder) / "link.log"
            log.write_text(text, encoding="ascii")
            link.symlink_to(log)
            for output in (log, link, f"{folder}/./in.log"):
                finished = programs.run(
                    "rsi-ecu", "replay", log, "--parameters", programs.CALIBRATION, "--output", output
                )
                self.assert_usage_error(finished, str(output), "choose another name", help_of="rsi-ecu replay")
                self.assertEqual(log.read_text(encoding="ascii"), text)

    def test_leaves_out_lines_of_a_log_that_are_no_frames_and_says_so(self):
        frames = "(1.000000) vcan0 120#0000000000000000\n(1.100000) vcan0 120#0000000000000000\n"
        others = "(1.000000) vcan0 20000080#0000000000000000\n(1.000000) vcan0 121#R8\n(1.010000) vcan0 12X#00\n"
        answers = []
        with tempfile.TemporaryDirectory() as folder:
            log, output = pathlib.Path(folder) / "in.log", pathlib.Path(folder) / "out.log"
            for text in (frames, others + frames):
                log.write_text(text, encoding="ascii")
                finished = programs.run(
                    "rsi-ecu", "replay", log, "--parameters", programs.CALIBRATION, "--output", output
                )
                self.assertEqual(finished.returncode, 0, finished.stderr)
                answers.append(output.read_bytes())
        self.assertEqual(answers[0], answers[1])
        self.assertIn(f"{log}: left out: 1 error frames; 1 remote frames; 1 lines that are no frames, the first {log}:3:18: ",
                      finished.stderr)


if __name__ == "__main__":
    unittest.main()
