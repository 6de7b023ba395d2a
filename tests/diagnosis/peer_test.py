"""Testers against the server: udsoncan over can-isotp, of other authors, with every service as a uds_client uses it; the
commands of sil/tools/diagnosis; and the ODX of the ECU, read back by odxtools.

use: peer_test.py ECU_ON_A_PIPE ODX_TABLE SECTION_IN_C
"""

import contextlib
import io

import pathlib
import re
import struct
import sys
import tempfile
import unittest
import zlib

import odxtools
from cryptography.hazmat.primitives import cmac
from cryptography.hazmat.primitives.ciphers import algorithms
from odxtools.variantmatcher import VariantMatcher
from udsoncan import services
from udsoncan.exceptions import NegativeResponseException

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parents[1]
sys.path[:0] = [str(PROJECT / "sil/tools"), str(PROJECT / "cmake/environment")]

import odx
import odx_tables
import pipe_tester
import simulated_bus
import uds_client
from log_error import LogError

PROGRAM, SECTION, TABLES = "", b"", None
IMU_LOST = 0xD12087
FAILED_NOW = 0x2F
PENDING = "ResponsePending"



class Peer(unittest.TestCase):
    stack = {}

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.ecu = pipe_tester.Ecu(PROGRAM, self.folder.name)
        self.addCleanup(lambda: self.ecu.close())
        self.connection = simulated_bus.IsoTpConnection(self.ecu, pipe_tester.PHYSICAL, pipe_tester.RESPONSE, **self.stack)
        self.client = uds_client.client(self.connection, TABLES)
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
        self.assertEqual(supported.dtc_count, len(TABLES.codes))
        self.assertTrue(set(codes) <= {code.id for code in supported.dtcs})
        snapshot = self.client.get_dtc_snapshot_by_dtc_number(IMU_LOST, 0xFF).service_data.dtcs[0]
        self.assertEqual([each.record_number for each in snapshot.snapshots], [1, 2])
        lateral, _, _, _, seconds, cycle, checksum = snapshot.snapshots[0].data
        self.assertEqual((lateral, seconds), (-32768, 1), "no sensor, and it was missed after a second")
        self.assertEqual((cycle, checksum), (1, uds_client.checksum_in_use(self.client, TABLES)))
        extended = self.client.get_dtc_extended_data_by_dtc_number(IMU_LOST, 1, data_size=1).service_data.dtcs[0]
        self.assertEqual(extended.extended_data[0].raw_data, b"\x01")

    def test_counters_of_codes_that_are_about_to_fail(self):
        counters = lambda: {TABLES.codes[each.id]: each.fault_counter
                            for each in self.client.get_dtc_fault_counter().service_data.dtcs}
        self.assertEqual(counters(), {})
        self.ecu.say("speed 0")  # and neither yaw rate nor steering, which fail after three cycles
        self.ecu.run(1)
        self.assertEqual(counters(), {"yaw rate invalid": 84, "steering invalid": 84})
        self.ecu.run(5)
        self.assertEqual(counters(), {}, "confirmed")

    def test_codes_outlive_a_loss_of_power(self):
        before = self.codes()
        self.ecu.loses_power()
        self.ecu.run(1)
        after = self.codes()
        self.assertEqual(set(after), set(before))
        self.assertEqual(after[IMU_LOST] & 0x0F, 0x0C, "confirmed and pending, and not yet failed again")

    def test_clearing(self):
        self.refused(lambda: self.client.clear_dtc(0xFFFFFF), 0x7F)
        self.client.change_session(3)
        self.refused(lambda: self.client.clear_dtc(0xFFFFFF), 0x33)
        self.unlock()
        off = lambda: self.client.control_dtc_setting(services.ControlDTCSetting.SettingType.off)
        self.refused(off, 0x22)  # it is not known to rest
        self.ecu.say("speed 0")
        self.ecu.run(10)
        off()
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

    def section(self, content):
        file = pathlib.Path(self.folder.name) / "section.bin"
        file.write_bytes(content)
        return file

    def said(self, call, *arguments):
        with contextlib.redirect_stdout(io.StringIO()) as out:
            call(self.client, TABLES, *arguments)
        return out.getvalue()

    def test_download_of_a_section(self):
        damaged = bytearray(SECTION)
        damaged[100] ^= 1
        with self.assertRaisesRegex(LogError, "a wrong checksum; what it had is still there"):
            uds_client.download(self.client, TABLES, self.section(bytes(damaged)))
        with self.assertRaisesRegex(LogError, "has 347 bytes, a section for this firmware 348"):
            uds_client.download(self.client, TABLES, self.section(SECTION[:-1]))
        stored = pathlib.Path(self.folder.name) / "parameters_1.bin"
        self.assertFalse(stored.exists())
        self.assertIn("from the next start", self.said(uds_client.download, self.section(SECTION)))
        self.assertEqual(stored.read_bytes()[:len(SECTION)], SECTION)

    def test_the_calibration_in_use_is_verified(self):
        other = bytearray(SECTION)
        other[16:24] = b"workshop"
        other[64:68] = struct.pack("<f", struct.unpack("<f", SECTION[64:68])[0] + 1.0)
        other[-4:] = struct.pack("<I", zlib.crc32(other[:-4]))
        verify = lambda: self.said(uds_client.verify, bytes(other), "other.bin")
        with self.assertRaisesRegex(LogError, "runs on other values than those of other.bin"):
            verify()
        with self.assertRaisesRegex(LogError, "cut.bin is no parameter section"):
            self.said(uds_client.verify, SECTION[:-1], "cut.bin")
        self.said(uds_client.download, self.section(bytes(other)))
        with self.assertRaisesRegex(LogError, "runs on other values"):
            verify()
        self.ecu.loses_power()
        self.assertIn("runs on the values of other.bin: checksum", verify())
        said = self.said(uds_client.identify)
        self.assertIn("calibration: workshop", said)
        self.assertIn(f"checksum of the calibration: {zlib.crc32(other[64:-4]):08X}\n", said)
        stored = pathlib.Path(self.folder.name) / "parameters_1.bin"
        stored.write_bytes(stored.read_bytes()[:-1])
        self.ecu.loses_power()
        self.ecu.run(1)
        with self.assertRaisesRegex(LogError, "runs on other values"):
            verify()
        self.assertIn("stored parameters refused: fails now", self.said(uds_client.show_codes))
        self.assertIn("wrong: parameters refused or damaged, in use or stored", self.said(uds_client.self_test))

    def test_the_output_of_the_commands(self):
        said = self.said(uds_client.show_codes)
        self.assertIn("U1120-87  imu lost: fails now, confirmed, pending\n    failed 1 times; good for 0", said)
        checksum = uds_client.checksum_in_use(self.client, TABLES)
        self.assertIn(f"    first: in operation cycle 1 of 1, 1 s after its start, with the calibration {checksum:08X}: "
                      "nothing measured\n", said)
        self.assertNotIn("about to fail", said)
        self.ecu.say("speed 0")
        self.ecu.run(1)
        self.assertIn("yaw rate invalid: about to fail, 84 of 127\n", self.said(uds_client.show_codes))
        self.assertIn("calibration: large_suv\n", self.said(uds_client.identify))
        self.assertIn("nothing wrong", self.said(uds_client.self_test))
        self.ecu.send(0x7FF, b"")
        self.assertEqual(self.said(uds_client.clear), "cleared\n")
        with self.assertRaisesRegex(LogError, "refuses ECUReset: ServiceNotSupportedInActiveSession"):
            with uds_client.reported():
                self.client.change_session(1)
                self.client.ecu_reset(1)


