"""The table of coverage and its goals."""

GOALS = {"line": 1.0, "branch": 1.0, "MC/DC": 0.95}


def _figures(file):
    return [file.line_figures(), file.branch_figures(), file.condition_figures()]


def _total(files):
    return [tuple(map(sum, zip(*column))) for column in zip(*map(_figures, files))]


def _cell(figures):
    reached, there = figures
    return f"{reached}/{there}" if there else ""


def table(files):
    rows = ["| file | lines | branches | conditions (MC/DC) |", "|---|---:|---:|---:|"]
    rows += [f"| {file.name} | " + " | ".join(map(_cell, _figures(file))) + " |" for file in files]
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
