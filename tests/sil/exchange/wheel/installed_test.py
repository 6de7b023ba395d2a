"""The wheel, packed, installed and used as docs/integration.md says: bytes, types, lines of the page, the example.

Use: installed_test.py BUILD RSI_SIL. The computed values are the matter of same_bits.py, started in the new place.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import unittest
import zipfile

PROJECT = pathlib.Path(__file__).resolve().parents[4]
HERE = pathlib.Path(__file__).resolve().parent
LARGE_SUV = PROJECT / "firmware/calibrations/large_suv.toml"
BUILD = PROGRAM = ""


def run(*command, **options):
    """Its output; a failure fails the test with all that it printed."""
    done = subprocess.run(
        [str(word) for word in command],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
        **options,
    )
    if done.returncode:
        raise AssertionError(f"{command}: {done.returncode}\n{done.stdout}")
    return done.stdout


def pack(folder):
    folder.mkdir(parents=True)
    run(sys.executable, "-B", PROJECT / "sil/exchange/wheel/pack.py", "packed", BUILD, cwd=folder)
    [wheel] = (folder / "packed").iterdir()
    return wheel


def fences():
    """Commands and Python of the page."""
    [section] = re.findall(r"^## In Python\n(.*?)^## ", (PROJECT / "docs/integration.md").read_text(), re.M | re.S)
    return re.findall(r"^```\n(.*?)^```$", section, re.M | re.S)[0], re.findall(
        r"^```python\n(.*?)^```$", section, re.M | re.S
    )[0]


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.place = pathlib.Path(cls.scratch.name, "a place of its own")
        cls.wheel = pack(cls.place / "one")
        commands = fences()[0].splitlines()
        assert commands[0].startswith("sil/exchange/wheel/build --output output/wheel"), commands
        shutil.copytree(cls.wheel.parent, cls.place / "output/wheel")
        # NumPy and Matplotlib are there already, so that nothing is fetched.
        run(
            "bash",
            "-ec",
            "\n".join(commands[1:]),
            cwd=cls.place,
            env={"PATH": "/usr/bin:/bin", "PIP_NO_INDEX": "1", "PIP_NO_DEPS": "1"},
        )
        cls.python = cls.place / "notebook/bin/python"
        [packages] = (cls.place / "notebook/lib").glob("python*/site-packages")
        (packages / "others.pth").write_text(sysconfig.get_path("platlib"))
        run(
            PROGRAM,
            "run",
            "j-turn-110",
            "--vehicle",
            PROJECT / "sil/vehicles/large_suv.toml",
            "--in-process",
            "--parameters",
            LARGE_SUV,
            "--noise",
            "--output",
            cls.place / "drive",
        )

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def in_place(self, *arguments):
        return run(
            self.python,
            "-I",
            "-B",
            *arguments,
            cwd=self.place,
            env={"PATH": "/usr/bin:/bin", "MPLBACKEND": "agg", "HOME": str(self.place)},
        )

    def test_the_same_files_give_the_same_bytes(self):
        other = pack(self.place / "another folder")
        self.assertEqual((other.name, other.read_bytes()), (self.wheel.name, self.wheel.read_bytes()))

    def test_the_tag_is_that_of_the_library_and_nothing_knows_this_machine(self):
        found = re.fullmatch(
            r"rsi_component-(.+)-py3-none-manylinux_2_(\d+)_" + os.uname().machine + r"\.whl", self.wheel.name
        )
        self.assertIn(f'RSI_VERSION "{found[1]}"', (PROJECT / "firmware/rsi/version.h").read_text())
        with zipfile.ZipFile(self.wheel) as archive:
            contents = {name: archive.read(name) for name in archive.namelist()}
        for name, content in contents.items():
            for path in (PROJECT, self.scratch.name, BUILD):
                self.assertNotIn(str(path).encode(), content, name)
        self.assertIn("rsi_component/py.typed", contents)
        library = self.place / "library.so"
        library.write_bytes(contents["rsi_component/librsi_judge.so"])
        needed = re.findall(r"NEEDED +(\S+)", run("objdump", "-p", library))
        self.assertLessEqual(set(needed), {"libc.so.6", "libm.so.6", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"})
        wanted = {int(number) for number in re.findall(r"GLIBC_2\.(\d+)", run("objdump", "-T", library))}
        self.assertEqual(max(wanted), int(found[2]))

    def test_the_same_bits(self):
        run(
            PROGRAM,
            "replay",
            *(self.place / "drive" / name for name in ("candump.log", "signals.csv")),
            "--parameters",
            LARGE_SUV,
            "--output",
            self.place / "replay",
            "--no-pictures",
        )
        run(
            PROGRAM,
            "campaign",
            "run",
            "--runs",
            "24",
            "--seed",
            "5",
            "--traces",
            "--output",
            self.place / "campaign",
            cwd=PROJECT,
        )
        shutil.copy(HERE / "same_bits.py", self.place)
        self.in_place("same_bits.py", "replay/candump", "replay/signals", "campaign", LARGE_SUV)

    def test_the_lines_of_the_page(self):
        shutil.copy(LARGE_SUV, self.place / "my_car.toml")
        before = (
            "import numpy as np\n"
            "import rsi_component as rsi\n"
            "time_s = np.arange(0, 3, 0.01)\n"
            "f_y = np.where(time_s > 1, 6.0, 0.0)\n"
            "p, phi = np.gradient(0.02 * f_y, 0.01), 0.02 * f_y\n"
            "front_left = rear_left = 5000 - 700 * f_y\n"
            "front_right = rear_right = 5000 + 700 * f_y\n"
            "others = []\n"
        )
        after = (
            "\nassert run['rsi'].shape == time_s.shape\n"
            "assert set(run.states()) == {'unavailable', 'ready', 'advisory', 'warning'}\n"
        )
        (self.place / "page.py").write_text(before + fences()[1] + after)
        said = self.in_place("page.py")
        self.assertRegex(said, r"(?m)^warning +nan +0/0 .* 1/1 +0/0$")
        self.assertRegex(said, r"(?m)^rollover_index ")

    def test_the_example_draws(self):
        said = self.in_place(PROJECT / "docs/examples/own_drive/indices.py", "drive/signals.csv", "drive.png")
        self.assertRegex(said, r"^two wheels lift at 1\.\d\d s, to the right; warned 0\.\d\d s before\n$")
        picture = (self.place / "drive.png").read_bytes()
        self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n")
        self.assertGreater(len(picture), 20000)

    def test_types(self):
        shutil.copy(PROJECT / "docs/examples/own_drive/indices.py", self.place)
        (self.place / "wrong.py").write_text(
            "import rsi_component as rsi\nrsi.Calibration.load(1)\nrsi.Truth([0.0]).falling_side.real\n"
        )
        checked = subprocess.run(
            [
                sys.executable,
                "-B",
                "-m",
                "mypy",
                "--strict",
                f"--cache-dir={os.devnull}",
                "--python-executable",
                self.python,
                "-p",
                "rsi_component",
                "-m",
                "indices",
                "-m",
                "wrong",
            ],
            capture_output=True,
            text=True,
            cwd=self.place,
            check=False,
        ).stdout
        self.assertIn('wrong.py:2: error: Argument 1 to "load"', checked)
        self.assertIn('wrong.py:3: error: "str" has no attribute "real"', checked)
        self.assertIn("Found 2 errors in 1 file (checked", checked)


if __name__ == "__main__":
    BUILD, PROGRAM = sys.argv[1:3]
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