class WithBlocksAndGaps(Peer):
    """The tester asks for blocks and for time between frames."""
    stack = {"blocksize": 3, "stmin": 5}


class WithShortGaps(Peer):
    stack = {"blocksize": 1, "stmin": 0xF5, "tx_padding": 0x55}


class Odx(unittest.TestCase):
    """The file describes the ECU: its requests are sent, its answers decoded."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        file = pathlib.Path(cls.folder.name) / "ecu.pdx"
        file.write_bytes(odx.pdx_of(TABLES))
        cls.database = odxtools.load_pdx_file(str(file))
        cls.layer = cls.database.ecu_variants[0]
        cls.ecu = pipe_tester.Ecu(PROGRAM, cls.folder.name)
        cls.connection = simulated_bus.IsoTpConnection(cls.ecu, pipe_tester.PHYSICAL, pipe_tester.RESPONSE)
        cls.ecu.run(250)

    @classmethod
    def tearDownClass(cls):
        cls.ecu.close()
        cls.folder.cleanup()

    def ask(self, name, **parameters):
        """The decoded answer; a refusal has a reason."""
        request = self.layer.services[name].encode_request(**parameters)
        self.connection.send(request)
        while True:
            answer = self.connection.wait_frame(timeout=6)
            messages = self.layer.decode_response(answer, request)
            self.assertEqual(len(messages), 1, answer.hex())
            decoded = messages[0].param_dict
            self.assertEqual("reason" in decoded, answer[0] == 0x7F, answer.hex())
            if decoded.get("reason") != PENDING:
                return decoded

    def unlock(self):
        code = cmac.CMAC(algorithms.AES(b"test key for UDS"))
        code.update(bytes(self.ask("request_seed")["seed"]))
        self.ask("send_key", key=code.finalize())

    def values_for(self, service):
        values = {"messages": 1, "key": bytes(16), "group": 0xFFFFFF, "mask": 8, "record": 0xFF, "code": IMU_LOST, "block": 1,
                  "data": [{"data": 0}], "vehicle_number": "WVWZZZ1JZXW000001", "programming_date": bytes((0x20, 0x26, 0x11, 0x27))}
        return {each.short_name: values[each.short_name] for each in service.request.required_parameters}

    def ask_in(self, session, service, unlocked=False):
        """The reason of a refusal, or None."""
        self.ask("session_default")
        if session != "default":
            self.ask(f"session_{session}")
        if unlocked:
            self.unlock()
        answer = self.ask(service.short_name, **self.values_for(service))
        self.ecu.run(2)  # after a reset
        return answer.get("reason")

    def test_every_answer_of_every_service_is_decoded(self):
        self.ecu.say("speed 0")
        self.ecu.run(10)
        refused, answered, locked = set(), set(), {}
        for session in ("default", "extended", "programming"):
            for service in self.layer.services:
                reason = self.ask_in(session, service)
                if reason == "SecurityAccessDenied":
                    locked.setdefault(service.short_name, session)
                    reason = self.ask_in(session, service, unlocked=True)
                self.assertNotIn(reason, ("other", "SecurityAccessDenied"), service.short_name)
                (answered if reason is None else refused).add(service.short_name)
        self.assertEqual(locked["clear_codes"], "extended")
        self.assertEqual(locked["request_download"], "programming")
        never = {service.short_name for service in self.layer.services} - answered
        self.assertEqual(never, {"send_key", "check_section", "transfer_data", "transfer_exit"}, "out of sequence")
        self.assertIn("write_vehicle_number", refused)

    def test_how_to_reach_the_ecu(self):
        constants = TABLES.constants
        self.assertEqual((self.layer.get_can_receive_id(), self.layer.get_can_send_id(), self.layer.get_can_func_req_id()),
                         (constants["physical_request"], constants["response"], constants["functional_request"]))
        self.assertEqual(self.layer.get_can_baudrate(), 500000)
        self.assertEqual([each.short_name for each in self.layer.protocols], ["UDS_on_CAN_protocol"])
        times = self.ask("session_default")
        self.assertEqual((int(self.layer.get_comparam("CP_P2Max").get_value()), int(self.layer.get_comparam("CP_P2Star").get_value())),
                         (1000 * times["p2_ms"], 10000 * times["p2_star_10_ms"]))

    def test_the_variant_is_found_by_its_name(self):
        matcher = VariantMatcher(self.database.ecu_variants, use_cache=False)
        for _, request in matcher.request_loop():
            self.connection.send(request)
            matcher.evaluate(self.connection.wait_frame(timeout=1))
        self.assertTrue(matcher.has_match())
        self.assertEqual(matcher.matching_variant, self.layer)

    def test_texts_and_choices_are_words(self):
        self.ask("session_default")
        self.assertEqual(self.ask("read_state")["state"], "unavailable")
        self.assertEqual(self.ask("read_session")["session"], "default")
        self.assertEqual(self.ask("read_calibration_name")["calibration_name"].rstrip("\0"), "large_suv")

    def test_every_code_has_its_name(self):
        codes = {code.trouble_code: code.short_name for code in self.layer.diag_data_dictionary_spec.dtc_dops[0].dtcs}
        self.assertEqual(codes, {number: odx.short(name) for number, name in TABLES.codes.items()})
        listed = self.ask("read_all_codes")["codes"]
        self.assertEqual([each["code"].trouble_code for each in listed], list(TABLES.codes))
        self.assertEqual(listed[0]["code"].display_trouble_code, "U1120-87")

    def test_every_service_and_sub_function_is_described(self):
        described = {bytes(service.request.coded_const_prefix()) for service in self.layer.services}
        for service in TABLES.services:
            self.assertTrue(any(each[0] == service for each in described), hex(service))
        for service, number in TABLES.sub_functions:
            self.assertTrue(any(each[:2] == bytes((service, number)) for each in described), (hex(service), number))

    def test_every_value_is_read(self):
        for identifier, name, *_ in TABLES.numbers + TABLES.choices:
            self.assertIn(odx.short(name), self.ask(f"read_{name}"), hex(identifier))

    def test_the_calibration_in_use_is_read(self):
        self.assertEqual(self.ask("read_calibration_checksum")["calibration_checksum"],
                         uds_client.checksum_in_use(uds_client.client(self.connection, TABLES), TABLES))

    def test_codes_and_snapshots_are_decoded(self):
        codes = self.ask("read_codes", mask=0x08)["codes"]
        lost = next(each for each in codes if each["code"].trouble_code == IMU_LOST)
        self.assertEqual(lost["status"], FAILED_NOW)
        snapshot = self.ask("read_snapshots", code=IMU_LOST, record=0xFF)["snapshots"][0]
        self.assertEqual((snapshot["record"], snapshot["seconds_since_start"]), (1, 1))
        self.assertAlmostEqual(snapshot["lateral_acceleration"], -327.68)
        self.assertEqual(snapshot["operation_cycle"], self.ask("read_operation_cycles")["operation_cycles"])
        self.assertEqual(snapshot["calibration_checksum"], self.ask("read_calibration_checksum")["calibration_checksum"])
        self.assertEqual(self.ask("read_fault_detection_counters")["counters"], [])
        self.assertEqual(self.ask("read_counts", code=IMU_LOST, record=0x01)["counts"], [{"record": 1, "value": 1}])

    def test_sessions_are_decoded(self):
        self.assertEqual(self.ask("session_extended")["p2_ms"], 50)
        self.assertEqual(len(self.ask("request_seed")["seed"]), 16)
        self.assertEqual(self.ask("self_test")["found"], 0)
        self.ask("session_default")


def section_of(source):
    text = pathlib.Path(source).read_text(encoding="utf-8")
    return bytes(int(each, 16) for each in re.findall(r"0x([0-9A-F]{2})\b", text))


if __name__ == "__main__":
    PROGRAM, SECTION = sys.argv[1], section_of(sys.argv[3])
    TABLES = odx_tables.read(sys.argv[2], PROJECT / "can_dbc/rollover_warning.dbc")
    assert len(SECTION) == 348, "the section in C is not read as it is written now"
    unittest.main(argv=sys.argv[:1])
