"""The commands on an ECU without a CAN interface, with the libraries of --bus and no other.

use: in_process_test.py A2L
"""

import importlib.metadata
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
A2L = pathlib.Path(sys.argv.pop(1))
PROJECT = pathlib.Path(__file__).resolve().parents[4]
sys.path[:0] = [str(PROJECT / "sil/tools"), str(PROJECT / "cmake/environment")]

import key_file  # noqa: E402
from log_error import LogError  # noqa: E402

LARGEST_BYTES = 75e6


def pinned():
    text = (PROJECT / "sil/tools/requirements_bus.txt").read_text()
    return re.findall(r"^([\w-]+)==", text, re.M)


class InProcess(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """A folder with links to the files of the pinned packages, in place of an environment with them alone."""
        cls.folder = tempfile.TemporaryDirectory()
        cls.libraries = pathlib.Path(cls.folder.name) / "libraries"
        cls.libraries.mkdir()
        cls.bytes = 0
        for name in pinned():
            for file in importlib.metadata.distribution(name).files:
                whole = file.locate()
                cls.bytes += whole.stat().st_size if whole.is_file() else 0
                top = cls.libraries / file.parts[0]
                if file.parts[0] != ".." and not top.exists():
                    top.symlink_to(whole.parents[len(file.parts) - 1] / file.parts[0] if len(file.parts) > 1 else whole)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def run_it(self, command, *arguments, status=0):
        program = PROJECT / f"sil/tools/{command}"
        finished = subprocess.run(["/usr/bin/python3", "-S", "-B", program, *arguments], capture_output=True, text=True,
                                  check=False, env={"PYTHONPATH": str(self.libraries), "PATH": "/usr/bin:/bin"}, timeout=60)
        self.assertEqual(finished.returncode, status, finished.stdout + finished.stderr)
        return finished.stdout if status == 0 else finished.stderr

    def calibrate(self, *arguments, status=0):
        return self.run_it("calibration.py", *arguments, "--a2l", str(A2L), status=status)

    def diagnosis(self, *arguments, status=0):
        return self.run_it("diagnosis_command.py", *arguments, status=status)

    def test_the_libraries_are_small(self):
        self.assertGreater(self.bytes, 10e6)
        self.assertLess(self.bytes, LARGEST_BYTES)

    def test_reads_a_first_value(self):
        said = self.calibrate("read", "state", "warning_on", "--in-process", "j-turn-110")
        self.assertEqual(said, "state = ready\nwarning_on = 0.88\n")

    def test_measures_inputs_and_codes(self):
        table = pathlib.Path(self.folder.name) / "codes.csv"
        self.calibrate("measure", "code_roll_angle_invalid", "code_speed_invalid", "speed_mps", "roll_angle_rad", "--seconds", "0.1",
                       "--output", str(table), "--in-process", "straight", "--lost", "roll_angle")
        for row in table.read_text().splitlines()[1:]:
            _, roll_angle, speed, value, angle = row.split(",")
            self.assertEqual((roll_angle, speed, angle), ("1", "0", "nan"))
            self.assertAlmostEqual(float(value), 27.78, delta=0.1)
        said = self.calibrate("read", "code_roll_angle_invalid", "confirmed_imu_lost", "--in-process", "straight", "--lost",
                              "roll_angle")
        self.assertEqual(said, "code_roll_angle_invalid = yes\nconfirmed_imu_lost = no\n")

    def test_measures_the_warning_of_a_manoeuvre(self):
        table = pathlib.Path(self.folder.name) / "measured.csv"
        said = self.calibrate("measure", "state", "--seconds", "3", "--output", str(table), "--in-process", "j-turn-110")
        self.assertIn("301 samples, 0 missing", said)
        states = [int(line.split(",")[1]) for line in table.read_text().splitlines()[1:]]
        self.assertEqual((states[0], max(states)), (1, 3))

    def test_reads_first_codes_on_a_bench_and_of_a_lost_sensor(self):
        said = self.diagnosis("codes", "--in-process", "bench")
        self.assertIn("U1120-87  imu lost: fails now, confirmed, pending\n", said)
        self.assertEqual(self.diagnosis("codes", "--in-process", "straight"), "no trouble codes\n")
        said = self.diagnosis("codes", "--in-process", "straight", "--lost", "roll_angle")
        self.assertRegex(said, r"\A\S+  roll angle invalid: fails now, confirmed, pending\n")
        self.assertEqual(self.diagnosis("clear", "--in-process", "bench"), "cleared\n")

    def test_says_which_manoeuvres_and_sensors_there_are(self):
        said = self.calibrate("read", "--in-process", "nosuch", status=1)
        self.assertRegex(said, r"^sil/tools/calibrate: There is no manoeuvre 'nosuch'. Choose one of: j-turn-110, ")
        said = self.diagnosis("codes", "--in-process", "straight", "--lost", "nosuch", status=1)
        self.assertRegex(said, r"^sil/tools/diagnosis: There is no sensor 'nosuch'. Choose one of: lateral_acceleration, ")

    def test_takes_keys_from_a_file(self):
        keys = pathlib.Path(self.folder.name) / "keys.toml"
        in_process = ("--in-process", "bench", "--key", str(keys))
        for text, said in (("", "it has no key for diagnosis"), ("=", "it is no TOML file"),
                           ('diagnosis = "00"', "is no key of AES-128"), ("diagnosis = 1", "is no key of AES-128")):
            keys.write_text(text)
            with self.assertRaisesRegex(LogError, said):
                key_file.read(keys, "diagnosis")
        keys.unlink()
        self.assertIn("name a key file", self.diagnosis("clear", *in_process, status=1))
        good = {"calibration": b"test key for XCP", "diagnosis": b"test key for UDS"}
        keys.write_text("".join(f'{slot} = "{key.hex()}"\n' for slot, key in good.items()))
        keys.chmod(0o600)
        self.assertEqual(self.calibrate("compare", *in_process), "")
        self.assertEqual(self.diagnosis("clear", *in_process), "cleared\n")
        keys.write_text("".join(f'{slot} = "{"00" * 16}"\n' for slot in good))
        self.assertIn("the key is wrong", self.calibrate("compare", *in_process, status=1))
        self.assertIn("refuses SecurityAccess: InvalidKey", self.diagnosis("clear", *in_process, status=1))


if __name__ == "__main__":
    unittest.main()
