"""The commands of sil/tools/diagnosis."""

import argparse
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parents[1]
sys.path.insert(0, str(PROJECT / "cmake/environment"))

import odx_tables
import file_io
from log_error import LogError


def parse(arguments):
    parser = argparse.ArgumentParser(prog="sil/tools/diagnosis", epilog="More: sil/tools/diagnosis --help", add_help=False)
    commands = parser.add_subparsers(dest="command", required=True)
    for name in ("codes", "clear", "identify", "self-test", "download"):
        command = commands.add_parser(name, add_help=False)
        command.add_argument("--interface", default="can0", metavar="IF")
        command.add_argument("--key", metavar="HEX")
        if name == "download":
            command.add_argument("section", type=pathlib.Path, metavar="SECTION.bin")
    commands.add_parser("pdx", add_help=False).add_argument("--output", required=True, type=pathlib.Path, metavar="FILE.pdx")
    return parser.parse_args(arguments)


def write_pdx(output, tables):
    import odx

    file_io.write(output, odx.pdx_of(tables))
    print(f"{output}: {len(tables.codes)} trouble codes, {len(tables.services)} services")


def main(arguments):
    options = parse(arguments)
    try:
        tables = odx_tables.read(PROJECT / "build/release/sil/exchange/odx/odx-table", PROJECT / "can_dbc/rollover_warning.dbc")
        if options.command == "pdx":
            write_pdx(options.output, tables)
            return
        import uds_client

        with uds_client.on_can(options.interface, tables, uds_client.key_from(options.key)) as tester:
            if options.command == "download":
                uds_client.download(tester, tables, options.section)
            else:
                {"codes": uds_client.show_codes, "clear": uds_client.clear, "identify": uds_client.identify,
                 "self-test": uds_client.self_test}[options.command](tester, tables)
    except (LogError, OSError) as error:
        sys.exit(f"sil/tools/diagnosis: {error}")
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main(sys.argv[1:])
