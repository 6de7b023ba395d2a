"""The Cortex-R5F's image under QEMU, with a bus of its own: what it does when an exception or the watchdog ends its run."""

import itertools
import time
import unittest

import processor
import programs

UNAVAILABLE, READY = 0, 1
PROVOCATION_IDENTIFIER = "7F0"
OBSERVER_IDENTIFIER = "234"
WARNING_DATA_IDENTIFIER = 0x61E
IMAGE = processor.CORTEX_R5F / "tests/targets/images/zynqmp_r5_faults/rsi-ecu-r5f-faults.elf"
SENSOR_LOG = programs.PROJECT / "tests/application/regression/logs/straight-noise.sensors.log"
# Cycles of the log after which the counters of its end-to-end protection go on at its beginning without a jump.
SENSOR_CYCLES = 300


def counter_of(data):
    return int(data[3], 16)


def reset_reason_of(data):
    """RollObserver.ResetReason: four bits from bit 55 on, the least first."""
    return int.from_bytes(bytes.fromhex(data), "little") >> 55 & 0xF


def has_right_checksum(data):
    """AUTOSAR profile 11: CRC-8 with the polynomial 0x1D over the data identifier's low byte, a zero and the payload."""
    remainder = 0
    for byte in bytes((WARNING_DATA_IDENTIFIER & 0xFF, 0)) + bytes.fromhex(data)[1:]:
        remainder ^= byte
        for _ in range(8):
            remainder = (remainder << 1) ^ (0x11D if remainder & 0x80 else 0)
    return remainder == int(data[:2], 16)


def sensor_cycles():
    """The frames of one cycle after the other, without end."""
    cycles = processor.cycles_of(programs.read_log(SENSOR_LOG))
    return itertools.cycle([cycles[number] for number in range(SENSOR_CYCLES)])


class Faults(unittest.TestCase):
    """One emulator for all: every fault ends in a reset, after which the firmware is there for the next."""

    # Sensor frames go out when the firmware has ended a cycle, never ahead of it: QEMU 7.2 breaks when frames fill the
    # controller's FIFO while the processor is in the midst of reading one.
    sensors = None

    @classmethod
    def setUpClass(cls):
        board = cls.enterClassContext(processor.Board(IMAGE))
        cls.bus = processor.Bus(
            board.can_socket(programs.WARNING_IDENTIFIER, OBSERVER_IDENTIFIER, programs.STATUS_IDENTIFIER)
        )
        cls.addClassCleanup(cls.bus.close)

    def frames(self):
        deadline = time.monotonic() + programs.LONGEST_S
        while time.monotonic() < deadline:
            identifier, data = self.bus.receive()
            if self.sensors and identifier == programs.STATUS_IDENTIFIER:
                for frame in next(self.sensors):
                    self.bus.send(*frame)
            yield identifier, data
        self.fail("the firmware was not seen to do what it should in time")

    def wait_for_warning(self, state=None):
        """Until a warning frame whose counter is so that a start at zero is no ordinary step, even a few cycles later."""
        for identifier, data in self.frames():
            if identifier == programs.WARNING_IDENTIFIER and counter_of(data) == 4:
                if state is None or programs.state_of(data) == state:
                    return data

    def provoke(self, code, last):
        """After the warning frame `last`: the last one before the reset, what followed it, the first one after it, the reason it then gives."""
        self.bus.send(PROVOCATION_IDENTIFIER, f"{code:02X}")
        after_it, first = [], None
        for identifier, data in self.frames():
            if first and identifier == OBSERVER_IDENTIFIER:
                return last, after_it, first, reset_reason_of(data)
            if identifier != programs.WARNING_IDENTIFIER:
                after_it.append(identifier)
            elif counter_of(data) != (counter_of(last) + 1) % 15 or not after_it:  # a busy machine comes late to `last`
                first = data
            else:
                last, after_it = data, []

    def check_start(self, first):
        self.assertEqual(counter_of(first), 0)
        self.assertEqual(programs.state_of(first), UNAVAILABLE)

    def check_exception(self, code, reason, state_before=None):
        before = self.wait_for_warning(state_before)
        last, after_it, first, reason_given = self.provoke(code, before)
        self.assertNotEqual(last, before)
        self.assertEqual(programs.state_of(last), UNAVAILABLE)
        self.assertTrue(has_right_checksum(last), last)
        self.assertEqual(after_it, [], "more of the cycle than the warning was sent")
        self.check_start(first)
        self.assertEqual(reason_given, reason)

    def test_a_read_from_nowhere_is_a_data_abort(self):
        self.check_exception(1, reason=5)

    def test_a_write_to_the_code_is_a_data_abort(self):
        self.check_exception(2, reason=5)

    def test_an_undefined_instruction(self):
        self.check_exception(3, reason=2)

    def test_an_unexpected_supervisor_call(self):
        self.check_exception(4, reason=3)

    def test_execution_of_data_is_a_prefetch_abort(self):
        self.check_exception(5, reason=4)

    def test_a_stack_overflow_ends_in_the_guard(self):
        self.check_exception(6, reason=6)

    def test_a_call_of_a_null_pointer_is_a_start_without_reset(self):
        self.check_exception(8, reason=8)

    def test_a_hang_is_ended_by_the_watchdog(self):
        # The processor can say nothing any more: silence, which a receiver takes for "unavailable", then the reset.
        last, _, first, reason = self.provoke(7, self.wait_for_warning())
        self.assertTrue(has_right_checksum(last), last)
        self.check_start(first)
        self.assertEqual(reason, 1)

    def test_a_fault_while_ready_says_unavailable_and_the_firmware_comes_back(self):
        self.sensors = sensor_cycles()
        self.check_exception(1, reason=5, state_before=READY)
        self.wait_for_warning(READY)


if __name__ == "__main__":
    unittest.main()
