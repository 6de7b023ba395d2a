"""Deviations of C files, and their table."""

import pathlib
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
HEAD = """
## C files
`tests/quality/coding_rules/misra_c` checks the firmware's C files and their headers by cppcheck's addon for MISRA C:2012.
Rules that the addon does not know are not checked, nor are the directives; no compliance is claimed. These are all
deviations.

| rule | about | files | reason |
|---|---|---|---|
"""


def read():
    return tomllib.loads((HERE / "misra_c.toml").read_text(encoding="utf-8"))["deviation"]


def table():
    rows = []
    for each in read():
        files = ", ".join(f"`{file.removeprefix('firmware/')}`" for file in each["files"])
        rows.append(f"| {each['rule']} | {each['about']} | {files} | {each['reason']} |\n")
    return HEAD + "".join(rows)
