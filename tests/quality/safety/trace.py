"""Checks the safety argument of docs/safety against the project, and writes its generated pages.

Use: tests/quality/safety/trace [--document] [--build FOLDER]

Reads requirements.toml and failure_modes.toml; asks ctest which tests there are in FOLDER (default build/release), which
must be built. --document: writes the generated pages and the state at the top of README.md instead of comparing them.
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
FOLDER = PROJECT / "docs/safety"


def judge(folder, evidence, write):
    """What is wrong with the argument in `folder`; with `write` its generated pages are written."""
    argument = argument_module.Argument(
        *((folder / name).read_text() for name in ("requirements.toml", "failure_modes.toml"))
    )
    problems = checks.all_problems(argument, evidence)
    if problems:
        return problems, argument
    pages = document.pages(argument, evidence)
    pages["README.md"] = document.with_state((folder / "README.md").read_text(), argument)
    for name, text in pages.items():
        page = folder / name
        if write:
            page.write_text(text)
        elif not page.is_file() or page.read_text() != text:
            problems.append(f"docs/safety/{name} is not what the argument says now; run: tests/quality/safety/trace --document")
    texts = {page.name: page.read_text() for page in sorted(folder.glob("*.md"))}
    return problems + checks.pages_name_what_exists(argument, texts), argument


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--document", action="store_true")
    parser.add_argument("--build", type=pathlib.Path, default=PROJECT / "build/release")
    options = parser.parse_args()
    problems, argument = judge(FOLDER, evidence_module.collect(PROJECT, options.build), options.document)
    print(document.state(argument))
    for identifier, requirement in argument.open().items():
        print(f"  open: {identifier} {requirement['text']}")
    for problem in problems:
        print("safety: " + problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (argument_module.ArgumentError, evidence_module.EvidenceError, document.DocumentError) as error:
        sys.exit(f"safety: {error}")
