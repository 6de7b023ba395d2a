#!/usr/bin/env python3
"""Writes the C++ codec of a DBC file, and with --page the table of its messages in a page; without --dbc, the project's own.

Exit status: 0 done (or, with --check, nothing would change), 1 --check found a difference, 2 a fault in the DBC file
or in the arguments.
"""
import argparse
import difflib
import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
DBC = FOLDER.parent / "rollover_warning.dbc"
HEADER = FOLDER.parent / "include/rsi/can_dbc/generated/rollover_warning.hpp"
REMEDY = ("run cmake/environment/build dev generate_codec or, for a DBC file of your own, generate.py with "
          "the same arguments but without --check; commit the result.")
PAGE_TABLE = re.compile(r"(?<=<!-- written by generate_codec -->\n).*?(?=\n\n)", re.DOTALL)

try:
    import jinja2

    from model import DbcError, load, senders

    import file_io
except ModuleNotFoundError as missing:
    sys.exit(f"generate.py: Python package '{missing.name}' is missing for {sys.executable}.\n"
             "Run cmake/environment/set_up once, then: build/venv/bin/python3 can_dbc/generator/generate.py\n"
             f"(without Debian: {sys.executable} -m pip install -r {FOLDER / 'requirements.txt'})")


def render(dbc, messages, namespace):
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(FOLDER / "templates"), autoescape=False,
                                     trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True,
                                     undefined=jinja2.StrictUndefined)
    return environment.get_template("codec.hpp.j2").render(
        dbc_name=dbc.name, namespace=namespace, messages=messages, senders=senders(messages))


def render_page(page, messages):
    rows = ["| frame | identifier | data identifier | from | carries |", "|---|---|---|---|---|"]
    for message in messages:
        data_id = f"0x{message.protection.data_id:03X}" if message.protection.profile else "none"
        rows.append(f"| {message.name} | 0x{message.identifier:03X} | {data_id} | {message.sender} | {message.comment} |")
    text, tables = PAGE_TABLE.subn(lambda _: "\n".join(rows), page.read_text(encoding="utf-8"))
    if tables != 1:
        raise DbcError(f"{page} has {tables} places '<!-- written by generate_codec -->', not one")
    return text


def difference(path, text):
    old = path.read_text(encoding="utf-8") if path.exists() else ""
    return "".join(difflib.unified_diff(old.splitlines(keepends=True), text.splitlines(keepends=True),
                                        f"{path} (committed)", f"{path} (as the DBC file wants it)"))


def command_line():
    parser = argparse.ArgumentParser(description="Write the C++ codec of a DBC file.")
    parser.add_argument("--dbc", type=pathlib.Path, default=DBC, help="DBC file (default: %(default)s)")
    parser.add_argument("--output", type=pathlib.Path, default=HEADER, help="header (default: %(default)s)")
    parser.add_argument("--page", type=pathlib.Path, help="page whose table of messages is written too")
    parser.add_argument("--namespace", default="rsi::can_dbc", help="C++ namespace (default: %(default)s)")
    parser.add_argument("--check", action="store_true",
                        help="write nothing; show the difference and fail if header or page would change")
    return parser.parse_args()


def main():
    arguments = command_line()
    try:
        messages = load(arguments.dbc)
        texts = {arguments.output: render(arguments.dbc, messages, arguments.namespace)}
        if arguments.page:
            texts[arguments.page] = render_page(arguments.page, messages)
    except DbcError as error:
        print(f"generate.py: {arguments.dbc}: {error}", file=sys.stderr)
        return 2
    if not arguments.check:
        for path, text in texts.items():
            file_io.write(path, text)
        return 0
    changed = {path: difference(path, text) for path, text in texts.items()}
    for path, changes in changed.items():
        if changes:
            print(changes, end="")
            print(f"\n{path} does not match {arguments.dbc}: {REMEDY}", file=sys.stderr)
    return 1 if any(changed.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
