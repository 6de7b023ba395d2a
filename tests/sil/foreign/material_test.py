"""The files with which others test their readers: whole, cut, with flipped bits. Reading ends within bounds, what is left out
is counted, and both signs of a signed quantity come out.

Use: material_test.py
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
MATERIAL = PROJECT / "build/foreign/material"
sys.path[:0] = [str(PROJECT / "tests/sil/tools")]

import damaging

import asammdf
import bus_log_writers
import can
import cantools
import command
from bus_frame import Frame

CUTS, FLIPS, SEED = 6, 8, 35
TEXTS = (".asc", ".trc")
# Without which the tests would have looked at little.
LEAST_LOGS, LEAST_DATABASES, LEAST_READ, LEAST_SIGNS = 25, 180, 0.6, 60
LARGEST_DAMAGED_DATABASE = 60_000


def files(*endings):
    return [path for path in sorted(MATERIAL.rglob("*")) if path.suffix.lower() in endings and path.stat().st_size > 0]


class Material(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        subprocess.run([str(PROJECT / "tests/sil/foreign/fetch_material"), sys.executable], check=True)

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def test_logs_whole_cut_and_with_flipped_bits(self):
        logs = files(".blf", ".asc", ".trc", ".mf4")
        self.assertGreaterEqual(len(logs), LEAST_LOGS)
        for path in logs:
            with self.subTest(path.name):
                content = path.read_bytes()
                judge = damaging.Judge(self, self.folder, path.name, content)
                if judge.whole.result is not None:
                    self.same_as_python_can(path, judge.whole)
                for what, damaged in {**damaging.cuts(content, CUTS), **damaging.flips(content, FLIPS, SEED)}.items():
                    judge.judge(what, damaged, path.suffix in TEXTS)

    def same_as_python_can(self, path, outcome):
        with can.LogReader(path) as reader:
            expected = [(message.arbitration_id, message.is_extended_id, bytes(message.data)) for message in reader
                        if not message.is_error_frame and not message.is_remote_frame]
        frames = [(frame[2], frame[3], frame[4]) for frame in outcome.result]
        if frames != expected:  # the requests are no frames of a bus, which python-can does not distinguish
            self.assertIn(f"{len(expected) - len(frames)} requests to send (TxRq)", outcome.said)

    def drafted(self, path):
        draft = self.folder / "draft.toml"
        draft.unlink(missing_ok=True)
        outcome = damaging.within_bounds(path.stat().st_size, lambda: command.main(["draft", "--dbc", str(path), "--output",
                                                                                  str(draft)]))
        self.assertTrue(outcome.ended, f"{path}: {outcome.refusal}")
        if outcome.refusal:
            self.assertTrue(outcome.refusal.startswith(f"sil/tools/logs: {path}"), outcome.refusal)
        return outcome.refusal is None or "has the name of a quantity" in outcome.refusal

    def test_databases_whole_cut_and_with_flipped_bits(self):
        databases = files(".dbc")
        self.assertGreaterEqual(len(databases), LEAST_DATABASES)
        self.assertGreaterEqual(sum(map(self.drafted, databases)), LEAST_READ * len(databases))
        for path in databases:
            content = path.read_bytes()
            if len(content) <= LARGEST_DAMAGED_DATABASE:
                for damaged in (*damaging.cuts(content, 1).values(), *damaging.flips(content, 1, SEED).values()):
                    changed = self.folder / path.name
                    changed.write_bytes(damaged)
                    self.drafted(changed)

    def test_both_signs_of_a_signed_quantity_come_out(self):
        count = 0
        for path in files(".dbc"):
            found = self.signed(path)
            if found is None:
                continue
            message, signal, frames = found
            log, output = self.folder / "signs.blf", self.folder / "decoded"
            bus_log_writers.write_blf(log, iter(frames))
            outcome = damaging.within_bounds(path.stat().st_size, lambda: command.main(
                ["decode", str(log), "--dbc", str(path), "--output", str(output)]))
            self.assertTrue(outcome.ended, f"{path}: {outcome.refusal}")
            if outcome.refusal:
                continue
            with asammdf.MDF(output / "signals.mf4", raise_on_multiple_occurrences=False) as mdf:
                group = next(index for index, group in enumerate(mdf.groups) if group.channel_group.acq_name == message.name)
                values = mdf.get(signal.name, group=group).samples
            self.assertTrue(values.min() < 0.0 < values.max(), f"{path}: {message.name}.{signal.name}: {values}")
            count += 1
        self.assertGreaterEqual(count, LEAST_SIGNS)

    @staticmethod
    def signed(path):
        """A message with a signed signal, which needs no other to be known, and frames of both its signs."""
        try:
            database = cantools.database.load_file(path, strict=False)
        except Exception:  # it is read line by line elsewhere
            return None
        for message in getattr(database, "messages", ()):
            for signal in message.signals:
                if not signal.is_signed or signal.is_float or signal.length < 8 or signal.choices or message.is_multiplexed() or \
                        message.length > 8:
                    continue
                frames = []
                try:
                    for number, raw in enumerate((-3, 3, -3, 3)):
                        data = message.encode({one.name: raw if one is signal else 0 for one in message.signals}, scaling=False,
                                              padding=False, strict=False)
                        frames.append(Frame(0.01 * number, 1, message.frame_id, message.is_extended_frame, bytes(data), False,
                                            False, False))
                except (OverflowError, cantools.database.errors.Error):  # signals beyond the message's end
                    continue
                if signal.conversion.raw_to_scaled(-3) < 0.0 < signal.conversion.raw_to_scaled(3):
                    return message, signal, frames
        return None


if __name__ == "__main__":
    unittest.main()
