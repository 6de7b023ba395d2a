"""Figures of a written page: each is guarded by a source, or of a kind that cannot go stale.

Guarded: NUMBER<!--=NAME--> with a source of that NAME (sources.py). Free without a source:
- everything in code, in a link's target or in a comment;
- numbers of equations, figures and list items, dates, hexadecimal numbers, and numbers within a name (Cortex-M7, profile 11);
- 0, 1 and -1;
- the figures of everyday.txt, which are compared with their own source;
- a paragraph, list or table right below a line `<!-- figures: KIND -->`, KIND being one of KINDS; the same with
  `<!-- figures: KIND, whole section -->` up to the next heading.
A count in words needs a source when one of COUNTED follows it, and so does a quantity in words (QUANTITIES): a part, a
multiple, a time or a length. Below `<!-- figures: definition -->` quantities in words are free, numbers are not.
`standard` and `hardware` name whose figures they are, as `<!-- figures: standard, AUTOSAR profile 11 -->` does, and
hold for one paragraph, list or table only. A code fence carries no version of this project.
"""

import re

import sources
from page import COMMENT, Page, blanked

KINDS = {
    "advice": "what the reader should do or choose, not what the project does",
    "hardware": "a property of another product, which is named",
    "standard": "a definition of a standard, which is named, or of the paper",
    "definition": "words such as half in what a quantity is by definition",
    "example": "an example, not a measurement",
}
NAMED_KINDS = ("hardware", "standard")
COUNTED = ("frames signals indices indicators manoeuvres vehicles targets processors codes requirements recordings "
           "parameters fields estimators scenes faults operators values").split()
WORD = "|".join(sources.WORDS[2:])
UNIT = r"(?:milli|micro)?seconds?|minutes?|hours?|(?:milli|centi|kilo)?metres?|degrees?"
QUANTITIES = re.compile("|".join((
    r"\b(?:half|halves|halved|halving|thirds|quarters?|fifths?|tenths?|hundredths?)\b",
    r"\b(?:a|one) third\b",
    r"\b(?:twice|double|triple) (?:as|its|their|the|that)\b", r"\b(?:doubled|tripled|hundred|thousand|million|dozen)\b",
    # Not every "a second": "a second reader" is no time.
    rf"\b(?:for|within|about|after|over|than|least|most|lasts?) (?:an?|one) (?:{UNIT})\b",
    rf"\b(?:an?|one) (?:{UNIT}) (?:of|after|before|later|ahead|long)\b",
    rf"\b(?:{WORD})\s+(?:{UNIT}|samples|cycles)\b")).replace(" ", r"\s+"), re.IGNORECASE)
VERSION = re.compile(r"\brsi[ -]v?\d+\.\d+")
PART = "|".join(sources.PARTS)
GUARDED = re.compile(rf"(?P<figure>{sources.NUMBER}|\b(?i:{WORD}|{PART})\b)"
                     r"(?P<mark>\**<!--=(?P<name>[\w.-]+)-->)")
FREE = re.compile(r"<!-- figures: (?P<kind>\w+)(?P<section>, whole section)?(?:, (?P<whose>[^>]+))? -->")
SOURCES = re.compile(r"<!-- sources\n(?P<lines>.*?)-->\s*\Z", re.DOTALL)
BARE = re.compile(rf"(?<![\w.,])(?:{sources.NUMBER})(?![\w])|(?<![\w.,])\d[\d.,]*(?=[a-zA-Z°%])")
COUNT = re.compile(rf"\b(?:{WORD})\s+(?:[\w-]+\s+)?(?:{'|'.join(COUNTED)})\b", re.IGNORECASE)
# Names that continue with a number, which is no figure.
NAMES = (r"Debian|QEMU|GCC|gcc|g\+\+|clang|clang-tidy|clang-format|Eigen|ISO|ISO/PAS|IEEE|RFC|AUTOSAR|release|[Pp]rofile|"
         r"[Vv]ersion|Technology|[Bb]ytes?|[Bb]its?|[Ff]orm|[Pp]oint|[Ss]tep|[Cc]olumn|[Ll]ine|[Cc]ode|Python|C|C\+\+|Fig\.|"
         r"Figs\.|MISRA C\+\+:|SAE|UG|AES|Cortex")
NAMED = re.compile(rf"(?<![\w])(?:{NAMES}) ?\d[\w.:]*(?:(?:, | and | to |/|-)\d[\w.]*)*")
HARMLESS = [
    re.compile(r"^\s*\d+\.(?=\s)", re.MULTILINE),  # numbered list
    re.compile(r"(?<=[ (\[|])\((?:\d{1,2})\)|^\(\d{1,2}\)|\(\d{1,2}\)(?= (?:to|and) \(\d)|(?<=to )\(\d{1,2}\)", re.MULTILINE),
    re.compile(r"\((?:\d{1,2})\)"),  # equation
    re.compile(r"\b0x[0-9A-Fa-f]+\b"),
    re.compile(r"\b(?:19|20)\d\d(?:-\d\d-\d\d)?\b"),
    re.compile(r"[A-Za-z+][\w+]*(?:-\d[\w.]*)+"),  # CRC-32, x86-64
    re.compile(r"(?<![\w.])\d+-bit\b"),
    NAMED,
    re.compile(r"(?<![\w.,])[+-]?[01](?![\w]|[.,]\d)"),
]


def without(text, pattern):
    return pattern.sub(lambda found: blanked(found[0]), text)


