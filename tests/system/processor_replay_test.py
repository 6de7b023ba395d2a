"""The Cortex-R5F's image under QEMU in lock-step, with a bus of its own: recorded frames give the recorded answers."""

import os
import unittest

import processor
import programs

IMAGE = processor.CORTEX_R5F / "sil/images/rsi-ecu-r5f-lock-step.elf"
LOGS = programs.PROJECT / "tests/application/regression/logs"
# Off-line, tests/targets has all of them.
MANOEUVRES = ("j-turn-110-noise",)
if os.environ.get("RSI_ALL_MANOEUVRES"):
    MANOEUVRES = tuple(log.name.removesuffix(".sensors.log") for log in sorted(LOGS.glob("*.sensors.log")))


class Replay(unittest.TestCase):
    def test_a_recorded_manoeuvre_gives_the_recorded_frames_byte_for_byte(self):
        board = self.enterContext(processor.Board(IMAGE))
        for name in MANOEUVRES:
            with self.subTest(name):
                bus = processor.Bus(board.can_socket())
                self.addCleanup(bus.close)
                answered = processor.answers(bus, programs.read_log(LOGS / f"{name}.sensors.log"))
                recorded = [
                    (round(time / programs.CYCLE_S), identifier, data)
                    for time, identifier, data in programs.read_log(LOGS / f"{name}.ecu.log")
                ]
                self.assertEqual(len(answered), len(recorded))
                for mine, wanted in zip(answered, recorded):
                    self.assertEqual(mine, wanted)


if __name__ == "__main__":
    unittest.main()
