"""The tables of coverage and its goals."""

import itertools

GOALS = {"line": 1.0, "branch": 1.0, "MC/DC": 0.95}


def _figures(file):
    return [file.line_figures(), file.branch_figures(), file.condition_figures()]


def _total(files):
    return [tuple(map(sum, zip(*column))) for column in zip(*map(_figures, files))]


def _cell(figures):
    reached, there = figures
    return f"{reached}/{there}" if there else ""


def _folder(file):
    return file.name.rpartition("/")[0]


def data(files):
    """Each file's figures, as CSV."""
    heads = [f"{what}_{how}" for what in ("lines", "branches", "conditions") for how in ("reached", "there")]
    rows = [",".join(["file", *heads])]
    rows += [",".join([file.name, *(str(figure) for pair in _figures(file) for figure in pair)]) for file in files]
    return "\n".join(rows) + "\n"


def table(files):
    """By folder; a file stands by itself only if something of it is not reached."""
    rows = ["| folder, file not reached in full | lines | branches | conditions (MC/DC) |", "|---|---:|---:|---:|"]
    for folder, there in itertools.groupby(sorted(files, key=_folder), key=_folder):
        there = list(there)
        rows.append(f"| {folder} | " + " | ".join(map(_cell, _total(there))) + " |")
        rows += [f"| {file.name} | " + " | ".join(map(_cell, _figures(file))) + " |" for file in there
                 if any(reached < count for reached, count in _figures(file))]
    total = _total(files)
    rows.append("| **all** | " + " | ".join(f"**{_cell(figures)}**" for figures in total) + " |")
    shares = ", ".join(f"{name} {100 * reached / there:.2f} %" for name, (reached, there) in zip(GOALS, total))
    return "\n".join(rows) + f"\n\nIn all: {shares}.\n"


def named(entries):
    if not entries:
        return "\nNothing is unreached.\n"
    rows = ["", "| not reached | where | why |", "|---|---|---|"]
    kinds = {"line": "", "true": " (never true)", "false": " (never false)", "condition": " (never decides alone)"}
    for entry in entries:
        text = entry["text"].replace("|", "\\|")
        rows.append(f"| `{text}`{kinds[entry['kind']]} | {entry['file']}, `{entry['function']}` | {entry['why']} |")
    return "\n".join(rows) + "\n"


def missed_goals(files):
    """Places left out by name still count: a list of excuses cannot make the figures good."""
    return [f"{name} coverage is {reached} of {there}, {100 * reached / there:.2f} %; the goal is {100 * goal:.0f} %"
            for (name, goal), (reached, there) in zip(GOALS.items(), _total(files)) if reached < goal * there]
