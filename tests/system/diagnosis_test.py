"""rsi-ecu --diagnosis on the interface, with a tester of a few lines on a raw socket, and by the kernel's ISO-TP: session, key,
codes, restart."""

import pathlib
import socket
import struct
import tempfile
import time
import unittest

import programs

PHYSICAL, FUNCTIONAL, ANSWER = 0x7A6, 0x7DF, 0x7AE
SINGLE, FIRST, CONSECUTIVE, FLOW_CONTROL = range(4)  # kinds of frame of ISO-TP
REFUSED, PENDING = 0x7F, 0x78
CLEAR = (0x14, b"\xFF\xFF\xFF")  # all codes
EXTENDED = 0x03
FAILS_NOW, CONFIRMED = 0x01, 0x08
IMU_LOST = bytes.fromhex("D12087")
STORED_PARAMETERS_REFUSED = bytes.fromhex("521746")
VEHICLE_NUMBER = b"WVWZZZ1JZXW000001"
LONGEST_ANSWER_S = 10.0  # of a busy machine
LONGEST_MISSED_S = 60.0  # until a missing sensor is a code: 1 s of the ECU's cycles


class Tester:
    def __init__(self, opened=programs.can_socket):
        self.socket = opened(f"{ANSWER:X}")

    def send_frame(self, data, identifier=PHYSICAL):
        self.socket.send(programs.FRAME.pack(identifier, 8, bytes(data).ljust(8, b"\xCC")))

    def receive_frame(self, within=LONGEST_ANSWER_S):
        self.socket.settimeout(within)
        _, length, data = programs.FRAME.unpack(self.socket.recv(programs.FRAME.size))
        return data[:length]

    def send(self, message):
        if len(message) < 8:
            self.send_frame(bytes((len(message),)) + message)
            return
        self.send_frame(struct.pack(">H", FIRST << 12 | len(message)) + message[:6])
        control = self.receive_frame()
        assert control[0] == FLOW_CONTROL << 4, f"no permission to go on: {control.hex()}"
        for number, at in enumerate(range(6, len(message), 7), 1):
            self.send_frame(bytes((CONSECUTIVE << 4 | number % 16,)) + message[at:at + 7])

    def receive(self):
        frame = self.receive_frame()
        if frame[0] >> 4 == SINGLE:
            return frame[1:1 + frame[0]]
        assert frame[0] >> 4 == FIRST, f"an answer begins with {frame.hex()}"
        length = struct.unpack(">H", frame[:2])[0] & 0xFFF
        message, number = frame[2:], 1
        self.send_frame((FLOW_CONTROL << 4, 0, 0))
        while len(message) < length:
            frame = self.receive_frame()
            assert frame[0] == CONSECUTIVE << 4 | number % 16, f"frame {number} of an answer is {frame.hex()}"
            message, number = message + frame[1:], number + 1
        return message[:length]

    def ask(self, *request):
        """The answer to a request of bytes and numbers, when the ECU no longer says that it is pending."""
        message = b"".join(part if isinstance(part, bytes) else bytes((part,)) for part in request)
        self.send(message)
        answer = self.receive()
        while answer == bytes((REFUSED, message[0], PENDING)):
            answer = self.receive()
        return answer

    def unlock(self):
        self.ask(0x10, EXTENDED)
        seed = self.ask(0x27, 0x01)[2:]
        return self.ask(0x27, 0x02, programs.test_key("diagnosis", seed))

    def confirmed(self):
        """The confirmed codes, with their status."""
        answer = self.ask(0x19, 0x02, CONFIRMED)
        assert answer[:2] == bytes((0x59, 0x02)), answer.hex()
        return {answer[at:at + 3]: answer[at + 3] for at in range(3, len(answer), 4)}

    def first_failed_s(self, code):
        """When the code failed first since it was cleared, in seconds after the start; None: it has not."""
        answer = self.ask(0x19, 0x04, code, 0x01)
        assert answer[:5] == b"\x59\x04" + code, answer.hex()
        return struct.unpack(">H", answer[18:20])[0] if len(answer) > 6 else None

    def codes_with(self, code, status=CONFIRMED):
        """The confirmed codes, once this one is among them with all bits of `status`."""
        end = time.monotonic() + LONGEST_MISSED_S
        while (codes := self.confirmed()).get(code, 0) & status != status:
            assert time.monotonic() < end, f"{code.hex()} is none of {codes}"
        return codes


class KernelTester(Tester):
    """The same requests by Linux' own ISO-TP, which does not fill its frames up."""

    def __init__(self):
        self.socket = socket.socket(socket.AF_CAN, socket.SOCK_DGRAM, socket.CAN_ISOTP)
        self.socket.bind((programs.INTERFACE, ANSWER, PHYSICAL))
        self.socket.settimeout(LONGEST_ANSWER_S)

    def send(self, message):
        self.socket.send(message)

    def receive(self):
        return self.socket.recv(4095)


def refused(service, code):
    return bytes((REFUSED, service, code))


