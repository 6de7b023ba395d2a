"""rsi-ecu --xcp on the interface, with a master of a few lines: change, store, start again, measure beside the warning."""

import pathlib
import re
import struct
import tempfile
import time
import unittest

import programs

COMMAND, ANSWER = 0x6F0, 0x6F1
ERROR, EVENT, FIRST_ANSWER = 0xFE, 0xFD, 0xFC
OVERLOAD = bytes((EVENT, 0x06))
MAP = (programs.PROJECT / "firmware/rsi/ecu/application/calibration_pages.hpp").read_text()
PARAMETERS_AT, OUTPUTS_AT, CHANGE_AT = (
    int(re.search(rf"{name} = (0x\w+)U;", MAP)[1], 16) for name in ("parameters_at", "outputs_at", "change_at")
)
FIELDS = re.findall(r'\{"(\w+)", &Parameters::', (programs.PROJECT / "firmware/rsi/parameters.hpp").read_text())
LONGEST_ANSWER_S = 10.0  # of a busy machine
MEASURED_S = 3.0
LOWER = 0.85


class Master:
    def __init__(self, opened=programs.can_socket):
        self.socket = opened(f"{ANSWER:X}")
        self.samples, self.events = [], []

    def receive(self, until):
        """The next answer; samples and events on its way are kept. None when there is none until then."""
        while (left := until - time.monotonic()) > 0.0:
            self.socket.settimeout(left)
            try:
                _, length, data = programs.FRAME.unpack(self.socket.recv(programs.FRAME.size))
            except TimeoutError:
                break
            data = data[:length]
            if data[0] < FIRST_ANSWER:
                self.samples.append(data)
            elif data[0] == EVENT:
                self.events.append(data)
            else:
                return data
        return None

    def ask(self, *data, word=None):
        data = bytes(data) + (b"" if word is None else struct.pack("<I", word))
        self.socket.send(programs.FRAME.pack(COMMAND, len(data), data.ljust(8, b"\0")))
        return self.receive(time.monotonic() + LONGEST_ANSWER_S)

    def demand(self, *data, word=None):
        answer = self.ask(*data, word=word)
        if answer is None or answer[0] == ERROR:
            raise AssertionError(f"{bytes(data).hex()} was answered with {answer}")
        return answer

    def unlock(self):
        self.demand(0xFF, 0)
        seed = b"".join(self.demand(0xF8, int(place > 0), 1)[2:] for place in range(3))
        key = programs.test_key("calibration", seed)
        for at in range(0, 16, 6):
            answer = self.demand(0xF7, 16 - at, *key[at:at + 6])
        assert answer[1] == 0, "the slave is not unlocked"

    def read_float(self, name):
        return struct.unpack("<f", self.demand(0xF4, 4, 0, 0, word=PARAMETERS_AT + 4 * FIELDS.index(name))[1:])[0]

    def write_float(self, name, value):
        self.demand(0xF6, 0, 0, 0, word=PARAMETERS_AT + 4 * FIELDS.index(name))
        self.demand(0xF0, 4, *struct.pack("<f", value))

    def change(self):
        """Result of the last change: whether one is on its way, the number of the field that was refused, how many
        have been taken over."""
        answer = self.demand(0xF4, 4, 0, 0, word=CHANGE_AT)
        return answer[2], answer[3], struct.unpack("<I", self.demand(0xF4, 4, 0, 0, word=CHANGE_AT + 4)[1:])[0]

    def measure(self, parts):
        """This number of parts of one float each, in every cycle, with the time in a part of its own."""
        for command in ((0xD6,), (0xD5, 0, 1, 0), (0xD4, 0, 0, 0, parts + 1)):
            self.demand(*command)
        for part in range(1, parts + 1):
            self.demand(0xD3, 0, 0, 0, part, 1)
        for part in range(1, parts + 1):
            self.demand(0xE2, 0, 0, 0, part, 0)
            self.demand(0xE1, 0xFF, 4, 0, word=OUTPUTS_AT + 4 * part)
        self.demand(0xE0, 0x10, 0, 0, 0, 0, 1, 0)
        self.demand(0xDE, 1, 0, 0)
        self.receive(time.monotonic() + MEASURED_S)
        self.demand(0xDD, 0)
        self.receive(time.monotonic() + 1.0)  # the rest of the last cycle, which a busy machine sends behind the answer


def check_samples(test, master, least):
    """Samples of Master.measure(19): that many, each whole, and none lost unreported."""
    stamps = [struct.unpack("<H", sample[1:3])[0] for sample in master.samples if sample[0] == 0]
    test.assertGreater(len(stamps), least)
    numbers = [sample[0] for sample in master.samples]
    test.assertEqual(numbers, list(range(20)) * len(stamps))
    # A cycle is late by less than a period, or others are counted as missed.
    gaps = sum((after - before) % 65536 > 200 for before, after in zip(stamps, stamps[1:]))
    test.assertTrue(gaps == 0 or OVERLOAD in master.events, f"{gaps} gaps, unreported")


class Xcp(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def master(self):
        master = Master()
        self.addCleanup(master.socket.close)
        return master

    def ecu(self):
        return programs.Ecu("--xcp", "--xcp-storage", self.folder.name)

    @programs.repeated_if_machine_stands_still
    def test_changes_stores_and_finds_it_after_a_restart(self):
        with self.ecu():
            master = self.master()
            self.assertEqual(master.ask(0xFF, 0), bytes((0xFF, 5, 0x80, 8, 8, 0, 1, 1)))
            self.assertEqual(programs.protection(), "unsealed test keys")
            self.assertEqual(master.ask(0xF9, 1), bytes((ERROR, 0x25)))  # locked
            master.unlock()
            before = master.read_float("warning_on")
            master.write_float("warning_on", LOWER)
            master.demand(0xF9, 1)
            self.assertNotAlmostEqual(before, LOWER)
        self.assertTrue((pathlib.Path(self.folder.name) / "xcp_parameters_1.bin").is_file())
        with self.ecu() as ecu:
            self.assertIn(", with what XCP has stored in", ecu.output)
            master = self.master()
            master.demand(0xFF, 0)
            self.assertAlmostEqual(master.read_float("warning_on"), LOWER, places=6)

    @programs.repeated_if_machine_stands_still
    def test_measures_beside_the_warning(self):
        with self.ecu():
            master = self.master()
            master.unlock()
            master.measure(19)
        check_samples(self, master, least=50 * MEASURED_S)

    @programs.repeated_if_machine_stands_still
    def test_without_the_option_no_request_is_answered(self):
        with programs.Ecu():
            self.assertEqual(programs.protection(), "unsealed")
            master = self.master()
            master.socket.send(programs.FRAME.pack(COMMAND, 2, bytes((0xFF, 0)).ljust(8, b"\0")))
            self.assertIsNone(master.receive(time.monotonic() + 0.5))


if __name__ == "__main__":
    unittest.main()
