"""Calibrates and judges the component on vehicles of others' equations, and of joints in another engine.

Use: study.py PROGRAM OUTPUT PAGE VEHICLES JOINTED ROUNDS SEED JOBS

Draws the vehicles, lets each drive, calibrates each by `PROGRAM identify` alone, sends the drives through the firmware by
`PROGRAM replay`, and writes the page, and the vehicles' quantities beside it. Called by sil/studies/foreign/run.
"""

import concurrent.futures
import csv
import functools
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import typing

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path += [str(PROJECT / folder) for folder in ("sil/judge", "sil/page", "cmake/environment")]

import families  # noqa: E402
import judge  # noqa: E402
import manoeuvres  # noqa: E402
import quantities  # noqa: E402
import report  # noqa: E402
import ways  # noqa: E402
import file_io  # noqa: E402


class Outcome(typing.NamedTuple):
    """A drive as `replay` judged it."""

    vehicle: str
    manoeuvre: str
    lift_s: float | None
    largest_ltr: float
    lead_s: float | None
    alarm: bool


class Result(typing.NamedTuple):
    """Outcomes of one vehicle in each way of the report; None: the component did not admit the calibration."""

    vehicle: str
    family: str
    kind: str
    tyre_limit_mps2: float
    largest_lateral_acceleration_mps2: float
    quantities: dict  # quantities.of_vehicle
    data_sheet: dict  # quantities.of_data_sheet
    inertia_assumed: bool  # no body has the roll inertia that the drives give; identify took its rule of thumb
    outcomes: dict


ASSUMED_INERTIA = "# rule of thumb: the drives alone would give"  # behind a roll inertia that identify wrote


class Refused(Exception):
    """The program did not accept what it was given."""


def say(text):
    print(f"foreign: {text}", file=sys.stderr, flush=True)


def run(*command):
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, check=False)
    if done.returncode:
        raise Refused(done.stderr.strip() or done.stdout.strip())


def write_drives(vehicle, seed, rounds, folder):
    """The drives of a vehicle in `folder`, and its data sheet. Returns the ramp, and the largest lateral acceleration of the
    evaluation."""
    for name in ("clean", "noisy"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    file_io.write(folder / "vehicle.toml", "".join(f"{key} = {value:.9g}\n" for key, value in vehicle.data().items()))
    ramp = manoeuvres.ramp(vehicle)
    reference = manoeuvres.reference_deg(ramp)
    file_io.write(folder / "ramp.csv", manoeuvres.csv_text(ramp))
    file_io.write(folder / "lane_change.csv", manoeuvres.csv_text(manoeuvres.lane_change(vehicle, reference)))
    largest = 0.0
    for number, plan in enumerate(manoeuvres.plans(seed, vehicle, rounds)):
        rows = manoeuvres.evaluation(vehicle, plan, reference)
        name = f"{number:02} {plan.kind}.csv".replace(" ", "_")
        file_io.write(folder / "clean" / name, manoeuvres.csv_text(rows))
        noisy = manoeuvres.noisy(rows, f"{seed} {vehicle.name} {number}")
        file_io.write(folder / "noisy" / name, manoeuvres.csv_text(noisy))
        largest = max(largest, *(abs(manoeuvres.on_the_road_mps2(row)) for row in rows))
    return ramp, largest


def identify(program, folder):
    """Calibrates the vehicle whose drives are in `folder`, from its ramp and lane change, into `folder`/calibration."""
    run(program, "identify", "--vehicle-data", folder / "vehicle.toml", "--ramp", folder / "ramp.csv", "--dynamic",
        folder / "lane_change.csv", "--output", folder / "calibration", "--no-pictures")


def replay(program, calibration, settings, files, wanted="table.csv"):
    """Rows of a table that `replay` leaves: of `table.csv` one a file."""
    changes = [part for key, value in settings.items() for part in ("--set", f"{key}={value:.9g}")]
    with tempfile.TemporaryDirectory() as scratch:
        run(program, "replay", *files, "--parameters", calibration, *changes, "--output", scratch, "--no-pictures")
        return list(csv.DictReader(file_io.read(pathlib.Path(scratch, wanted)).splitlines()))


def outcome(vehicle, row):
    def number(key):
        return float(row[key]) if row[key] else None

    return Outcome(vehicle, row["drive"].split("_", 1)[1].replace("_", " "), number("two_wheel_lift_time_s"),
                   number("largest_load_transfer_ratio"), number("lead_time_s"), bool(row["warning_time_s"]))


def judged(program, vehicle, folder, changes):
    """Outcomes in each of the ways."""
    outcomes = {}
    for way, settings in changes.items():
        try:
            drives = sorted((folder / ways.DRIVES[way]).iterdir())
            rows = replay(program, folder / "calibration/calibration.toml", settings, drives)
            outcomes[way] = [outcome(vehicle.name, row) for row in rows]
        except Refused as error:
            say(f"vehicle {vehicle.name}, {way}: {error}")
            outcomes[way] = None
    return outcomes


def of_vehicle(program, output, seed, rounds, family_and_number):
    family, number = family_and_number
    vehicle = families.FAMILIES[family].draw(seed, number)
    folder = output / vehicle.name
    ramp, largest = write_drives(vehicle, seed, rounds, folder)
    identify(program, folder)
    written = file_io.read(folder / "calibration/calibration.toml")
    calibration = tomllib.loads(written)
    replayed_ramp = replay(program, folder / "calibration/calibration.toml", {}, [folder / "ramp.csv"], "ramp/indices.csv")
    outcomes = judged(program, vehicle, folder, ways.changes(calibration, seed, vehicle.name))
    return Result(vehicle.name, family, vehicle.kind, calibration[ways.TYRE_LIMIT], largest,
                  quantities.of_vehicle(vehicle, ramp, replayed_ramp, calibration), quantities.of_data_sheet(vehicle, calibration),
                  ASSUMED_INERTIA in written, outcomes)


def main(arguments):
    program, output, page = map(pathlib.Path, arguments[:3])
    *counts, rounds, seed, jobs = map(int, arguments[3:])
    numbers = [(family, number) for family, count in zip(families.FAMILIES, counts) for number in range(count)]
    judge.use(program)
    results = []
    with concurrent.futures.ProcessPoolExecutor(jobs) as pool:
        for result in pool.map(functools.partial(of_vehicle, program, output, seed, rounds), numbers):
            results.append(result)
            drives = result.outcomes[ways.CLEAN] or []
            lifted = sum(drive.lift_s is not None for drive in drives)
            say(f"vehicle {len(results)} of {len(numbers)}, {result.kind}: {lifted} lift-offs in {len(drives)} drives")
    print(report.results_table(results))
    file_io.write(page, report.page(results, seed))
    data = page.parent / "data/foreign_vehicles.csv"
    data.parent.mkdir(exist_ok=True)
    file_io.write(data, quantities.data(results))
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Refused as error:
        sys.exit(f"study.py: {error}")
    except OSError as error:
        sys.exit(f"study.py: {error.filename}: {error.strerror}")
