"""Logs of vehicle buses, frame by frame: MF4, BLF, ASC and candump. None is held as a whole."""

import collections
import errno
import heapq
import io
import pathlib
import re

import can

import file_io
from log_error import LogError

# One data frame. `bus` is a number as it stands in the file, or the interface's name in a candump log.
Frame = collections.namedtuple("Frame", "time_s bus identifier extended data flexible bit_rate_switch error_state")

CANDUMP_LINE = re.compile(
    r"\((\d+\.\d{6})\) (\S+) ([0-9A-Fa-f]{3}|[0-9A-Fa-f]{8})#(?:#([0-9A-Fa-f]))?((?:[0-9A-Fa-f]{2})*)(?: [RT])?")
CANDUMP_REMOTE = re.compile(r"\(\d+\.\d{6}\) \S+ [0-9A-Fa-f]+#[Rr]\w*(?: [RT])?")
CANDUMP_ERROR = re.compile(r"\(\d+\.\d{6}\) \S+ [2-3][0-9A-Fa-f]{7}#.*")
RECORDS = 20_000  # of an MF4, taken at a time
SEEMS_CSV = (", and it seems to be a CSV: `rsi-sil replay` reads it as it is, where its columns have the names of "
             "docs/drives.md, and `sil/tools/logs drive` without --dbc any other")


