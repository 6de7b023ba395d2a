"""From a folder of logs to a verdict: mapping, drives, calibration, validation and replays, each by the command for it. An
answer is kept in the mapping, so that it is asked for once."""

import collections
import contextlib
import io
import pathlib
import re
import shutil
import subprocess
import sys

import bus_logs
import dbc_signals
import drive
import drive_facts
import file_io
import mapping
import verdict_text
from log_error import LogError
from mapping_answers import answer, dbc_options, said, write_draft

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = PROJECT / "build/release/sil/rsi-sil"
CALIBRATIONS = PROJECT / "firmware/calibrations"
TABLES = (".csv", ".txt", ".tsv", ".dat")
NO_LOGS = (".toml", ".dbc", ".md", ".html")
DOUBT = "# Doubt: "
PURPOSES = ("ramp", "dynamic")  # as rsi-sil validate reads them from names
DYNAMIC_MPS2 = 3.5              # of the drives without such names those nearest to it are taken as dynamic
MOST_OF_A_PURPOSE = 2

# A drive made of a log: its file, the object, and lines about it.
Made = collections.namedtuple("Made", "log file drive facts")


def make(options):
    parameters = calibration(options.parameters) if options.parameters else None
    data = mapping.read_text(options.vehicle_data) if options.vehicle_data else None
    try:
        logs, left_out = logs_of(options.folder, options.dbc)
    except OSError as error:
        raise LogError(f"{options.folder}: cannot be read: {error.strerror}") from error
    output = options.output or PROJECT / "output" / f"logs-{options.folder.resolve().name}"
    begin(output)
    odd = Kept(sys.stderr)
    with contextlib.redirect_stderr(odd):
        if options.dbc:
            dbc_signals.database(options.dbc)
    own = options.folder / "mapping.toml"
    signals = own if own.exists() else output / "mapping.toml"
    if not signals.exists():
        write_draft(options.dbc, logs, signals)
    answer(signals, options.answer)
    made = drives_of(logs, options.dbc, signals, output / "drives", left_out)
    found = ""
    if data is not None:
        file_io.write(output / "drives/vehicle.toml", data)
        said("cp", options.vehicle_data, output / "drives/vehicle.toml")
        made, parameters, found = calibrated(options, made, parameters, output)
    is_shipped = parameters is None
    parameters = parameters or CALIBRATIONS / "large_suv.toml"
    called(options.program, "replay", *[one.file for one in made], "--parameters", parameters, "--no-pictures", "--output",
           output / "replays")
    text = verdict_text.markdown(made, left_out, found, doubts_of(parameters), output)
    text += verdict_text.section("DBC files", [line.removeprefix("sil/tools/logs: ") for line in odd.getvalue().splitlines()])
    if is_shipped:
        text += ("\nThe calibration is that of the shipped large_suv and not your vehicle's: the warnings show that the signals are "
                 "right, not when yours is warned. Give --vehicle-data FILE, or --parameters FILE.\n")
    text += f"\nCalibration: {parameters}\nSigns and signals: {signals}\n"
    file_io.write(output / "verdict.md", text)
    file_io.write(output / "verdict.html", verdict_text.page(text, verdict_text.pictures(made, output)))
    print(f"\n{text}\nThe same as a page: {output / 'verdict.html'}")


def doubts_of(parameters):
    """Doubts that rsi-sil identify left at the head of a calibration."""
    return [line.removeprefix(DOUBT) for line in mapping.read_text(parameters).splitlines() if line.startswith(DOUBT)]


def begin(output):
    """Results of an earlier call go, and nothing else."""
    folders = [output / name for name in ("drives", "replays", "validation", "identification")]
    for folder in folders:
        if folder.exists() and not (output / "verdict.md").exists():
            raise LogError(f"{folder}: exists, and is not of an earlier verdict; choose another folder with --output")
        shutil.rmtree(folder, ignore_errors=True)
    try:
        folders[0].mkdir(parents=True)
        (output / "verdict.html").unlink(missing_ok=True)
    except OSError as error:
        raise LogError(f"{output}: cannot be written: {error.strerror}; choose another folder with --output") from error
    file_io.write(output / "verdict.md", "# Verdict\n\nIs being made, or was not finished.\n")


def calibration(name):
    file = CALIBRATIONS / f"{name}.toml"
    if not pathlib.Path(name).exists() and not file.exists():
        shipped = " ".join(sorted(each.stem for each in CALIBRATIONS.glob("*.toml")))
        raise LogError(f"--parameters {name}: there is no such file, nor a calibration of that name; there are {shipped}")
    return file if not pathlib.Path(name).exists() else pathlib.Path(name)


def logs_of(folder, dbc):
    """The logs of a folder, and lines about its other files."""
    if not folder.is_dir():
        raise LogError(f"{folder}: is no folder; give the one with the logs")
    logs, others = [], []
    for path in sorted(folder.iterdir()):
        if not path.is_file() or path.name.startswith(".") or path.suffix in NO_LOGS:
            continue
        try:
            with path.open("rb") as file:
                kind = bus_logs.kind_of(file.read(4096))
        except OSError as error:
            others.append(f"{path.name}: cannot be read: {error.strerror}")
            continue
        is_table = kind is None and path.suffix.lower() in TABLES
        if kind is not None and (dbc or kind == "MF4") or is_table and not dbc:
            logs.append(path)
        else:
            others.append(f"{path.name}: " + (f"holds frames ({kind}), so your DBC file is needed: --dbc FILE" if kind else
                                              "is no log of frames" if dbc else "is no table of values"))
    if not logs:
        raise LogError(f"{folder}: has no log that can be read with{'' if dbc else 'out'} a DBC file"
                       + "".join(f"\n  {line}" for line in others))
    return logs, others


