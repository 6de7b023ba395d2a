"""The data of the last whole runs, in docs/reports/data: what is killed in each file, and the survivors.

A file's share of killed mutants is its floor. A survivor's text need not follow the source: it only says which mutant a reason
is about, and which ones a sample need not draw."""

import csv
import dataclasses
import io
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[3] / "cmake/environment"))

import file_io  # noqa: E402

FOLDER = "docs/reports/data"
SURVIVED = "survived"


@dataclasses.dataclass(frozen=True)
class Floor:
    scope: str
    file: str
    mutants: int
    killed: int

    def holds(self, mutants, killed):
        """Neither a smaller share is killed nor, where mutants went, does one more survive."""
        return killed * self.mutants >= self.killed * mutants or mutants - killed <= self.mutants - self.killed


@dataclasses.dataclass(frozen=True)
class Survivor:
    scope: str
    file: str
    function: str
    operator: str
    change: str
    equivalent: str  # yes: no input shows a difference, so that no test could kill it
    reason: str

    def key(self):
        return self.file, f"{self.function}: {self.operator}: {self.change}"

    def place(self):
        return self.file, self.function, self.operator


@dataclasses.dataclass(frozen=True)
class Total:
    scope: str
    kind: str  # operator, or why not tried, or how killed
    name: str
    mutants: int
    killed: int


_TABLES = {"floors": ("mutation_files.csv", Floor), "survivors": ("mutation_survivors.csv", Survivor),
           "totals": ("mutation_totals.csv", Total)}


class Ledger:
    def __init__(self, project):
        self._folder = project / FOLDER
        for name, (file, row) in _TABLES.items():
            setattr(self, name, _rows(self._folder / file, row))

    def of(self, scope):
        """The rows of one scope: floors, survivors, totals."""
        return [[row for row in getattr(self, name) if row.scope == scope] for name in _TABLES]

    def replace(self, scope, floors, survivors, totals):
        for name, rows in zip(_TABLES, (floors, survivors, totals)):
            setattr(self, name, [row for row in getattr(self, name) if row.scope != scope] + rows)

    def write(self):
        self._folder.mkdir(exist_ok=True)
        for name, (file, row) in _TABLES.items():
            text = io.StringIO()
            writer = csv.writer(text, lineterminator="\n")
            writer.writerow(field.name for field in dataclasses.fields(row))
            writer.writerows(dataclasses.astuple(one) for one in sorted(getattr(self, name), key=lambda one: one.scope))
            file_io.write(self._folder / file, text.getvalue())


def _rows(path, row):
    if not path.is_file():
        return []
    fields = dataclasses.fields(row)
    with path.open(newline="", encoding="utf-8") as file:
        return [row(**{field.name: field.type(line[field.name]) for field in fields}) for line in csv.DictReader(file)]


def reviewed(scope, mutants, results, known):
    """The survivors of a run. A reason stays with its mutant; with those of its function and operator if their texts have
    changed, their number has not grown, and all have the same reason."""
    by_key = {survivor.key(): survivor for survivor in known}
    surviving = [mutant for mutant in mutants if results.get(mutant.id) == SURVIVED]
    keys = {mutant.key() for mutant in surviving}
    left = {}
    for survivor in known:
        if survivor.key() not in keys:
            left.setdefault(survivor.place(), []).append((survivor.equivalent, survivor.reason))
    rows = []
    for mutant in surviving:
        function, _, change = mutant.name().partition(f": {mutant.operator}: ")
        old = by_key.get(mutant.key())
        review = (old.equivalent, old.reason) if old else ("", "")
        of_place = left.get((mutant.file, function, mutant.operator), [])
        if not old and of_place and len(set(of_place)) == 1:
            review = of_place.pop()
        rows.append(Survivor(scope, mutant.file, function, mutant.operator, change, *review))
    return rows


def below_floor(mutants, results, floors, least):
    """Files of which too little is killed, each with its sentence. `mutants`: all that a whole run tries; a file of which
    some were not tried is not judged. `least`: the share of a file that no run has measured yet."""
    by_file = {}
    for mutant in mutants:
        by_file.setdefault(mutant.file, []).append(mutant)
    floor_of = {floor.file: floor for floor in floors}
    found = {}
    for file, of_file in by_file.items():
        if any(mutant.id not in results for mutant in of_file):
            continue
        killed = sum(results[mutant.id] != SURVIVED for mutant in of_file)
        floor = floor_of.get(file)
        if floor and not floor.holds(len(of_file), killed):
            found[file] = (f"{file}: {killed} of {len(of_file)} mutants are killed; its floor is {floor.killed} of "
                           f"{floor.mutants}")
        elif not floor and killed < least * len(of_file):
            found[file] = (f"{file}: {killed} of {len(of_file)} mutants are killed; a file without a row in "
                           f"{FOLDER}/mutation_files.csv needs {100 * least:.0f} %; was it renamed?")
    return found
