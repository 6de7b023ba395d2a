"""The commands of sil/tools/diagnosis."""

import argparse
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parents[1]
sys.path.insert(0, str(PROJECT / "cmake/environment"))

import file_io
import key_file
import odx_tables
import simulated_bus
from log_error import LogError


def parse(arguments):
    parser = argparse.ArgumentParser(prog="sil/tools/diagnosis", epilog="More: sil/tools/diagnosis --help", add_help=False)
    commands = parser.add_subparsers(dest="command", required=True)
    for name in ("codes", "clear", "identify", "self-test", "download", "verify"):
        command = commands.add_parser(name, add_help=False)
        command.add_argument("--interface", default="can0", metavar="IF")
        command.add_argument("--key", default=key_file.TEST, type=pathlib.Path, metavar="FILE")
        simulated_bus.add_options(command, after=3.0)
        if name == "download":
            command.add_argument("section", type=pathlib.Path, metavar="SECTION.bin")
        if name == "verify":
            command.add_argument("calibration", type=pathlib.Path, metavar="FILE")
    commands.add_parser("pdx", add_help=False).add_argument("--output", required=True, type=pathlib.Path, metavar="FILE.pdx")
    options = parser.parse_args(arguments)
    if options.command != "pdx" and not 0.0 <= options.after <= 3600.0:
        parser.error("--after wants 0 to 3600 seconds")
    return options


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
        key = key_file.read(options.key, "diagnosis")
        with simulated_bus.driven(options) as bus, (uds_client.on_can(options.interface, tables, key) if bus is None else
                                                    uds_client.in_process(bus, tables, key)) as tester:
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
