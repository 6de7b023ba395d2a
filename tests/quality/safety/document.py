"""The generated pages of the argument, as Markdown."""

import evidence as evidence_module
from argument import integrity_level

NOTE = "<!-- Written by tests/quality/safety/trace --document from {source}; do not edit. -->\n"
REQUIREMENTS = "docs/safety/requirements.toml"
FAILURE_MODES = "docs/safety/failure_modes.toml"
MATRIX = "docs/reports/safety/fault_matrix.md"



def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def joined(identifiers):
    return ", ".join(identifiers) if identifiers else "–"


def state(argument):
    requirements = argument.requirements
    open_ones, limited = argument.open(), argument.limited()
    verified = len(requirements) - len(open_ones) - len(limited)
    return (
        f"{len(requirements)} safety requirements: {verified} verified, {len(limited)} verified within a stated limit, "
        f"{len(open_ones)} open"
    )


def open_table(argument):
    return table(
        ["open", "the firmware shall", "why it is open"],
        [[i, r["text"], r["open"]] for i, r in argument.open().items()],
    )


def linked(test, evidence):
    """The test as a link to the first file that holds such a test, where one is known."""
    for name in evidence.matching(test):
        if name in evidence.sources:
            return f"[{test}](../../../{evidence.sources[name]})"
    return test


def verified_by(requirement, evidence):
    by_group = {}
    for test in requirement["tests"]:
        if evidence_module.is_command(test):
            by_group.setdefault(f"by command `{test}`", [])
            continue
        groups = {evidence.tests[name] for name in evidence.matching(test)} or {"awaited"}
        for group in sorted(groups):
            head = group + (", on request" if group in evidence_module.ON_REQUEST else "")
            by_group.setdefault(head, []).append(linked(test, evidence))
    return "; ".join(f"{group}: {', '.join(tests)}" if tests else group for group, tests in by_group.items())


def links(paths):
    return ", ".join(f"[{path.rsplit('/', 1)[-1]}](../../../{path})" for path in paths) or "–"


def trace(argument, evidence):
    text = NOTE.format(source=REQUIREMENTS)
    text += "# From goal to test\n\n"
    text += f"**{state(argument)}.**\n\n"
    text += "`tests/run safety` fails when a requirement has no test, when a test, file or signal does not exist, or when this page is\n"
    text += "not what [requirements.toml](../../safety/requirements.toml) says. Tests have the names that ctest uses, with the group of\n"
    text += "`tests/run` that runs them; `*` stands for any ending. Those groups show that the tests pass.\n"
    if argument.open():
        text += "\n## Open\n" + open_table(argument)
    text += "\n## Verified within a limit\n"
    text += table(["", "limit"], [[i, r["limit"]] for i, r in argument.limited().items()])
    text += "\n## Goals\n"
    text += "Each requirement below names the goals that it serves.\n\n"
    text += table(["goal", "", "against"], [[i, goal["text"], joined(goal["hazards"])] for i, goal in argument.goals.items()])
    for theme in dict.fromkeys(r["theme"] for r in argument.requirements.values()):
        text += f"\n## {theme}\n"
        rows = []
        for identifier, requirement in argument.requirements.items():
            if requirement["theme"] != theme:
                continue
            tests = verified_by(requirement, evidence)
            if requirement.get("open"):
                tests = "**open**" + (f"; {tests}" if tests else "")
            rows.append(
                [
                    identifier,
                    requirement["text"],
                    joined(requirement["goals"] + requirement["assumptions"]),
                    links(requirement["code"]),
                    tests,
                ]
            )
        text += table(["", "the firmware shall", "for, assuming", "met in", "verified by"], rows)
    return text


def reason(hazard):
    return hazard["reasons"] + (f" ({joined(hazard['assumptions'])})" if hazard["assumptions"] else "")


