"""Drafts a mapping from the names and units of a DBC file, and asks for what it cannot know."""

import collections
import json
import re
import struct

import numpy

import consistency
import dbc_signals
import drive_rows
import progress
import signal_names
import table_signals
import file_io
from bus_log_writers import number_of
from bus_logs import BusLog, Frame
from drive_quantities import QUANTITIES, REQUIRED, WHEEL_LOADS, admitted, factor_of
from log_error import LogError
from mapping import Entry
from recorded import LONGEST_DRIVE_S
from signal_names import Candidate

# All of these are positive in a left turn.
SIGNED = ("lateral_acceleration", "roll_angle", "yaw_rate", "steering_wheel_angle")
SMOOTHED_ROWS = 21
STANDING_KMH = 1.0
# Signals that distinguish a turn from a straight, the best first; in the units of the columns.
TURNS = {"yaw_rate": 3.0, "lateral_acceleration": 1.0, "steering_wheel_angle": 20.0}
NEEDED = {"roll_angle": "this, or speed and yaw_rate", "speed": "with yaw_rate, where there is no roll_angle",
          "yaw_rate": "with speed, where there is no roll_angle"}


def make(dbc, log, output):
    if dbc is None and log is None:
        raise LogError("draft needs a DBC file (--dbc FILE), or a log that is decoded already (--log FILE): a CSV or an MF4")
    if output.exists():
        raise LogError(f"{output}: exists already, perhaps with answers in it; delete it, or choose another file with --output")
    source = DbcSource(dbc_signals.database(dbc), log) if dbc else TableSource(log)
    choices = {}
    for quantity in QUANTITIES:
        found, is_clear = signal_names.candidates(quantity, source.in_log)
        if not found:
            found, is_clear = signal_names.candidates(quantity, source.signals)
        choices[quantity] = Choice(quantity, found, is_clear)
    if not all(choices[name].found for name in WHEEL_LOADS):  # fewer than four are of no use
        choices.update({name: Choice(name, [], False) for name in WHEEL_LOADS})
    evidence = Evidence(source, choices, log)
    blocks = [beginning(dbc, log)] + source.head() + [block(choice, source, evidence) for choice in choices.values()]
    text = "\n".join(blocks)
    known = sum(bool(choice.found) for choice in choices.values())
    if not known:
        raise LogError(f"{dbc or log}: none of its {len(source.signals)} signals has the name of a quantity of a drive; write the "
                       "mapping yourself (docs/can.md), or take another file")
    file_io.write(output, text)
    questions = text.count('= "?"')
    print(f"{output}: {known} of {len(choices)} quantities drafted, {questions} questions (\"?\") to answer")


def beginning(dbc, log):
    sources = " and ".join(" ".join(str(path).split()) for path in [*(dbc or []), *([log] if log else [])])
    return (f"# A draft by `sil/tools/logs draft` of {sources}.\n"
            "# Put an answer in place of each \"?\", compare the rest, then `sil/tools/logs drive` takes it. docs/can.md says what\n"
            "# the keys mean.\n")


# Candidates for a quantity: the likeliest signal first.
Choice = collections.namedtuple("Choice", "quantity found is_clear")


class DbcSource:
    """The signals of a DBC file, and what a log has of them."""

    def __init__(self, database, log):
        self.database, self.log = database, log
        self.signals = [Candidate(f"{message.name}.{signal.name}", signal.name, signal.unit or "", signal.comment)
                        for message in database.messages for signal in message.signals
                        if not dbc_signals.is_enumeration(signal) and signal.length > 1]
        self.in_log = self.signals
        self.buses = collections.defaultdict(set)
        self.kept = KeptFrames()
        if log:
            keys = self.keys_of_candidates()
            for frame in progress.reported(BusLog(log)):
                key = dbc_signals.frame_key(frame)
                group = dbc_signals.group_key(frame.identifier) if frame.extended else key
                self.buses[key].add(frame.bus)
                self.buses[group].add(frame.bus)
                if key in keys or group in keys:
                    self.kept.add(frame)
            self.in_log = [signal for signal in self.signals if self.is_there(signal)]
            if not self.in_log:
                raise LogError(f"{log}: has no frame of any message of {database.name}; is it the right log or DBC file?")

    def keys_of_candidates(self):
        """Keys of the messages with a signal that may be a quantity."""
        keys = set()
        for signal in self.signals:
            if any(signal_names.likeness(quantity, signal)[0] for quantity in QUANTITIES):
                message, _ = self.database.signals[signal.key]
                keys.add(dbc_signals.key_of(message))
                if message.is_extended_frame:
                    keys.add(dbc_signals.group_key(message.frame_id))
        return keys

    def head(self):
        return []

    def buses_of(self, signal):
        message, _ = self.database.signals[signal.key]
        buses = self.buses.get(dbc_signals.key_of(message), ())
        if not buses and message.is_extended_frame:
            buses = self.buses.get(dbc_signals.group_key(message.frame_id), ())
        return sorted(buses, key=str)

    def is_contested(self, signal):
        return dbc_signals.key_of(self.database.signals[signal.key][0]) in self.database.contested

    def is_there(self, signal):
        return bool(self.buses_of(signal))

    def is_magnitude(self, signal):
        """Whether its bits have no room for a negative value."""
        _, known = self.database.signals[signal.key]
        return not known.is_signed and not known.is_float and known.scale > 0 and known.offset >= 0

    def sign_of(self, signal):
        """The signal of one bit that is the sign of this magnitude; None if there is none."""
        if not self.is_magnitude(signal):
            return None
        message, known = self.database.signals[signal.key]
        flag = signal_names.sign_of(known.name, [other.name for other in message.signals if other.length == 1])
        return f"{message.name}.{flag}" if flag else None

    def read(self, entries):
        return dbc_signals.read_frames({self.log: self.kept.frames()}, self.database, AsDrafted(entries))[0]


