"""A log of this project's own frames, in any container, as the candump log that `rsi-sil replay` reads."""

import pathlib

import cantools

import bus_log_writers
import progress
from bus_logs import BusLog
from log_error import LogError

DBC = pathlib.Path(__file__).resolve().parents[2] / "can_dbc/rollover_warning.dbc"


def sensor_identifiers():
    messages = cantools.database.load_file(DBC).messages
    return {message.frame_id: message.name for message in messages if "RolloverEcu" not in message.senders}


def output_files(logs, folder, ending):
    """Path of each log's result."""
    files = {}
    for path in logs:
        file = folder / (path.stem + ending)
        if file in files.values():
            raise LogError(f"two logs are called {path.stem}: their results would be the same file; convert them into two folders")
        if file.exists() and path.exists() and file.samefile(path):
            raise LogError(f"{path}: the result would take its place; choose another folder with --output")
        files[path] = file
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise LogError(f"cannot make the folder {folder}: {error.strerror}") from error
    return files


def convert(logs, folder, bus):
    known = sensor_identifiers()
    for path, file in output_files(logs, folder, ".log").items():
        log = BusLog(path)
        counts = {}
        bus_log_writers.write_candump(file, checked(log, known, bus, counts))
        converted = ", ".join(f"{count} {known[identifier]}" for identifier, count in sorted(counts.items()))
        print(f"{path} ({log.kind}): {converted}\n  {file}")


def checked(log, known, bus, counts):
    """The frames of the log, if they are the project's, and of one bus only."""
    buses = []
    seen = set()
    for frame in progress.reported(log):
        if bus is not None and str(frame.bus) != bus:
            seen.add(str(frame.bus))
            continue
        if frame.identifier in known and not frame.extended:
            counts[frame.identifier] = counts.get(frame.identifier, 0) + 1
            if frame.bus not in buses:
                buses.append(frame.bus)
            if len(buses) > 1:
                raise LogError(f"{log.path}: {known[frame.identifier]} comes on the buses {buses[0]} and {buses[1]}; choose one "
                               f"with --bus {buses[0]}")
        yield frame
    if not counts:
        expected = ", ".join(f"0x{identifier:03X}" for identifier in sorted(known))
        elsewhere = f" on bus {bus} (there are: {', '.join(sorted(seen))})" if seen else ""
        raise LogError(f"{log.path}: there is none of this project's sensor frames ({expected}){elsewhere}; for other frames, "
                       "with their DBC file, there is `sil/tools/logs drive` (docs/can.md)")
