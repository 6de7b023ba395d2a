"""The mapped signals of bus logs, decoded with a DBC file."""

import errno
import functools
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
from mapping import IGNORED, closest, signals_of
from recorded import OUTSIDE, TEXTS, Clock, Collected, combined

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
    """As it is; if a line of it is odd, statement by statement, without those that are: cantools refuses some of them, and
    takes others silently."""
    text = dbc_file.text_of(path.read_bytes())
    file, failure = dbc_file.DbcFile(text), None
    try:
        if dbc_file.HUGE.search(text):
            raise ValueError("it has numbers beyond anything possible")
        # Foreign files have overlaps and lengths that contradict themselves, mostly in signals outside the mapping.
        whole = cantools.database.load_string(text, "dbc", strict=False)
        if not file.odd:
            return whole
    except Exception as error:  # of many kinds
        failure = error
    odd = list(file.odd)
    messages = sorted_out(file.blocks, odd)
    if not any(message.signals for message in messages) and failure:
        raise refusal(path, failure) from failure
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
        text = dbc_file.BEGIN + dbc_file.DEFINITIONS + "".join(block.text() for block in blocks)
        return cantools.database.load_string(text, "dbc", strict=False).messages
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
    return (f"sil/tools/logs: {path}: {len(odd)} odd {'lines' if len(odd) > 1 else 'line'}; "
            + first_of([f"line {line}: {what}" for line, what in odd]))


def first_of(remarks):
    more = f"; and {len(remarks) - ODD_SHOWN} more" if len(remarks) > ODD_SHOWN else ""
    return "; ".join(remarks[:ODD_SHOWN]) + more


class Database:
    """The messages of several files, as of a car and of an added sensor."""

    def __init__(self, paths):
        self.name = " and ".join(str(path) for path in paths)
        self.messages = []
        self.contested = set()  # keys of messages of which the files have several
        first = {}              # by key, and by name: the message and its file
        for path in paths:
            others = []
            for message in load(path).messages:
                key = key_of(message)
                rival, file = first.get(key, (None, path))
                if file != path and layout(rival) == layout(message):
                    continue
                _, other_file = first.get(message.name, (None, path))
                if other_file != path:
                    others.append(f"{message.name}, which is another one in {other_file}: that one is taken")
                    continue
                if file != path:
                    self.contested.add(key)
                    others.append(f"{message.name} (0x{message.frame_id:X}), which is {rival.name} in {file}: a mapping of either "
                                  "needs its bus")
                first.setdefault(key, (message, path))
                first.setdefault(message.name, (message, path))
                self.messages.append(message)
            if others:
                print(f"sil/tools/logs: {path}: has {first_of(others)}", file=sys.stderr)
        self.signals = {}
        for message in self.messages:
            for signal in message.signals:
                self.signals.setdefault(f"{message.name}.{signal.name}", (message, signal))


def database(paths):
    """The database of these files. It is read, and its oddities are said, once for all the logs of a call."""
    try:
        return read_once(tuple((path, path.stat().st_mtime_ns, path.stat().st_size) for path in map(pathlib.Path, paths)))
    except OSError:
        return Database(paths)  # says what is wrong


@functools.lru_cache(maxsize=2)
def read_once(files):
    return Database([path for path, _, _ in files])


def layout(message):
    return sorted((signal.name, signal.start, signal.length, signal.byte_order, signal.is_signed, signal.scale, signal.offset,
                   signal.unit or "") for signal in message.signals)


def key_of(message):
    """Key that links a frame to a message: its identifier; for J1939 only the number of the parameter group."""
    if message.protocol == "j1939":
        return group_key(message.frame_id)
    return "id", message.frame_id | (EXTENDED if message.is_extended_frame else 0)


def frame_key(frame):
    return "id", frame.identifier | (EXTENDED if frame.extended else 0)


def group_key(identifier):
    return "pgn", parameter_group(identifier)


def found_for(frame, by_key):
    """The entry of a frame: that of its identifier, else that of its parameter group; None if there is neither."""
    found = by_key.get(frame_key(frame))
    if found is None and frame.extended:
        found = by_key.get(group_key(frame.identifier))
    return found


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
        self.stand_in = None    # takes frames of the same parameter group, for want of any with the identifier

    def is_seen(self):
        return bool(self.count or self.undecodable or self.elsewhere)


def wanted_messages(database, mapping):
    """The mapped messages of the database, by the key of their frames."""
    messages = {}

    def wanted_of(key, message, bus):
        same = messages.setdefault(key, [])
        wanted = next((known for known in same if known.message is message and known.bus == bus), None)
        if wanted is None:
            wanted = Message(message, bus)
            same.append(wanted)
        return wanted

    for entry in mapping.entries:
        for role, name in signals_of(entry).items():
            message, signal = mapped_signal(database, mapping, entry, role, name)
            wanted = wanted_of(key_of(message), message, entry.bus)
            wanted.collected.append(Collected(entry, signal, role))
            if message.is_extended_frame and message.protocol != "j1939":
                wanted.stand_in = wanted_of(group_key(message.frame_id), message, entry.bus)
                wanted.stand_in.collected.append(Collected(entry, signal, role))
    for wanted in (wanted for same in messages.values() for wanted in same):
        together = narrowed(wanted.message, [collected.signal.name for collected in wanted.collected])
        wanted.parts = sound_parts(together)
    return messages


