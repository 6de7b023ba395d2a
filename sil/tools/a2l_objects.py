"""Parameters and outputs of an A2L that sil/exchange/a2l/write has written. A parser of all of ASAP2 would be more than the
rest of the tools together."""

import dataclasses
import re
import struct

import file_io
from log_error import LogError

FORMS = {"RL_value": "<f", "RL_selection": "<I", "FLOAT32_IEEE": "<f", "UBYTE": "<B", "ULONG": "<I"}
BLOCKS = ("COMPU_METHOD", "COMPU_VTAB", "CHARACTERISTIC", "MEASUREMENT")
KINDS = {"<f": "F32", "<B": "U8", "<I": "U32"}  # as pyxcp calls them


@dataclasses.dataclass
class Object:
    name: str
    is_parameter: bool
    text: str
    address: int
    form: str  # as struct calls it
    least: float
    largest: float
    unit: str
    choices: list  # texts of its numbers, from 0; empty for a number
    mask: int = 0  # of a bit in its byte

    def number(self, data):
        value, = struct.unpack(self.form, data)
        return int(value & self.mask != 0) if self.mask else value

    def decoded(self, data):
        value = self.number(data)
        return self.choices[value] if self.choices and value < len(self.choices) else value

    def encoded(self, text):
        """A VALUE as it is written; LogError for an error in it."""
        if self.choices:
            if text not in self.choices:
                raise LogError(f"{self.name}: {text} is not one of its choices: {' '.join(self.choices)}")
            return struct.pack(self.form, self.choices.index(text))
        try:
            return struct.pack(self.form, float(text))
        except (ValueError, OverflowError, struct.error):
            raise LogError(f"{self.name}: {text} is not a number") from None


@dataclasses.dataclass
class File:
    objects: dict
    epk: str
    epk_at: int
    command_identifier: int
    answer_identifier: int


def _blocks(text):
    """Words of each block by its keyword; texts without their quotes."""
    found, keyword, words = {key: [] for key in BLOCKS}, None, []
    for line in text.splitlines():
        new = [quoted or word for quoted, word in re.findall(r'"([^"]*)"|([^\s"]+)', line)]
        if new[:1] == ["/begin"] and new[1:] and new[1] in BLOCKS:
            keyword, words = new[1], new[2:]
        elif keyword and new == ["/end", keyword]:
            found[keyword].append(words)
            keyword = None
        elif keyword:
            words += new
    return found


def _after(text, tag):
    """The word or text behind the only such tag in a line of its own."""
    found = re.findall(rf'^ *{tag} "?([^"\n]+)"?$', text, re.M)
    return found[0]


def _parsed(text):
    units, tables, objects, blocks = {}, {}, {}, _blocks(text)
    for name, _, kind, _, *rest in blocks["COMPU_METHOD"]:
        units[name] = rest[0] if kind == "RAT_FUNC" and rest[0] != "COEFFS" else ""
    for name, _, _, _, *pairs in blocks["COMPU_VTAB"]:
        tables[name.removeprefix("VT_")] = pairs[1::2]
    for name, meaning, _, address, layout, _, method, least, largest, *_ in blocks["CHARACTERISTIC"]:
        objects[name] = Object(name, True, meaning, int(address, 0), FORMS[layout], float(least), float(largest),
                               units[method], tables.get(name, []))
    for name, meaning, kind, method, _, _, least, largest, *tagged in blocks["MEASUREMENT"]:
        told = dict(zip(tagged[::2], tagged[1::2]))
        objects[name] = Object(name, False, meaning, int(told["ECU_ADDRESS"], 0), FORMS[kind], float(least), float(largest),
                               units[method], tables.get(method.removeprefix("CM_"), []), int(told.get("BIT_MASK", "0"), 0))
    return File(objects, _after(text, "EPK"), int(_after(text, "ADDR_EPK"), 0), int(_after(text, "CAN_ID_MASTER"), 0),
                int(_after(text, "CAN_ID_SLAVE"), 0))


def read(path):
    try:
        return _parsed(file_io.read(path))
    except FileNotFoundError:
        raise LogError(f"there is no {path}; make it: cmake --build --preset release --target a2l") from None
    except (KeyError, ValueError, IndexError):
        raise LogError(f"{path} is no A2L of this project; make it: cmake --build --preset release --target a2l") from None
