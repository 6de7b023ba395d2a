"""The list of folders in docs/architecture.md, compared with the tree."""

import re

PAGE = "docs/architecture.md"
# The names at the beginning of a line, and those in its text, which are folders within the line's own.
ENTRY = re.compile(r"^( *)((?:[\w.-]+/ ?)+|[\w.-]+)(?:  +(.*)|$)")
IN_TEXT = re.compile(r"(?<![\w/.-])([\w.-]+)/(?![\w*])")


def listed(text):
    """(line number, path, whether it is a line of its own) for each folder, and each file, of the first block of code under
    "## Folders". A line that is indented further than a level is the text of the one above."""
    found, above, number = [], [], text[: text.index("## Folders")].count("\n") + 1
    block = text.split("## Folders", 1)[1].split("```")[1]
    number += text.split("## Folders", 1)[1].split("```")[0].count("\n")
    for number, line in enumerate(block.split("\n"), number):
        entry = ENTRY.match(line)
        if entry and len(entry[1]) <= 2 * len(above):
            above = above[: len(entry[1]) // 2]
            paths = ["".join(above) + name for name in entry[2].split()]
            found += [(number, path, True) for path in paths]
            above = [*above, entry[2].split()[0]]
            line = entry[3] or ""
        found += [(number, "".join(above) + name + "/", False) for name in IN_TEXT.findall(line)]
    return found


def problems(project, files):
    """Every folder of the list is there; beside a folder that has a line, no other is missing."""
    if not (project / PAGE).is_file():
        return []
    folders = {"/".join(name.split("/")[:depth]) + "/" for name in files for depth in range(1, name.count("/") + 1)}
    entries = listed((project / PAGE).read_text(encoding="utf-8"))
    found = [f"{PAGE}:{number}: there is no {path}" for number, path, _ in entries
             if path not in folders and path not in files]
    lines = {path for _, path, is_line in entries if is_line}
    parents = {parent(path) for path in lines if path.endswith("/")}
    return found + [f"{PAGE}: its list of folders lacks {folder}" for folder in sorted(folders - lines)
                    if parent(folder) in parents and not folder.startswith(".")]


def parent(folder):
    return folder.rstrip("/").rpartition("/")[0]
