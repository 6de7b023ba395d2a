"""Texts of a file: comments, messages (string literals), identifiers and, of a page, its prose; each with its line."""

import bisect
import dataclasses
import pathlib
import re
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "docs"))

from page import HEADING, INLINE_CODE, ITEM, LINK, Page, blanked  # noqa: E402

SLASHES = {".c", ".h", ".cpp", ".hpp", ".js", ".S", ".ld"}
HASHES = {".sh", ".cmake", ".txt", ".toml", ".yml", ".yaml", ".gp", ""}
C_TOKEN = re.compile(r'(?P<comment>//[^\n]*|/\*.*?\*/)|(?<!\w)(?:u8|[uUL])?R"(?P<raw>\w*)\(.*?\)(?P=raw)"'
                     r'|(?P<string>"(?:\\.|[^"\\\n])*")|(?<!\w)\'(?:\\.|[^\'\\\n])*\'', re.DOTALL)
PYTHON_TOKEN = re.compile(r'(?P<comment>#[^\n]*)|(?P<doc>"""(?:\\.|[^\\])*?""")|(?P<string>"(?:\\.|[^"\\\n])*")'
                          r"|'(?:\\.|[^'\\\n])*'", re.DOTALL)
SQL_TOKEN = re.compile(r"(?P<comment>--[^\n]*)|(?P<string>'[^']*')|\"[^\"\n]*\"")
# A '#' within a word or a quote is no comment: ${#list}, "#1".
HASH_TOKEN = re.compile(r'(?P<comment>(?:(?<=\s)|^)#[^\n]*)|(?P<doc>""".*?""")|(?P<string>"(?:\\.|[^"\\])*")'
                        r"|'[^'\n]*'", re.DOTALL | re.MULTILINE)
CMAKE_TOKEN = re.compile(r'(?P<comment>#[^\n]*)|(?P<string>"(?:\\.|[^"\\])*")', re.DOTALL)
TITLE = re.compile(r"^(?:#|//|--|/\*+|\*+/?|\s)*[!<]*\s?|\s*\*/$")
BETWEEN_SENTENCES = re.compile(r"(?<=[.!?])[\"')]*\s+(?=[\"'(`]*[A-Z])")
FEW_WORDS = 4


@dataclasses.dataclass
class Sentence:
    line: int
    text: str
    kind: str  # comment, message or page
    first: bool = True  # of its comment or paragraph
    trailing: bool = False  # a comment behind code


def syntax_of(name, text):
    suffix = pathlib.PurePath(name).suffix
    if suffix == ".in":
        suffix = pathlib.PurePath(name[:-3]).suffix
    if suffix == "" and not text.startswith("#!"):
        return None
    if suffix == ".py" or text.startswith("#!/usr/bin/python3"):
        return PYTHON_TOKEN
    if suffix in SLASHES:
        return C_TOKEN
    if suffix == ".sql":
        return SQL_TOKEN
    if suffix == ".cmake" or name.endswith("CMakeLists.txt"):
        return CMAKE_TOKEN
    return HASH_TOKEN if suffix in HASHES and (suffix != ".txt") else None


def paragraphs(lines):
    """Of numbered lines: runs that belong together, broken at blank lines, items of lists and indented text."""
    run = []
    for number, line in lines:
        item = ITEM.match(line)
        if (not line.strip() or item) and run:
            yield run
            run = []
        if line.strip():
            run.append((number, line[item.end():] if item else line))
    if run:
        yield run


def sentences(lines, kind, trailing=False):
    """Of numbered lines without comment signs."""
    for run in paragraphs(lines):
        starts, text = [], ""
        for number, line in run:
            starts.append((len(text), number))
            text += line.strip() + " "
        begin = 0
        for end in [found.end() for found in BETWEEN_SENTENCES.finditer(text)] + [len(text)]:
            place = bisect.bisect_right(starts, (begin, sys.maxsize)) - 1
            yield Sentence(starts[place][1], text[begin:end].strip(), kind, begin == 0, trailing)
            begin = end


class Source:
    """A source, split into its comments, its messages and the rest."""

    def __init__(self, text, token):
        self.sentences, code, code_end = [], [], 0
        breaks = [found.start() for found in re.finditer("\n", text)]
        block, messages, message_end = [], [], 0
        for found in token.finditer(text):
            line = bisect.bisect_left(breaks, found.start()) + 1
            groups = found.groupdict()
            code += [text[code_end: found.start()], blanked(found[0])]
            code_end = found.end()
            if found[0].startswith("#!"):
                continue
            before = text[text.rfind("\n", 0, found.start()) + 1: found.start()]
            if groups.get("comment") or groups.get("doc"):
                rows = [TITLE.sub("", row) for row in found[0].strip('"').split("\n")]
                numbered = list(enumerate(rows, line))
                alone = not before.strip()
                if block and (not alone or numbered[0][0] != block[-1][0] + 1 or groups.get("doc")):
                    self.sentences += sentences(block, "comment")
                    block = []
                if not alone or groups.get("doc"):
                    self.sentences += sentences(numbered, "comment", trailing=not alone)
                else:
                    block += numbered
            elif groups.get("string"):
                if messages and text[message_end: found.start()].strip(" \n\\fru") == "":
                    messages[-1][1] += found[0][1:-1]
                else:
                    messages.append([line, found[0][1:-1]])
                message_end = found.end()
        self.sentences += sentences(block, "comment")
        for line, message in messages:
            message = message.replace("\\n", " ").replace('\\"', '"')
            if len(message.split()) >= FEW_WORDS:
                self.sentences += sentences([(line, message)], "message")
        self.code = "".join(code) + text[code_end:]


def page_sentences(project, name, text):
    """Paragraphs, items and cells of a page; headings name what a section answers and may be clauses."""
    # Code stands for a noun: a blank would let the word behind it begin the sentence.
    prose = INLINE_CODE.sub(lambda code: re.sub(r"\S", "x", code[0]), Page(project, name, text).without_fences())
    prose = LINK.sub(lambda link: link[1], prose)
    lines = []
    for number, line in enumerate(prose.splitlines(), 1):
        if HEADING.match(line):
            lines.append((number, ""))
        elif line.lstrip().startswith("|"):
            for cell in line.strip().strip("|").split("|"):
                lines += [(number, ""), (number, cell)]
        else:
            lines.append((number, re.sub(r"\*\*|(?<!\w)\*|\*(?!\w)", "", line)))
    return list(sentences(lines, "page"))
