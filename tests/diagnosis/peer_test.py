"""A tester of other authors, udsoncan over can-isotp, against the server: every service, as a workshop uses it.

use: peer_test.py ECU_ON_A_PIPE SECTION_IN_C
"""

import pathlib
import re
import sys
import tempfile
import unittest

from udsoncan import DataFormatIdentifier, MemoryLocation, services
from udsoncan.exceptions import NegativeResponseException

import pipe_tester

PROGRAM, SECTION = "", b""
IMU_LOST = 0xD12087
FAILED_NOW = 0x2F



class Peer(unittest.TestCase):
    stack = {}

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.ecu = pipe_tester.Ecu(PROGRAM, folder.name)
        self.addCleanup(lambda: self.ecu.close())
        self.connection = pipe_tester.PipeConnection(self.ecu, **self.stack)
        self.client = pipe_tester.client(self.connection)
        self.ecu.run(250)  # long enough to miss the sensors

    def unlock(self, session=services.DiagnosticSessionControl.Session.extendedDiagnosticSession):
        self.client.change_session(session)
        self.client.unlock_security_access(1)

    def codes(self, mask=0x08):
        return {code.id: code.status.get_byte_as_int() for code in
                self.client.get_dtc_by_status_mask(mask).service_data.dtcs}

    def refused(self, call, code):
        with self.assertRaises(NegativeResponseException) as caught:
            call()
        self.assertEqual(caught.exception.response.code, code)

    def test_times_of_a_session(self):
        answer = self.client.change_session(3).service_data
        self.assertEqual(answer.session_echo, 3)
        self.assertAlmostEqual(answer.p2_server_max, 0.05)
        self.assertAlmostEqual(answer.p2_star_server_max, 5.0)

    def test_codes_with_snapshots_and_counts(self):
        codes = self.codes()
        self.assertEqual(codes[IMU_LOST], FAILED_NOW)
        self.assertEqual(self.client.get_number_of_dtc_by_status_mask(0x08).service_data.dtc_count, len(codes))
        supported = self.client.get_supported_dtc().service_data
        self.assertEqual(supported.dtc_count, 50)
        self.assertTrue(set(codes) <= {code.id for code in supported.dtcs})
        snapshot = self.client.get_dtc_snapshot_by_dtc_number(IMU_LOST, 0xFF).service_data.dtcs[0]
        self.assertEqual([each.record_number for each in snapshot.snapshots], [1, 2])
        lateral, _, _, _, seconds = snapshot.snapshots[0].data
        self.assertEqual((lateral, seconds), (-32768, 1), "no sensor, and it was missed after a second")
        extended = self.client.get_dtc_extended_data_by_dtc_number(IMU_LOST, 1, data_size=1).service_data.dtcs[0]
        self.assertEqual(extended.extended_data[0].raw_data, b"\x01")

    def test_codes_outlive_a_loss_of_power(self):
        before = self.codes()
        self.ecu.loses_power()
        self.ecu.run(1)
        after = self.codes()
        self.assertEqual(set(after), set(before))
        self.assertEqual(after[IMU_LOST] & 0x0F, 0x0C, "confirmed and pending, and not yet failed again")

    def test_clearing(self):
        self.refused(lambda: self.client.clear_dtc(0xFFFFFF), 0x33)
        self.unlock()
        self.client.control_dtc_setting(services.ControlDTCSetting.SettingType.off)
        self.client.clear_dtc(0xFFFFFF)
        self.assertEqual(self.codes(), {})
        self.client.control_dtc_setting(services.ControlDTCSetting.SettingType.on)
        self.assertEqual(self.codes()[IMU_LOST], FAILED_NOW)

    def test_identification_and_values(self):
        values = self.client.read_data_by_identifier([0xF182, 0xF195, 0xF197, 0xF186, 0x1000]).service_data.values
        self.assertEqual(values[0xF182], "large_suv")
        self.assertEqual(values[0xF197], "Rollover warning")
        self.assertEqual(values[0xF186], (1,))
        self.assertNotEqual(values[0x1000][0], values[0x1000][0], "without sensors there is no warning level: NaN")
        self.ecu.say("speed 12.5")
        self.ecu.run(10)
        self.assertAlmostEqual(self.client.read_data_by_identifier(0x1206).service_data.values[0x1206][0], 12.5, delta=0.1)

    def test_writing_the_vehicle_number(self):
        self.unlock()
        self.client.write_data_by_identifier(0xF190, "WVWZZZ1JZXW000001")
        self.ecu.loses_power()
        self.assertEqual(self.client.read_data_by_identifier(0xF190).service_data.values[0xF190], "WVWZZZ1JZXW000001")

    def test_wrong_keys(self):
        self.client.change_session(3)
        for code in (0x35, 0x35, 0x36):
            self.client.request_seed(1)
            self.refused(lambda: self.client.send_key(2, bytes(16)), code)
        self.refused(lambda: self.client.request_seed(1), 0x37)
        self.ecu.loses_power()
        self.client.change_session(3)
        self.refused(lambda: self.client.request_seed(1), 0x37)

    def test_self_test(self):
        self.client.change_session(3)
        self.client.start_routine(0x0203)
        self.assertEqual(self.client.get_routine_result(0x0203).service_data.routine_status_record, b"\x00")

    def test_silence_of_the_ecu_at_rest_only(self):
        self.client.change_session(3)
        silent = services.CommunicationControl.ControlType.enableRxAndDisableTx
        self.refused(lambda: self.client.communication_control(silent, 1), 0x22)
        self.ecu.say("speed 0")
        self.ecu.run(10)
        self.client.communication_control(silent, 1)
        self.ecu.say("speed 20")
        self.ecu.run(10)
        self.refused(lambda: self.client.communication_control(silent, 1), 0x22)

    def test_reset(self):
        self.client.change_session(3)
        self.client.ecu_reset(services.ECUReset.ResetType.hardReset)
        self.ecu.run(2)
        self.assertEqual(self.ecu.resets, 1)
        self.assertEqual(self.client.read_data_by_identifier(0xF186).service_data.values[0xF186], (1,))

    def test_tester_present_keeps_a_session(self):
        self.client.change_session(3)
        for _ in range(3):
            self.ecu.run(400)
            with self.client.suppress_positive_response:
                self.client.tester_present()
            self.ecu.run(5)  # P3: after a request that is not answered a tester waits
        self.assertEqual(self.client.read_data_by_identifier(0xF186).service_data.values[0xF186], (3,))
        self.ecu.run(510)
        self.assertEqual(self.client.read_data_by_identifier(0xF186).service_data.values[0xF186], (1,))

    def download(self, section):
        location = MemoryLocation(address=0, memorysize=len(section), address_format=8, memorysize_format=16)
        answer = self.client.request_download(location, DataFormatIdentifier(compression=0, encryption=0))
        size = answer.service_data.max_length - 2
        for number, at in enumerate(range(0, len(section), size), start=1):
            self.client.transfer_data(number, section[at:at + size])
        self.client.request_transfer_exit()
        return self.client.start_routine(0xFF01).service_data.routine_status_record

    def test_download_of_a_section(self):
        self.unlock(services.DiagnosticSessionControl.Session.programmingSession)
        damaged = bytearray(SECTION)
        damaged[100] ^= 1
        self.assertEqual(self.download(bytes(damaged)), b"\x05", "checksum, as ParametersRefusal has it")
        self.assertEqual(self.download(SECTION), b"\x00")


class WithBlocksAndGaps(Peer):
    """The tester asks for blocks and for time between frames."""
    stack = {"blocksize": 3, "stmin": 5}


class WithShortGaps(Peer):
    stack = {"blocksize": 1, "stmin": 0xF5, "tx_padding": 0x55}


def section_of(source):
    text = pathlib.Path(source).read_text(encoding="utf-8")
    return bytes(int(each, 16) for each in re.findall(r"0x([0-9A-F]{2})\b", text))


if __name__ == "__main__":
    PROGRAM, SECTION = sys.argv[1], section_of(sys.argv[2])
    assert len(SECTION) == 340, "the section in C is not read as it is written now"
    unittest.main(argv=sys.argv[:1])
