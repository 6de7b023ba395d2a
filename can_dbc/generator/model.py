"""Reads a DBC file and turns it into what the template needs, refusing whatever the codec cannot carry faithfully."""
import pathlib
import re
import struct
import sys
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from math import ceil, floor, lcm

import cantools

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "cmake/environment"))

import file_io  # noqa: E402
from names import CONVERSIONS, RESERVED, TAKEN, TAKEN_TYPES, UNIT_ENDINGS, camel_case, is_usable, snake_case

NOT_AVAILABLE = "not available"
LONGEST_SIGNAL = 32
LONGEST_IN_INT32 = 24  # bits that a float holds without rounding; longer fields are scaled in 64 bits
CLASSIC_LENGTH = 8  # bytes at most
LARGEST_DATA_ID = 0xFFF  # of profile 11, as a nibble
FD_LENGTHS = (*range(9), 12, 16, 20, 24, 32, 48, 64)  # bytes that a CAN FD frame can have


class DbcError(Exception):
    """A fault in a DBC file; the text says what and where."""


@dataclass
class Enumerator:
    name: str
    text: str
    number: int


@dataclass
class Signal:
    name: str
    kind: str  # physical, integer, flag or enumeration
    field_name: str
    cpp_type: str
    comment: str
    unit: str
    byte_order: str
    start_bit: int
    length: int
    is_signed: bool
    minimum_text: str
    maximum_text: str
    raw_at_minimum: int
    raw_at_maximum: int
    start_value: int
    default: str
    not_available: int | None
    factor_text: str
    offset_text: str
    source: str = ""  # the member of the sender's structure that the signal carries
    source_factor: str = ""
    raw_type: str = ""
    scale: dict = field(default_factory=dict)
    enumerators: list = field(default_factory=list)


@dataclass
class Protection:
    profile: int
    data_id: int
    fields: tuple


UNPROTECTED = Protection(0, 0, ())


@dataclass
class ProtectionField:
    name: str
    start: int
    length: int
    largest: int


PROTECTION_FIELDS = (ProtectionField("E2eCrc", 0, 8, 255), ProtectionField("E2eCounter", 8, 4, 14),
                     ProtectionField("E2eDataIdNibble", 12, 4, 15))


@dataclass
class Message:
    name: str
    comment: str
    sender: str
    receivers: list
    identifier: int
    extended: bool
    flexible_data_rate: bool
    length: int
    cycle_time_ms: int
    protection: Protection
    signals: list

    @property
    def has_sources(self):
        return any(signal.source for signal in self.signals)


def load(path):
    """The messages of a DBC file, in the file's order."""
    try:
        text = file_io.read(path)
    except OSError as error:
        raise DbcError(f"cannot be read: {error.strerror}; check the path and the permissions") from error
    except UnicodeDecodeError as error:
        raise DbcError(f"cannot be read: it is no text in UTF-8: {error}") from error
    if re.search(r"^SIG_VALTYPE_\s+\d", text, re.MULTILINE):
        raise DbcError("SIG_VALTYPE_: signals in IEEE floating point are not supported; give the signal a factor")
    try:
        database = cantools.database.load_string(text, database_format="dbc", strict=True, sort_signals=None)
    except Exception as error:  # cantools raises many kinds, none of them ours
        raise DbcError(str(error)) from error
    messages = [_message(message) for message in database.messages]
    _refuse_duplicates("the file", [message.name for message in messages])
    _refuse_duplicates("the E2EDataId attributes",
                       [message.protection.data_id for message in messages if message.protection.profile])
    return messages


def senders(messages):
    """The nodes that send, each with the names of its messages, all in the file's order."""
    names = {}
    for message in messages:
        names.setdefault(message.sender, []).append(message.name)
    return list(names.items())


def _message(message):
    where = f"message {message.name}"
    if not is_usable(message.name):
        raise DbcError(f"{where}: the name is not a usable C++ name")
    if not message.senders:
        raise DbcError(f"{where}: no sender")
    _check_length(where, message)
    fields = PROTECTION_FIELDS if _is_protected(where, message) else ()
    missing = list(_missing_lines(message, fields))
    if missing:
        raise DbcError(f"{where}: these lines are missing:\n" + "\n".join(missing))
    protection = _protection(where, message, fields)
    signals = [_signal(message, signal) for signal in message.signals if signal.name not in protection.fields]
    _refuse_duplicates(where, [signal.field_name for signal in signals])
    return Message(message.name, _comment(message.comment), message.senders[0], sorted(message.receivers),
                   message.frame_id, message.is_extended_frame, message.is_fd, message.length,
                   message.cycle_time or 0, protection, signals)