class Everyday:
    """Figures that every page may use, with their sources: lines FIGURE = SOURCE of everyday.txt."""

    def __init__(self, path, project, files):
        self.path, self.entries = path, []
        for line in path.read_text(encoding="utf-8").splitlines():
            if line and not line.startswith("#"):
                text, _, source = line.partition(" = ")
                self.entries.append((text, sources.Source(f"everyday: {source}", project, files)))

    def problems(self):
        found = []
        for text, source in self.entries:
            figure = re.search(sources.NUMBER, text)[0]
            try:
                if not sources.agree(figure, source.value()):
                    found.append(f"{self.path.name}: {text}: {source.file} now says {source.value():g}")
            except sources.SourceError as error:
                found.append(f"{self.path.name}: {text}: {error}")
        return found

    def blank(self, text):
        for figure, _ in self.entries:
            spaced = re.escape(figure).replace(r"\ ", r"\s+")
            text = re.sub(rf"(?<![\w.,]){spaced}(?!\w)", lambda found: blanked(found[0]), text)
        return text


def sources_of(page, files):
    """By name; a list of what is wrong with them."""
    found = SOURCES.search(page.without_fences())
    by_name, problems = {}, []
    for line in found["lines"].splitlines() if found else []:
        if not line.strip():
            continue
        try:
            source = sources.Source(line, page.project, files)
        except sources.SourceError as error:
            problems.append(f"{page.path}: sources: {error}")
            continue
        if source.name in by_name:
            problems.append(f"{page.path}: sources: {source.name} stands there twice")
        by_name[source.name] = source
    return by_name, problems


def free_spans(page):
    """Places of the page without guard, with their kinds, and a list of what is wrong with them."""
    spans, problems = [], []
    for found in FREE.finditer(page.text):
        if found["kind"] not in KINDS:
            problems.append(f"{page.place(found.start())}: figures: {found['kind']} is none of {', '.join(KINDS)}")
            continue
        if found["kind"] in NAMED_KINDS and (found["section"] or not found["whose"]):
            problems.append(f"{page.place(found.start())}: figures: {found['kind']} holds for one paragraph and says "
                            "whose they are")
        end = re.compile(r"\n#" if found["section"] else r"\n\s*\n").search(page.text, found.end())
        spans.append((found.start(), end.start() if end else len(page.text), found["kind"]))
    return spans, problems


def guarded_problems(page, by_name):
    problems, used = [], set()
    text = page.without_fences()
    for found in GUARDED.finditer(text):
        name, figure = found["name"], found["figure"]
        used.add(name)
        if name not in by_name:
            problems.append(f"{page.place(found.start())}: {figure}: the page has no source {name}")
            continue
        try:
            value = by_name[name].value()
            if not sources.agree(figure, value):
                problems.append(f"{page.place(found.start())}: stale figure: {figure}, but {by_name[name].file} says "
                                f"{sources.shown(value, figure)} ({by_name[name].what}); check --refresh corrects it")
        except sources.SourceError as error:
            problems.append(f"{page.place(found.start())}: {figure}: {error}")
    ends = {found.end("mark") for found in GUARDED.finditer(text)}
    for mark in re.finditer(r"<!--=([\w.-]+)-->", text):
        if mark.end() not in ends:
            problems.append(f"{page.place(mark.start())}: the mark {mark[1]} does not stand behind a figure")
    problems += [f"{page.path}: sources: {name} guards nothing" for name in by_name if name not in used]
    return problems


def bare_problems(page, everyday, spans):
    text = page.text
    for start, end, kind in spans:
        span = text[start:end]
        span = without(span, QUANTITIES) if kind == "definition" else blanked(span)
        text = text[:start] + span + text[end:]
    text = GUARDED.sub(lambda found: blanked(found[0]), text)
    prose = page.prose()
    text = "".join(a if b == a else " " if a != "\n" else a for a, b in zip(text, prose + " " * (len(text) - len(prose))))
    text = without(text, COMMENT)
    text = everyday.blank(text)
    for pattern in HARMLESS:
        text = without(text, pattern)
    problems = []
    for pattern in (BARE, COUNT, QUANTITIES):
        for found in pattern.finditer(text):
            figure = " ".join(found[0].split())
            problems.append(f"{page.place(found.start())}: unguarded figure: {figure}; name its source, or take it away")
    for place, line in page.code()[1]:
        if VERSION.search(line):
            problems.append(f"{place}: a version of this project in code: take it away")
    return problems


def problems(page, everyday, files):
    by_name, found = sources_of(page, files)
    spans, more = free_spans(page)
    return found + more + guarded_problems(page, by_name) + bare_problems(page, everyday, spans)


def refreshed(page, files):
    """The page's text with every guarded figure, and every path of a source that has moved, as it is now."""
    text = page.text
    by_name, _ = sources_of(page, files)
    for name, source in by_name.items():
        there = source.moved_to()
        if there:
            text = text.replace(f"\n{name}: {source.file} ", f"\n{name}: {there} ")
            source.file = there

    def now(found):
        try:
            value = by_name[found["name"]].value()
        except (KeyError, sources.SourceError):
            return found[0]
        return found[0] if sources.agree(found["figure"], value) else sources.shown(value, found["figure"]) + found["mark"]

    fences = Page(page.project, page.path, text).without_fences()
    for found in reversed(list(GUARDED.finditer(fences))):
        text = text[: found.start()] + now(found) + text[found.end():]
    return text
