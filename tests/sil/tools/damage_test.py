"""Logs of every kind, cut and with flipped bits: they end within bounds, and what they lose is counted.

The material of others is in tests/sil/foreign/material_test.py.
"""

import os
import signal
import sys
import unittest
import unittest.mock

import damaging
import support

import apart
import asammdf
import bus_log_writers
import can
import numpy
import table_signals
from bus_frame import Frame

FRAMES = [Frame(round(0.01 * number, 6), 1, 0x120 + number % 3, False, bytes([number % 256, 255 - number % 256, 3, 4, 5, 6, 7, 8]),
                False, False, False) for number in range(300)]
CUTS, FLIPS, SEED = 5, 8, 35
TEXTS = ("asc", "trc", "csv", "candump", "gvret", "canedge")


def by_python_can(writer, path):
    with writer(path) as log:
        for frame in FRAMES:
            log.on_message_received(bus_log_writers.message(frame))


def written(kind, path):
    if kind in ("trc", "csv"):
        by_python_can({"trc": can.TRCWriter, "csv": can.CSVWriter}[kind], path)
    elif kind == "gvret":
        path.write_text("Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\n" + "".join(
            f"{round(1e6 * frame.time_s)},{frame.identifier:08X},false,Rx,0,8,{frame.data.hex(',')},\n" for frame in FRAMES))
    elif kind == "canedge":
        path.write_text("TimestampEpoch;BusChannel;ID;IDE;DLC;DataLength;Dir;EDL;BRS;DataBytes\n" + "".join(
            f"{frame.time_s:.6f};1;{frame.identifier:X};0;8;8;0;0;0;{frame.data.hex()}\n" for frame in FRAMES))
    elif kind == "blf without containers":
        with can.BLFWriter(path, compression_level=0) as log:
            for frame in FRAMES:
                log.on_message_received(bus_log_writers.message(frame))
        content = path.read_bytes()
        path.write_bytes(content[:144] + content[176:])  # the header of its only container
    else:
        getattr(bus_log_writers, f"write_{kind}")(path, iter(FRAMES))
    return path.read_bytes()


class Damage(support.WithFolder):
    def test_every_kind(self):
        for kind in ("blf", "blf without containers", "mf4", *TEXTS):
            with self.subTest(kind):
                content = written(kind, self.folder / "written")
                judge = damaging.Judge(self, self.folder, f"log.{kind}", content)
                self.assertEqual([frame[4] for frame in judge.whole.result], [frame.data for frame in FRAMES])
                counts = {what: judge.judge(what, damaged, kind in TEXTS) for what, damaged in
                          {**damaging.cuts(content, CUTS), **damaging.flips(content, FLIPS, SEED)}.items()}
                if kind in TEXTS:
                    singles = [count for what, count in counts.items() if what.startswith("1 flip") and count is not None]
                    self.assertGreaterEqual(len(singles), FLIPS // 4)  # others are in the head, without which nothing can be read
                    # One flipped bit costs two lines at most, where it was the end of one.
                    self.assertGreaterEqual(min(singles), len(FRAMES) - 2)
                    self.assertGreater(counts[f"cut at {len(content) // 2}"], len(FRAMES) / 2 - 10)

    def test_an_mf4_of_signals(self):
        file = self.folder / "signals.mf4"
        mdf = asammdf.MDF(version="4.10")
        mdf.append([asammdf.Signal(numpy.sin(numpy.arange(400.0)), 0.01 * numpy.arange(400), name=name, unit="deg/s")
                    for name in ("RollRate", "YawRate")])
        mdf.save(file)
        mdf.close()
        content = file.read_bytes()
        self.assertEqual([column.name for column in table_signals.columns_of(file)], ["RollRate", "YawRate"])
        for what, damaged in {**damaging.cuts(content, CUTS), **damaging.flips(content, FLIPS, SEED)}.items():
            file.write_bytes(damaged)
            outcome = damaging.within_bounds(len(damaged), lambda: table_signals.columns_of(file))
            self.assertTrue(outcome.ended, f"{what}: {outcome.refusal}")
            if outcome.refusal:
                self.assertTrue(outcome.refusal.startswith(f"{file}"), f"{what}: {outcome.refusal}")

    def test_the_bounds_end_what_takes_too_much(self):
        with unittest.mock.patch.object(damaging, "SECONDS", 0.0):
            for name, work in (("time", lambda: sum(1 for _ in iter(int, 1))), ("memory", lambda: len(bytearray(1 << 40))),
                               ("disk", lambda: (self.folder / "large").write_bytes(bytes(1 << 22)))):
                self.assertFalse(damaging.within_bounds(10, work).ended, name)
        self.assertEqual(damaging.within_bounds(10, lambda: 5), damaging.Outcome(True, 5, None, ""))

    def test_work_apart_that_waits_for_ever_is_ended(self):
        def work():
            yield 1
            yield from [bytes(1 << 20), 3]
            signal.pause()

        items = []
        with unittest.mock.patch.object(apart, "WALL_PER_CPU", 0.25), self.assertRaisesRegex(apart.Ended, "nothing came .* for 1 s"):
            items.extend(apart.items(10, work))
        self.assertTrue(items == [1, bytes(1 << 20), 3], f"{len(items)} items")
        with self.assertRaises(ChildProcessError):
            os.waitpid(-1, os.WNOHANG)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