def _missing_lines(message, fields):
    """The lines of the DBC file that a message lacks, as they must be but for TEXT and NUMBER."""
    identifier = message.frame_id | (1 << 31 if message.is_extended_frame else 0)
    receiver = next(iter(sorted(message.receivers)), "Vector__XXX")
    names = {signal.name for signal in message.signals}
    for part in fields:
        if part.name not in names:
            yield f' SG_ {part.name} : {part.start}|{part.length}@1+ (1,0) [0|{part.largest}] "-" {receiver}'
    if not message.comment:
        yield f'CM_ BO_ {identifier} "TEXT";'
    signals = [signal for signal in message.signals if signal.name not in {part.name for part in fields}]
    for signal in signals:
        if not signal.comment:
            yield f'CM_ SG_ {identifier} {signal.name} "TEXT";'
    if "GenMsgCycleTime" not in message.dbc.attributes:
        yield f'BA_ "GenMsgCycleTime" BO_ {identifier} 10;'
    if fields and "E2EDataId" not in message.dbc.attributes:
        yield f'BA_ "E2EDataId" BO_ {identifier} NUMBER;'
    for signal in signals:
        missing = _not_available(signal)
        if missing and "GenSigStartValue" not in signal.dbc.attributes:
            yield f'BA_ "GenSigStartValue" SG_ {identifier} {signal.name} {missing[0]};'


def _not_available(signal):
    """The codes that stand for no value."""
    return [int(number) for number, text in (signal.choices or {}).items() if str(text).strip().lower() == NOT_AVAILABLE]


def _check_length(where, message):
    if message.is_fd and message.length not in FD_LENGTHS:
        raise DbcError(f"{where}: {message.length} bytes; a CAN FD frame has "
                       f"{', '.join(map(str, FD_LENGTHS[:-1]))} or {FD_LENGTHS[-1]}")
    if not message.is_fd and message.length > CLASSIC_LENGTH:
        raise DbcError(f"{where}: {message.length} bytes, but a classic frame has {CLASSIC_LENGTH} at most; "
                       "set attribute VFrameFormat to StandardCAN_FD or ExtendedCAN_FD")


def _is_protected(where, message):
    profile = _choice(message, "E2EProfile")
    if profile in (None, "none"):
        return False
    if profile != "P11":
        raise DbcError(f"{where}: attribute E2EProfile is '{profile}'; only none and P11 are supported")
    if message.is_fd:
        raise DbcError(f"{where}: profile 11 is for classic frames, its CRC of 8 bits too short for CAN FD; set "
                       "attribute E2EProfile to none")
    return True


def _protection(where, message, fields):
    """How the message is protected end to end."""
    if not fields:
        return UNPROTECTED
    for part in fields:
        signal = next(signal for signal in message.signals if signal.name == part.name)
        if (signal.start, signal.length, signal.byte_order, signal.is_signed) != (
                part.start, part.length, "little_endian", False):
            raise DbcError(f"{where}: profile 11 needs signal {part.name} as {part.start}|{part.length}@1+")
    data_id = message.dbc.attributes["E2EDataId"].value
    if not 0 < data_id <= LARGEST_DATA_ID:
        raise DbcError(f"{where}: profile 11 needs attribute E2EDataId from 1 to {LARGEST_DATA_ID}")
    return Protection(11, data_id, tuple(part.name for part in fields))


def _choice(message, name):
    """The text of an enumeration attribute or of its default, or None where the file does not define it."""
    attribute = message.dbc.attributes.get(name)
    if attribute is None:
        definition = message.dbc.attribute_definitions.get(name)
        return definition.default_value if definition else None
    value = attribute.value
    return attribute.definition.choices[value] if isinstance(value, int) else value


