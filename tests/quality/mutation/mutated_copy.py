"""The mutated copy of the project: links to everything but what is mutated, and the build of its test programs."""

import concurrent.futures
import hashlib
import os
import pathlib
import pickle
import re
import subprocess

import edited_source
import mutate
import mutants

PROJECT = pathlib.Path(__file__).resolve().parents[3]
FOLDER = PROJECT / "build/mutation"
SOURCE, BUILD = FOLDER / "source", FOLDER / "build"
PROGRAMS = {"codec_test": "tests/can_dbc", "rsi_tests": "tests/rsi", "monitoring_tests": "tests/monitoring",
            "application_test": "tests/application", "replay_test": "tests/quality/mutation"}
# Which programs are asked about what: a test of the frames seldom sees in the algorithm what its own tests and a drive do not.
SCOPE = {"firmware/rsi": {"rsi_tests", "monitoring_tests", "replay_test"},
         "firmware/monitoring": {"rsi_tests", "monitoring_tests", "application_test", "replay_test"},
         "firmware/application": set(PROGRAMS), "can_dbc/e2e": set(PROGRAMS)}
INCLUDES = ["-I", "{project}", "-I", "{project}/firmware", "-isystem", "/usr/include/eigen3"]
HELPERS = "tests/quality/mutation/schemata.hpp"


def is_asked(mutant, program):
    return any(mutant.file.startswith(folder) and program in programs for folder, programs in SCOPE.items())


def sources(project=PROJECT, scope=SCOPE):
    return sorted(str(path.relative_to(project)) for folder in scope
                  for path in (project / folder).rglob("*") if path.suffix in (".cpp", ".hpp"))


def parse_arguments(project):
    return ["-x", "c++", "-std=c++17", "-DEIGEN_DONT_VECTORIZE", "-resource-dir=/usr/lib/llvm-19/lib/clang/19", "-w"] + [
        part.format(project=project) for part in INCLUDES]


def mutated_texts(names, project, left_out=frozenset()):
    """The mutated text of each file and all mutants. `left_out`: (file, line) that does not compile when mutated."""
    all_mutants = mutants.Mutants()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        units = pool.map(lambda name: edited_source.parse(project / name, parse_arguments(project)), names)
    files = [mutate.FileMutator(all_mutants, name, project / name, unit,
                                {line for file, line in left_out if file == name}) for name, unit in zip(names, units)]
    for file in files:
        file.find_constants()
    return {file.source.name: file.mutated() for file in files}, all_mutants


def kept_mutated_texts(names, left_out):
    """Those of the last run, unless a source, a header next to it, or the tool has changed: clang takes its time."""
    read = hashlib.sha256(repr(sorted(left_out)).encode())
    for path in [PROJECT / name for name in names] + sorted((PROJECT / "can_dbc").rglob("*.hpp")) + sorted(
            (PROJECT / "hal/interface").rglob("*.hpp")) + sorted(pathlib.Path(__file__).parent.glob("*.py")):
        read.update(path.read_bytes())
    kept = FOLDER / f"mutants_{read.hexdigest()[:16]}.pickle"
    if not kept.is_file():
        texts, all_mutants = mutated_texts(names, PROJECT, left_out)
        all_mutants.sources = {name: hashlib.sha256((PROJECT / name).read_bytes()).hexdigest() for name in names}
        for old in FOLDER.glob("mutants_*.pickle"):
            old.unlink()
        kept.write_bytes(pickle.dumps((texts, all_mutants)))
    return pickle.loads(kept.read_bytes())


def write_if_other(path, text):
    if not path.is_file() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def link_everything_else(names):
    """One link for a folder without a mutated file, folders of their own for those with one."""
    mutated = {PROJECT / name for name in names}
    parents = {parent for path in mutated for parent in path.parents}
    def link(folder):
        for entry in sorted(folder.iterdir()):
            place = SOURCE / entry.relative_to(PROJECT)
            if entry in parents:
                place.mkdir(parents=True, exist_ok=True)
                link(entry)
            elif entry not in mutated and entry.name not in ("build", ".git", "output"):
                if not place.is_symlink():
                    place.symlink_to(entry)
    SOURCE.mkdir(parents=True, exist_ok=True)
    for old in [path for path in SOURCE.rglob("*") if path.is_symlink() and not path.exists()]:
        old.unlink()
    link(PROJECT)


def build(jobs):
    flags = f"-O1 -w -Wno-narrowing -D_GLIBCXX_ASSERTIONS -include {PROJECT / HELPERS}"
    if not (BUILD / "build.ninja").is_file():
        configured = subprocess.run(
            ["cmake", "-S", SOURCE, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DRSI_BUILD_SIL=OFF",
             "-DRSI_MUTATION=ON", f"-DCMAKE_CXX_FLAGS_RELEASE={flags}"], capture_output=True, text=True)
        if configured.returncode != 0:
            raise SystemExit(f"{configured.stdout}{configured.stderr}\nmutation: could not configure {BUILD}")
    return subprocess.run(["ninja", "-C", BUILD, "-j", str(jobs), "-k", "0", *PROGRAMS], capture_output=True, text=True)


def refused_places(output, names):
    """File and line of every error in a mutated file."""
    places = set()
    for file, line in re.findall(r"^([^\s:]+):(\d+):\d+: (?:fatal )?error:", output, re.M) + re.findall(
            r"^([^\s:]+):(\d+):\d+:   (?:required|in .constexpr. expansion)", output, re.M):
        path = (BUILD / file).resolve()
        for name in names:
            if path == (SOURCE / name).resolve():
                places.add((name, int(line)))
    return places


def make(jobs):
    """Writes, builds; a line that does not compile when mutated is left out, and counted. Gives all mutants."""
    names = sources()
    link_everything_else(names)
    left_out = set()
    while True:
        texts, all_mutants = kept_mutated_texts(names, left_out)
        for name, text in texts.items():
            write_if_other(SOURCE / name, text)
        built = build(jobs)
        if built.returncode == 0:
            break
        refused = refused_places(built.stdout, names) - left_out
        if not refused:
            raise SystemExit(f"{built.stdout[-6000:]}\nmutation: the mutated copy does not build; the reason is above")
        left_out |= refused
    return all_mutants
