"""All checks of the documentation of a project, and its figures written anew."""

import pathlib
import re
import sys

import figures
import folders
import references
from page import COMMENT, Page, all_pages, newest_changes, tracked, written_pages

sys.path.append(str(pathlib.Path(__file__).resolve().parents[3] / "cmake/environment"))

import file_io  # noqa: E402

EVERYDAY = pathlib.Path(__file__).resolve().parent / "everyday.txt"
README_LINES = 120
COLUMNS = 120
PAGE_WORDS = 4000
PAGES = 14
# The page that explains a file, and the first cell of the header of its tables of keys.
KEYS = {
    "docs/calibration.md": ("firmware/calibrations/large_suv.toml", "field"),
    "docs/drives.md": ("sil/vehicles/large_suv.toml", "key"),
}

OUTPUTS, THEORY, INDEX_TESTS = "firmware/rsi/rsi_outputs.h", "docs/theory.md", "tests/rsi"


def length_problems(page):
    problems = []
    if page.path == "README.md" and len(page.lines) > README_LINES:
        problems.append(f"README.md: {len(page.lines)} lines; at most {README_LINES}")
    words = len(COMMENT.sub("", page.text).split())
    if words > PAGE_WORDS:
        problems.append(f"{page.path}: {words} words; at most {PAGE_WORDS}: split or shorten it")
    last = figures.SOURCES.search(page.without_fences())
    for number, line in enumerate(page.text[: last.start() if last else None].splitlines(), 1):
        columns = len(COMMENT.sub("", line))
        # A row of a table cannot be broken, and a picture's line is its address.
        if columns > COLUMNS and not line.startswith(("|", "![")):
            problems.append(f"{page.path}:{number}: {columns} columns; at most {COLUMNS}")
    return problems


def check(project):
    files = tracked(project)
    everyday = figures.Everyday(EVERYDAY, project, files)
    commands = references.Commands(project, files)
    written, pages = written_pages(project), {}
    problems = everyday.problems()
    if len(written) > PAGES:
        problems.append(f"{len(written)} written pages; at most {PAGES}")
    for path in all_pages(project):
        page = pages.setdefault(path, Page(project, path))
        if path in written:
            problems += figures.problems(page, everyday, files)
            problems += references.problems(page, commands, pages)
            problems += length_problems(page) + page.list_items_by_accident()
        elif path.startswith("docs/reports/"):
            problems += references.report_problems(page, commands, pages)
        else:
            problems += references.link_problems(page, pages)
    changes = newest_changes(project)
    if changes:
        problems += references.code_problems(changes, commands)  # its links are checked above, of all versions
    problems += incomplete_indices(project)
    return problems + references.pages_elsewhere(project, files) + keys_of_files(project) + folders.problems(project, files), written


def keys_of_files(project):
    """Every key of these files stands on the page that explains them, and no other."""
    problems = []
    for page, (file, header) in KEYS.items():
        if not (project / page).is_file():
            continue
        text = (project / page).read_text(encoding="utf-8")
        keys = set(re.findall(r"^\[?(\w+)\]?(?: =|$)", (project / file).read_text(encoding="utf-8"), re.MULTILINE))
        problems += [f"{page}: does not name {key} of {file}" for key in sorted(keys)
                     if not re.search(rf"`\[?{key}\]?`", text)]
        problems += [f"{page}: {file} has no {key}" for key in keys_of_page(text, header) if key not in keys]
    return problems


def incomplete_indices(project):
    """Every index in the table of outputs has its equation on the page of the theory, and a test, by its name."""
    if not (project / OUTPUTS).is_file():
        return []
    names = re.findall(r"^ +INDEX\((\w+),", (project / OUTPUTS).read_text(encoding="utf-8"), re.MULTILINE)
    tests = "\n".join(test.read_text(encoding="utf-8") for test in (project / INDEX_TESTS).glob("*.cpp"))
    wanted = ((THEORY, "equation", (project / THEORY).read_text(encoding="utf-8")), (INDEX_TESTS, "test", tests))
    return [f"{place}: has no {kind} of `{name}`, an index of {OUTPUTS}: write it there, with this name"
            for name in names for place, kind, text in wanted if not re.search(rf"(?<![\w/]){name}(?![\w/])", text)]


def keys_of_page(text, header):
    """Sections that headings name, and what the first column of the tables with that header names."""
    found, in_table = [], False
    for line in text.splitlines():
        if line.startswith("#"):
            found += re.findall(r"`\[(\w+)\]`", line)
        first = line.split("|")[1].strip() if line.startswith("|") else None
        if first is None:
            in_table = False
        elif first.split(" ")[0] == header:
            in_table = True
        elif in_table:
            found += re.findall(r"`(\w+)`", re.match(r"(?:`\w+`(?:, )?)*", first)[0])
    return found


def refresh(project):
    files = tracked(project)
    for path in written_pages(project):
        page = Page(project, path)
        text = figures.refreshed(page, files)
        if text != page.text:
            file_io.write(project / path, text)
            print(f"docs: {path} refreshed")
