"""Decodes a log of frames once and for all: signals.mf4 and run.mcap, for the tools that show and compare signals."""

import contextlib
import math
import pathlib

from cantools.database.namedsignalvalue import NamedSignalValue

import dbc_signals
import progress
import file_io
from bus_logs import BusLog
from log_error import LogError
from own_frames import DBC
from recorded import Clock
from signal_writers import McapWriter, Mf4Writer

MOST_BITS_OF_TEXTS = 8
LEAST_TEXTS = 3


def make(log_or_run, dbc, output):
    path, folder = places(log_or_run, output)
    database = dbc_signals.Database(dbc or [DBC])
    messages = {}
    for message in database.messages:
        messages.setdefault(dbc_signals.key_of(message), Decoder(message))
    messages.update(stand_ins(path, list(messages.values()), messages))
    log = BusLog(path)
    unknown = {}
    clock = Clock(earliest_s=0.0, longest_gap_s=math.inf, longest_s=math.inf)
    with contextlib.ExitStack() as files:
        writers = [kind(files.enter_context(file_io.growing(folder / name)))
                   for kind, name in ((Mf4Writer, "signals.mf4"), (McapWriter, "run.mcap"))]
        for frame in progress.reported(log):
            clock.take(path, frame.time_s)
            decoder = dbc_signals.found_for(frame, messages)
            if decoder is None:
                unknown[frame.identifier] = unknown.get(frame.identifier, 0) + 1
                continue
            decoder.take(frame, writers)
        if not any(decoder.count for decoder in messages.values()):
            raise LogError(f"{path}: has no frame that {database.name} knows; give the DBC file of its frames with --dbc")
        for writer in writers:
            writer.finish()
    account(path, {id(decoder): decoder for decoder in messages.values()}.values(), unknown, folder)


def places(log_or_run, output):
    """The log, and where the results go."""
    if not log_or_run.exists():
        raise LogError(f"{log_or_run}: there is no such folder or log")
    if not log_or_run.is_dir():
        if output is None:
            raise LogError(f"{log_or_run}: is no folder of a run, so say where the results go: --output DIR")
    elif not (log_or_run / "candump.log").exists():
        raise LogError(f"{log_or_run}: has no candump.log; give the folder of a run, or a log")
    path = log_or_run / "candump.log" if log_or_run.is_dir() else log_or_run
    folder = output or log_or_run
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise LogError(f"cannot make the folder {folder}: {error.strerror}") from error
    if path.exists() and path.resolve() in [(folder / name).resolve() for name in ("signals.mf4", "run.mcap")]:
        raise LogError(f"{path}: the result would take its place; choose another folder with --output")
    return pathlib.Path(path), folder


def stand_ins(path, decoders, messages):
    """Decoders of messages whose identifier no frame has, by their J1939 parameter group. The log is read for it."""
    absent = {decoder.message.frame_id: decoder for decoder in decoders
              if decoder.message.is_extended_frame and decoder.message.protocol != "j1939"}
    if absent:
        for frame in BusLog(path).frames():
            if frame.extended:
                absent.pop(frame.identifier, None)
    by_group = {}
    for decoder in absent.values():
        by_group.setdefault(dbc_signals.group_key(decoder.message.frame_id), decoder)
    return {key: decoder for key, decoder in by_group.items() if key not in messages}


def is_text(signal):
    """Whether its values are shown as texts. A name or two for "not available" make no text of a number."""
    return dbc_signals.is_enumeration(signal) or (bool(signal.choices) and len(signal.choices) >= LEAST_TEXTS
                                                  and signal.length <= MOST_BITS_OF_TEXTS and not signal.is_float)


class Decoder:
    """The frames of one message. Each of its senders has a group of signals, and each page of a multiplexed one."""

    def __init__(self, message):
        self.message = message
        self.parts = dbc_signals.sound_parts(message)
        self.count = self.undecodable = 0
        self.texts = {signal.name for signal in message.signals if is_text(signal)}
        self.signals = {signal.name: signal for signal in message.signals}
        self.first = None  # bus and identifier of the first sender; identifiers differ in the source address of J1939

    def take(self, frame, writers):
        try:
            values = dbc_signals.decoded(self.parts, frame.data)
            whole = values if len(frame.data) >= self.message.length else dbc_signals.decoded(
                self.parts, frame.data.ljust(self.message.length, b"\0"))
        except Exception:  # cantools raises several; the frame is lost, not the log
            self.undecodable += 1
            return
        self.count += 1
        self.first = self.first or (frame.bus, frame.identifier)
        group = self.message.name
        group += f"_on_bus_{frame.bus}" if frame.bus != self.first[0] else ""
        group += f"_from_{frame.identifier & 0xFF:02X}" if frame.identifier != self.first[1] else ""
        for name, value in whole.items():
            if self.signals[name].is_multiplexer:
                group += f"_{name}_{int(getattr(value, 'value', value))}"
        shown = {name: self.shown(name, values.get(name)) for name in whole}
        for writer in writers:
            writer.take(group, round(frame.time_s * 1.0e6), shown, self.signals)

    def shown(self, name, value):
        """A text, or a number that is NaN where there is none."""
        if name in self.texts:
            return "" if value is None else str(value)
        return float("nan") if value is None or isinstance(value, NamedSignalValue) else float(value)


def account(path, decoders, unknown, folder):
    print(f"{path}: " + ", ".join(f"{one.count} {one.message.name}" for one in decoders if one.count))
    for one in decoders:
        if one.first and one.message.protocol != "j1939" and one.first[1] != one.message.frame_id:
            print(f"  {dbc_signals.said_of_group(one.message, one.first[1])}")
        if one.undecodable:
            print(f"  {one.undecodable} frames of {one.message.name} could not be decoded")
    if unknown:
        print(f"  {sum(unknown.values())} frames are not in the DBC file: "
              + ", ".join(f"0x{identifier:X}" for identifier in sorted(unknown)[:10]) + (", ..." if len(unknown) > 10 else ""))
    print(f"  {folder / 'signals.mf4'}\n  {folder / 'run.mcap'}")
