"""Sources of guarded figures: the value is read from its source again.

A source is a line of the page's last comment, which begins with `<!-- sources`, or of everyday.txt:

    NAME: FILE KEY                 a TOML file: the value of the key, with dots for tables
    NAME: FILE WORD                any other file: the first number after that word, on its line
    NAME: FILE /REGULAR EXPRESSION/      the first group of the first match; it may be a number or a word for one
    NAME: FILE count /REGULAR EXPRESSION/      how many lines match
    NAME: FILE row FIRST CELL column N     the first number of that cell of the first table row that begins so
    NAME: PATTERN count            how many files there are of that pattern

each with ` * FACTOR` behind it when the page has another unit.
"""

import fnmatch
import math
import re
import tomllib

WORDS = ("zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen seventeen "
         "eighteen nineteen twenty").split()
# Words for parts and multiples of a quantity.
PARTS = {"half": 0.5, "halved": 0.5, "third": 1.0 / 3.0, "quarter": 0.25, "fifth": 0.2, "tenth": 0.1, "twice": 2.0}
NUMBER = r"[-+]?\d(?:[\d,']*\d)?(?:\.\d+)?(?:[eE][-+]?\d+)?"
LINE = re.compile(r"^(?P<name>[\w.-]+): (?P<file>\S+) (?P<what>.+?)(?: \* (?P<factor>[\d.e+-]+))?$")


class SourceError(Exception):
    """A source that does not give a value; says why."""


def number_of(text):
    if text.lower() in WORDS:
        return float(WORDS.index(text.lower()))
    if text.lower() in PARTS:
        return PARTS[text.lower()]
    found = re.fullmatch(NUMBER, text)
    if not found:
        raise SourceError(f"'{text}' is no number")
    return float(text.replace(",", "").replace("'", ""))


class Source:
    def __init__(self, line, project, files):
        found = LINE.match(line.strip())
        if not found:
            raise SourceError(f"not of the form NAME: FILE WHAT: {line.strip()}")
        self.name, self.file, self.what = found["name"], found["file"], found["what"]
        self.factor = float(found["factor"] or 1.0)
        self.project, self.files = project, files

    def value(self):
        return self._read() * self.factor

    def moved_to(self):
        """The one file of the same name when the stated one is gone."""
        if self.file in self.files or "*" in self.file:
            return None
        same = [name for name in self.files if name.rsplit("/", 1)[-1] == self.file.rsplit("/", 1)[-1]]
        return same[0] if len(same) == 1 else None

    def _read(self):
        if self.what == "count":
            found = fnmatch.filter(self.files, self.file)
            if not found:
                raise SourceError(f"no file is called {self.file}")
            return float(len(found))
        if self.file not in self.files:
            there = self.moved_to()
            raise SourceError(f"there is no file {self.file}" + (f"; {there}? --refresh follows it" if there else ""))
        text = (self.project / self.file).read_text(encoding="utf-8")
        if self.file.endswith(".toml") and not self.what.startswith(("/", "count /")):
            return self._key(tomllib.loads(text))
        cell = re.fullmatch(r"row (.+) column (\d+)", self.what)
        if cell:
            return self._cell(text, cell[1], int(cell[2]))
        counted = re.fullmatch(r"count /(.*)/", self.what)
        if counted:
            found = sum(bool(re.search(counted[1], line)) for line in text.splitlines())
            if not found:
                raise SourceError(f"no line of {self.file} matches {counted[1]}")
            return float(found)
        pattern = re.fullmatch(r"/(.*)/", self.what)
        expression = pattern[1] if pattern else rf"\b{re.escape(self.what)}\b[^\n;]*?({NUMBER})"
        found = re.search(expression, text, re.MULTILINE)
        if not found or not found.groups():
            raise SourceError(f"{self.file} has no number for {self.what}")
        return number_of(found[1])

    def _cell(self, text, name, column):
        for line in text.splitlines():
            cells = [cell.strip(" *`") for cell in line.strip().strip("|").split("|")]
            if line.startswith("|") and cells[0] == name:
                found = re.search(NUMBER, cells[column - 1]) if column <= len(cells) else None
                if found:
                    return number_of(found[0])
                break
        raise SourceError(f"{self.file} has no row {name} with a number in column {column}")

    def _key(self, value):
        for key in self.what.split("."):
            if not isinstance(value, dict) or key not in value:
                raise SourceError(f"{self.file} has no key {self.what}")
            value = value[key]
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise SourceError(f"{self.what} of {self.file} is no number")
        return float(value)


def shown(value, like):
    """The value as a page would show it that now says `like`."""
    if like.lower() in WORDS and value == int(value) and 0 <= value < len(WORDS):
        word = WORDS[int(value)]
        return word.capitalize() if like[0].isupper() else word
    like = "0.00" if like.lower() in PARTS else like  # no word may fit the new value
    places = len(like.partition(".")[2]) if like.lower() not in WORDS else 0
    text = f"{value:,.{places}f}" if "," in like or abs(value) >= 10000 else f"{value:.{places}f}"
    return "+" + text if like.startswith("+") and value >= 0 else text


def agree(like, value):
    """Whether the page's figure is the value, rounded to the page's places."""
    if like.lower() in WORDS or like.lower() in PARTS:
        return math.isclose(number_of(like), value)
    places = len(like.partition(".")[2])
    return math.isclose(number_of(like), value, rel_tol=0.0, abs_tol=0.500001 * 10.0**-places)
