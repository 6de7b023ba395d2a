"""use: libraries_test.py XCP_LIBRARY UDS_LIBRARY ECU_DRIVE A2L"""

import ctypes
import pathlib
import re
import sys
import unittest

sys.dont_write_bytecode = True
XCP, UDS, PROGRAM, A2L = sys.argv[1:5]
del sys.argv[1:]
PROJECT = pathlib.Path(__file__).resolve().parents[4]
sys.path[:0] = [str(PROJECT / "sil/tools"), str(PROJECT / "cmake/environment")]

import simulated_bus  # noqa: E402

CALIBRATION, MEASUREMENT, PROGRAMMING = 0x01, 0x04, 0x10
ROOM = 255


def key_of_xcp(seed, privilege=CALIBRATION, room=ROOM):
    """The answer's number and the key, which is empty after a refusal."""
    key, length = ctypes.create_string_buffer(ROOM), ctypes.c_uint8(room)
    answer = ctypes.CDLL(XCP).XCP_ComputeKeyFromSeed(
        ctypes.c_uint8(privilege), ctypes.c_uint8(len(seed)), bytes(seed), ctypes.byref(length), key)
    return answer, key.raw[:length.value] if answer == 0 else b""


def key_of_uds(seed, level=1, room=ROOM):
    key, length = ctypes.create_string_buffer(ROOM), ctypes.c_uint(0)
    answer = ctypes.CDLL(UDS).GenerateKeyEx(bytes(seed), ctypes.c_uint(len(seed)), ctypes.c_uint(level), b"", key,
                                            ctypes.c_uint(room), ctypes.byref(length))
    return answer, key.raw[:length.value]


class Libraries(unittest.TestCase):
    def setUp(self):
        self.bus = simulated_bus.SimulatedBus(PROGRAM)
        self.addCleanup(self.bus.end)
        self.bus.drive(simulated_bus.BENCH)

    def xcp(self, *command):
        self.bus.ask(bytes(command))
        return bytes(self.bus.answers.get_nowait().data)

    def seed_of_xcp(self, resource):
        self.xcp(0xFF, 0)
        return b"".join(self.xcp(0xF8, int(part > 0), resource)[2:] for part in range(3))

    def locked_after(self, key):
        for at in range(0, 16, 6):
            answer = self.xcp(0xF7, 16 - at, *key[at:at + 6])
        return answer

    def test_the_firmware_takes_the_key_of_xcp(self):
        for resource in (CALIBRATION, MEASUREMENT):
            seed = self.seed_of_xcp(resource)
            answer, key = key_of_xcp(seed, resource)
            self.assertEqual((answer, len(seed), len(key)), (0, 16, 16))
            self.assertEqual(self.locked_after(key), b"\xFF\x00", "a resource is still locked")
        key = bytearray(key_of_xcp(self.seed_of_xcp(CALIBRATION))[1])
        key[15] ^= 1
        self.assertEqual(self.locked_after(key)[0], 0xFE)

    def test_the_firmware_takes_the_key_of_uds(self):
        tester = simulated_bus.IsoTpConnection(self.bus, 0x7A6, 0x7AE)

        def ask(*request):
            tester.send(bytes(request))
            return tester.wait_frame(timeout=2)

        ask(0x10, 0x03)
        for wrong in (1, 0):
            seed = ask(0x27, 0x01)[2:]
            answer, key = key_of_uds(seed)
            self.assertEqual((answer, len(seed), len(key)), (0, 16, 16))
            self.assertEqual(ask(0x27, 0x02, key[0] ^ wrong, *key[1:]), b"\x7F\x27\x35" if wrong else b"\x67\x02")

    def test_a_request_without_an_answer_is_refused_by_its_number(self):
        seed = bytes(16)
        self.assertEqual(key_of_xcp(seed, PROGRAMMING), (1, b""))
        self.assertEqual(key_of_xcp(seed[1:]), (2, b""))
        self.assertEqual(key_of_xcp(seed, room=15), (3, b""))
        self.assertEqual(key_of_uds(seed, room=15), (1, b""))
        self.assertEqual(key_of_uds(seed, level=3), (2, b""))
        self.assertEqual(key_of_uds(seed[1:]), (4, b""))
        privileges = ctypes.c_uint8(0)
        self.assertEqual(ctypes.CDLL(XCP).XCP_GetAvailablePrivileges(ctypes.byref(privileges)), 0)
        self.assertEqual(privileges.value, CALIBRATION | MEASUREMENT)

    def test_the_a2l_names_the_library_that_build_writes(self):
        named = re.search(r'SEED_AND_KEY_EXTERNAL_FUNCTION "(.*)"', pathlib.Path(A2L).read_text())[1]
        self.assertIn(f"/{named}\"", (PROJECT / "sil/exchange/seed_and_key/build").read_text())


if __name__ == "__main__":
    unittest.main()
