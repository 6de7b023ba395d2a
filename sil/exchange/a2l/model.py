"""Content of the A2L: parameters and outputs out of the firmware's tables, their meanings and groups out of rsi.h."""

import dataclasses
import re
import subprocess

import description
import file_io

# Display limits of a meaning without a range. No value is cut there.
DISPLAYED = {"rad": (-3.2, 3.2), "m/s2": (-100.0, 100.0), "m": (-2.0, 2.0), "N.m": (-1e6, 1e6), "N.m/rad": (-1e7, 1e7),
             "N.m.s/rad": (-1e6, 1e6), "s": (0.0, 100.0), "g": (-20.0, 20.0), "kg": (0.0, 100000.0), "": (-20.0, 20.0)}


@dataclasses.dataclass
class Value:
    name: str
    address: int
    least: float
    largest: float
    unit: str  # as DISPLAYED has it; "" for none
    meaning: str
    choices: list  # of a code, from 0; empty for a float
    mask: int = 0  # of a bit in a byte


@dataclasses.dataclass
class Model:
    constants: dict
    parameters: list
    outputs: list
    inputs: list
    codes: list
    groups: dict  # of parameters: title to names


@dataclasses.dataclass
class Row:
    """Arguments of description.explain."""
    role: str
    name: str
    meaning: str


def meanings_of(rows, header):
    explained = [Row(role, name, meaning) for role, name, meaning in rows]
    description.explain(explained, header)
    return {(row.role, row.name): row.meaning for row in explained}


def unit_of(name, told):
    """Unit by the table of outputs, or by the end of a parameter's name."""
    key = description.unit_of(name, told)
    return description.UNITS[key][0] if key else ""


def range_of(meaning, unit):
    told = re.search(r"(-?\d+(?:\.\d+)?) to (-?\d+(?:\.\d+)?)", meaning)
    return (float(told[1]), float(told[2])) if told else DISPLAYED[unit]


def choices_of(meaning, largest):
    """The enumerators that explain() has put behind a code's meaning; without any it is no or yes."""
    told = re.findall(r"(?:: |, )(\d+) ([a-z][a-z ]*)", meaning)
    if not told:
        return ["no", "yes"]
    if [int(number) for number, _ in told] != list(range(largest + 1)):
        raise ValueError(f"the enumerators of \"{meaning}\" are not those from 0 to {largest}")
    return [text.strip() for _, text in told]


def groups_of(header, names):
    """The comments that stand alone within rsi_parameters, with the fields that follow each."""
    text = file_io.read(header)
    body = text[text.index("/* The calibration."):text.index("} rsi_parameters;")]
    groups, title = {}, None
    for comment, field in re.findall(r"^    /\*(.*?)\*/$|^    (?:float|int32_t)\s+(\w+)", body, re.M | re.S):
        if comment:
            title = re.split(r"[,:;(]|\. ", " ".join(comment.replace("*", " ").split()))[0].strip(" .")
        elif field in names:
            groups.setdefault(title, []).append(field)
    if sorted(name for group in groups.values() for name in group) != sorted(names):
        raise ValueError(f"{header}: not every parameter stands behind the title of a group")
    return groups


def fill_in_meanings(parameters, groups):
    """A field without a remark is of the kind of the one before it; the first of a group is what the group's title says."""
    by_name = {parameter.name: parameter for parameter in parameters}
    for title, names in groups.items():
        before = title
        for name in names:
            before = by_name[name].meaning = by_name[name].meaning or before


def read(table, header):
    """`table`: the program a2l-table."""
    lines = subprocess.run([table], check=True, capture_output=True, text=True).stdout.splitlines()
    rows = [line.split("\t") for line in lines]
    constants = {row[1]: row[2] for row in rows if row[0] == "constant"}
    told = [("parameter", row[1], "") for row in rows if row[0] == "parameter"]
    told += [("output", row[1], row[5]) for row in rows if row[0] == "output"]
    told += [("parameter", row[1], "") for row in rows if row[0] == "input"]  # explained by its field, as a parameter
    meanings = meanings_of(told, header)
    parameters, outputs, inputs, codes = [], [], [], []
    for row in rows:
        if row[0] == "parameter":
            _, name, address, least, largest, choices = row
            unit = "" if choices else unit_of(name, "")
            parameters.append(Value(name, int(address), float(least), float(largest), unit, meanings["parameter", name],
                                    choices.split(",") if choices else []))
        elif row[0] == "output":
            _, name, address, largest, unit, _ = row
            meaning = meanings["output", name]
            if largest:
                outputs.append(Value(name, int(address), 0.0, float(largest), "", meaning, choices_of(meaning, int(largest))))
            else:
                unit = unit_of(name, unit)
                outputs.append(Value(name, int(address), *range_of(meaning, unit), unit, meaning, []))
        elif row[0] == "input":
            _, name, address, unit = row
            meaning, unit = meanings["parameter", name], unit_of(name, unit)
            inputs.append(Value(name, int(address), *range_of(meaning, unit), unit, meaning, []))
        elif row[0] == "code":
            _, name, address, mask, meaning = row
            codes.append(Value(name.replace(" ", "_"), int(address), 0.0, 1.0, "", meaning, ["no", "yes"], int(mask)))
    groups = groups_of(header, [parameter.name for parameter in parameters])
    fill_in_meanings(parameters, groups)
    return Model(constants, parameters, outputs, inputs, codes, groups)
