"""The commands of sil/tools/logs."""

import argparse
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "cmake/environment"))

import dbc_signals
import decode
import draft
import drive
import own_frames
import verdict
from log_error import LogError
from mapping_answers import Unanswered


def parse(arguments):
    parser = argparse.ArgumentParser(prog="sil/tools/logs", epilog="More: sil/tools/logs --help", add_help=False)
    commands = parser.add_subparsers(dest="command", required=True)
    convert = commands.add_parser("convert", add_help=False)
    convert.add_argument("logs", nargs="+", type=pathlib.Path, metavar="LOG")
    convert.add_argument("--output", required=True, type=pathlib.Path, metavar="DIR")
    convert.add_argument("--bus")
    drive_of = commands.add_parser("drive", add_help=False)
    drive_of.add_argument("logs", nargs="+", type=pathlib.Path, metavar="LOG")
    drive_of.add_argument("--dbc", action="append", type=pathlib.Path, metavar="FILE")
    drive_of.add_argument("--mapping", required=True, type=pathlib.Path, metavar="FILE")
    drive_of.add_argument("--output", required=True, type=pathlib.Path, metavar="FILE")
    draft_of = commands.add_parser("draft", add_help=False)
    draft_of.add_argument("--dbc", action="append", type=pathlib.Path, metavar="FILE")
    draft_of.add_argument("--log", type=pathlib.Path, metavar="FILE")
    draft_of.add_argument("--output", required=True, type=pathlib.Path, metavar="FILE")
    decode_of = commands.add_parser("decode", add_help=False)
    decode_of.add_argument("log", type=pathlib.Path, metavar="RUN|LOG")
    decode_of.add_argument("--dbc", action="append", type=pathlib.Path, metavar="FILE")
    decode_of.add_argument("--output", type=pathlib.Path, metavar="DIR")
    verdict_of = commands.add_parser("verdict", add_help=False)
    verdict_of.add_argument("folder", type=pathlib.Path, metavar="FOLDER")
    verdict_of.add_argument("--dbc", action="append", type=pathlib.Path, metavar="FILE")
    verdict_of.add_argument("--vehicle-data", type=pathlib.Path, metavar="FILE")
    verdict_of.add_argument("--parameters", metavar="FILE|NAME")
    verdict_of.add_argument("--answer", choices=("left", "right"))
    verdict_of.add_argument("--output", type=pathlib.Path, metavar="DIR")
    verdict_of.add_argument("--program", type=pathlib.Path, default=verdict.PROGRAM, metavar="FILE")
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    dbc_signals.read_once.cache_clear()  # each call says what is odd of its files
    sys.unraisablehook = lambda _: None  # asammdf fails once more, in a destructor, after it has refused a file
    try:
        if options.command == "convert":
            own_frames.convert(options.logs, options.output, options.bus)
        elif options.command == "drive":
            drive.make(options.logs, options.dbc, options.mapping, options.output)
        elif options.command == "draft":
            draft.make(options.dbc, options.log, options.output)
        elif options.command == "decode":
            decode.make(options.log, options.dbc, options.output)
        elif options.command == "verdict":
            verdict.make(options)
    except Unanswered as error:
        print(f"sil/tools/logs: {error}", file=sys.stderr)
        sys.exit(3)
    except LogError as error:
        sys.exit(f"sil/tools/logs: {error}")
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main(sys.argv[1:])