def check_cleared(test, tester):
    """By a tester who is unlocked: the sensors are still missing, so the code fails anew, and this is then its first time."""
    before = tester.first_failed_s(IMU_LOST)
    end = time.monotonic() + LONGEST_MISSED_S
    while True:
        test.assertEqual(tester.ask(*CLEAR), b"\x54")
        tester.codes_with(IMU_LOST)
        if tester.first_failed_s(IMU_LOST) > before:
            return
        test.assertLess(time.monotonic(), end, "a code that was cleared is as old as before")


class Diagnosis(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.options = ("--diagnosis", "--diagnosis-storage", folder.name)

    def workshop(self, kind=Tester):
        tester = kind()
        self.addCleanup(tester.socket.close)
        return tester

    @programs.repeated_if_machine_stands_still
    def test_reads_and_clears_codes_with_the_key_and_keeps_what_is_written(self):
        with programs.Ecu(*self.options):
            self.assertEqual(programs.protection(), "unsealed test keys")
            tester = self.workshop()
            tester.codes_with(IMU_LOST, FAILS_NOW | CONFIRMED)
            self.assertEqual(tester.ask(*CLEAR), refused(0x14, 0x7F))
            self.assertEqual(tester.ask(0x27, 0x01), refused(0x27, 0x7F))
            self.assertEqual(tester.ask(0x10, EXTENDED), bytes.fromhex("5003003201F4"))
            self.assertEqual(len(tester.ask(0x27, 0x01)), 18)
            self.assertEqual(tester.ask(0x27, 0x02, bytes(16)), refused(0x27, 0x35))
            self.assertEqual(tester.ask(*CLEAR), refused(0x14, 0x33))
            self.assertEqual(tester.unlock(), b"\x67\x02")
            self.assertEqual(tester.ask(0x85, 0x02), refused(0x85, 0x22))  # the vehicle is not known to rest
            check_cleared(self, tester)
            self.assertEqual(tester.ask(0x2E, b"\xF1\x90" + VEHICLE_NUMBER), b"\x6E\xF1\x90")
        with programs.Ecu(*self.options):
            self.assertEqual(self.workshop().ask(0x22, b"\xF1\x90"), b"\x62\xF1\x90" + VEHICLE_NUMBER)

    @programs.repeated_if_machine_stands_still
    def test_reports_a_stored_section_that_it_cannot_use(self):
        (pathlib.Path(self.options[-1]) / "parameters_1.bin").write_bytes(b"RSIP")
        with programs.Ecu(*self.options) as ecu:
            self.assertIn("the section that was stored is not used: its CRC-32 is wrong", ecu.output)
            self.workshop().codes_with(STORED_PARAMETERS_REFUSED, FAILS_NOW | CONFIRMED)

    @programs.repeated_if_machine_stands_still
    def test_understands_the_kernels_iso_tp(self):
        many = b"\xF1\x82\xF1\x91\xF1\x95\xF1\x97"
        with programs.Ecu(*self.options):
            tester = self.workshop(KernelTester)
            answer = tester.ask(0x22, many)
            self.assertEqual((answer[:3], len(answer)), (b"\x62\xF1\x82", 1 + 4 * 2 + 48 + 3 * 16))
            self.assertIn(b"large_suv", answer)
            self.assertIn(IMU_LOST, tester.codes_with(IMU_LOST))
            self.assertEqual(tester.unlock(), b"\x67\x02")
            self.assertEqual(tester.ask(0x2E, b"\xF1\x90" + VEHICLE_NUMBER), b"\x6E\xF1\x90")
            self.assertEqual(tester.ask(0x22, b"\xF1\x90"), b"\x62\xF1\x90" + VEHICLE_NUMBER)

    @programs.repeated_if_machine_stands_still
    def test_a_reset_by_the_tester_ends_his_session(self):
        with programs.Ecu(*self.options) as ecu:
            tester = self.workshop()
            self.assertEqual(tester.unlock(), b"\x67\x02")
            self.assertEqual(tester.ask(0x11, 0x01), b"\x51\x01")
            self.assertEqual(tester.ask(0x22, b"\xF1\x86"), b"\x62\xF1\x86\x01")
            self.assertEqual(tester.ask(*CLEAR), refused(0x14, 0x7F))
            self.assertEqual(tester.ask(0x10, EXTENDED)[:2], bytes((0x50, EXTENDED)))
            self.assertEqual(tester.ask(*CLEAR), refused(0x14, 0x33))  # the key is gone, too
            self.assertEqual(ecu.stop(), 0)
        self.assertIn("a tester resets it", ecu.output)

    @programs.repeated_if_machine_stands_still
    def test_without_the_option_no_request_is_answered(self):
        with programs.Ecu():
            tester = self.workshop()
            for identifier in (PHYSICAL, FUNCTIONAL):
                tester.send_frame((2, 0x3E, 0x00), identifier)
            with self.assertRaises(TimeoutError):
                tester.receive_frame(within=0.5)


if __name__ == "__main__":
    unittest.main()
