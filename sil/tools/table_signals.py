"""The mapped signals of logs that are decoded already: columns of a CSV, channels of an MF4."""

import collections
import csv
import datetime
import errno
import itertools
import pathlib
import re

import apart
import progress
import file_io
from bus_logs import kind_of
from drive_quantities import UNITS, is_known
from left_out import LeftOut
from log_error import LogError
from mapping import closest, signals_of
from recorded import Clock, Collected, combined

# A column or channel, with what a signal of a DBC file also has.
Column = collections.namedtuple("Column", "name unit minimum maximum scale is_float", defaults=("", None, None, 1.0, True))

HEADER_LINES = 200  # the names stand before
LONGEST_LINE = 1_000_000
SEPARATORS = (",", ";", "\t")
# Time of day, perhaps with its day before it.
CLOCK = re.compile(r"(?:(\d{4})-(\d\d?)-(\d\d?)[T ]\s*|(\d\d?)\.(\d\d?)\.(\d{4})[ T,]\s*)?(\d\d?):(\d\d):(\d\d(?:[.,]\d+)?)Z?")
DAY_S = 86_400
SHORTEST_STEP_S, LONGEST_STEP_S = 0.004, 0.1  # between rows; 1 may be a second or a millisecond


def read(logs, mapping):
    """As dbc_signals.read()."""
    clock = Clock()
    collected = {}
    for path in logs:
        if is_csv(path):
            read_csv(path, mapping, clock, collected)
        else:
            read_mf4(path, mapping, collected)
    recorded = {entry.quantity: combined({role: collected[entry.quantity, role] for role in signals_of(entry)}, mapping)
                for entry in mapping.entries}
    missing = {}
    for (quantity, _), one in collected.items():
        if not one.times_us or quantity not in missing and not len(recorded[quantity].times_us):
            texts = f", only texts, such as '{one.examples[0]}'" if one.examples else ""
            missing[quantity] = f"{one.name()} has no value{texts}"
    return {name: one for name, one in recorded.items() if name not in missing}, missing


def is_csv(path):
    """Whether it is a CSV; otherwise it is an MF4."""
    beginning = beginning_of(path)
    kind = kind_of(beginning)
    if kind not in (None, "MF4"):
        raise LogError(f"{path}: holds frames ({kind}), so your DBC file is needed: --dbc FILE")
    if b"\0" in beginning and kind is None:
        raise LogError(f"{path}: is neither a log of frames (MF4, BLF, ASC, TRC, candump) nor a CSV")
    return kind is None


def beginning_of(path):
    try:
        if path.exists() and not path.is_file():
            raise OSError(errno.EINVAL, "it is a folder" if path.is_dir() else file_io.NO_ORDINARY_FILE)
        with path.open("rb") as file:
            beginning = file.read(4096)
    except OSError as error:
        raise LogError(f"{path}: cannot be read: {error.strerror}") from error
    if not beginning:
        raise LogError(f"{path}: the file is empty; was the recording or the copy finished?")
    return beginning


def into(collected, entry, role, unit, mapping):
    """The values of this entry's signal."""
    if entry.bus is not None:
        mapping.fail(entry.quantity, "bus", "is for logs of frames; leave it out here")
    if (entry.quantity, role) not in collected:
        if role != "sign":
            mapping.unit_factor(entry, unit, role)
        collected[entry.quantity, role] = Collected(entry, Column(signals_of(entry)[role], unit), role)
    return collected[entry.quantity, role]


def columns_of(path):
    """The columns or channels of a log that is decoded already, with their units; of a CSV also the time's."""
    if not is_csv(path):
        return list(itertools.chain(*of_mf4(path, lambda mdf: [[Column(channel.name, channel.unit or "")
                                                                for channel in mdf.iter_channels(skip_master=True)]])))
    layout = Csv(path).layout()
    if layout is None:
        raise LogError(f"{path}:1: no line of the first {HEADER_LINES} names columns of which rows of numbers follow")
    return [Column(name, unit) for name, unit in zip(layout.names, layout.units) if name]