def hazards(argument):
    text = NOTE.format(source=REQUIREMENTS)
    text += "# Hazards, goals, assumptions\n\n"
    text += "The vehicle is not known, so the classes are assumptions: S severity, E exposure, C controllability. They give the level in\n"
    text += "the last column. An integrator analyses the actual vehicle and compares. The argument: [safety](../../safety.md).\n\n## Hazards\n"
    rows = [
        [i, h["malfunction"], h["situation"], f"{h['severity']} {h['exposure']} {h['controllability']}", reason(h), integrity_level(h)]
        for i, h in argument.hazards.items()
    ]
    text += table(["", "the item ...", "where it hurts", "class", "why", "level"], rows)
    text += "\n## Safety goals\n"
    levels = "QM A B C D".split()
    rows = []
    for identifier, goal in argument.goals.items():
        level = max((integrity_level(argument.hazards[h]) for h in goal["hazards"]), key=levels.index)
        rows.append([identifier, goal["text"], joined(goal["hazards"] + goal["assumptions"]), level, goal["safe_state"], goal["time"]])
    text += table(["", "goal", "against, assuming", "level, assumed", "safe state", "time"], rows)
    for on, head in (("vehicle", "Assumptions on the vehicle"), ("integrator", "Assumptions on the integrator")):
        text += f"\n## {head}\n"
        rows = []
        for identifier, assumption in argument.assumptions.items():
            if assumption["on"] != on:
                continue
            relying = [
                i
                for kind in argument.by_kind
                for i, entry in argument.by_kind[kind].items()
                if identifier in entry.get("assumptions", [])
            ]
            rows.append([identifier, assumption["text"], assumption["because"], joined(relying)])
        text += table(["", "it is assumed that", "because otherwise", "relied on by"], rows)
    return text


def failure_modes(argument, evidence):
    text = NOTE.format(source=FAILURE_MODES)
    text += "# Failure modes of every input and output\n\n"
    text += "Every signal that the ECU sends or receives; a test compares the list with the `.dbc`. Requirements marked * are open: the\n"
    text += "reaction stated there is required but not shown. Diagnostic codes are in italics"
    text += ".\n" if evidence.codes else "; no frame carries them yet.\n"
    if evidence.has_file(MATRIX):
        text += "The measured effect of each input failure on the sent frames: [fault_matrix.md](fault_matrix.md).\n"
    sections = {"received": [], "sent": [], "platform": []}
    for identifier, mode in argument.failure_modes.items():
        answered = [r + ("*" if argument.requirements[r].get("open") else "") for r in mode["requirements"]]
        detected = mode["detection"]
        if mode["codes"]:
            detected += f": *{', '.join(mode['codes'])}*"
        by_frame = {}
        for signal in mode["signals"]:
            if mode["direction"] == "platform":
                by_frame[signal] = []
                continue
            frame, name = signal.split(".")
            by_frame.setdefault("any frame" if frame == "*" else frame, []).append("any signal" if name == "*" else name)
        where = "; ".join(f"{frame}: {', '.join(names)}" if names else frame for frame, names in by_frame.items())
        sections[mode["direction"]].append(
            [identifier, where, mode["mode"], mode["effect"], detected, mode["reaction"], joined(mode["hazards"]),
             joined(answered + mode["assumptions"]) + (f" ({mode['awaited']})" if mode.get("awaited") else "")]
        )
    for direction, head in (("received", "Received"), ("sent", "Sent"), ("platform", "Of the platform")):
        text += f"\n## {head}\n"
        of = "part" if direction == "platform" else "signal"
        text += table(["", of, "fails as", "effect if nothing were done", "detected by", "reaction", "hazard", "answered by"], sections[direction])
    return text


def pages(argument, evidence):
    made = {
        "trace.md": trace(argument, evidence),
        "hazards.md": hazards(argument),
        "failure_modes.md": failure_modes(argument, evidence),
    }
    if evidence.signatures:
        made["signatures.md"] = evidence.signatures
    return made
