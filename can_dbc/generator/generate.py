#!/usr/bin/env python3
"""Writes the C++ codec of a DBC file; without arguments, the project's own.

Exit status: 0 done (or, with --check, nothing would change), 1 --check found a difference, 2 a fault in the DBC file
or in the arguments.
"""
import argparse
import difflib
import pathlib
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
DBC = FOLDER.parent / "rollover_warning.dbc"
HEADER = FOLDER.parent / "generated" / "rollover_warning.hpp"

try:
    import jinja2

    from model import DbcError, load, senders

    import whole_file
except ModuleNotFoundError as missing:
    sys.exit(f"generate.py: Python package '{missing.name}' is missing for {sys.executable}.\n"
             f"Install the generator's packages: {sys.executable} -m pip install -r {FOLDER / 'requirements.txt'}")


def render(dbc, namespace):
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(FOLDER / "templates"), autoescape=False,
                                     trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True,
                                     undefined=jinja2.StrictUndefined)
    messages = load(dbc)
    return environment.get_template("codec.hpp.j2").render(
        dbc_name=dbc.name, namespace=namespace, messages=messages, senders=senders(messages))


def difference(header, text):
    old = header.read_text(encoding="utf-8") if header.exists() else ""
    return "".join(difflib.unified_diff(old.splitlines(keepends=True), text.splitlines(keepends=True),
                                        f"{header} (committed)", f"{header} (as the DBC file wants it)"))


def command_line():
    parser = argparse.ArgumentParser(description="Write the C++ codec of a DBC file.")
    parser.add_argument("--dbc", type=pathlib.Path, default=DBC, help="DBC file (default: %(default)s)")
    parser.add_argument("--output", type=pathlib.Path, default=HEADER, help="header (default: %(default)s)")
    parser.add_argument("--namespace", default="can_dbc", help="C++ namespace (default: %(default)s)")
    parser.add_argument("--check", action="store_true",
                        help="write nothing; show the difference and fail if the header would change")
    return parser.parse_args()


def main():
    arguments = command_line()
    try:
        text = render(arguments.dbc, arguments.namespace)
    except DbcError as error:
        print(f"generate.py: {arguments.dbc}: {error}", file=sys.stderr)
        return 2
    if not arguments.check:
        whole_file.write(arguments.output, text)
        return 0
    changes = difference(arguments.output, text)
    if changes:
        print(changes, end="")
        print(f"\n{arguments.output} does not match {arguments.dbc}: run can_dbc/generator/generate.py "
              "with the same arguments but without --check, and commit the result.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
