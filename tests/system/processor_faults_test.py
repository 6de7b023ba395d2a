"""The Cortex-R5F's image under QEMU on a CAN interface: what it does when an exception or the watchdog ends its run."""

import threading
import time
import unittest

import processor
import programs

UNAVAILABLE, READY = 0, 1
PROVOCATION_IDENTIFIER = "7F0"
WARNING_DATA_IDENTIFIER = 0x61E
IMAGE = programs.PROJECT / "build/cortex-r5f/images/zynqmp_r5/rsi-ecu-r5f-faults.elf"


class Sensors:
    """A straight drive from a recorded log, over and over, in real time."""

    # As many cycles as the counters of the end-to-end protection come round in, so that no jump is seen.
    CYCLES = 300

    def __init__(self):
        log = programs.read_log(programs.PROJECT / "tests/regression/logs/straight-noise.sensors.log")
        self.cycles = processor.cycles_of(log)
        self.ended = threading.Event()
        self.thread = threading.Thread(target=self._send)

    def _send(self):
        bus = processor.Bus()
        start = time.monotonic()
        number = 0
        while not self.ended.wait(max(0.0, start + number * processor.CYCLE_S - time.monotonic())):
            for identifier, data in self.cycles[number % self.CYCLES]:
                bus.send(identifier, data)
            number += 1
        bus.close()

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.ended.set()
        self.thread.join()


def counter_of(data):
    return int(data[3], 16)


def has_right_checksum(data):
    """AUTOSAR profile 11: CRC-8 with the polynomial 0x1D over the data identifier's low byte, a zero and the payload."""
    remainder = 0
    for byte in bytes((WARNING_DATA_IDENTIFIER & 0xFF, 0)) + bytes.fromhex(data)[1:]:
        remainder ^= byte
        for _ in range(8):
            remainder = (remainder << 1) ^ (0x11D if remainder & 0x80 else 0)
    return remainder == int(data[:2], 16)


class Faults(unittest.TestCase):
    """One emulator for all: every fault ends in a reset, and the next one waits until the firmware is ready again."""

    @classmethod
    def setUpClass(cls):
        cls.enterClassContext(processor.Processor("--image", IMAGE))
        cls.enterClassContext(Sensors())
        cls.bus = processor.Bus()
        cls.addClassCleanup(cls.bus.close)

    def warnings(self, deadline_s=60.0):
        """What the ECU sends, one (frames before it, data) for each warning frame."""
        between = []
        deadline = time.monotonic() + deadline_s
        while time.monotonic() < deadline:
            identifier, data = self.bus.receive()
            if identifier == programs.WARNING_IDENTIFIER:
                yield between, data
                between = []
            elif identifier in processor.ECU_IDENTIFIERS:
                between.append(identifier)
        self.fail("the firmware was not seen to do what it should in time")

    def wait_until_ready(self):
        # The counter is in the middle, so that its start at zero after the reset is no ordinary step.
        for _, data in self.warnings():
            if programs.state_of(data) == READY and counter_of(data) == 4:
                return

    def provoke(self, code):
        """The last warning frame before the reset, the frames that follow it, and the first one after the reset."""
        self.wait_until_ready()
        self.bus.send(PROVOCATION_IDENTIFIER, f"{code:02X}")
        last = None
        for between, data in self.warnings():
            if last and counter_of(data) != (counter_of(last) + 1) % 15:
                return last, between, data
            last = data

    def check_restart(self, first):
        self.assertEqual(counter_of(first), 0)
        self.assertEqual(programs.state_of(first), UNAVAILABLE)
        self.wait_until_ready()

    def check_exception(self, code):
        last, after_it, first = self.provoke(code)
        self.assertEqual(programs.state_of(last), UNAVAILABLE)
        self.assertTrue(has_right_checksum(last), last)
        self.assertEqual(after_it, [], "the run went on after the fault")
        self.check_restart(first)

    def test_a_read_from_nowhere_is_a_data_abort(self):
        self.check_exception(1)

    def test_a_write_to_the_code_is_a_data_abort(self):
        self.check_exception(2)

    def test_an_undefined_instruction(self):
        self.check_exception(3)

    def test_a_supervisor_call_that_nobody_makes(self):
        self.check_exception(4)

    def test_execution_of_data_is_a_prefetch_abort(self):
        self.check_exception(5)

    def test_a_stack_overflow_ends_in_the_guard(self):
        self.check_exception(6)

    def test_a_hang_is_ended_by_the_watchdog(self):
        # The processor can say nothing any more: silence, which a receiver takes for "unavailable", then the reset.
        last, _, first = self.provoke(7)
        self.assertTrue(has_right_checksum(last), last)
        self.check_restart(first)


if __name__ == "__main__":
    unittest.main()
