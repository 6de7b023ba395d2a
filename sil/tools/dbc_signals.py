"""The mapped signals of bus logs, decoded with a DBC file."""

import errno
import json
import logging
import pathlib
import re
import sys

import cantools
from cantools.database.namedsignalvalue import NamedSignalValue

import dbc_file
import progress
from bus_log_writers import number_of
from bus_logs import BusLog
from log_error import LogError
from mapping import closest
from recorded import OUTSIDE, TEXTS, Clock, Collected

EXTENDED = 0x8000_0000
OTHER_DATABASES = (".arxml", ".kcd", ".sym", ".cdd")  # that cantools knows by their endings
ODD_SHOWN = 3  # lines of a file

logging.getLogger("cantools").setLevel(logging.ERROR)  # it warns of oddities of foreign files outside the mapping


def load(path):
    """The messages of one database file."""
    path = pathlib.Path(path)
    try:
        if path.exists() and not path.is_file():
            raise OSError(errno.EINVAL, "it is no ordinary file")
        if not path.stat().st_size:
            raise LogError(f"{path}: the file is empty; was the copy finished?")
        if path.suffix.lower() in OTHER_DATABASES:
            database = cantools.database.load_file(path, strict=False)
        else:
            database = load_dbc(path)
    except OSError as error:
        raise LogError(f"{path}: cannot be read: {error.strerror}") from error
    except LogError:
        raise
    except Exception as error:  # a parser's many kinds, up to those of damaged numbers
        raise refusal(path, error) from error
    if not isinstance(database, cantools.database.can.Database) or not database.messages:
        raise LogError(f"{path}: has no messages of a CAN bus; is it the right file?")
    return database


def refusal(path, error):
    said = " ".join(str(error).split())[:300]
    line = re.search(r"at line (\d+), column (\d+)", said)
    place = f"{path}:{line[1]}:{line[2]}" if line else path
    return LogError(f"{place}: this is no DBC file that can be read: {said}")


def load_dbc(path):
    """As it is; if a line of it is odd, statement by statement, without those that are."""
    text = dbc_file.text_of(path.read_bytes())
    try:
        # Foreign files have overlaps and lengths that contradict themselves, mostly in signals outside the mapping.
        return cantools.database.load_string(text, "dbc", strict=False)
    except Exception as error:  # of many kinds
        file = dbc_file.DbcFile(text)
        odd = list(file.odd)
        messages = sorted_out(file.blocks, odd)
        if not any(message.signals for message in messages):
            raise refusal(path, error) from error
        for message in messages:
            give_names(message, file.names)
        if odd:
            print(account_of(path, sorted(odd)), file=sys.stderr)
        return cantools.database.can.Database(messages, strict=False)


def sorted_out(blocks, odd):
    """Messages of the blocks that can be read. A block that cannot costs reading its half, its quarter and so on again."""
    if not blocks:
        return []
    try:
        return cantools.database.load_string(dbc_file.BEGIN + dbc_file.DEFINITIONS + "".join(block.text() for block in blocks), "dbc",
                                             strict=False).messages
    except Exception as error:  # of many kinds
        if len(blocks) > 1:
            return sorted_out(blocks[:len(blocks) // 2], odd) + sorted_out(blocks[len(blocks) // 2:], odd)
        said = " ".join(str(error).split())[:100]
        odd.append(dbc_file.Odd(blocks[0].line, f"message {blocks[0].name} cannot be understood ({said}): left out"))
        return []


def give_names(message, names):
    """Their own names to what was read by others."""
    message.name = names.get(message.name, message.name)
    renamed = [signal for signal in message.signals if signal.name in names or signal.multiplexer_signal in names]
    for signal in renamed:
        signal.name = names.get(signal.name, signal.name)
        signal.multiplexer_signal = names.get(signal.multiplexer_signal, signal.multiplexer_signal)
    if renamed:
        message.refresh(strict=False)


def account_of(path, odd):
    shown = "; ".join(f"line {line}: {what}" for line, what in odd[:ODD_SHOWN])
    more = f"; and {len(odd) - ODD_SHOWN} more" if len(odd) > ODD_SHOWN else ""
    return f"sil/tools/logs: {path}: {len(odd)} odd {'lines' if len(odd) > 1 else 'line'}; {shown}{more}"


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
