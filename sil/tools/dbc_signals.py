"""The mapped signals of bus logs, decoded with a DBC file."""

import errno
import json
import logging
import pathlib
import re

import cantools
from cantools.database.namedsignalvalue import NamedSignalValue

import progress
from bus_log_writers import number_of
from bus_logs import BusLog
from log_error import LogError
from mapping import closest
from recorded import OUTSIDE, TEXTS, Clock, Collected

EXTENDED = 0x8000_0000
OTHER_DATABASES = (".arxml", ".kcd", ".sym", ".cdd")  # that cantools knows by their endings

logging.getLogger("cantools").setLevel(logging.ERROR)  # it warns of oddities of foreign files outside the mapping


def load(path):
    path = pathlib.Path(path)
    try:
        if path.exists() and not path.is_file():
            raise OSError(errno.EINVAL, "it is no ordinary file")
        if not path.stat().st_size:
            raise LogError(f"{path}: the file is empty; was the copy finished?")
        is_dbc = path.suffix.lower() not in OTHER_DATABASES
        # Foreign files have overlaps and lengths that contradict themselves, mostly in signals outside the mapping.
        database = cantools.database.load_file(path, database_format="dbc" if is_dbc else None, strict=False,
                                               encoding=encoding_of(path) if is_dbc else None)
    except OSError as error:
        raise LogError(f"{path}: cannot be read: {error.strerror}") from error
    except LogError:
        raise
    except Exception as error:  # a parser's many kinds, up to those of damaged numbers
        said = " ".join(str(error).split())[:300]
        line = re.search(r"at line (\d+), column (\d+)", said)
        place = f"{path}:{line[1]}:{line[2]}" if line else path
        raise LogError(f"{place}: this is no DBC file that can be read: {said}") from error
    if not isinstance(database, cantools.database.can.Database) or not database.messages:
        raise LogError(f"{path}: has no messages of a CAN bus; is it the right file?")
    return database


def encoding_of(path):
    """Old DBC files are in the code page of Windows; newer tools write UTF-8."""
    try:
        path.read_bytes().decode("utf-8")
        return "utf-8"
    except UnicodeDecodeError:
        return "cp1252"


def names_of(database):
    return [f"{message.name}.{signal.name}" for message in database.messages for signal in message.signals]


def key_of(message):
    """Key that links a frame to a message: its identifier; for J1939 only the number of the parameter group."""
    if message.protocol == "j1939":
        return "pgn", parameter_group(message.frame_id)
    return "id", message.frame_id | (EXTENDED if message.is_extended_frame else 0)


def parameter_group(identifier):
    is_addressed = (identifier >> 16 & 0xFF) < 0xF0
    return identifier >> 8 & (0x3FF00 if is_addressed else 0x3FFFF)


def narrowed(message, names):
    """The message with these signals only, and those that say which page of it is sent."""
    signals = {signal.name: signal for signal in message.signals}
    wanted = set()
    for name in names:
        while name and name not in wanted:
            wanted.add(name)
            name = signals[name].multiplexer_signal
    return cantools.database.can.Message(message.frame_id, message.name, message.length,
                                         [signal for signal in message.signals if signal.name in wanted],
                                         is_extended_frame=message.is_extended_frame, strict=False)


def sound_parts(message):
    """The message as it is, or signal by signal where its signals overlap: decoded together they would be wrong. One that is
    longer than the message is left out."""
    try:
        cantools.database.can.Message(message.frame_id, message.name, message.length, message.signals,
                                      is_extended_frame=message.is_extended_frame, strict=True)
        return [message]
    except cantools.database.Error:
        return [part for part in (narrowed(message, [signal.name]) for signal in message.signals) if fits(part)]


def fits(part):
    try:
        part.decode(bytes(part.length), allow_truncated=True)
        return True
    except cantools.database.Error:
        return False


class Message:
    """A message of which signals are mapped."""

    def __init__(self, message, bus):
        self.message = message
        self.bus = bus
        self.parts = []
        self.collected = []
        self.count = 0
        self.undecodable = 0
        self.senders = {}       # by the log: buses and identifiers, which of J1939 differ in the source address
        self.elsewhere = set()  # buses on which the mapping does not want it


def wanted_messages(database, dbc, mapping):
    """The mapped messages of the database, by the key of their frames."""
    names = names_of(database)
    messages = {}
    for entry in mapping.entries:
        message_name, _, signal_name = entry.signal.partition(".")
        message = next((candidate for candidate in database.messages if candidate.name == message_name), None)
        signal = next((candidate for candidate in message.signals if candidate.name == signal_name), None) if message else None
        if signal is None:
            mapping.fail(entry.quantity, "signal", f"is '{entry.signal}', but {dbc} has no such signal; "
                                                   f"{closest(entry.signal, names)}")
        if is_enumeration(signal):
            mapping.fail(entry.quantity, "signal", f"is {entry.signal}, whose values are texts ({dbc}: "
                                                   f"{', '.join(str(name) for name in list(signal.choices.values())[:3])}, "
                                                   "...); map a signal that has numbers")
        collected = Collected(entry, signal)
        mapping.unit_factor(entry, signal.unit)  # refused before a long log is read
        same = messages.setdefault(key_of(message), [])
        wanted = next((known for known in same if known.message is message and known.bus == entry.bus), None)
        if wanted is None:
            wanted = Message(message, entry.bus)
            same.append(wanted)
        wanted.collected.append(collected)
    for wanted in (wanted for same in messages.values() for wanted in same):
        together = narrowed(wanted.message, [collected.signal.name for collected in wanted.collected])
        wanted.parts = sound_parts(together)
    return messages


