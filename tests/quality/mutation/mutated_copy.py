"""The mutated copy of the project: links to everything but what is mutated, and the build of its test programs."""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import pickle
import re
import shutil
import subprocess

import edited_source
import expressions
import kinds
import mutants
import mutate
import statements
from scope import PROJECT

HELPERS = "tests/quality/mutation/schemata.hpp"
ARGUMENTS = ["-x", "c++", "-std=c++17", "-DEIGEN_DONT_VECTORIZE", "-resource-dir=/usr/lib/llvm-19/lib/clang/19", "-w",
             "-isystem", "/usr/include/eigen3", "-DRSI_SOURCE_DIR=\"\"", "-DRSI_IDENTIFICATION_DRAW_SCRIPT=\"\"",
             "-DRSI_REPLAY_DRAW_SCRIPT=\"\""]


def declarations_of(names, project, generated=()):
    """Declarations of each file, as clang reads them. `generated`: folders of headers that the build writes."""
    arguments = ARGUMENTS + [part for folder in (project, project / "firmware", project / "hal/interface", project / "can_dbc/include", *generated) for part in ("-I", str(folder))]
    folders = {}
    for name in names:
        folders.setdefault(str(pathlib.Path(name).parent), []).append(project / name)
    declarations = {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for of_folder in pool.map(lambda paths: edited_source.parse(paths, arguments), folders.values()):
            declarations.update(of_folder)
    return declarations


def mutated_texts(names, project, declarations, left_out=frozenset()):
    """The mutated text of each file and all mutants. `left_out`: (file, line) that does not compile when mutated."""
    all_mutants = mutants.Mutants()
    files = [mutate.FileMutator(all_mutants, name, project / name, declarations[str(project / name)],
                                {line for file, line in left_out if file == name}) for name in names]
    for file in files:
        file.find_constants()
    return {file.source.name: file.mutated() for file in files}, all_mutants


def write_if_other(path, text):
    if path.is_symlink():
        raise ValueError(f"{path} is a link to the project's own file")
    if not path.is_file() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def link_everything_else(names, project, source):
    """One link for a folder without a mutated file, folders of their own for those with one. An entry of an earlier copy may
    be of the other kind; nothing is ever written through a link."""
    mutated = {project / name for name in names}
    parents = {parent for path in mutated for parent in path.parents}
    def link(folder):
        for entry in sorted(folder.iterdir()):
            place = source / entry.relative_to(project)
            if entry in parents or entry in mutated:
                if place.is_symlink():
                    place.unlink()
                if entry in parents:
                    place.mkdir(parents=True, exist_ok=True)
                    link(entry)
            elif entry.name not in ("build", ".git", "output") and not place.is_symlink():
                if place.is_dir():
                    shutil.rmtree(place)
                place.unlink(missing_ok=True)
                place.symlink_to(entry)
    source.mkdir(parents=True, exist_ok=True)
    for old in [path for path in source.rglob("*") if path.is_symlink() and not path.exists()]:
        old.unlink()
    link(project)


def forget_another_scope(names, folder):
    """Removes a copy in which other files were mutated, but for the results, which give hints. A file that is mutated no
    longer becomes a link to one that is older than what was compiled of the mutated one: ninja would keep that, and so would
    the record the numbers of mutants that are none any more."""
    kept = folder / "names.json"
    if not kept.is_file() or json.loads(kept.read_text()) != names:
        for place in ("source", "build"):
            shutil.rmtree(folder / place, ignore_errors=True)
        for old in folder.glob("record_*.json"):
            old.unlink()
        folder.mkdir(parents=True, exist_ok=True)
        kept.write_text(json.dumps(names))


def refused_places(output, names, source, build):
    """File and line of every error in a mutated file."""
    places = set()
    for file, line in re.findall(r"^([^\s:]+):(\d+):\d+: (?:fatal )?error:", output, re.M) + re.findall(
            r"^([^\s:]+):(\d+):\d+:   (?:required|in .constexpr. expansion)", output, re.M):
        path = (build / file).resolve()
        for name in names:
            if path == (source / name).resolve():
                places.add((name, int(line)))
    return places


class MutatedCopy:
    def __init__(self, scope, is_wanted=lambda name: True):
        """All of the scope is mutated; of the programs those are built that are asked about a file that is wanted."""
        self.scope = scope
        self.folder = PROJECT / scope.work
        self._names = scope.sources()
        asked = set().union(*(scope.asked_about(name) for name in self._names if is_wanted(name)))
        self.programs = {name: self.folder / "build" / folder / name
                         for name, folder in scope.programs.items() if name in asked}
        self._source, self._build = self.folder / "source", self.folder / "build"
        self._declarations = None  # of the sources, once clang has read them

    def make(self, jobs):
        """Writes, builds; a line that does not compile when mutated is left out, and counted. Gives all mutants."""
        forget_another_scope(self._names, self.folder)
        link_everything_else(self._names, PROJECT, self._source)
        self._configure()
        left_out = self._refused_earlier()
        while True:
            texts, all_mutants = self._kept_mutated_texts(left_out)
            for name, text in texts.items():
                write_if_other(self._source / name, text)
            built = subprocess.run(["ninja", "-C", self._build, "-j", str(jobs), "-k", "0", *self.programs],
                                   capture_output=True, text=True)
            if built.returncode == 0:
                return all_mutants
            refused = refused_places(built.stdout, self._names, self._source, self._build) - left_out
            if not refused:
                raise SystemExit(f"{built.stdout[-6000:]}\nmutation: the mutated copy does not build; the reason is above")
            left_out |= refused

    def _configure(self):
        """Before anything is mutated, for clang reads headers that this writes."""
        if (self._build / "build.ninja").is_file():
            return
        for name in self._names:
            write_if_other(self._source / name, (PROJECT / name).read_text())
        flags = f"-O1 -w -Wno-narrowing -D_GLIBCXX_ASSERTIONS -include {PROJECT / HELPERS}"
        configured = subprocess.run(
            ["cmake", "-S", self._source, "-B", self._build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             "-DCMAKE_C_COMPILER=clang-19", "-DCMAKE_CXX_COMPILER=clang++-19",  # gcc takes twice as long
             f"-DRSI_MUTATION={self.scope.name}", f"-DCMAKE_CXX_FLAGS_RELEASE={flags}",
             f"-DRSI_MBEDTLS={PROJECT / 'build/mbedtls'}", *self.scope.options],
            capture_output=True, text=True)
        if configured.returncode != 0:
            raise SystemExit(f"{configured.stdout}{configured.stderr}\nmutation: could not configure {self._build}")

    def _digest(self, *more):
        """Fingerprint of the mutated sources, of those that clang reads, and of the tool."""
        read = hashlib.sha256(repr((ARGUMENTS, self._names, more)).encode())
        headers = [path for folder in self.scope.headers for path in (PROJECT / folder).rglob("*")
                   if path.suffix in (".hpp", ".h", ".toml", ".in")]
        tools = [pathlib.Path(module.__file__) for module in (edited_source, expressions, kinds, mutants, mutate, statements)]
        for path in sorted({*headers, *(PROJECT / name for name in self._names), *tools}):
            read.update(path.read_bytes())
        return read.hexdigest()[:16]

    def _refused_earlier(self):
        """Keeps the same sources from being built, and refused, again."""
        kept = self.folder / f"refused_{self._digest()}.json"
        return {tuple(place) for place in json.loads(kept.read_text())} if kept.is_file() else set()

    def _kept_mutated_texts(self, left_out):
        """Those of the last run, unless a source, a header it reads, or the tool has changed: clang takes its time."""
        kept = self.folder / f"mutants_{self._digest(sorted(left_out))}.pickle"
        if not kept.is_file():
            if self._declarations is None:
                generated = sorted((self._build / "sil").rglob("generated"))
                self._declarations = declarations_of(self._names, PROJECT, generated)
            texts, all_mutants = mutated_texts(self._names, PROJECT, self._declarations, left_out)
            for old in [*self.folder.glob("mutants_*.pickle"), *self.folder.glob("refused_*.json")]:
                old.unlink()
            kept.write_bytes(pickle.dumps((texts, all_mutants)))
            (self.folder / f"refused_{self._digest()}.json").write_text(json.dumps(sorted(left_out)))
        return pickle.loads(kept.read_bytes())
