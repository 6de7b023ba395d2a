"""The A2L as another's parser reads it (pya2l)."""

import dataclasses
import json
import pathlib
import subprocess
import sys
import tempfile

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
    mask: int = 0


def module_of(path):
    """pya2l's JSON of its only module."""
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / "a2l.json"
        subprocess.run([BINARIES / "pya2l", path, "to_json", "-o", output], check=True, capture_output=True)
        return json.loads(output.read_text())["PROJECT"]["MODULE"][0]


def value(element):
    return element.get("Value", 0)


def objects(module):
    """Objects of both kinds, by name."""
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
            float(value(entry["LowerLimit"])), float(value(entry["UpperLimit"])),
            int(value(entry.get("BIT_MASK", {}).get("Mask", {}))))
    return found