def is_enumeration(signal):
    """Whether it has a text for every value that it can have."""
    if not signal.choices or signal.is_float:
        return False
    low, high = signal.minimum, signal.maximum
    values = (high - low) / abs(signal.scale) + 1 if low is not None and high is not None and high > low else 2**signal.length
    return len(signal.choices) >= min(values, 2**signal.length)


def read(logs, dbc, mapping):
    """Recorded values of each mapped quantity, and a sentence on each without values. The logs are parts of one
    recording, in their order."""
    database = load(dbc)
    messages = wanted_messages(database, dbc, mapping)
    clock = Clock()
    for path in logs:
        log = BusLog(path)
        for frame in progress.reported(log):
            clock.take(path, frame.time_s)
            take(frame, messages, path)
    missing = check(messages, logs, dbc, mapping)
    return {collected.entry.quantity: collected.recorded()
            for same in messages.values() for wanted in same for collected in wanted.collected
            if collected.entry.quantity not in missing}, missing


def take(frame, messages, path):
    identifier = frame.identifier | (EXTENDED if frame.extended else 0)
    found = messages.get(("id", identifier))
    if found is None and frame.extended:
        found = messages.get(("pgn", parameter_group(frame.identifier)))
    for wanted in found or ():
        if wanted.bus is not None and wanted.bus != (number_of(frame.bus) if isinstance(wanted.bus, int) else str(frame.bus)):
            wanted.elsewhere.add(str(frame.bus))
            continue
        wanted.senders.setdefault(path, set()).add((frame.bus, frame.identifier))
        decode(frame, wanted)


def decoded(parts, data):
    values = {}
    for part in parts:
        values.update(part.decode(data, allow_truncated=True))
    return values


def decode(frame, wanted):
    try:
        values = decoded(wanted.parts, frame.data)
    except Exception:  # cantools raises several; the frame is lost, not the log
        wanted.undecodable += 1
        return
    wanted.count += 1
    time_us = round(frame.time_s * 1.0e6)
    for collected in wanted.collected:
        value = values.get(collected.signal.name)
        if isinstance(value, NamedSignalValue):
            collected.take_text(str(value))
        elif value is not None:
            collected.take(time_us, value)


def check(messages, logs, dbc, mapping):
    """Refuses what would give a drive of two senders' values; tells why there is no value, by the quantities without one."""
    missing = {}
    for wanted in (wanted for same in messages.values() for wanted in same):
        name, quantity = wanted.message.name, wanted.collected[0].entry.quantity
        for path in logs:
            here = wanted.senders.get(path, ())
            buses = sorted({bus for bus, _ in here}, key=str)
            if len(buses) > 1:
                mapping.fail(quantity, "signal", f"is of {name}, which comes on the buses {' and '.join(map(str, buses))} in "
                                                 f"{path}; choose one by a line bus = {json.dumps(buses[0])}")
            if len(here) > 1:
                addresses = " and ".join(f"0x{identifier & 0xFF:02X}" for _, identifier in sorted(here))
                mapping.fail(quantity, "signal", f"is of {name}, which several senders send (source addresses {addresses}) in "
                                                 f"{path}; export the log with one of them")
        for collected in wanted.collected:
            if not collected.times_us:
                missing[collected.entry.quantity] = why_empty(wanted, collected, dbc)
    return missing


def why_empty(wanted, collected, dbc):
    """A sentence on a signal of which the logs have no value."""
    name, signal = wanted.message.name, collected.signal
    if not wanted.count and not wanted.undecodable:
        elsewhere = sorted(wanted.elsewhere)
        bus = f", bus {wanted.bus}" if wanted.bus is not None else ""
        return (f"there is no frame of {name} (0x{wanted.message.frame_id:X} in {dbc}{bus})"
                + (f"; it comes on bus {', '.join(elsewhere)}" if elsewhere else ""))
    if collected.left_out.get(TEXTS):
        return f"every value of {collected.entry.signal} is a text, such as '{collected.examples[0]}'"
    if collected.left_out.get(OUTSIDE):
        return (f"every value of {collected.entry.signal} is outside {signal.minimum} to {signal.maximum}, the DBC file's "
                "range: not available, or of another DBC file")
    return (f"there is no value of {collected.entry.signal} in {wanted.count} frames of {name}; {wanted.undecodable} more could "
            "not be decoded")
