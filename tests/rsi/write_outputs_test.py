"""rsi.h has the rows of rsi_outputs.h, and firmware/rsi/write_outputs --check notices where it has not."""
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOM = pathlib.Path(__file__).resolve().parents[2] / "firmware/rsi"
# Edits to plant, each by file: every one makes header and table differ.
DIFFERENCES = [
    ("rsi.h", "    float warning_level; ", "    double warning_level;"),
    ("rsi.h", "[m/s^2] a_y: horizontal", "[m/s^2] a_y: vertical"),
    ("rsi.h", "RSI_INDICATOR_ENERGY = 9,", "RSI_INDICATOR_ENERGY = 8,"),
    ("rsi_outputs.h", "NUMBER(disturbance_nm,", "NUMBER(disturbance,"),
    ("rsi_outputs.h", "d of (11), in units of Y", "d of (11)"),
    ("rsi_outputs.h", '"N m", turns, sometimes', '"J", turns, sometimes'),
    ("rsi_outputs.h", "INDEX(rsi_bank_free,", "INDEX(rsi_flat,"),
    ("rsi_outputs.h", "CODE(estimate_frozen,", "NUMBER(estimate_frozen,"),
]


class WriteOutputs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.room = pathlib.Path(folder.name)
        for name in ("write_outputs", "rsi.h", "rsi_outputs.h"):
            shutil.copy(ROOM / name, self.room)

    def run_it(self, *arguments):
        return subprocess.run([self.room / "write_outputs", *arguments], capture_output=True, text=True, check=False)

    def change(self, name, before, after):
        text = (self.room / name).read_text(encoding="utf-8")
        self.assertEqual(text.count(before), 1, before)
        (self.room / name).write_text(text.replace(before, after), encoding="utf-8")

    def test_the_header_has_the_rows_of_the_table(self):
        answer = self.run_it("--check")
        self.assertEqual((answer.returncode, answer.stderr), (0, ""))

    def test_every_difference_is_noticed_and_mended(self):
        for name, before, after in DIFFERENCES:
            with self.subTest(before):
                self.setUp()
                self.change(name, before, after)
                answer = self.run_it("--check")
                self.assertEqual(answer.returncode, 1)
                self.assertIn("Run: firmware/rsi/write_outputs", answer.stderr)
                self.assertEqual(self.run_it().returncode, 0)
                self.assertEqual(self.run_it("--check").returncode, 0)

    def test_a_row_that_cannot_be_read_is_named(self):
        self.change("rsi_outputs.h", "CODE(estimate_frozen,", "FLAG(estimate_frozen,")
        before = (self.room / "rsi.h").read_text(encoding="utf-8")
        answer = self.run_it()
        self.assertEqual(answer.returncode, 2)
        self.assertIn("FLAG(estimate_frozen", answer.stderr)
        self.assertEqual((self.room / "rsi.h").read_text(encoding="utf-8"), before)

    def test_a_wrong_use_is_refused(self):
        self.assertEqual(self.run_it("--chek").returncode, 2)


if __name__ == "__main__":
    unittest.main()