class KeptFrames:
    """Frames in memory, in few more bytes than their own: so that a log is read once."""

    HEAD = struct.Struct("<dIIB?")  # time, identifier, number of the bus, bytes of data, extended

    def __init__(self):
        self.bytes = bytearray()
        self.numbers = {}  # of the buses

    def add(self, frame):
        number = self.numbers.setdefault(frame.bus, len(self.numbers))
        self.bytes += self.HEAD.pack(frame.time_s, frame.identifier, number, len(frame.data), frame.extended) + frame.data

    def frames(self):
        place, buses = 0, list(self.numbers)
        while place < len(self.bytes):
            time_s, identifier, number, length, extended = self.HEAD.unpack_from(self.bytes, place)
            place += self.HEAD.size + length
            yield Frame(time_s, buses[number], identifier, extended, bytes(self.bytes[place - length:place]), length > 8, False,
                        False)


class TableSource:
    """The columns of a CSV or the channels of an MF4."""

    def __init__(self, log):
        self.log = log
        self.signals = [Candidate(column.name, column.name.split("[")[0].split("(")[0], column.unit, "")
                        for column in table_signals.columns_of(log)]
        self.in_log = self.signals
        times = [signal for signal in self.signals
                 if re.match(r"(t|(date (and )?|datum (und )?)?\w*(time|zeit)\w*|timestamp|interval)( |$)", signal_names.words(signal.name))]
        self.is_csv = table_signals.is_csv(log)
        self.time = times[0] if times else None

    def head(self):
        if not self.is_csv:
            return []
        key = f"signal = {quoted(self.time.key)}" if self.time else 'signal = "?"  # the column of the time'
        unit = self.time_unit() if self.time else None
        if unit is None:
            return [f"[time]\n{key}\nunit = \"?\"  # of the time: {admitted('time')}\n"]
        return [f"[time]\n{key}\nunit = {quoted(unit[0])}{'  # ' * bool(unit[1])}{unit[1]}\n"]

    def time_unit(self):
        """Unit of the time and a remark on it; None where it is not known."""
        if factor_of(self.time.unit, "time"):
            return self.time.unit, ""
        return table_signals.time_unit(self.log, self.time.key)

    def buses_of(self, _):
        return []

    def is_contested(self, _):
        return False

    def is_there(self, _):
        return True

    def is_magnitude(self, _):
        return False

    def sign_of(self, _):
        return None

    def read(self, entries):
        if self.is_csv and not self.time:
            return None
        mapping = AsDrafted(entries)
        if self.is_csv:
            unit = self.time_unit()
            mapping.time = (self.time.key, factor_of(unit[0], "time") if unit else 1.0)
        else:
            mapping.time = None
        return table_signals.read([self.log], mapping)[0]


class AsDrafted:
    """A mapping without signs and questions, to look into a log with."""

    path = "the draft"

    def __init__(self, entries):
        self.entries = entries

    def unit_factor(self, entry, unit, _role="signal"):
        return factor_of(unit, QUANTITIES[entry.quantity].dimension) or 1.0

    def fail(self, table, _, what):
        raise LogError(f"{table} {what}")