# How a CSV is written: what separates fields, the line of the names, names and units, the first rows.
Layout = collections.namedtuple("Layout", "separator number names units rows")


class Csv:
    """A CSV of others, line by line: its fields, and how its numbers are written."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.size = self.path.stat().st_size
        self.left_out = LeftOut()
        self.number = 0
        self.is_ended = True
        self._file = None
        self.separator, self.comma = ",", False

    def lines(self):
        with self.path.open("rb") as self._file:
            for self.number, raw in enumerate(iter(lambda: self._file.readline(LONGEST_LINE), b""), 1):
                self.is_ended = raw.endswith((b"\n", b"\r"))
                try:
                    yield raw.decode("utf-8-sig" if self.number == 1 else "utf-8")
                except UnicodeDecodeError:
                    yield raw.decode("cp1252", "replace")

    def fields(self, line):
        try:
            return [field.strip() for field in next(csv.reader([line.rstrip("\r\n")], delimiter=self.separator), [])]
        except csv.Error as error:
            raise LogError(f"{self.path}:{self.number}: this line cannot be understood ({error}); export it again") from error

    def layout(self):
        """As far as the lines themselves tell, from the first rows of numbers upwards; None where there are no such."""
        head = [(self.number, line.strip()) for line in itertools.islice(self.lines(), HEADER_LINES)]
        layouts = [layout for layout in (self._layout(separator, head) for separator in SEPARATORS) if layout]
        return max(layouts, key=lambda layout: len(layout.names), default=None)

    def _layout(self, separator, head):
        self.separate_by(separator)
        rows = [(number, self.fields(line) if line and not is_remark(line) else []) for number, line in head]
        first = next((index for index, (_, fields) in enumerate(rows) if self.is_row(fields)), None)
        above = []  # lines without a number and of as many fields, the nearest first
        for number, fields in reversed(rows[:first] if first is not None else []):
            if len(fields) == len(rows[first][1]) and not any(self.is_value(field) for field in fields):
                above += [(number, fields)] * any(fields)
            elif above:
                break
        if not above:
            return None
        has_units = len(above) > 1 and any(field and is_known(field) for field in above[0][1])
        number, fields = above[has_units]
        names, units = named(fields)
        return Layout(separator, number, names, above[0][1] if has_units else units,
                      [fields for _, fields in rows[first:] if len(fields) == len(names)])

    def is_row(self, fields):
        filled = [field for field in fields if field]
        return len(fields) > 1 and sum(self.is_value(field) for field in filled) > len(filled) / 2

    def is_value(self, field):
        return self.number_of(field) is not None or CLOCK.fullmatch(field) is not None

    def separate_by(self, separator):
        self.separator, self.comma = separator, separator != ","

    def header(self, lines, time_name):
        """Names and units of the columns: of the line that has the name of the time's column."""
        layout = self.layout()
        number = layout.number if layout and time_name in layout.names else None
        first = layout.names if layout else None
        for line in lines:
            for separator in SEPARATORS:
                self.separate_by(separator)
                names, units = named(self.fields(line))
                if time_name in names and number in (None, self.number):
                    return names, units
                if first is None and len(names) > 1:
                    first = names
            if self.number >= HEADER_LINES:
                break
        raise LogError(f"{self.path}:1: no line of the first {HEADER_LINES} has a column '{time_name}', which the mapping's "
                       f"[time] names; {closest(time_name, first or [])}")

    def number_of(self, text):
        """None for what is no number."""
        try:
            return float(text.replace(",", ".") if self.comma else text)
        except ValueError:
            return None

    # For the account of progress.
    def position(self):
        return self.size if self._file.closed else self._file.tell()

    def frames(self):
        return self.rows

    rows = ()


