"""The rules for words, and all that breaks them."""

import dataclasses
import pathlib
import re
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "docs"))

from page import COMMENT, tracked  # noqa: E402
from text import Source, page_sentences, syntax_of  # noqa: E402

PAGES = re.compile(r"(?:README|CONTRIBUTING|CHANGELOG|SECURITY)\.md|docs/[^/]+\.md")
# Written by commands, or the rules themselves.
LEFT_OUT = re.compile(r"can_dbc/include/rsi/can_dbc/generated/|firmware/calibrations/generated/|tests/can_dbc/(?:byte_orders|can_fd)\.hpp"
                      r"|docs/reports/|tests/quality/words/|tests/quality/mutation/survivors|.*\.zip")
CLAUSES = {
    "of": "begin with the subject",
    "what": "name the thing, or use the passive ('Values kept over a reset' for 'What a reset keeps')",
    "who": "name the role ('A tester that ...')",
    "whom": "name the role",
    "whose": "begin with the subject",
    "whoever": "name the role ('A caller that ...')",
    "whatever": "'Everything that', 'Any'",
    "whichever": "'The ... that', 'Any'",
    "where": "'If', 'When', or 'Place of ...'",
    "wherever": "'If', 'Everywhere that'",
    "so": "'Therefore', 'Thus', or join it to the sentence before",
}
# Behind code these complete the name before them, as in `counter;  // of the newest frame`.
COMPLETIONS = ("of", "where", "so")
# The name of a C++ test continues that of its suite: ALead, OfALiftOffIsThatOfTheWarningInForce.
CONTINUATIONS = ("of", "whose")
FIRST_WORD = re.compile(r"[\"'(\[`*_]*(\w+)")
TEST_NAME = re.compile(r"\b(?:TYPED_)?TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)|\bdef test_(\w+)")
IDENTIFIER = re.compile(r"[A-Za-z_]\w*")
ENTRY = re.compile(r"^- (.*(?:\n(?:  .*))*)", re.MULTILINE)
VERB = re.compile(r"[A-Z][a-z]+ed\b|(?:Split|Made|Cut|Rewrote|Sped|Took)\b")
ENTRY_LINES = 2


@dataclasses.dataclass
class Fault:
    path: str
    line: int
    rule: str
    text: str
    instead: str

    def __str__(self):
        shown = self.text if len(self.text) <= 100 else self.text[:97] + "..."
        return f"{self.path}:{self.line}: {self.rule}: \"{shown}\"; write {self.instead}"


class Words:
    def __init__(self, path=HERE / "words.toml"):
        tables = tomllib.loads(path.read_text(encoding="utf-8"))
        self.persons = [(re.compile(rf"\b(?:{word})\b", re.IGNORECASE), better) for word, better in tables["persons"].items()]
        self.names = [(re.compile(rf"\b(?:{word})\b", re.IGNORECASE), better) for word, better in tables["names"].items()]
        self.identifiers = [(re.compile(word, re.IGNORECASE), better) for word, better in tables["identifiers"].items()]
        self.files = [(re.compile(rf"(?:.*/)?(?:{word})"), better) for word, better in tables["files"].items()]
        words = [word.replace(" ", "_?") for word in tables["names"]] + list(tables["identifiers"])
        self.any_name = re.compile("|".join(words), re.IGNORECASE)

    def of_sentence(self, path, sentence):
        first = FIRST_WORD.match(sentence.text)
        word = first[1].lower() if first else ""
        completes = sentence.trailing and sentence.first and word in COMPLETIONS and first[1].islower()
        small = sentence.kind == "message" and first and first[1].islower()  # a piece of a sentence
        instruction = re.match(r"\W*wh\w+ to\b", sentence.text, re.IGNORECASE)  # what to do
        capitals = first and first[1].isupper() and len(first[1]) > 1  # WHAT, the name of an argument
        if word in CLAUSES and not (capitals or sentence.text.endswith("?") or instruction or completes or small):
            yield Fault(path, sentence.line, f"begins with '{first[1]}'", sentence.text, CLAUSES[word])
            return
        for pattern, better in self.persons:
            found = pattern.search(sentence.text)
            if found:
                yield Fault(path, sentence.line, f"'{found[0]}'", sentence.text, better)

    def of_code(self, path, code):
        seen = set()  # each name once a file
        for number, line in enumerate(code.split("\n"), 1):
            for found in TEST_NAME.finditer(line):
                name = found[2] or found[3]
                first = apart(name).split(" ")[0].lower()
                if first in CLAUSES and not (found[2] and first in CONTINUATIONS):
                    yield Fault(path, number, f"test begins with '{first}'", name, CLAUSES[first])
            if not self.any_name.search(line):
                continue
            for name in dict.fromkeys(IDENTIFIER.findall(line)):
                if name in seen:
                    continue
                seen.add(name)
                found = [better for pattern, better in self.names if pattern.search(apart(name))]
                found += [better for pattern, better in self.identifiers if pattern.fullmatch(name)]
                yield from (Fault(path, number, "name", name, better) for better in found)

    def of_name(self, path):
        for pattern, better in self.files:
            if pattern.fullmatch(path):
                yield Fault(path, 1, "name of a file", path, better)


def apart(name):
    """TakesOutASensor, take_out_a_sensor: the words with blanks."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", name).replace("_", " ").strip()


def of_changelog(path, text):
    """Entries of the newest version."""
    older = [found.start() for found in re.finditer(r"^## ", text, re.MULTILINE)][1:]
    for found in ENTRY.finditer(text[: older[0]] if older else text):
        line = text.count("\n", 0, found.start()) + 1
        first = found[1].split("\n")[0]
        if not VERB.match(found[1]):
            yield Fault(path, line, "entry", first, "a verb first: Added, Changed, Renamed, Removed, Fixed")
        if found[1].count("\n") >= ENTRY_LINES:
            yield Fault(path, line, "entry", first, f"at most {ENTRY_LINES} lines; the page has the rest")


def faults_of(project, path, words):
    found = list(words.of_name(path))
    try:
        text = (project / path).read_text(encoding="utf-8")
    except (UnicodeDecodeError, IsADirectoryError):
        return found
    if PAGES.fullmatch(path):
        if path == "CHANGELOG.md":
            found += of_changelog(path, text)
            older = [begin.start() for begin in re.finditer(r"^## ", text, re.MULTILINE)][1:]
            text = text[: older[0]] if older else text
        for sentence in page_sentences(project, path, COMMENT.sub(lambda note: re.sub(r"[^\n]", " ", note[0]), text)):
            found += words.of_sentence(path, sentence)
        return found
    token = syntax_of(path, text)
    if token:
        source = Source(text, token)
        for sentence in source.sentences:
            found += words.of_sentence(path, sentence)
        found += words.of_code(path, source.code)
    return found


def check(project, names=None):
    """All faults of the project, or of these files and folders."""
    words = Words()
    files = [name for name in tracked(project) if not LEFT_OUT.match(name)]
    if names:
        files = [file for file in files if any(file == name or file.startswith(name.rstrip("/") + "/") for name in names)]
    return [fault for file in files for fault in faults_of(project, file, words)]