class Kept(io.StringIO):
    """A stream that keeps a text and shows it at once besides."""

    def __init__(self, shown):
        super().__init__()
        self.shown = shown

    def write(self, text):
        self.shown.write(text)
        return super().write(text)


def drives_of(logs, dbc, signals, folder, left_out):
    made = []
    for log in logs:
        others = [name for other in logs if other != log for name in (other.stem, other.name)]
        file = folder / f"{log.name if log.stem in others else log.stem}.csv"
        said("sil/tools/logs", "drive", log, *dbc_options(dbc), "--mapping", signals, "--output", file)
        account, errors = io.StringIO(), Kept(sys.stderr)
        try:
            with contextlib.redirect_stdout(account), contextlib.redirect_stderr(errors):
                driven = drive.make([log], dbc, signals, file)
        except LogError as error:
            left_out.append(f"{log.name}: {error}")
            print(f"  no drive: {error}")
            continue
        file_io.write(file.with_suffix(".txt"), account.getvalue())
        remarks = [line for line in account.getvalue().splitlines() if re.search("left out|: none; |LOOK|check the units", line)]
        remarks += [line for line in errors.getvalue().splitlines() if "left out" in line]
        made.append(Made(log, file, driven, drive_facts.facts(driven) + remarks))
        print("  " + "\n  ".join(made[-1].facts))
    if not made:
        raise LogError("no log gives a drive:\n  " + "\n  ".join(left_out))
    return made


def called(program, *parts):
    """A command of rsi-sil; what it said."""
    said(program, *parts)
    try:
        finished = subprocess.run([str(part) for part in (program, *parts)], stdout=subprocess.PIPE, text=True, check=False)
    except OSError as error:
        raise LogError(f"{program}: {error.strerror}; make it with cmake/environment/build release rsi-sil") from error
    print("".join(f"  {line}\n" for line in finished.stdout.splitlines()), end="")
    if finished.returncode:
        raise LogError(f"rsi-sil {parts[0]} ended with status {finished.returncode}; what it said stands above")
    return finished.stdout


def chosen(made):
    """The drives, with names that say what rsi-sil validate is to do with them: best to calibrate by are those to both sides,
    and dynamic ones of moderate size, of which two thirds remain to check with."""
    of_ramp, of_dynamic = ([one for one in made if drive_facts.purpose(one.drive) == word] for word in PURPOSES)
    of_ramp.sort(key=lambda one: not drive_facts.is_to_both_sides(one.drive))
    of_dynamic.sort(key=lambda one: (not drive_facts.is_to_both_sides(one.drive),
                                     abs(drive_facts.hardest_mps2(one.drive) - DYNAMIC_MPS2)))
    names = {one.log: PURPOSES[0] for one in of_ramp[:MOST_OF_A_PURPOSE]}
    names.update({one.log: PURPOSES[1] for one in of_dynamic[:min(max(len(of_dynamic) // 3, 1), MOST_OF_A_PURPOSE)]})
    renamed = []
    for one in made:
        if one.log in names:
            file = one.file.with_name(f"{names[one.log]}-{one.file.name}")
            said("mv", one.file, file)
            one = one._replace(file=one.file.rename(file))
        renamed.append(one)
    return renamed


def calibrated(options, made, parameters, output):
    """The drives by the names that rsi-sil validate knows, the calibration of some, and what the others say of it."""
    if not parameters and not any(one.file.name.startswith(PURPOSES) for one in made):
        made = chosen(made)
    ramps, dynamics = ([one.file for one in made if one.file.name.startswith(word)] for word in PURPOSES)
    if not parameters and not (ramps and dynamics):
        raise LogError(f"{options.folder}: no calibration without a slow ramp and a dynamic drive (docs/calibration.md), of which "
                       f"there are {len(ramps)} and {len(dynamics)}; name them ramp* and dynamic* where they were not recognised, or "
                       "give --parameters FILE in place of --vehicle-data")
    data = output / "drives/vehicle.toml"
    if len(ramps) + len(dynamics) < len(made):
        given = ["--parameters", parameters] if parameters else []
        found = called(options.program, "validate", data.parent, *given, "--output", output / "validation")
        return made, parameters or output / "validation/identification/calibration.toml", found
    if parameters:
        return made, parameters, "Nothing: all drives are named ramp or dynamic, and none is left to check with."
    inputs = [part for option, files in (("--ramp", ramps), ("--dynamic", dynamics)) for file in files for part in (option, file)]
    called(options.program, "identify", "--vehicle-data", data, *inputs, "--no-pictures", "--output", output / "identification")
    return made, output / "identification/calibration.toml", "Nothing: no further drive is left to check the calibration with."
