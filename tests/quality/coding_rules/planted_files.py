"""The planted violations of planted.toml, and which checks must catch them."""

import pathlib
import tomllib

from findings import PROJECT

_TABLE = pathlib.Path(__file__).resolve().parent / "planted.toml"
_DECLARATIONS = "planted.hpp"


def _table():
    table = tomllib.loads(_TABLE.read_text(encoding="utf-8"))
    declarations = table.pop("declarations")
    if len(table) < 2:
        raise SystemExit(f"no planted violations in {_TABLE}: nothing was tested")
    return declarations, table


def caught_by():
    """The rules of each file; none for the clean one."""
    return {name: set(planted["caught_by"]) for name, planted in _table()[1].items()}


def write(folder):
    """Each violation as a file of its own; their paths from the project's folder, by name."""
    declarations, table = _table()
    shared = {"guarded": True, "includes": ["<cstdint>"], "code": declarations}
    for name, planted in {**table, _DECLARATIONS: shared}.items():
        (folder / name).write_text(_text(name, planted), encoding="utf-8")
    return {name: str((folder / name).relative_to(PROJECT)) for name in table}


def _text(name, planted):
    includes = planted.get("includes", [])
    if name.endswith(".cpp"):
        includes = [f'"{_DECLARATIONS}"', *includes]
    guard = "#pragma once\n" if planted.get("guarded") else ""
    return guard + "".join(f"#include {header}\n" for header in includes) + f"namespace planted {{\n{planted['code']}}}\n"