def _signal(message, signal):
    where = f"message {message.name}, signal {signal.name}"
    if signal.is_multiplexer or signal.multiplexer_ids is not None:
        raise DbcError(f"{where}: multiplexed signals are not supported; give each layout a message of its own")
    if not 1 <= signal.length <= LONGEST_SIGNAL:
        raise DbcError(f"{where}: {signal.length} bits; signals of 1 to {LONGEST_SIGNAL} bits are supported")
    if signal.minimum is None or signal.maximum is None:
        raise DbcError(f"{where}: no range; give a minimum and a maximum")
    factor, offset = _fraction(signal.scale), _fraction(signal.offset)
    if factor == 0:
        raise DbcError(f"{where}: the factor is zero")
    choices = {int(number): str(text) for number, text in (signal.choices or {}).items()}
    missing = _not_available(signal)
    if len(missing) > 1:
        raise DbcError(f"{where}: more than one code is called '{NOT_AVAILABLE}'")
    not_available = missing[0] if missing else None
    kind = _kind(where, signal, factor, offset, choices, not_available)
    result = Signal(
        name=signal.name, kind=kind, field_name=_field_name(where, signal, kind), cpp_type="",
        comment=_comment(signal.comment), unit=signal.unit or "", byte_order=signal.byte_order,
        start_bit=signal.start, length=signal.length, is_signed=signal.is_signed,
        minimum_text=_decimal(signal.minimum), maximum_text=_decimal(signal.maximum),
        raw_at_minimum=0, raw_at_maximum=0, start_value=_start_value(where, signal), default="",
        not_available=not_available, factor_text=_decimal(signal.scale), offset_text=_decimal(signal.offset))
    _add_range(where, signal, result, factor, offset)
    _add_type(where, result, factor, offset, choices)
    _add_source(where, signal, result)
    return result


def _add_source(where, signal, result):
    attribute = signal.dbc.attributes.get("Source") if signal.dbc else None
    if attribute is None or not attribute.value:
        return
    result.source = attribute.value
    if not is_usable(result.source):
        raise DbcError(f"{where}: Source '{result.source}' cannot be a member's name in C++")
    if result.kind != "physical":
        return
    endings = set(UNIT_ENDINGS.values()) | {unit for unit, _ in CONVERSIONS}
    last_word = result.source.rsplit("_", 1)[-1]
    given, wanted = last_word if last_word in endings else "", UNIT_ENDINGS[result.unit]
    if given != wanted:
        result.source_factor = CONVERSIONS.get((given, wanted), "")
        if not result.source_factor:
            raise DbcError(f"{where}: Source '{result.source}' has another unit than '{result.unit}', and "
                           "CONVERSIONS in can_dbc/generator/names.py knows no factor")


def _kind(where, signal, factor, offset, choices, not_available):
    identity = factor == 1 and offset == 0
    if len(choices) > (not_available is not None):
        if not identity:
            raise DbcError(f"{where}: a scaled signal may name only the code '{NOT_AVAILABLE}'")
        return "enumeration"
    if not identity or not_available is not None:
        if identity and signal.length > LONGEST_IN_INT32:
            raise DbcError(f"{where}: an integer with a code '{NOT_AVAILABLE}' may have {LONGEST_IN_INT32} bits at most")
        return "physical"
    return "flag" if signal.length == 1 and not signal.is_signed else "integer"


def _add_range(where, signal, result, factor, offset):
    """Sets the outermost codes within the physical range and refuses what does not fit into the field."""
    bits = signal.length
    lowest, highest = (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) if signal.is_signed else (0, (1 << bits) - 1)
    at_minimum = (_fraction(signal.minimum) - offset) / factor
    at_maximum = (_fraction(signal.maximum) - offset) / factor
    rising = factor > 0
    result.raw_at_minimum = ceil(at_minimum) if rising else floor(at_minimum)
    result.raw_at_maximum = floor(at_maximum) if rising else ceil(at_maximum)
    first, last = sorted((result.raw_at_minimum, result.raw_at_maximum))
    if signal.minimum > signal.maximum or first < lowest or last > highest:
        raise DbcError(f"{where}: the range [{signal.minimum}|{signal.maximum}] needs the codes {first} to {last}, "
                       f"but {bits} bits hold {lowest} to {highest}")
    missing = result.not_available
    if missing is not None and not lowest <= missing <= highest:
        raise DbcError(f"{where}: the code '{NOT_AVAILABLE}' {missing} does not fit into {bits} bits")
    if missing is not None and first <= missing <= last and result.kind != "enumeration":
        raise DbcError(f"{where}: the code '{NOT_AVAILABLE}' {missing} lies within the physical range")
    if not first <= result.start_value <= last and result.start_value != missing:
        raise DbcError(f"{where}: GenSigStartValue {result.start_value} is outside the range")


