"""Parameters and outputs of an A2L, as pya2l reads it."""

import dataclasses
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

from log_error import LogError

FORMS = {"RL_value": "<f", "RL_selection": "<I", "FLOAT32_IEEE": "<f", "UBYTE": "<B", "ULONG": "<I"}
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

    def decoded(self, data):
        value, = struct.unpack(self.form, data)
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


def module_of(path):
    """pya2l's JSON of its only module."""
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / "a2l.json"
        finished = subprocess.run([pathlib.Path(sys.executable).parent / "pya2l", path, "to_json", "-o", output],
                                  capture_output=True, text=True, check=False)
        if finished.returncode != 0 or not output.is_file():
            raise LogError(f"{path}: pya2l does not read it: {(finished.stdout + finished.stderr).strip()[-300:]}")
        return json.loads(output.read_text())["PROJECT"]["MODULE"][0]


def _text(entry, key):
    return entry.get(key, {}).get("Value", "")


def _identifiers(module):
    """CAN_ID_MASTER and CAN_ID_SLAVE of IF_DATA XCP."""
    for data in module["IF_DATA"]:
        for blob in data["Blob"]:
            if blob["Generic"]["Name"]["Value"] == "XCP_ON_CAN":
                elements = [element.get("Identifier", {}).get("Value") or int(element.get("Long", {}).get("Value", 0))
                            for element in blob["Generic"]["Element"]]
                return [elements[elements.index(tag) + 1] for tag in ("CAN_ID_MASTER", "CAN_ID_SLAVE")]
    raise LogError("the A2L has no XCP_ON_CAN")


def read(path):
    if not pathlib.Path(path).is_file():
        raise LogError(f"there is no {path}; make it: cmake --build --preset release --target a2l")
    module = module_of(path)
    units = {_text(method, "Name"): _text(method, "Unit") for method in module["COMPU_METHOD"]}
    tables = {_text(table, "Name")[3:]: [_text(pair, "OutVal") for pair in table["InValOutVal"]]
              for table in module["COMPU_VTAB"]}
    objects = {}
    for kind in ("CHARACTERISTIC", "MEASUREMENT"):
        for entry in module[kind]:
            name, is_parameter = _text(entry, "Name"), kind == "CHARACTERISTIC"
            address = entry["Address"] if is_parameter else entry["ECU_ADDRESS"]["Address"]
            data_type = _text(entry, "Deposit" if is_parameter else "DataType")
            objects[name] = Object(name, is_parameter, _text(entry, "LongIdentifier"), int(address["Value"]), FORMS[data_type],
                                   float(entry["LowerLimit"].get("Value", 0)), float(entry["UpperLimit"].get("Value", 0)),
                                   units[_text(entry, "Conversion")], tables.get(name, []))
    memory = module["MOD_PAR"]
    return File(objects, memory["EPK"]["Identifier"]["Value"], int(memory["ADDR_EPK"][0]["Address"]["Value"]),
                *_identifiers(module))