class ClockTimes:
    """Seconds of a column of times of day: since midnight, or with days since 1970."""

    def __init__(self):
        self.days, self.latest_s = 0, 0.0

    def seconds(self, text):
        """None for what is no time of day."""
        found = CLOCK.fullmatch(text)
        if found is None:
            return None
        year, month, day, other_day, other_month, other_year, hours, minutes, rest = found.groups()
        of_day_s = 3600 * int(hours) + 60 * int(minutes) + float(rest.replace(",", "."))
        if year or other_year:
            try:
                date = datetime.date(int(year or other_year), int(month or other_month), int(day or other_day))
            except ValueError:
                return None
            return DAY_S * (date - datetime.date(1970, 1, 1)).days + of_day_s
        self.days += of_day_s < self.latest_s - DAY_S / 2  # midnight
        self.latest_s = of_day_s
        return DAY_S * self.days + of_day_s


def time_unit(path, name):
    """The unit of a CSV's times by its first rows, and a remark on it; None where they do not tell."""
    table = Csv(path)
    layout = table.layout()
    table.separate_by(layout.separator)
    texts = [row[layout.names.index(name)] for row in layout.rows]
    if texts and CLOCK.fullmatch(texts[0]):
        return "s", "the log has times of day"
    times = [number for number in map(table.number_of, texts) if number is not None]
    steps = sorted(later - earlier for earlier, later in zip(times, times[1:]))
    for unit, factor in UNITS["time"].items():
        if steps and SHORTEST_STEP_S <= factor * steps[len(steps) // 2] <= LONGEST_STEP_S:
            return unit, f"none stands there; the rows are {steps[len(steps) // 2]:g} apart"
    return None


def is_remark(line):
    """As recorders for lap times write between the rows."""
    return line.lstrip().startswith("#")


def named(fields):
    """Names and units of columns: a name, perhaps with its unit at the end, or "name"|"unit"|least|largest|rate."""
    parts = [[part.strip(' "') for part in field.split("|")] if field.count("|") == 4 else [field, unit_in(field)]
             for field in fields]
    return [part[0] for part in parts], [part[1] for part in parts]


def read_csv(path, mapping, clock, collected):
    if mapping.time is None:
        raise LogError(f"{mapping.path}:1: there is no table [time], and {path} is a CSV; add [time] with signal = the name of "
                       "the column that has the time, and its unit (for a log of frames in another container give --dbc)")
    table = Csv(path)
    lines = table.lines()
    names, units = table.header(lines, mapping.time[0])
    repeated = [name for name, count in collections.Counter(names).items() if count > 1]
    wanted = [(entry, role, name) for entry in mapping.entries for role, name in signals_of(entry).items()]
    used = {mapping.time[0]} | {name for _, _, name in wanted}
    if used.intersection(repeated):
        raise LogError(f"{path}:{table.number}: two columns are called '{sorted(used.intersection(repeated))[0]}'; rename one "
                       "of them")
    for entry, role, name in wanted:
        if name not in names:
            mapping.fail(entry.quantity, role, f"is '{name}', but {path} has no such column; {closest(name, names)}")
    read_rows(table, lines, names, units, mapping, wanted, clock, collected)


def read_rows(table, lines, names, units, mapping, wanted, clock, collected):
    time_index, time_factor = names.index(mapping.time[0]), mapping.time[1]
    header_line, targets, clock_times = table.number, None, ClockTimes()
    table.rows = lines
    for line in progress.reported(table):
        if not line.strip() or is_remark(line):
            continue
        fields = table.fields(line)
        if len(fields) == len(names) + 1 and not fields[-1]:
            fields.pop()  # a separator at the end of each row
        place = f"{table.path}:{table.number}"
        if not table.is_ended:
            raise LogError(f"{place}: the last line has no line end: the file was cut off; copy it again, or delete this line")
        if len(fields) != len(names):
            raise LogError(f"{place}: {len(fields)} fields, but line {header_line} names {len(names)} columns; export it again")
        number = table.number_of(fields[time_index])
        clock_s = clock_times.seconds(fields[time_index]) if number is None else None
        if targets is None and clock_s is None and all(table.number_of(field) is None for field in fields):
            units = fields if any(fields) else units  # a line of units below the names
            continue
        if number is None and clock_s is None:
            raise LogError(f"{place}: the time is '{fields[time_index][:40]}', which is neither a number nor a time of day; export "
                           "it as seconds")
        if targets is None:
            places = [names.index(name) for _, _, name in wanted]
            targets = [(index, into(collected, entry, role, units[index], mapping))
                       for index, (entry, role, _) in zip(places, wanted)]
        time_s = clock_s if number is None else number * time_factor
        clock.take(place, time_s)
        time_us = round(time_s * 1.0e6)
        for index, target in targets:
            take_field(table, fields[index], time_us, target)
    if targets is None:
        raise LogError(f"{table.path}:{header_line}: there are no rows below the header")


def take_field(table, text, time_us, target):
    if not text:
        target.left_out["empty"] += 1
        return
    value = table.number_of(text)
    if value is None:
        target.take_text(text[:40])
    else:
        target.take(time_us, value)


def unit_in(name):
    """The unit that a column's name ends with, as in "ay [m/s^2]", "ay (m/s^2)", "ay in m/s^2", "ay / m/s^2" and "ay_mps2"."""
    for opening, closing in ("[]", "()"):
        if name.endswith(closing) and opening in name:
            return name[name.rindex(opening) + 1:-1]
    for between in (" in ", " / ", "_"):
        ending = name.rpartition(between)[2]
        if ending != name and is_known(ending):
            return ending
    return ""


def read_mf4(path, mapping, collected):
    def channels(mdf):
        start_s = mdf.header.start_time.timestamp()
        for entry in mapping.entries:
            for role in signals_of(entry):
                signal = channel_of(mdf, path, mapping, entry, role)
                times_s = [start_s + time_s for time_s in signal.timestamps.tolist()]
                yield entry, role, signal.unit, times_s, signal.samples.tolist()

    for entry, role, unit, times_s, values in of_mf4(path, channels):
        target = into(collected, entry, role, unit, mapping)
        for time_s, value in zip(times_s, values):
            target.clock.take(path, time_s)
            if isinstance(value, (bytes, str)):
                target.take_text(value.decode("utf-8", "replace") if isinstance(value, bytes) else value)
            else:
                target.take(round(time_s * 1.0e6), float(value))


def of_mf4(path, work):
    """Items that `work` makes of an MF4 of decoded signals."""
    def opened():
        import asammdf  # takes a second, and others do not need it

        with asammdf.MDF(path) as mdf:
            if "CAN_DataFrame" in mdf.channels_db:
                raise LogError(f"{path}: holds frames (MF4), so your DBC file is needed: --dbc FILE")
            yield from work(mdf)

    try:
        yield from apart.items(path.stat().st_size, opened)
    except apart.Ended as error:
        raise LogError(f"{path}: the MF4 is damaged ({error}); copy or export it again") from error


def channel_of(mdf, path, mapping, entry, role):
    name = signals_of(entry)[role]
    places = mdf.channels_db.get(name)
    if not places:
        mapping.fail(entry.quantity, role, f"is '{name}', but {path} has no such channel; "
                                           f"{closest(name, list(mdf.channels_db))}")
    if len({group for group, _ in places}) > 1:
        mapping.fail(entry.quantity, role, f"is '{name}', but {path} has {len(places)} channels of this name; "
                                           "export it with names of their own")
    signal = mdf.get(name, group=places[0][0], index=places[0][1]).validate()
    if signal.samples.ndim != 1 or signal.samples.dtype.kind not in "fiubSUO":
        mapping.fail(entry.quantity, role, f"is '{name}', whose values in {path} are no numbers")
    return signal