class Evidence:
    """Signs as the log shows them."""

    def __init__(self, source, choices, log):
        self.columns, self.turn_s, self.present, self.doubts = {}, None, None, {}
        if not log:
            return
        first_of = {name: choice.found[0] for name, choice in choices.items() if choice.found}
        entries = [Entry(name, signal.key, None, 1.0, 0.0, 1, 0.0, bus_key(source.buses_of(signal)),
                         source.sign_of(signal) if is_signed(name) else None)
                   for name, signal in first_of.items() if source.is_there(signal)]
        recorded = source.read(entries)
        if recorded is None:
            return
        self.present = set(recorded)
        self.doubts = {name: one.doubts for name, one in recorded.items()}
        recorded = {name: one for name, one in recorded.items() if len(one.times_us) > 1}
        if not recorded:
            return
        first = min(int(one.times_us[0]) for one in recorded.values())
        last = max(int(one.times_us[-1]) for one in recorded.values())
        if last - first > LONGEST_DRIVE_S * 1.0e6:
            return  # channels on clocks of their own
        times_us = numpy.arange(first, last + 1, drive_rows.STEP_US, dtype="i8")
        columns, without_unit = {}, set()
        for name, one in recorded.items():
            factor = factor_of(one.unit, QUANTITIES[name].dimension)
            if factor is None:
                without_unit.add(name)
            elif lacks_sign(name, first_of[name], source):
                continue  # it shows no side
            columns[name] = drive_rows.sampled(one.times_us, one.values * (factor or 1.0), times_us)
        self.look(times_us, columns, without_unit)

    def look(self, times_us, columns, without_unit=()):
        """At the columns of a drive, as far as the vehicle stays upright. Only the signs of some have a meaning."""
        self.without_unit = without_unit
        rows = consistency.upright_rows({name: values for name, values in columns.items() if name not in without_unit},
                                        len(times_us))
        self.times_us = times_us[:rows]
        self.columns = {name: values[:rows] for name, values in columns.items()}
        self._find_turn()

    def _find_turn(self):
        """The hardest turn, by the best signal that moves at all."""
        for self.anchor in (name for name in TURNS if name in self.columns):
            values = self.columns[self.anchor] - self._straight(self.anchor)
            known = values[~numpy.isnan(values)]
            if len(known) < SMOOTHED_ROWS or known.max() == known.min():
                continue
            values = numpy.where(numpy.isnan(values), 0.0, values)
            smooth = numpy.convolve(values, numpy.ones(SMOOTHED_ROWS) / SMOOTHED_ROWS, mode="same")
            hardest = int(numpy.argmax(numpy.abs(smooth)))
            least = TURNS[self.anchor] if self.anchor not in self.without_unit else 0.0
            if abs(smooth[hardest]) > least:
                self.turn_s, self.turn = (self.times_us[hardest] - self.times_us[0]) / 1.0e6, float(smooth[hardest])
            return

    def _straight(self, name):
        """The value of no turn, which a drive to one side has nowhere in its middle: that at rest, or zero; in a unit that is
        not known that of the drive's beginning."""
        values, speed = self.columns[name], self.columns.get("speed")
        if speed is not None and "speed" not in self.without_unit and name != "steering_wheel_angle":
            standing = values[(speed < STANDING_KMH) & ~numpy.isnan(values)]
            if len(standing) >= consistency.UPRIGHT_ROWS:
                return float(numpy.median(standing))
        if name not in self.without_unit:
            return 0.0
        beginning = values[:consistency.UPRIGHT_ROWS]
        beginning = beginning[~numpy.isnan(beginning)]
        return float(numpy.median(beginning)) if len(beginning) else 0.0

    def sign_if_left(self, name):
        """The sign of the quantity if that turn was one to the left; None where the log does not tell."""
        if self.turn_s is None or name not in self.columns:
            return None
        anchored = 1 if self.turn > 0.0 else -1
        if name in SIGNED:
            by_anchor = self._times(anchored, self.columns[name], self.columns[self.anchor])
            lateral = "lateral_acceleration"
            if by_anchor or name == lateral or self.anchor == lateral or lateral not in self.columns:
                return by_anchor
            base = self.sign_if_left(lateral)
            return base and self._times(base, self.columns[name], self.columns[lateral])
        if name != "roll_rate":
            return None
        by = "roll_angle" if "roll_angle" in self.columns else "lateral_acceleration"
        base = self.sign_if_left(by)
        return base and self._times(base, consistency.turned(self.times_us, self.columns[name]),
                                    consistency.change(self.times_us, self.columns[by]))

    @staticmethod
    def _times(sign, one, other):
        link = consistency.compared("", one, "", other)
        if link is None or abs(link.correlation) < consistency.LEAST_CORRELATION:
            return None
        return sign if link.correlation > 0.0 else -sign


