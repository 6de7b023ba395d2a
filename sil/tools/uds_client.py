"""UDS client of a workshop: reads and clears trouble codes, identifies it, downloads parameters."""

import contextlib
import logging
import zlib

import can
import isotp
import udsoncan
import udsoncan.configs
from cryptography.hazmat.primitives import cmac
from cryptography.hazmat.primitives.ciphers import algorithms
from udsoncan import DataFormatIdentifier, MemoryLocation, services
from udsoncan.client import Client
from udsoncan.connections import PythonIsoTpConnection

import key_file
import simulated_bus
from log_error import LogError
from odx_tables import name_of_trouble_code

TEST_KEY = key_file.TEST_KEYS["diagnosis"]
IN_MEMORY = 0x0C  # confirmed or pending
NOT_AVAILABLE = -32768

STATUS = ((0x01, "fails now"), (0x08, "confirmed"), (0x04, "pending"))
FOUND = ((0x01, "parameters refused or damaged, in use or stored"), (0x02, "memory that had to be restored"),
         (0x04, "an estimate or output out of range"), (0x08, "late cycles, or a clock that jumps"),
         (0x10, "the bus"), (0x20, "a memory that takes no records, or has lost one"))
REFUSALS = ("good", "no parameter section", "a section of another format", "a section for another set of parameters",
            "a section of another length", "a wrong checksum", "a value that is out of range or contradicts another",
            "no good seal")


class Text(udsoncan.DidCodec):
    """A text filled up with zeros."""

    def __init__(self, length):
        self.length = length

    def encode(self, *value):
        return value[0].encode().ljust(self.length, b"\0")

    def decode(self, string_bin):
        return string_bin.rstrip(b"\0").decode(errors="replace")

    def __len__(self):
        return self.length


IDENTIFIERS = {0xF197: ("system", Text(16)), 0xF195: ("software version", Text(16)), 0xF182: ("calibration", Text(48)),
               0xF191: ("hardware", Text(16)), 0xF18C: ("serial number", Text(16)), 0xF190: ("vehicle number", Text(17))}


def client(connection, tables, key=TEST_KEY):
    """A client of udsoncan that knows the ECU's identifiers and its key."""
    def answer(level, seed, params):
        del level, params
        code = cmac.CMAC(algorithms.AES(key))
        code.update(bytes(seed))
        return code.finalize()

    logging.getLogger("UdsClient").setLevel(logging.CRITICAL)  # errors are reported once, by reported()
    config = dict(udsoncan.configs.default_client_config)
    config.update(security_algo=answer, request_timeout=8, extended_data_size=1, dtc_snapshot_did_size=2,
                  data_identifiers={**{each: codec for each, (_, codec) in IDENTIFIERS.items()}, 0xF186: "B",
                                    tables.constants["calibration_checksum_identifier"]: ">I",
                                    tables.constants["operation_cycles_identifier"]: ">I",
                                    tables.constants["freeze_frame_identifier"]: ">hhhhHII", "default": ">f"})
    return Client(connection, config=config)


@contextlib.contextmanager
def on_can(interface, tables, key):
    """A client on a CAN interface. Errors are LogErrors."""
    response, request = tables.constants["response"], tables.constants["physical_request"]
    try:
        bus = can.Bus(interface="socketcan", channel=interface,
                      can_filters=[{"can_id": response, "can_mask": 0x7FF, "extended": False}])
    except (OSError, can.CanError) as error:
        raise LogError(f"cannot open the CAN interface {interface} ({error}); `ip link` shows those that are there, "
                       "--in-process needs none") from error
    address = isotp.Address(isotp.AddressingMode.Normal_11bits, rxid=response, txid=request)
    try:
        stack = isotp.CanStack(bus, address=address, params={"tx_padding": 0xCC})
        with client(PythonIsoTpConnection(stack), tables, key) as tester, reported():
            yield tester
    finally:
        bus.shutdown()


@contextlib.contextmanager
def in_process(bus, tables, key):
    """A client on a simulated_bus. Errors are LogErrors."""
    connection = simulated_bus.IsoTpConnection(bus, tables.constants["physical_request"], tables.constants["response"])
    with client(connection, tables, key) as tester, reported():
        yield tester


@contextlib.contextmanager
def reported():
    try:
        yield
    except udsoncan.exceptions.TimeoutException as error:
        raise LogError("the ECU does not answer; does it run with diagnosis (rsi-ecu --diagnosis), on this interface?") from error
    except udsoncan.exceptions.NegativeResponseException as error:
        response = error.response
        raise LogError(f"the ECU refuses {response.service.get_name()}: {response.code_name} (0x{response.code:02X})") from error
    except udsoncan.exceptions.UdsoncanException as error:
        raise LogError(f"the ECU's answer cannot be understood: {error}") from error


def unlock(tester, session):
    tester.change_session(session)
    tester.unlock_security_access(1)