def mapped_signal(database, mapping, entry, role, name):
    """The message and signal of a name in the mapping."""
    if name not in database.signals:
        mapping.fail(entry.quantity, role, f"is '{name}', but {database.name} has no such signal; "
                                           f"{closest(name, database.signals)}")
    message, signal = database.signals[name]
    if key_of(message) in database.contested and entry.bus is None:
        mapping.fail(entry.quantity, role, f"is {name}, and 0x{message.frame_id:X} is another message in another DBC file; say on "
                                           "which bus this one is by a line bus = 1, or leave the other file out")
    if role != "sign":
        if is_enumeration(signal):
            mapping.fail(entry.quantity, role, f"is {name}, whose values are texts ({database.name}: "
                                               f"{', '.join(str(text) for text in list(signal.choices.values())[:3])}, "
                                               "...); map a signal that has numbers")
        mapping.unit_factor(entry, signal.unit, role)  # refused before a long log is read
    return message, signal


def is_enumeration(signal):
    """Whether it has a text for every value that it can have."""
    if not signal.choices or signal.is_float:
        return False
    low, high = signal.minimum, signal.maximum
    values = (high - low) / abs(signal.scale) + 1 if low is not None and high is not None and high > low else 2**signal.length
    return len(signal.choices) >= min(values, 2**signal.length)


def read(logs, database, mapping):
    """Recorded values of each mapped quantity, and a sentence on each without values. The logs are parts of one
    recording, in their order."""
    return read_frames({path: progress.reported(BusLog(path)) for path in logs}, database, mapping)


def read_frames(logs, database, mapping):
    """The same of the frames of each log, by its path."""
    messages = wanted_messages(database, mapping)
    clock = Clock()
    for path, frames in logs.items():
        for frame in frames:
            clock.take(path, frame.time_s)
            take(frame, messages, path)
    messages = of_parameter_groups(messages, logs)
    check_senders(messages, logs, mapping)
    parts = {}
    for wanted in messages:
        for collected in wanted.collected:
            parts.setdefault(collected.entry.quantity, {})[collected.role] = (wanted, collected)
    recorded, missing = {}, {}
    for quantity, roles in parts.items():
        recorded[quantity] = combined({role: collected for role, (_, collected) in roles.items()}, mapping)
        if not len(recorded[quantity].times_us):
            missing[quantity] = why_empty(roles, database.name)
            del recorded[quantity]
    return recorded, missing


def of_parameter_groups(messages, logs):
    """The messages that are used: where no frame has the identifier, those of its parameter group."""
    used = []
    stand_ins = {id(wanted.stand_in) for same in messages.values() for wanted in same}
    for wanted in (wanted for same in messages.values() for wanted in same if id(wanted) not in stand_ins):
        other = wanted.stand_in
        if other is not None and other.count and not wanted.is_seen():
            sender = min(identifier for log in logs for _, identifier in other.senders.get(log, ()))
            print(f"sil/tools/logs: {said_of_group(wanted.message, sender)}", file=sys.stderr)
            wanted = other
        used.append(wanted)
    return used


def said_of_group(message, sender):
    return (f"no frame has the identifier 0x{message.frame_id:X} of {message.name}: those of its J1939 parameter group "
            f"{parameter_group(message.frame_id)} are taken, from source address 0x{sender & 0xFF:02X}")


def take(frame, messages, path):
    for wanted in found_for(frame, messages) or ():
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
        if isinstance(value, NamedSignalValue) and collected.role != "sign":
            collected.take_text(str(value))
        elif value is not None:
            collected.take(time_us, getattr(value, "value", value))


def check_senders(messages, logs, mapping):
    """Refuses what would give a drive of two senders' values."""
    for wanted in messages:
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


def why_empty(roles, dbc):
    """A sentence on a quantity of which the logs have no value."""
    wanted, collected = next((one for one in roles.values() if not len(one[1].recorded().times_us)), roles["signal"])
    name, signal = wanted.message.name, collected.signal
    if not wanted.count and not wanted.undecodable:
        elsewhere = sorted(wanted.elsewhere)
        bus = f", bus {wanted.bus}" if wanted.bus is not None else ""
        return (f"there is no frame of {name} (0x{wanted.message.frame_id:X} in {dbc}{bus})"
                + (f"; it comes on bus {', '.join(elsewhere)}" if elsewhere else ""))
    left_out = collected.recorded().left_out
    if collected.left_out.get(TEXTS):
        return f"every value of {collected.name()} is a text, such as '{collected.examples[0]}'"
    if left_out.get(OUTSIDE):
        return (f"every value of {collected.name()} is outside {signal.minimum} to {signal.maximum}, the DBC file's "
                f"range: not available, or of another DBC file; range = \"{IGNORED}\" in the mapping takes them")
    if len(collected.recorded().times_us):
        return f"{' and '.join(one.name() for _, one in roles.values())} have no value at the same time"
    return (f"there is no value of {collected.name()} in {wanted.count} frames of {name}; {wanted.undecodable} more could "
            "not be decoded")
