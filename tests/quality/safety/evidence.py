"""Content of the project: tests that ctest knows, commands, files, signals of the .dbc."""

import fnmatch
import json
import os
import re
import subprocess

ECU = "RolloverEcu"
DIAGNOSTIC_CODE = "RolloverDiagnosis.Code"
# Groups of tests/run that run on request only.
ON_REQUEST = {"real_time", "benchmark", "bare_machine"}
GOOGLE_TEST = re.compile(r"^(?:TYPED_)?TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\)", re.MULTILINE)


class EvidenceError(Exception):
    """The evidence cannot be collected; says what to do."""


def plain_name(ctest_name):
    """The name without what a parameter adds: AtEveryPhase/Silence.Ends/3 # GetParam() = 3 is Silence.Ends."""
    parts = ctest_name.split("  #")[0].strip().split("/")
    for before, part in zip([""] + parts, parts):
        if "." in part:
            suite, test = part.split(".", 1)
            return f"{before if suite.isdigit() else suite}.{test}"
    return parts[0]


def tests_of(listing):
    """Name to group, from the text of `ctest --show-only=json-v1`. Disabled tests do not count."""
    tests = {}
    not_built = []
    for test in json.loads(listing)["tests"]:
        properties = {p["name"]: p["value"] for p in test.get("properties", [])}
        if test["name"].endswith("_NOT_BUILT"):
            not_built.append(test["name"].removesuffix("_NOT_BUILT"))
        elif not properties.get("DISABLED"):
            rooms = (properties.get("LABELS") or ["none"])[0].split(":")[0].split("/")
            tests[plain_name(test["name"])] = rooms[-1] if rooms[-1] in ON_REQUEST else rooms[0]
    if not_built:
        raise EvidenceError(f"not built: {', '.join(not_built)}; build first: cmake/environment/build release")
    return tests


class Evidence:
    """`codes`: the diagnostic codes that the ECU can send; empty while there is no frame for them. `sources`: test to file.
    `signatures`: the page of the tables by which the ECU isolates a faulty sensor; empty where there are none."""

    def __init__(self, project, tests, groups, signals, codes, sources, signatures=""):
        self.project = project
        self.tests = tests
        self.groups = groups
        self.signals = signals
        self.codes = codes
        self.sources = sources
        self.signatures = signatures

    def matching(self, pattern):
        """The tests that a name, perhaps with *, stands for."""
        return sorted(name for name in self.tests if fnmatch.fnmatchcase(name, pattern))

    def has_file(self, path):
        return (self.project / path).is_file()

    def has_command(self, command):
        words = command.split()
        program = self.project / words[0]
        if not (program.is_file() and os.access(program, os.X_OK)):
            return False
        return words[0] != "tests/run" or (len(words) == 2 and words[1] in self.groups)

    def matching_signals(self, pattern, direction):
        """Frame.Signal, perhaps with *, of those that the ECU has received or sent."""
        of_direction = (name for name, its in self.signals.items() if its == direction)
        return [name for name in of_direction if fnmatch.fnmatchcase(name, pattern)]


def is_command(test):
    """Tests are named as ctest names them; whatever has a path in it is a command."""
    return "/" in test.split()[0]


def signals_and_codes(*files):
    """Frame.Signal of all that the ECU sends or receives, with the direction; and the names of the diagnostic codes."""
    import cantools

    signals = {}
    codes = []
    for message in (message for file in files for message in cantools.database.load_file(file).messages):
        for signal in message.signals:
            name = f"{message.name}.{signal.name}"
            if ECU in message.senders:
                signals[name] = "sent"
            elif ECU in signal.receivers:
                signals[name] = "received"
            if name == DIAGNOSTIC_CODE:
                codes = [str(text) for value, text in sorted(signal.choices.items()) if value != 0]
    return signals, codes


def sources_of(project):
    """The file in which a test of GoogleTest stands, by the test's name."""
    sources = {}
    for file in sorted((project / "tests").rglob("*.cpp")):
        for suite, name in GOOGLE_TEST.findall(file.read_text()):
            sources.setdefault(f"{suite}.{name}", str(file.relative_to(project)))
    return sources


def collect(project, build):
    def output(*command):
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode:
            raise EvidenceError(f"{' '.join(map(str, command))} failed: {done.stderr.strip()}")
        return done.stdout

    signature_page = build / "tests/quality/safety/signature_page"
    if not (build / "CTestTestfile.cmake").is_file() or not signature_page.is_file():
        raise EvidenceError(f"{build} is not built; build first: cmake/environment/build release")
    tests = tests_of(output("/usr/bin/ctest", "--test-dir", str(build), "--show-only=json-v1"))
    groups = {folder.parent.name for folder in (project / "tests").rglob("CMakeLists.txt")} | ON_REQUEST | {"sanitize", "vcan"}
    signals, codes = signals_and_codes(
        project / "can_dbc/rollover_warning.dbc", project / "sil/simulation/simulation.dbc"
    )
    signatures = output(signature_page)
    return Evidence(project, tests, groups, signals, codes, sources_of(project), signatures)
