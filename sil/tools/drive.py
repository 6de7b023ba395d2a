"""Makes a drive for `rsi-sil replay` and `identify` from others' logs and a mapping."""

import datetime
import sys

import numpy

import consistency
import dbc_signals
import drive_rows
import table_signals
import file_io
from bus_log_writers import FIRST_CALENDAR_TIME_S
from drive_quantities import QUANTITIES, REQUIRED, WHEEL_LOADS
from log_error import LogError
from mapping import Mapping

LONGEST_PERIOD_US = 21_000  # of what replays need in every row: 50 Hz, with room for a clock's error
ROWS = 20_000               # written at a time
LARGEST_VALUE = 1.0e9       # as rsi-sil replay has it
KMH_PER_MPS = 3.6
ALTERNATIVES = (("roll_angle",), ("speed", "yaw_rate"))


def make(logs, dbc, mapping_file, output):
    mapping = Mapping(mapping_file)
    check_quantities(mapping)
    for path in [*logs, mapping_file, *(dbc or [])]:
        if output.exists() and path.exists() and output.samefile(path):
            raise LogError(f"{path}: the result would take its place; choose another file with --output")
    log_names = ", ".join(str(path) for path in logs)
    recorded, missing = (dbc_signals.read(logs, dbc_signals.database(dbc), mapping) if dbc else
                         table_signals.read(logs, mapping))
    check_recorded(mapping, recorded, missing, log_names)
    recorded, start = from_zero(recorded)
    drive = Drive(mapping, recorded, missing, log_names)
    write(output, drive, [f"of {log_names}, by {mapping_file}"] + start)
    lines, is_doubtful = consistency.reported(drive.times_us, drive.columns)
    doubts = [f"{name}: LOOK: {doubt}" for name, one in drive.recorded.items() for doubt in one.doubts]
    print("\n".join([drive.account()] + start + lines + doubts))
    if is_doubtful:
        print("sil/tools/logs: the drive was written, but its signals contradict each other (LOOK above): check signs and units "
              f"in {mapping_file}", file=sys.stderr)
    if doubts:
        print(f"sil/tools/logs: the drive was written, but a range is not as the signal (LOOK above): say in {mapping_file} which "
              "one it has", file=sys.stderr)
    print(f"  {output}")
    return drive


def check_quantities(mapping):
    """That it will make a drive, before a long log is read."""
    there = {entry.quantity for entry in mapping.entries}
    for quantity in QUANTITIES.values():
        if quantity.need == REQUIRED and quantity.name not in there:
            raise LogError(f"{mapping.path}: there is no table [{quantity.name}], and every drive needs it (docs/drives.md)")
    if not any(there.issuperset(names) for names in ALTERNATIVES):
        raise LogError(f"{mapping.path}: there is no table [roll_angle], nor both [speed] and [yaw_rate]; a drive needs the one "
                       "or the others (docs/drives.md)")
    loads = there.intersection(WHEEL_LOADS)
    if loads and len(loads) < len(WHEEL_LOADS):
        absent = next(name for name in WHEEL_LOADS if name not in there)
        raise LogError(f"{mapping.path}: only {len(loads)} of the four wheel loads are mapped; add [{absent}], or leave all out")


def check_recorded(mapping, recorded, missing, log_names):
    """That what every drive needs was in the log. Anything else may be missing, and is reported."""
    for name in [quantity.name for quantity in QUANTITIES.values() if quantity.need == REQUIRED]:
        if name in missing:
            raise LogError(f"{log_names}: {missing[name]}, and {mapping.place(name, 'signal')} maps it to {name}, which every drive "
                           "needs; is it the right log, DBC file and bus?")
    if not any(set(names) <= set(recorded) for names in ALTERNATIVES):
        raise LogError(f"{log_names}: there is neither roll_angle nor both speed and yaw_rate: "
                       + "; ".join(missing[name] for names in ALTERNATIVES for name in names if name in missing))
    if any(name in missing for name in WHEEL_LOADS):
        for name in WHEEL_LOADS:
            recorded.pop(name, None)


def from_zero(recorded):
    """Calendar times made those since the first value, which people can read, and a line that says so."""
    start_us = min(int(one.times_us[0]) for one in recorded.values())
    if start_us < FIRST_CALENDAR_TIME_S * 1_000_000:
        return recorded, []
    start = datetime.datetime.fromtimestamp(0, datetime.timezone.utc) + datetime.timedelta(microseconds=start_us)
    shifted = {name: one._replace(times_us=one.times_us - start_us) for name, one in recorded.items()}
    return shifted, [f"time_s is the time since {start_us / 1.0e6:.6f} s in the log, {start.isoformat(timespec='microseconds')}"]


