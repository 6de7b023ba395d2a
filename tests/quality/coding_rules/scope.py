"""Which sources the rules are for, and the units that they are compiled in."""

import pathlib
import re

from compilers import BOARD, HOST, Unit
from findings import PROJECT

FOLDERS = ("firmware", "can_dbc", "hal/interface", "hal/zynqmp_r5")
# Test programs among the firmware's images.
LEFT_OUT = {"firmware/images/zynqmp_r5/faults_main.cpp": "breaks the rules in order to provoke faults; never flashed"}
_BOARD_FOLDERS = ("firmware/images/", "hal/zynqmp_r5/")
_ENDINGS = (".c", ".h", ".cpp", ".hpp")


def sources():
    """All of them, from the project's folder, sorted."""
    found = []
    for folder in FOLDERS:
        for file in sorted((PROJECT / folder).rglob("*")):
            path = str(file.relative_to(PROJECT))
            if path.endswith(_ENDINGS) and path not in LEFT_OUT and not is_for_users_build(path):
                found.append(path)
    if len(found) < 50:
        raise SystemExit(f"only {len(found)} sources found: the folders of tests/quality/coding_rules/scope.py have moved")
    return found


def is_for_users_build(path):
    """C99 that is never flashed with the ECU: a calibration as a header, and the self-test of a build. Their tests compile
    them, with warnings."""
    return path.startswith("firmware/selftest/") or (
        path.startswith("firmware/calibrations/generated/") and path.endswith(".h"))


def is_compiled(path):
    """C sources are parameter sections: data, compiled with warnings by the build."""
    return not path.endswith(".c")


def _is_of_board(path):
    return path.startswith(_BOARD_FOLDERS)


def _in_order(paths):
    """Units first; then headers, most of which are read by then."""
    return tuple(sorted(paths, key=lambda path: (path.endswith((".h", ".hpp")), path)))


def units():
    """The component and application as one, the image as one."""
    all_sources = [path for path in sources() if is_compiled(path)]
    return [
        Unit("firmware", HOST, _in_order(path for path in all_sources if not _is_of_board(path))),
        Unit("image", BOARD, _in_order(path for path in all_sources if _is_of_board(path))),
    ]


def unit_of(path):
    """One file on its own."""
    name = re.sub(r"\W", "_", path)
    return Unit(name, BOARD if _is_of_board(path) else HOST, (path,))


def path_of(argument):
    file = pathlib.Path(argument).resolve()
    if not file.is_file() or not file.is_relative_to(PROJECT):
        raise SystemExit(f"{argument}: no such file in the project")
    return str(file.relative_to(PROJECT))
