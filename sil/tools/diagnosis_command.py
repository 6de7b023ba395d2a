"""The commands of sil/tools/diagnosis."""

import argparse
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parents[1]
sys.path.insert(0, str(PROJECT / "cmake/environment"))

import odx_tables
import file_io
from log_error import LogError


def parse(arguments):
    parser = argparse.ArgumentParser(prog="sil/tools/diagnosis", epilog="More: sil/tools/diagnosis --help", add_help=False)
    commands = parser.add_subparsers(dest="command", required=True)
    for name in ("codes", "clear", "identify", "self-test", "download", "verify"):
        command = commands.add_parser(name, add_help=False)
        command.add_argument("--interface", default="can0", metavar="IF")
        command.add_argument("--key", metavar="HEX")
        if name == "download":
            command.add_argument("section", type=pathlib.Path, metavar="SECTION.bin")
        if name == "verify":
            command.add_argument("calibration", type=pathlib.Path, metavar="FILE")
    commands.add_parser("pdx", add_help=False).add_argument("--output", required=True, type=pathlib.Path, metavar="FILE.pdx")
    return parser.parse_args(arguments)


def write_pdx(output, tables):
    import odx

    file_io.write(output, odx.pdx_of(tables))
    print(f"{output}: {len(tables.codes)} trouble codes, {len(tables.services)} services")


def section_of(calibration):
    """The section that a calibration file makes, or that it is."""
    if calibration.suffix != ".toml":
        return calibration.read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        section = pathlib.Path(folder) / "section.bin"
        made = subprocess.run([PROJECT / "build/release/sil/rsi-sil", "parameters", "--parameters", calibration, "--output",
                               section], check=False, capture_output=True, text=True)
        if made.returncode:
            raise LogError(f"rsi-sil makes no section of {calibration}: {made.stderr.strip()}")
        return section.read_bytes()


def main(arguments):
    options = parse(arguments)
    try:
        tables = odx_tables.read(PROJECT / "build/release/sil/exchange/odx/odx-table", PROJECT / "can_dbc/rollover_warning.dbc")
        if options.command == "pdx":
            write_pdx(options.output, tables)
            return
        import uds_client

        wanted = section_of(options.calibration) if options.command == "verify" else b""
        with uds_client.on_can(options.interface, tables, uds_client.key_from(options.key)) as tester:
            if options.command == "download":
                uds_client.download(tester, tables, options.section)
            elif options.command == "verify":
                uds_client.verify(tester, tables, wanted, options.calibration)
            else:
                {"codes": uds_client.show_codes, "clear": uds_client.clear, "identify": uds_client.identify,
                 "self-test": uds_client.self_test}[options.command](tester, tables)
    except (LogError, OSError) as error:
        sys.exit(f"sil/tools/diagnosis: {error}")
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main(sys.argv[1:])