class Drive:
    """The rows of a drive and what was found on the way."""

    def __init__(self, mapping, recorded, missing, log_names):
        self.entries = {entry.quantity: entry for entry in mapping.entries if entry.quantity in recorded}
        self.missing = missing
        self.recorded = {}
        self.found = {}
        for name in QUANTITIES:
            if name in self.entries:
                self.recorded[name] = applied(self.entries[name], recorded[name], mapping)
                self.found[name] = drive_rows.examine(self.recorded[name].times_us)
        self._check_rates(mapping, log_names)
        self.times_us = self._clock(log_names)
        self.columns = {name: drive_rows.sampled(one.times_us, one.values, self.times_us) for name, one in self.recorded.items()}
        is_whole = numpy.all([~numpy.isnan(self.columns[name]) for name in self._required()], axis=0)
        self.silent = len(self.times_us) - int(numpy.sum(is_whole))
        self.times_us = self.times_us[is_whole]
        self.columns = {name: values[is_whole] for name, values in self.columns.items()}
        if len(self.times_us) < 2:
            raise LogError(f"{log_names}: there are no two instants at which {' and '.join(self._required())} are both known")

    @staticmethod
    def _required():
        return [quantity.name for quantity in QUANTITIES.values() if quantity.need == REQUIRED]

    def _check_rates(self, mapping, log_names):
        for name in self._required():
            period_us = self.found[name].period_us
            if period_us > LONGEST_PERIOD_US or period_us == 0:
                often = f"comes every {period_us / 1000:g} ms" if period_us else "comes once"
                mapping.fail(name, "signal", f"is {self.entries[name].signal}, which {often} in {log_names}; the component needs it "
                                             "every 20 ms at least: record at 50 Hz or more")

    def _clock(self, log_names):
        """Every 10 ms from the first lateral acceleration on, as far as all that every row needs goes."""
        spans = {name: (int(one.times_us[0]), int(one.times_us[-1])) for name, one in self.recorded.items()
                 if name in self._required()}
        first = max(start for start, _ in spans.values())
        last = min(end for _, end in spans.values())
        times_us = self.recorded["lateral_acceleration"].times_us
        times_us = times_us[times_us >= first]
        if not len(times_us) or last <= times_us[0]:
            spoken = ", ".join(f"{name} from {start / 1e6:.3f} s to {end / 1e6:.3f} s" for name, (start, end) in spans.items())
            raise LogError(f"{log_names}: never has all that every row needs at a time: {spoken}")
        return numpy.arange(times_us[0], last + 1, drive_rows.STEP_US, dtype="i8")

    def account(self):
        """Statistics of each signal and of the rows."""
        rows = [("column", "signal", "Hz", "from s", "to s", "missing", "gaps", "longest s", "empty", "least", "largest")]
        for name, found in self.found.items():
            times_us = self.recorded[name].times_us
            rate = f"{1e6 / found.period_us:.4g}" if found.period_us else "-"
            empty = int(numpy.sum(numpy.isnan(self.columns[name])))
            known = self.columns[name][~numpy.isnan(self.columns[name])]
            ends = (f"{known.min():.4g}", f"{known.max():.4g}") if len(known) else ("-", "-")
            rows.append((QUANTITIES[name].column, self.entries[name].signal, rate,
                         f"{times_us[0] / 1e6:.3f}", f"{times_us[-1] / 1e6:.3f}", str(found.missing), str(found.gaps),
                         f"{found.longest_us / 1e6:.3f}", str(empty), *ends))
        widths = [max(len(row[index]) for row in rows) for index in range(len(rows[0]))]
        lines = ["  ".join(text.ljust(width) if index < 2 else text.rjust(width)
                           for index, (text, width) in enumerate(zip(row, widths))) for row in rows]
        for name, one in self.recorded.items():
            lines += [f"{name}: {count} values left out: {reason}" for reason, count in one.left_out.items()]
        lines += [f"{name}: none; {why}" for name, why in self.missing.items()]
        span = (self.times_us[-1] - self.times_us[0]) / 1e6
        lost = f"{self.silent} left out, where {' or '.join(self._required())} is missing" if self.silent else "none missing"
        lines.append(f"{len(self.times_us)} rows over {span:.2f} s; {lost}")
        return "\n".join(lines)


def applied(entry, recorded, mapping):
    """In the unit, with the sign and at the time of the drive's column."""
    factor = mapping.unit_factor(entry, recorded.unit)
    with numpy.errstate(over="ignore"):
        values = factor * (entry.factor * recorded.values + entry.offset)
        if entry.distance_m is not None:
            values = slope(values, entry)
        values = entry.sign * values + 0.0  # no minus zero
    is_possible = numpy.abs(values) <= LARGEST_VALUE
    absurd = len(values) - int(numpy.sum(is_possible))
    if absurd > len(values) / 2:
        largest = values[numpy.argmax(numpy.abs(values))]
        mapping.fail(entry.quantity, "signal", f"is {entry.signal}, and {QUANTITIES[entry.quantity].column} becomes "
                                               f"{largest:.4g} of it, beyond anything possible; are its unit, factor and offset "
                                               "right?")
    left_out = {**recorded.left_out, **({"beyond anything possible": absurd} if absurd else {})}
    times_us = recorded.times_us - round(entry.lag_s * 1.0e6)
    return recorded._replace(times_us=times_us[is_possible], values=values[is_possible], left_out=left_out)


def slope(difference, entry):
    """The angle or rate of a body of which two points so far apart differ in height or speed."""
    if QUANTITIES[entry.quantity].dimension == "angle":
        return numpy.degrees(numpy.arctan(difference / entry.distance_m))
    return numpy.degrees(difference / KMH_PER_MPS / entry.distance_m)


def write(output, drive, remarks):
    names = list(drive.columns)
    with file_io.growing(output) as file:
        header = ",".join(["time_s"] + [QUANTITIES[name].column for name in names])
        lines = [f"# {' '.join(remark.split())}" for remark in remarks] + [header]
        file.write(("\n".join(lines) + "\n").encode("utf-8", "replace"))
        for first in range(0, len(drive.times_us), ROWS):
            part = slice(first, first + ROWS)
            times = [seconds(time_us) for time_us in drive.times_us[part].tolist()]
            columns = [["" if value != value else f"{value:.9g}" for value in drive.columns[name][part].tolist()]
                       for name in names]
            file.write("".join(",".join(row) + "\n" for row in zip(times, *columns)).encode("ascii"))


def seconds(time_us):
    return f"{'-' * (time_us < 0)}{abs(time_us) // 1_000_000}.{abs(time_us) % 1_000_000:06d}"
