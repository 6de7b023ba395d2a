"""The mutants, numbered over all files."""

import collections
import dataclasses
import re


@dataclasses.dataclass
class Mutant:
    id: int
    file: str
    line: int
    function: str  # or the field whose initial value it is
    operator: str
    original: str
    mutated: str
    occurrence: int = 1  # the first, second ... in its function with this text

    def name(self):
        """Which one it is within its file, whatever the line."""
        occurrence = f" ({self.occurrence})" if self.occurrence > 1 else ""
        return f"{self.function or '(file)'}: {self.operator}: {self.original} -> {self.mutated}{occurrence}"

    def key(self):
        return self.file, self.name()

    def __str__(self):
        return f"{self.file}:{self.line} {self.name()}"


def plain(text):
    return re.sub(r"\s+", " ", text).strip()


class Mutants(list):
    """Those of the constants first, for a constant of one file is used in others."""

    def __init__(self):
        super().__init__()
        self.skipped = collections.Counter()  # why: how many places
        self._occurrences = collections.Counter()
        self.of_constant = {}  # name of a constant: number of its first mutant

    def new(self, file, line, function, operator, original, *mutated):
        """The number of the first; the others follow."""
        first = len(self) + 1
        for text in mutated:
            mutant = Mutant(len(self) + 1, file, line, function, operator, plain(original), plain(text))
            self._occurrences[mutant.key()] += 1
            mutant.occurrence = self._occurrences[mutant.key()]
            self.append(mutant)
        return first
