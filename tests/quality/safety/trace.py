"""Checks the safety argument of docs/safety against the project, and writes its reports.

Use: tests/quality/safety/trace [--document] [--build FOLDER]

Reads requirements.toml and failure_modes.toml; asks ctest which tests there are in FOLDER, which must be built (default:
build/release, or build/dev if that one alone is complete). --document: writes docs/reports/safety instead of comparing it.
The exit status is 1 when something is wrong, 2 for a wrong use.
"""

import argparse
import pathlib
import sys

import argument as argument_module
import checks
import document
import evidence as evidence_module

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path.append(str(PROJECT / "cmake/environment"))

import file_io  # noqa: E402

DOCS = PROJECT / "docs"


def judge(docs, evidence, write):
    """Errors of the argument in `docs`/safety; with `write` its reports are written."""
    argument = argument_module.Argument(
        *((docs / "safety" / name).read_text() for name in ("requirements.toml", "failure_modes.toml"))
    )
    problems = checks.all_problems(argument, evidence)
    if problems:
        return problems, argument
    pages = document.pages(argument, evidence)
    for name, text in pages.items():
        page = docs / "reports/safety" / name
        if write:
            file_io.write(page, text)
        elif not page.is_file() or page.read_text() != text:
            problems.append(f"docs/reports/safety/{name} is not what the argument says now; run: tests/quality/safety/trace --document")
    texts = {str(page.relative_to(docs)): page.read_text() for page in sorted(docs.rglob("*.md"))}
    return problems + checks.pages_name_what_exists(argument, texts), argument


def evidence_of(project, build):
    """From `build`; without one, from the first build of an edit loop or a merge that is complete."""
    if build:
        return evidence_module.collect(project, build)
    reasons = []
    for preset in ("release", "dev"):
        try:
            return evidence_module.collect(project, project / "build" / preset)
        except evidence_module.EvidenceError as error:
            reasons.append(str(error))
    raise evidence_module.EvidenceError(reasons[0])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--document", action="store_true")
    parser.add_argument("--build", type=pathlib.Path)
    options = parser.parse_args()
    problems, argument = judge(DOCS, evidence_of(PROJECT, options.build), options.document)
    print(document.state(argument))
    for identifier, requirement in argument.open().items():
        print(f"  open: {identifier} {requirement['text']}")
    for problem in problems:
        print("safety: " + problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (argument_module.ArgumentError, evidence_module.EvidenceError) as error:
        sys.exit(f"safety: {error}")
