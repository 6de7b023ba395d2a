"""draw_measurement.py A2L FILE.png: see draw_measurement."""

import pathlib
import sys

sys.dont_write_bytecode = True
PROJECT = pathlib.Path(__file__).resolve().parents[4]
sys.path[1:1] = [str(PROJECT / "sil/tools"), str(PROJECT / "cmake/environment")]

import a2l_objects  # noqa: E402
import calibration  # noqa: E402
import simulated_bus  # noqa: E402
import xcp_session  # noqa: E402

NAMES = ["lateral_acceleration_mps2", "lateral_acceleration_threshold_mps2", "warning_level", "state"]
DRIVE = ("j-turn-110", 4.0)
CYCLES = 205


def main(a2l, picture):
    bus = simulated_bus.SimulatedBus()
    bus.drive(*DRIVE)
    try:
        with xcp_session.Session(a2l_objects.read(a2l), simulated_bus.Interface(bus)) as session:
            session.unlock()
            options = calibration.parse(["measure", *NAMES, "--seconds", str(CYCLES / 100), "--output", picture])
            calibration.measure(session, options, lambda _seconds: bus.run(CYCLES))
    finally:
        bus.end()


if __name__ == "__main__":
    main(*sys.argv[1:])
