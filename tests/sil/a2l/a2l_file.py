"""The A2L as another's parser reads it (pya2l)."""

import dataclasses
import json
import pathlib
import subprocess
import sys

BINARIES = pathlib.Path(sys.executable).parent


@dataclasses.dataclass
class Object:
    kind: str
    name: str
    text: str
    address: int
    data_type: str
    method: str
    least: float
    largest: float


def parsed(path):
    finished = subprocess.run([BINARIES / "pya2l", path, "to_json", "-o", "/dev/stdout"], capture_output=True,
                              text=True, check=True)
    return json.loads(finished.stdout[finished.stdout.index("{"):])["PROJECT"]["MODULE"][0]


def value(element):
    return element.get("Value", 0)


def objects(module):
    """Of both kinds, by name."""
    found = {}
    for entry in module["CHARACTERISTIC"]:
        found[entry["Name"]["Value"]] = Object(
            "CHARACTERISTIC", entry["Name"]["Value"], entry["LongIdentifier"].get("Value", ""), int(value(entry["Address"])),
            entry["Deposit"]["Value"], entry["Conversion"]["Value"], float(value(entry["LowerLimit"])),
            float(value(entry["UpperLimit"])))
    for entry in module["MEASUREMENT"]:
        found[entry["Name"]["Value"]] = Object(
            "MEASUREMENT", entry["Name"]["Value"], entry["LongIdentifier"].get("Value", ""),
            int(value(entry["ECU_ADDRESS"]["Address"])), entry["DataType"]["Value"], entry["Conversion"]["Value"],
            float(value(entry["LowerLimit"])), float(value(entry["UpperLimit"])))
    return found
