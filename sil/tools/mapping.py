"""A mapping: the signal of a foreign log for each quantity of a drive. TOML, one table a quantity."""

import collections
import difflib
import math
import pathlib
import re
import tomllib

import file_io
from drive_quantities import QUANTITIES, admitted, factor_of
from log_error import LogError

# The quantity in the unit of its column is sign * unit_factor * (factor * number + offset), lag_s earlier than
# recorded. `unit` is None where the log's own is meant. `bus` is None where any will do. The number is the signal's; less that
# of the signal `minus`, `distance_m` apart; negative where the signal `sign_signal` is 1. `range` is what the number is in
# where it is known, IGNORED where any is, None where it is as the log says.
Entry = collections.namedtuple("Entry", "quantity signal unit factor offset sign lag_s bus sign_signal minus distance_m range",
                               defaults=(None, None, None, None))

KEYS = ("signal", "unit", "factor", "offset", "sign", "lag_ms", "bus", "minus", "distance_m", "range")
IGNORED = "ignore"
ROLES = {"signal": "signal", "sign": "sign_signal", "minus": "minus"}  # keys that name signals: fields of the entry
# A difference over a distance is a slope: of lengths an angle, of speeds a rate.
SLOPES = {"angle": "length", "rate": "speed"}
OPEN = "?"  # a draft's entry for an unknown value
LARGEST_LAG_MS = 1000.0


