"""Mutated files, and the test programs that are asked about them."""

import dataclasses
import pathlib

PROJECT = pathlib.Path(__file__).resolve().parents[3]


def _is_within(file, place):
    return file == place or file.startswith(place + "/")


@dataclasses.dataclass(frozen=True)
class Scope:
    name: str
    work: str                 # folder of the mutated copy, within the project
    programs: dict            # test program: its folder in the build
    asked: dict               # mutated folder or file: the programs that are asked about it
    left_out: dict            # file or folder in there that is not mutated: why
    headers: tuple            # folders whose headers the mutated sources read
    options: tuple            # of cmake
    title: str                # of its section of the page
    goal: float               # least share of killed mutants
    goal_of_able: float       # the same of those that are not equivalent
    longest_ms: int           # tests that take more CPU time are not asked
    every_survivor_explained: bool  # each has a reason in the list
    all_executed: bool              # every line, by the goals of the coverage: what is not, only the compiler uses

    def asked_about(self, file):
        """The programs whose tests a mutant of this file is tried on."""
        place = max((place for place in self.asked if _is_within(file, place)), key=len, default=None)
        return self.asked.get(place, set())

    def sources(self, project=PROJECT):
        """All that is mutated, in the order of the names."""
        found = {str(path.relative_to(project)) for place in self.asked
                 for path in (project / place, *(project / place).rglob("*")) if path.suffix in (".cpp", ".hpp")}
        return sorted(name for name in found if not any(_is_within(name, out) for out in self.left_out))


FIRMWARE_PROGRAMS = {"codec_test": "tests/can_dbc", "rsi_tests": "tests/rsi", "monitoring_tests": "tests/monitoring",
                     "access_test": "tests/access", "xcp_test": "tests/xcp", "application_test": "tests/application",
                     "diagnosis_test": "tests/diagnosis", "replay_test": "tests/quality/mutation"}
FIRMWARE = Scope(
    name="firmware", work="build/mutation", programs=FIRMWARE_PROGRAMS,
    # A test of the frames seldom sees in the algorithm what its own tests and a drive do not.
    asked={"firmware/rsi": {"rsi_tests", "monitoring_tests", "replay_test"},
           "firmware/rsi/ecu/monitoring": {"rsi_tests", "monitoring_tests", "application_test", "replay_test"},
           "firmware/rsi/ecu/access": {"access_test", "application_test"},
           "firmware/rsi/ecu/diagnosis": {"diagnosis_test"},
           "firmware/rsi/ecu/xcp": {"xcp_test"},
           "firmware/rsi/ecu/application": set(FIRMWARE_PROGRAMS), "can_dbc/include/rsi/can_dbc/e2e": set(FIRMWARE_PROGRAMS)},
    left_out={},
    headers=("can_dbc", "hal/interface"), options=("-DRSI_BUILD_SIL=OFF", "-DRSI_TESTS_COMPILE_OPTIONS=-O0"), title="The firmware",
    goal=0.9, goal_of_able=0.93, longest_ms=900, every_survivor_explained=True, all_executed=True)

JUDGES_PROGRAMS = {"judge_tests": "tests/sil/judge", "results_test": "tests/sil/results",
                   "hal_test": "tests/hal", "zynqmp_r5_test": "tests/hal/zynqmp_r5",
                   "campaign_tests": "tests/sil/campaign", "faults_tests": "tests/sil/faults", "files_test": "tests/sil/files",
                   "simulation_test": "tests/sil/simulation", "candump_compare_test": "tests/application/regression"}
BARE = "start-up or board code: no test program of the host compiles it"
INTERFACE = "needs a CAN interface: tests/system drives it, in a process of its own"
DRIVES = "decides what is driven, and judges none of it"
KEEPS = "keeps rows of a campaign that was interrupted"
WRITES = "writes what others have judged"
JUDGES_OF_FAULTS = [f"sil/studies/faults/{name}" for name in (
    "finding.cpp", "finding.hpp", "flip_effect.cpp", "flip_effect.hpp", "judgement.cpp", "judgement.hpp", "known_findings.cpp",
    "known_findings.hpp", "recovery_watch.hpp", "silence_watch.cpp", "silence_watch.hpp")]
JUDGES = Scope(
    name="judges", work="build/mutation_of_judges", programs=JUDGES_PROGRAMS,
    asked={"sil/judge": {"judge_tests", "results_test", "campaign_tests"},
           "sil/results": {"results_test"}, "hal": {"hal_test", "zynqmp_r5_test"}, "sil/files": {"files_test"},
           **{f"sil/simulation/bus_timing{suffix}": {"simulation_test"} for suffix in (".cpp", ".hpp")},
           **{f"tests/application/regression/{name}{suffix}": {"candump_compare_test"}
              for name in ("candump_compare", "frame_description") for suffix in (".cpp", ".hpp")},
           "sil/studies/campaign": {"campaign_tests"}, **{file: {"faults_tests"} for file in JUDGES_OF_FAULTS}},
    left_out={"sil/results/versions.cpp": "names versions, decides nothing",
              **{f"hal/{name}": BARE for name in ("mps2", "semihosting", "zynqmp_r5/startup")},
              **{f"hal/socketcan/{name}.cpp": INTERFACE
                 for name in ("can_socket", "controller_restart", "interface_lookup", "route_netlink", "socket_can_bus")},
              "hal/zynqmp_r5/emulator": "stands in for what the emulator lacks; no silicon has it",
              "hal/zynqmp_r5/policy.hpp": "names one of two other headers",
              **{f"sil/studies/campaign/{name}{suffix}": why for why, names in (
                  (DRIVES, ("campaign_run", "draw", "drawn_run", "learning_drive", "settings")),
                  (KEEPS, ("campaign", "campaign_folder", "campaign_part", "row_file", "row_workers")))
                 for name in names for suffix in (".cpp", ".hpp")},
              "sil/studies/campaign/settings_file.cpp": DRIVES,
              **{f"sil/studies/campaign/{name}.cpp": WRITES for name in ("report_files", "report_text")}},
    headers=("can_dbc", "firmware", "hal", "sil", "tests/application"), options=("-DRSI_TESTS_COMPILE_OPTIONS=-O0",),
    title="The judges", goal=0.85, goal_of_able=0.85, longest_ms=900, every_survivor_explained=False, all_executed=False)

SCOPES = {scope.name: scope for scope in (FIRMWARE, JUDGES)}