def _add_type(where, result, factor, offset, choices):
    if result.kind == "physical":
        result.cpp_type = "float"
        result.raw_type = f"std::int{32 if result.length <= LONGEST_IN_INT32 else 64}_t"
        result.scale = _scale(factor, offset)
        start = result.start_value
        result.default = ("not_available" if start == result.not_available
                          else _float(float(start * factor + offset)))
        return
    if result.kind == "flag":
        result.cpp_type = "bool"
        result.default = "true" if result.start_value else "false"
        return
    width = next(width for width in (8, 16, 32) if result.length <= width)
    integer = f"std::{'' if result.is_signed else 'u'}int{width}_t"
    if result.kind == "integer":
        result.cpp_type = integer
        result.default = str(result.start_value) if result.is_signed else f"{result.start_value}U"
        return
    result.cpp_type, result.raw_type = camel_case(result.name), integer
    if result.cpp_type in TAKEN_TYPES:
        raise DbcError(f"{where}: the name is used by the codec itself; choose another")
    result.enumerators = [Enumerator(_enumerator(where, text), text, number)
                          for number, text in sorted(choices.items())]
    _refuse_duplicates(where, [enumerator.name for enumerator in result.enumerators])
    start = [enumerator for enumerator in result.enumerators if enumerator.number == result.start_value]
    if not start:
        raise DbcError(f"{where}: GenSigStartValue {result.start_value} is none of the named values")
    result.default = f"{result.cpp_type}::{start[0].name}"


def _scale(factor, offset):
    """numerator, shift and denominator of raw * factor + offset, exact in float wherever that is possible."""
    denominator = lcm(factor.denominator, offset.denominator)
    exact = (factor * denominator, offset * denominator, Fraction(denominator))
    if all(_is_exact(number) for number in exact):
        return dict(zip(("numerator", "shift", "denominator"), (_float(float(number)) for number in exact)))
    return {"numerator": _float(float(factor)), "shift": _float(float(offset)), "denominator": "1.0F"}


def _is_exact(number):
    """Whether a float holds an integer exactly."""
    try:
        return Fraction(struct.unpack("<f", struct.pack("<f", float(number)))[0]) == number
    except OverflowError:
        return False


def _start_value(where, signal):
    attribute = signal.dbc.attributes.get("GenSigStartValue") if signal.dbc else None
    if attribute is None:
        return 0
    if attribute.value != int(attribute.value):
        raise DbcError(f"{where}: GenSigStartValue must be the integer on the bus, not a physical value")
    return int(attribute.value)


def _field_name(where, signal, kind):
    unit = signal.unit or ""
    if unit not in UNIT_ENDINGS:
        raise DbcError(f"{where}: unit '{unit}' is unknown; add it to UNIT_ENDINGS in can_dbc/generator/names.py")
    ending = UNIT_ENDINGS[unit] if kind != "enumeration" else ""
    name = snake_case(signal.name) + (f"_{ending}" if ending else "")
    if not is_usable(name) or name in TAKEN:
        raise DbcError(f"{where}: '{name}' cannot be a field's name in C++; choose another")
    return name


def _enumerator(where, text):
    name = snake_case(text)
    name = f"{name}_" if name in RESERVED else name
    if not is_usable(name):
        raise DbcError(f"{where}: the value's name '{text}' gives no C++ name")
    return name


def _refuse_duplicates(where, names):
    for name in names:
        if names.count(name) > 1:
            raise DbcError(f"{where}: '{name}' occurs twice")


def _comment(comment):
    return " ".join(str(comment).split())


def _fraction(number):
    return Fraction(Decimal(str(number)))


def _decimal(number):
    text = format(Decimal(str(number)), "f")
    return text.rstrip("0").rstrip(".") if "." in text else text


def _float(number):
    """A C++ float literal."""
    text = repr(float(number))
    return f"{text}F" if "." in text or "e" in text else f"{text}.0F"