class Mapping:
    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.text = read_text(self.path)
        tables = self._parse()
        self.time = self._time(tables.pop("time", None))
        self.entries = [self._entry(name, table) for name, table in tables.items()]
        if not self.entries:
            raise LogError(f"{self.path}:1: there is no quantity; a mapping has tables such as [lateral_acceleration] with a key "
                           "signal (docs/can.md); `sil/tools/logs draft` writes one to begin with")

    def place(self, table, key=None):
        """FILE:LINE of a key, as far as it can be found."""
        current = ""
        fallback = 1
        for number, line in enumerate(self.text.splitlines(), 1):
            header = re.match(r"\s*\[\s*([\w\"'-]+)\s*\]", line)
            if header:
                current = header[1].strip("\"'")
                fallback = number if current == table else fallback
            elif re.match(rf"\s*{re.escape(table)}\s*[.=]", line) and not current:
                fallback = number
                if key is None or re.search(rf"\b{re.escape(key)}\s*=", line):
                    return f"{self.path}:{number}"
            elif current == table and key is not None and re.match(rf"\s*[\"']?{re.escape(key)}[\"']?\s*=", line):
                return f"{self.path}:{number}"
        return f"{self.path}:{fallback}"

    def fail(self, table, key, what):
        raise LogError(f"{self.place(table, key)}: {table}{'.' + key if key else ''} {what}")

    def _parse(self):
        try:
            tables = tomllib.loads(self.text)
        except tomllib.TOMLDecodeError as error:
            line = re.search(r"at line (\d+), column (\d+)", str(error))
            where = f"{line[1]}:{line[2]}" if line else str(len(self.text.splitlines()))
            what = re.sub(r" \(at .*\)", "", str(error))
            raise LogError(f"{self.path}:{where}: this is no TOML ({what}); texts need quotation marks, as in signal = "
                           "\"Message.Signal\"") from error
        for name, table in tables.items():
            if name != "time" and name not in QUANTITIES:
                raise LogError(f"{self.place(name)}: {name} is no quantity of a drive; {closest(name, QUANTITIES)}")
            if not isinstance(table, dict):
                self.fail(name, None, f"must be a table: a line [{name}], then the line signal = \"Message.Signal\"")
        return tables

    def _time(self, table):
        """Column and unit of the time, for tables of values; None where it is not given."""
        if table is None:
            return None
        self._check_keys("time", table, ("signal", "unit"))
        unit = self._text("time", table, "unit", "s")
        if factor_of(unit, "time") is None:
            self.fail("time", "unit", f"is '{unit}', but must be one of {admitted('time')}")
        return self._text("time", table, "signal", None), factor_of(unit, "time")

    def _check_keys(self, name, table, keys):
        for key, value in table.items():
            if key not in keys:
                self.fail(name, key, f"is not known; there are {', '.join(keys)}")
            if value == OPEN:
                self.fail(name, key, "is not answered yet: the draft could not know it; put the answer in place of \"?\", or "
                                     f"delete the whole table [{name}] when the log has no such signal")

    def _entry(self, name, table):
        self._check_keys(name, table, KEYS)
        minus, distance_m = self._difference(name, table)
        dimension = dimension_of(name, minus)
        unit = self._text(name, table, "unit", "") or None
        if unit is not None and factor_of(unit, dimension) is None:
            self.fail(name, "unit", f"is '{unit}', but must be one of {admitted(dimension)}; for any other give factor, which "
                                    "makes one of these of the log's numbers")
        factor = self._number(name, table, "factor", 1.0)
        if factor == 0.0:
            self.fail(name, "factor", "is 0: that leaves nothing of the signal")
        if factor < 0.0:
            self.fail(name, "factor", "is negative; give it positive, and sign = -1")
        sign, sign_signal = self._sign(name, table)
        lag_ms = self._number(name, table, "lag_ms", 0.0)
        if not 0.0 <= lag_ms <= LARGEST_LAG_MS:
            self.fail(name, "lag_ms", f"is {lag_ms:g}, but must be from 0 to {LARGEST_LAG_MS:g}: so long before its time in the "
                                      "log a value was measured")
        bus = table.get("bus")
        if bus is not None and (isinstance(bus, bool) or not isinstance(bus, (int, str))):
            self.fail(name, "bus", "must be the bus's number, from 1, or a candump log's interface in quotation marks")
        return Entry(name, self._text(name, table, "signal", None), unit, factor, self._number(name, table, "offset", 0.0),
                     sign, lag_ms / 1000.0, bus, sign_signal, minus, distance_m, self._range(name, table))

    def _difference(self, name, table):
        minus = self._text(name, table, "minus", "") or None
        if (minus is None) != ("distance_m" not in table):
            self.fail(name, "distance_m" if minus is None else "minus", "needs the other one: minus is the signal to subtract, "
                                                                        "distance_m how far they are apart")
        if minus is not None and QUANTITIES[name].dimension not in SLOPES:
            self.fail(name, "minus", f"makes an angle of two heights or a rate of two speeds, and {name} is neither")
        distance_m = self._number(name, table, "distance_m", 1.0)
        if distance_m <= 0.0:
            self.fail(name, "distance_m", f"is {distance_m:g}, but must be more than 0")
        return minus, distance_m if minus is not None else None

    def _sign(self, name, table):
        """1 or -1, and the signal that has the sign, if it comes beside a magnitude."""
        sign = table.get("sign", 1)
        if isinstance(sign, str) and sign.strip("- "):
            return -1 if sign.startswith("-") else 1, sign.lstrip("-").strip()
        if isinstance(sign, bool) or sign not in (1, -1):
            self.fail(name, "sign", "must be 1 (as in docs/drives.md: a left turn is positive), -1 (the other way round), or the "
                                    "signal \"Message.Signal\" that is 1 where the number is negative (\"-Message.Signal\": where "
                                    "it is positive)")
        return int(sign), None

    def _range(self, name, table):
        values = table.get("range")
        if values is None or values == IGNORED:
            return values
        if not isinstance(values, list) or len(values) != 2 or not all(is_number(value) for value in values) \
                or not values[0] < values[1]:
            self.fail(name, "range", f"must be [least, largest] of the log's numbers, or \"{IGNORED}\"")
        return float(values[0]), float(values[1])

    def _text(self, name, table, key, default):
        value = table.get(key, default)
        if value is None:
            self.fail(name, None, f"has no key {key}; add {key} = \"Message.Signal\", or the column's name for a table of values")
        if not isinstance(value, str) or (key == "signal" and not value.strip()):
            self.fail(name, key, "must be a text in quotation marks")
        return value.strip()

    def _number(self, name, table, key, default):
        value = table.get(key, default)
        if not is_number(value):
            self.fail(name, key, "must be a finite number")
        return float(value)

    def unit_factor(self, entry, unit_of_log, role="signal"):
        """From the log's number (after factor and offset) to the drive's column."""
        dimension = dimension_of(entry.quantity, entry.minus)
        factor = factor_of(entry.unit if entry.unit is not None else unit_of_log, dimension)
        if factor is None:
            said = f"'{unit_of_log}'" if unit_of_log else "none"
            self.fail(entry.quantity, role, f"is {signals_of(entry)[role]}, whose unit in the log or DBC file ({said}) does not "
                                            f"do; add unit = one of {admitted(dimension)}")
        return factor


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def signals_of(entry):
    """The names of an entry's signals by their roles."""
    return {role: getattr(entry, field) for role, field in ROLES.items() if getattr(entry, field) is not None}


def dimension_of(quantity, minus):
    """The dimension of the log's numbers."""
    dimension = QUANTITIES[quantity].dimension
    return dimension if minus is None else SLOPES[dimension]


def read_text(path):
    try:
        return file_io.read(path)
    except UnicodeDecodeError as error:
        raise LogError(f"{path}: is no text in UTF-8 (byte {error.start})") from error
    except OSError as error:
        raise LogError(f"{path}: cannot be read: {error.strerror}") from error


def closest(name, names):
    """The likeliest of what a misspelt name may have meant; all of a few, some of many."""
    by_lower_case = {known.lower(): known for known in names}
    near = difflib.get_close_matches(name.lower(), by_lower_case, n=5, cutoff=0.5)
    last = name.lower().rpartition(".")[2]
    if not near:
        near = [key for key in by_lower_case if key.rpartition(".")[2] == last or (len(last) > 2 and last in key)][:5]
    if near:
        return "close to it: " + ", ".join(by_lower_case[key] for key in near)
    shown = sorted(names)[:15]
    return "there are " + ", ".join(shown) + (f" and {len(names) - len(shown)} more" if len(names) > len(shown) else "")