def bus_key(buses):
    return (buses[0] if isinstance(buses[0], str) else number_of(buses[0])) if buses else None


def block(choice, source, evidence):
    """The table of one quantity."""
    quantity = QUANTITIES[choice.quantity]
    need = "needed" if quantity.need == REQUIRED else NEEDED.get(choice.quantity, "optional")
    head = f"# {need}; {admitted(quantity.dimension)}"
    if not choice.found:
        if quantity.need != REQUIRED:
            return f"{head}\n# No signal was found by its name.\n# [{choice.quantity}]\n# signal = \"\"\n"
        return f"{head}\n[{choice.quantity}]\nsignal = \"?\"  # none was found by its name\n"
    first = choice.found[0]
    lines = [head, f"[{choice.quantity}]"]
    if len(choice.found) > 1:
        lines.append("# candidates: " + ", ".join(f"{signal.key} [{signal.unit}]" for signal in choice.found))
    lines.append(f"signal = {quoted(first.key)}" if choice.is_clear else
                 f"signal = \"?\"  # of the candidates; the questions below are about {first.key}")
    if evidence.present is not None and choice.quantity not in evidence.present:
        lines.append("# the log has no value of it: delete this table, unless other logs have it")
    if first.comment:
        lines.append(f"# DBC: {' '.join(first.comment.split())[:110]}")
    lines += [f"# LOOK: {doubt}" for doubt in evidence.doubts.get(choice.quantity, ())]
    lines += unit_lines(quantity, first)
    if lacks_sign(choice.quantity, first, source):
        lines.append("# LOOK: its bits have no room for negative values; does another signal have the sign, then sign = "
                     "\"Message.Signal\"?")
    lines += sign_lines(choice.quantity, evidence, source.sign_of(first))
    buses = source.buses_of(first)
    if len(buses) > 1:
        lines.append(f"bus = \"?\"  # it comes on the buses {', '.join(str(bus) for bus in buses)}")
    elif source.is_contested(first):
        lines.append("bus = \"?\"  # another DBC file has another message of this identifier; the bus of this one")
    return "\n".join(lines) + "\n"


def unit_lines(quantity, signal):
    if factor_of(signal.unit, quantity.dimension) is not None:
        return [f"unit = {quoted(signal.unit)}  # as it says there"]
    said = f"{quoted(signal.unit)} stands there" if signal.unit else "none stands there"
    return [f"unit = \"?\"  # {said}; one of those above, and where one number is not one of it, also factor"]


def is_signed(name):
    return name not in ("speed", "vehicle_mass") and not name.startswith("wheel_load_")


def lacks_sign(name, signal, source):
    return (is_signed(name) and name != "vertical_acceleration" and source.is_magnitude(signal)
            and source.sign_of(signal) is None)


def sign_lines(name, evidence, sign_key):
    if not is_signed(name):
        return []
    if name == "vertical_acceleration":
        return vertical_lines(evidence)
    meaning = "left side up" if name == "bank_angle" else "a left turn"
    if name == "roll_rate":
        meaning = "rolling to the right, as when a left turn begins,"
    answers = {1: "1", -1: "-1"}
    question = f"sign = \"?\"  # 1 if {meaning} is positive, -1 if negative"
    if sign_key:
        answers = {1: quoted(sign_key), -1: quoted("-" + sign_key)}
        question = (f"sign = \"?\"  # it is a magnitude, with its sign beside it: {answers[1]} if {meaning} has the sign 0, "
                    f"{answers[-1]} if 1")
    left = evidence.sign_if_left(name)
    if left is None:
        return [question + ("; the log does not show it" if evidence.present is not None and name != "bank_angle" else "")]
    return [question, f"#          the log turns hardest at {evidence.turn_s:.2f} s of the drive: {answers[left]} if that was to "
                      f"the left, {answers[-left]} if to the right"]


def vertical_lines(evidence):
    upright = consistency.upright_mps2(evidence.columns)
    if upright is None:
        return ["sign = \"?\"  # 1 if it shows about +1 g at rest, -1 if -1 g; if gravity is not in it, offset = 1 g in its unit"]
    share = upright / consistency.G_MPS2
    if 0.5 < abs(share) < 2.0:
        return [f"sign = {1 if share > 0 else -1}  # the log shows {share:+.2f} g at its beginning"]
    return [f"sign = \"?\"  # the log shows {share:+.2f} g at its beginning: if gravity is not in it, offset = 1 g in its unit, "
            "and 1 if upwards is positive"]


def quoted(text):
    return json.dumps(text, ensure_ascii=False)