class BusLog:
    """A log to be read once. Afterwards `others` says how many frames it had that carry no data, by their kind."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.others = collections.Counter()
        self.size, beginning = self._look()
        self.kind = kind_of(beginning)
        self.position = lambda: 0
        if self.kind is None:
            raise LogError(f"{self.path}: this is no log that can be read; there are MF4, BLF, ASC and the log of "
                           "`candump -L`" + (SEEMS_CSV if b"," in beginning.split(b"\n")[0] else ""))

    def _look(self):
        try:
            if self.path.exists() and not self.path.is_file():
                raise OSError(errno.EINVAL, "it is a folder" if self.path.is_dir() else file_io.NO_ORDINARY_FILE)
            with self.path.open("rb") as file:
                beginning = file.read(4096)
            if not beginning:
                raise LogError(f"{self.path}: the file is empty; was the recording or the copy finished?")
            return self.path.stat().st_size, beginning
        except OSError as error:
            raise LogError(f"{self.path}: cannot be read: {error.strerror}") from error

    def frames(self):
        """All data frames, in the order of the file."""
        read = {"BLF": self._blf, "ASC": self._asc, "MF4": self._mf4, "candump": self._candump}[self.kind]
        try:
            yield from read()
        except OSError as error:
            raise LogError(f"{self.path}: cannot be read: {error.strerror}") from error
        except LogError:
            raise
        except Exception as error:  # the libraries raise anything on a damaged file
            raise LogError(f"{self.path}: the {self.kind} is damaged near byte {self.position()} of {self.size} "
                           f"({type(error).__name__}: {error}); copy or export it again") from error

    def _blf(self):
        with self.path.open("rb") as raw:
            file = Unbroken(raw, self.path, self.size)
            self.position = lambda: file.reached
            reader = can.BLFReader(file)
            if self.size < reader.file_size:
                raise LogError(f"{self.path}: the BLF was cut off: it says that it has {reader.file_size} bytes, and "
                               f"{self.size} are there; copy it again")
            yield from self._messages(reader)

    def _asc(self):
        # Comments and names may be in any code page; frames are ASCII.
        with self.path.open("r", encoding="latin-1") as raw:
            self.position = lambda: self.size if raw.closed else raw.buffer.tell()
            lines = NumberedLines(raw)
            reader = can.ASCReader(lines)
            try:
                for frame in self._messages(reader):
                    if reader.timestamps_format and reader.timestamps_format.lower() == "relative":
                        raise LogError(f"{self.path}:1: the times are relative, each to the line before; record or export "
                                       "the ASC with absolute ones")
                    yield frame
            except (ValueError, IndexError, TypeError) as error:
                raise LogError(f"{self.path}:{lines.number}: this line cannot be understood ({error}); export the log again, "
                               "or delete the line") from error
            if lines.number and not lines.is_ended:
                raise LogError(f"{self.path}:{lines.number}: the last line has no line end: the file was cut off; copy it again, "
                               "or delete this line")

    def _messages(self, reader):
        for message in reader:
            if message.is_error_frame or message.is_remote_frame:
                self.others["error" if message.is_error_frame else "remote"] += 1
                continue
            bus = message.channel + 1 if isinstance(message.channel, int) else 1  # python-can counts from 0
            yield Frame(message.timestamp, bus, message.arbitration_id, message.is_extended_id, bytes(message.data),
                        message.is_fd, message.bitrate_switch, message.error_state_indicator)

    def _mf4(self):
        import asammdf  # takes a second, and others do not need it

        with asammdf.MDF(self.path, raise_on_multiple_occurrences=False) as mdf:
            start_s = mdf.header.start_time.timestamp()
            groups = []
            for index, group in enumerate(mdf.groups):
                names = {channel.name for channel in group.channels}
                count = group.channel_group.cycles_nr
                if "CAN_DataFrame" in names and count:
                    groups.append(self._mf4_group(mdf, index, count, start_s))
                for kind in ("Error", "Remote"):
                    if f"CAN_{kind}Frame" in names:
                        self.others[kind.lower()] += count
            if not groups:
                raise LogError(f"{self.path}: the MF4 has no frames of a CAN bus (CAN_DataFrame); it holds decoded signals "
                               "(`sil/tools/logs drive` takes it without --dbc), or nothing")
            self.position = lambda: self.size * self._taken // max(self._wanted, 1)
            self._taken = 0
            self._wanted = sum(group.channel_group.cycles_nr for group in mdf.groups)
            yield from heapq.merge(*groups, key=lambda frame: frame.time_s)

    def _mf4_group(self, mdf, index, count, start_s):
        for offset in range(0, count, RECORDS):
            part = mdf.get("CAN_DataFrame", group=index, record_offset=offset, record_count=min(RECORDS, count - offset))
            self._taken += len(part.timestamps)
            column = {name.rpartition(".")[2]: part.samples[name] for name in part.samples.dtype.names}
            if len(part.timestamps) < min(RECORDS, count - offset):
                raise LogError(f"{self.path}: the MF4 was cut off: it says that it has {count} frames, and "
                               f"{offset + len(part.timestamps)} are there; copy it again")
            zeros = [0] * len(part.timestamps)
            rows = zip(part.timestamps.tolist(), *(
                column[name].tolist() if name in column else zeros for name in ("BusChannel", "ID", "IDE", "EDL", "BRS", "ESI")))
            lengths = column["DataLength"].tolist()
            for number, (time_s, bus, identifier, extended, flexible, switch, error_state) in enumerate(rows):
                yield Frame(time_s + start_s, bus, identifier & 0x1FFFFFFF, bool(extended or identifier & 0x80000000),
                            column["DataBytes"][number][:lengths[number]].tobytes(), bool(flexible), bool(switch),
                            bool(error_state))

    def _candump(self):
        with self.path.open("rb") as raw:
            self.position = lambda: self.size if raw.closed else raw.tell()
            for number, line in enumerate(raw, 1):
                text = line.decode("ascii", "replace").rstrip("\r\n")
                if not text:
                    continue
                if not line.endswith(b"\n"):
                    raise LogError(f"{self.path}:{number}: the last line has no line end: the file was cut off; copy it again, or "
                                   "delete this line")
                match = CANDUMP_LINE.fullmatch(text)
                if match is None and (CANDUMP_REMOTE.fullmatch(text) or CANDUMP_ERROR.fullmatch(text)):
                    self.others["remote" if CANDUMP_REMOTE.fullmatch(text) else "error"] += 1
                    continue
                if match is None:
                    raise LogError(f"{self.path}:{number}: this is no line of `candump -L`, such as (0.010000) can0 123#AABB")
                time, bus, identifier, flags, data = match.groups()
                if len(identifier) == 8 and int(identifier, 16) > 0x1FFFFFFF:
                    self.others["error"] += 1
                    continue
                flag_bits = int(flags or "0", 16)
                yield Frame(float(time), bus, int(identifier, 16), len(identifier) == 8, bytes.fromhex(data), flags is not None,
                            bool(flag_bits & 1), bool(flag_bits & 2))


def kind_of(beginning):
    """Which kind of log begins so; None for any other file."""
    if beginning.startswith(b"LOGG"):
        return "BLF"
    if beginning.startswith((b"MDF     ", b"UnFinMF ")):
        return "MF4"
    text = beginning.decode("latin-1").lstrip("\ufeff\u00ef\u00bb\u00bf \t\r\n")
    if text.startswith("("):
        return "candump"
    if re.match(r"date\s|base\s+(hex|dec)|begin\s+triggerblock", text, re.IGNORECASE):
        return "ASC"
    return None


class Unbroken(io.RawIOBase):
    """A binary file whose end, in the middle of what a reader wants, is an error and not the end."""

    def __init__(self, file, path, size):
        super().__init__()
        self._file, self._path, self._size = file, path, size
        self.reached = 0

    def read(self, count=-1):
        data = self._file.read(count)
        self.reached += len(data)
        padding, header = 4, 16  # of a BLF's objects: the end may stand before either
        if len(data) < count and count >= padding and not (count == header and not data):
            raise LogError(f"{self._path}: the BLF was cut off after {self._size} bytes, in the middle of an object; copy it again")
        return data

    def readable(self):
        return True


class NumberedLines(io.TextIOBase):
    """The lines of a text, counted."""

    def __init__(self, file):
        super().__init__()
        self._file = file
        self.number = 0
        self.is_ended = True

    def __iter__(self):
        return self

    def __next__(self):
        line = self._file.readline()
        if not line:
            raise StopIteration
        self.number += 1
        self.is_ended = line.endswith("\n")
        return line

    def read(self, count=-1):
        return self._file.read(count)
