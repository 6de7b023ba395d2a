"""The Cortex-R5F's image under QEMU by itself, on a machine that does nothing else: a hundred cycles a second.

Requirements on every machine: processor_off_line_test.py."""

import time
import unittest

import processor_off_line_test
import programs


class Pace(processor_off_line_test.Image):
    def test_a_hundred_cycles_a_second(self):
        # A window in which the machine was busy says nothing about the pace; but in each, a cycle is kept or counted.
        with self.running(self.good) as sent:
            statuses = self.wait_for_cycles(sent, 50)  # slow at first: the emulator translates the code
            least_missed = 1.0
            for _ in range(6):
                before, begin = statuses, time.monotonic()
                statuses = self.wait_for_cycles(sent, len(before) + 150)
                elapsed = (time.monotonic() - begin) / programs.CYCLE_S
                cycles = len(statuses) - len(before)
                if programs.cycle_overruns_of(statuses[-1]) >= programs.MOST_OVERRUNS:
                    self.fail("this machine is too busy for real time: so many cycles were missed that the count has ended")
                missed = programs.cycle_overruns_of(statuses[-1]) - programs.cycle_overruns_of(before[-1])
                print(f"{cycles} cycles kept, {missed} missed, in {elapsed:.1f} periods")
                self.assertAlmostEqual(cycles + missed, elapsed, delta=8.0)
                least_missed = min(least_missed, missed / cycles)
                if least_missed <= 0.02:
                    break
        # The time of a busy machine varies; an image that is too slow loses a cycle in two, whatever the machine does.
        self.assertLess(least_missed, 0.3, "no window of 150 cycles kept the pace")


if __name__ == "__main__":
    unittest.main()
