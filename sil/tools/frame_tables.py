"""Tables of frames: CSVs of GVRET (SavvyCAN), python-can, CANedge, and others that name the same columns."""

import csv
import re

import can

from bus_frame import LARGEST_STANDARD, Frame, checked
from text_lines import frames_by, is_comment, lines_of

PYTHON_CAN = "timestamp,arbitration_id,extended,remote,error,dlc,data"
NAMES = {"time": ("time stamp", "timestamp", "timestampepoch", "time", "time_s"), "identifier": ("id", "arbitration_id", "addr"),
         "extended": ("extended", "ide"), "bus": ("bus", "buschannel", "channel"), "remote": ("rtr", "remote"),
         "error": ("error",), "length": ("len", "datalength"), "data": ("data", "databytes", "d1"), "flexible": ("edl", "fdf"),
         "bit_rate_switch": ("brs",), "error_state": ("esi",)}
NEEDED = {"time", "identifier", "data"}
HEADER_LINES = 20


def kind_of(text):
    """Which table of frames begins so; None for any other text."""
    for line in text.splitlines()[:HEADER_LINES]:
        if line.strip() == PYTHON_CAN:
            return "CSV of python-can"
        if header_of(line):
            return "CSV of frames"
        if line.strip() and not is_comment(line):
            return None
    return None


def header_of(line):
    """The separator and the place of each column; None where it is no header."""
    for separator in ",;\t":
        names = [name.strip(' "').lower() for name in line.strip().split(separator)]
        places = {role: names.index(name) for role, known in NAMES.items() for name in known if name in names}
        if NEEDED <= set(places):
            return separator, places, names
    return None


def python_can(log):
    with log.path.open("rb") as file:
        lines = lines_of(log, file)
        next(lines, None)
        yield from frames_by(can.CSVReader, log, (line for line in lines if line.strip()), lambda: [PYTHON_CAN], first_bus=1)


def table(log):
    with log.path.open("rb") as file:
        lines = (line for line in lines_of(log, file) if line.strip())
        separator, places, names = header_of(next(line for line in lines if not is_comment(line)))
        row = Row(places, names)
        if any(re.fullmatch(r"\d+(\.\d*)?", name) for name in names):
            log.left_out.damage(log.place(), "a row follows the names in their line")
        for line in lines:
            if is_comment(line):
                log.left_out.kinds["remarks"] += 1
                continue
            try:
                kind, frame = row.read(next(csv.reader([line], delimiter=separator)))
                if kind:
                    log.left_out.kinds[kind] += 1
                else:
                    yield checked(frame)
            except (ValueError, IndexError, csv.Error) as error:
                log.left_out.damage(log.place(), f"the line cannot be understood ({error})")


class Row:
    def __init__(self, places, names):
        self._places = places
        self._columns = len(names)
        self._is_gvret = names[places["data"]] == "d1"  # a column each byte
        self._counts_from_0 = "bus" in names

    def read(self, fields):
        """A kind that is left out, or the frame."""
        fields = [field.strip() for field in fields]
        for name, kind in (("remote", "remote frames"), ("error", "error frames")):
            if self._flag(fields, name):
                return kind, None
        text = fields[self._places["identifier"]]
        identifier = int(text, 16)
        extended = self._flag(fields, "extended") if "extended" in self._places else identifier > LARGEST_STANDARD
        bus = int(fields[self._places["bus"]]) + self._counts_from_0 if "bus" in self._places else 1
        return None, Frame(self._time_s(fields), bus, identifier, extended, self._data(fields), self._flag(fields, "flexible"),
                           self._flag(fields, "bit_rate_switch"), self._flag(fields, "error_state"))

    def _flag(self, fields, name):
        if name not in self._places:
            return False
        text = fields[self._places[name]].lower()
        if text not in ("0", "1", "false", "true"):
            raise ValueError(f"{name} is '{text[:20]}'")
        return text in ("1", "true")

    def _time_s(self, fields):
        text = fields[self._places["time"]].replace(",", ".")
        return int(text) / 1.0e6 if self._is_gvret and re.fullmatch(r"\d+", text) else float(text)

    def _data(self, fields):
        first = self._places["data"]
        length = int(fields[self._places["length"]]) if "length" in self._places else None
        if self._is_gvret:
            columns = [field for field in fields[first:] if field]
            data = bytes(int(field, 16) for field in (columns if length is None else columns[:length]))
            is_longer = length is not None and any(column.strip("0") for column in columns[length:])
        else:
            is_longer = any(fields[self._columns:])
            data = bytes.fromhex(re.sub(r"0[xX]|[ .:-]", "", fields[first]))
        if is_longer:
            raise ValueError("another row follows in the same line")
        if length is not None and len(data) < length:
            raise ValueError(f"there are {len(data)} of {length} bytes")
        return data if length is None else data[:length]
