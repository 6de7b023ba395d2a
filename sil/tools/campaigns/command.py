"""The commands of sil/tools/campaign."""

import argparse
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
sys.path[:0] = [str(HERE), *(str(PROJECT / folder) for folder in ("sil/judge", "cmake/environment"))]

from campaign_error import CampaignError  # noqa: E402
from judge import JudgeError  # noqa: E402


def at_least_one(text):
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"wants a whole number from 1 on, not {text}")
    return int(text)


def parse(arguments):
    parser = argparse.ArgumentParser(prog="sil/tools/campaign", epilog="More: sil/tools/campaign --help", add_help=False,
                                     allow_abbrev=False)
    commands = parser.add_subparsers(dest="command", required=True)
    run = commands.add_parser("run", add_help=False, allow_abbrev=False)
    run.add_argument("--output", required=True, type=pathlib.Path, metavar="DIR")
    run.add_argument("--settings", type=pathlib.Path, metavar="FILE")
    run.add_argument("--runs", type=at_least_one, metavar="N")
    run.add_argument("--seed", type=int, metavar="S")
    run.add_argument("--vehicle", action="append", default=[], metavar="VEHICLE_FILE:CALIBRATION_FILE")
    run.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    run.add_argument("--part-runs", type=at_least_one, default=10_000, metavar="N")
    run.add_argument("--job", action="append", default=[], metavar="KEY=VALUE")
    run.add_argument("--jobs", type=at_least_one, default=1, metavar="N")
    place = run.add_mutually_exclusive_group()
    place.add_argument("--workers", type=at_least_one, metavar="N")
    place.add_argument("--cluster", choices=("slurm", "pbs", "lsf", "sge", "htcondor"))
    place.add_argument("--scheduler", metavar="ADDRESS")
    query = commands.add_parser("query", add_help=False, allow_abbrev=False)
    query.add_argument("folder", nargs="?", type=pathlib.Path, metavar="DIR")
    query.add_argument("name", nargs="?", metavar="NAME")
    query.add_argument("--list", action="store_true")
    query.add_argument("--sql", metavar="TEXT")
    query.add_argument("--csv", type=pathlib.Path, metavar="FILE")
    convert = commands.add_parser("convert", add_help=False, allow_abbrev=False)
    convert.add_argument("folder", type=pathlib.Path, metavar="DIR")
    score = commands.add_parser("score", add_help=False, allow_abbrev=False)
    score.add_argument("folder", type=pathlib.Path, metavar="DIR")
    score.add_argument("given", nargs="+", metavar="NAME=FILE")
    score.add_argument("--csv", type=pathlib.Path, metavar="FILE")
    rare = commands.add_parser("rare", add_help=False, allow_abbrev=False)
    rare.add_argument("folders", nargs="+", type=pathlib.Path, metavar="DIR")
    rare.add_argument("--event", required=True, choices=("missed", "late", "alarm_below_0_7", "alarm_0_7_to_0_8"))
    rare.add_argument("--propose", type=pathlib.Path, metavar="FILE")
    for command in (run, query, convert, score, rare):
        command.add_argument("--program", type=pathlib.Path, default=PROJECT / "build/release/sil/rsi-sil", metavar="FILE")
    options = parser.parse_args(arguments)
    asks = options.command == "query" and not options.list
    if asks and (options.folder is None or (options.name is None) == (options.sql is None)):
        query.error("wants a folder and the name of a question, or --sql TEXT in its place; --list names the questions")
    return options


def main(arguments):
    options = parse(arguments)
    try:
        if options.command == "run":
            import engine

            engine.run(options)
        elif options.command == "convert":
            import parquet

            parquet.convert(options.folder, options.program)
        elif options.command == "score":
            import query

            print(query.answer(options.folder, options.program, "index_comparison", None, options.csv, options.given))
        elif options.command == "rare":
            import rare

            print(rare.answer(options))
        else:
            import query

            if options.list:
                print("\n".join(f"{name:<36} {what}" for name, what in query.names().items()))
            else:
                print(query.answer(options.folder, options.program, options.name, options.sql, options.csv))
    except (CampaignError, JudgeError) as error:
        sys.exit(f"sil/tools/campaign: {error}")
    except KeyboardInterrupt:
        print("sil/tools/campaign: interrupted; the parts that are there are kept, the same command goes on", file=sys.stderr)
        sys.exit(130)


if __name__ == "__main__":
    main(sys.argv[1:])
