"""The firmware's tables of diagnosis, as the program odx-table prints them, with the names of the codes out of the DBC
file."""

import dataclasses
import pathlib
import subprocess
import sys

import cantools

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(PROJECT / folder) for folder in ("cmake/environment", "sil/exchange/a2l", "sil/exchange/fmu")]

import model  # noqa: E402

HEADER = PROJECT / "firmware/rsi/rsi.h"


@dataclasses.dataclass
class Tables:
    constants: dict
    codes: dict  # trouble code to the name of the diagnostic code
    texts: list  # (identifier, length, name)
    numbers: list  # (identifier, name, unit)
    choices: list  # (identifier, name, texts of its numbers)
    services: list
    sub_functions: list  # (service, number)


def name_of_trouble_code(number):
    """As a workshop writes it: 0xD12087 is U1120-87."""
    code = number >> 8
    return f"{'PCBU'[code >> 14]}{code >> 12 & 3:X}{code & 0xFFF:03X}-{number & 0xFF:02X}"


def names_of_diagnostic_codes(dbc):
    message = cantools.database.load_file(str(dbc)).get_message_by_name("RolloverDiagnosis")
    return {value: str(name) for value, name in message.get_signal_by_name("Code").choices.items()}


def read(program, dbc):
    printed = subprocess.run([str(program)], check=True, capture_output=True, text=True).stdout
    names = names_of_diagnostic_codes(dbc)
    tables = Tables({}, {}, [], [], [], [], [])
    for line in printed.splitlines():
        kind, *fields = line.split("\t")
        if kind == "constant":
            tables.constants[fields[0]] = int(fields[1])
        elif kind == "code":
            tables.codes[int(fields[1])] = names[int(fields[0])]
        elif kind == "text":
            tables.texts.append((int(fields[0]), int(fields[1]), fields[2]))
        elif kind == "number":
            tables.numbers.append((int(fields[0]), fields[1], fields[2]))
        elif kind == "choice":
            identifier, name, largest, meaning = fields
            explained = model.meanings_of([("output", name, meaning)], HEADER)["output", name]
            tables.choices.append((int(identifier), name, model.choices_of(explained, int(largest))))
        elif kind == "service":
            tables.services.append(int(fields[0]))
        elif kind == "sub":
            tables.sub_functions.append((int(fields[0]), int(fields[1])))
        else:
            raise ValueError(f"{program} prints an unknown line: {line}")
    return tables