def show_codes(tester, tables):
    about_to_fail = tester.get_dtc_fault_counter().service_data.dtcs
    codes = tester.get_dtc_by_status_mask(IN_MEMORY).service_data.dtcs
    if not codes:
        print("no trouble codes")
    cycles = value_of(tester, tables, "operation_cycles_identifier")
    for code in codes:
        status = code.status.get_byte_as_int()
        said = ", ".join(text for bit, text in STATUS if status & bit)
        print(f"{name_of_trouble_code(code.id)}  {tables.codes.get(code.id, 'unknown')}: {said}")
        counts = tester.get_dtc_extended_data_by_dtc_number(code.id, 0xFF, data_size=1).service_data.dtcs[0].extended_data
        occurrences, ageing = (each.raw_data[0] for each in counts)
        print(f"    failed {occurrences} times; good for {ageing} operation cycles since, forgotten after 40")
        for each in tester.get_dtc_snapshot_by_dtc_number(code.id, 0xFF).service_data.dtcs[0].snapshots:
            print(f"    {'first' if each.record_number == 1 else 'last'}: {measured(each.data, cycles)}")
    for code in about_to_fail:
        print(f"{name_of_trouble_code(code.id)}  {tables.codes.get(code.id, 'unknown')}: about to fail, {code.fault_counter} of 127")


def measured(frame, cycles):
    *values, seconds, cycle, checksum = frame
    rows = zip(("lateral", "roll rate", "roll angle", "speed"), values, (100, 1000, 1000, 100),
               ("m/s^2", "rad/s", "rad", "m/s"))
    said = [f"{name} {value / steps:g} {unit}" for name, value, steps, unit in rows if value != NOT_AVAILABLE]
    return (f"in operation cycle {cycle} of {cycles}, {seconds} s after its start, with the calibration {checksum:08X}: "
            + (", ".join(said) or "nothing measured"))


def clear(tester, tables):
    del tables
    unlock(tester, services.DiagnosticSessionControl.Session.extendedDiagnosticSession)
    tester.clear_dtc(0xFFFFFF)
    print("cleared")


def identify(tester, tables):
    for identifier, (name, _) in IDENTIFIERS.items():
        text = tester.read_data_by_identifier(identifier).service_data.values[identifier]
        print(f"{name}: {text or 'not written'}")
    print(f"checksum of the calibration: {checksum_in_use(tester, tables):08X}")


def value_of(tester, tables, name):
    identifier = tables.constants[name]
    return tester.read_data_by_identifier(identifier).service_data.values[identifier][0]


def checksum_in_use(tester, tables):
    return value_of(tester, tables, "calibration_checksum_identifier")


def checksum_of(section, name, tables):
    """CRC-32 of the values of a section, whatever follows it."""
    length = tables.constants["section_length"]
    if len(section) < length or section[:4] != b"RSIP":
        raise LogError(f"{name} is no parameter section for this firmware")
    return zlib.crc32(section[tables.constants["section_values_at"]:length - 4])


def verify(tester, tables, section, name):
    """A LogError says that the ECU runs on other values."""
    wanted, found = checksum_of(section, name, tables), checksum_in_use(tester, tables)
    if wanted != found:
        raise LogError(f"the ECU runs on other values than those of {name}: checksum {found:08X}, not {wanted:08X}; a "
                       "download is in use from the next start on, and `codes` names a stored section that is refused")
    print(f"the ECU runs on the values of {name}: checksum {found:08X}")


def self_test(tester, tables):
    tester.change_session(services.DiagnosticSessionControl.Session.extendedDiagnosticSession)
    answer = tester.start_routine(tables.constants["self_test_routine"]).service_data.routine_status_record
    found = [text for bit, text in FOUND if answer[0] & bit]
    print("the self test finds " + ("nothing wrong" if not found else "wrong: " + "; ".join(found)))


def download(tester, tables, section):
    """The section is taken over at the next start. A LogError says why the ECU refuses it."""
    content = section.read_bytes()
    length = tables.constants["section_length"]
    if len(content) != length:
        raise LogError(f"{section} has {len(content)} bytes, a section for this firmware {length}; "
                       "`rsi-sil parameters --parameters FILE.toml --output SECTION.bin` writes one")
    unlock(tester, services.DiagnosticSessionControl.Session.programmingSession)
    location = MemoryLocation(address=0, memorysize=length, address_format=8, memorysize_format=16)
    answer = tester.request_download(location, DataFormatIdentifier(compression=0, encryption=0))
    size = answer.service_data.max_length - 2
    for number, at in enumerate(range(0, length, size), start=1):
        tester.transfer_data(number, content[at:at + size])
    tester.request_transfer_exit()
    refusal = tester.start_routine(tables.constants["check_section_routine"]).service_data.routine_status_record[0]
    if refusal:
        raise LogError(f"the ECU refuses {section}: {REFUSALS[refusal]}; what it had is still there")
    print(f"{section}: downloaded, in use from the next start of the ECU on")
