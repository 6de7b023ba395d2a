"""The checks of the argument against the evidence. Each answers a list of sentences: what is wrong and what to do."""

import evidence as evidence_module
from argument import IDENTIFIER

DIRECTIONS = ("received", "sent", "platform")


def exists(test, evidence):
    if evidence_module.is_command(test):
        return evidence.has_command(test)
    return bool(test.strip("*.")) and bool(evidence.matching(test))


def verification(argument, evidence):
    problems = []
    for identifier, requirement in argument.requirements.items():
        tests = requirement["tests"]
        missing = [test for test in tests if not exists(test, evidence)]
        if requirement.get("open"):
            if tests and not missing:
                problems.append(
                    f"{identifier} is open, but all the tests that it awaits exist; take `open` away, or, if they do not yet show "
                    "what it says, name in `tests` only what is still missing"
                )
            continue
        if not tests:
            problems.append(f"{identifier} has no test; name one in `tests`, or say in `open` why there is none")
        for test in missing:
            problems.append(f"{identifier} is verified by {test}, which neither ctest nor tests/run knows")
    return problems


def code(argument, evidence):
    problems = []
    for identifier, requirement in argument.requirements.items():
        if not requirement["code"] and not requirement.get("open"):
            problems.append(f"{identifier} names no code that meets it")
        for path in requirement["code"]:
            if not evidence.has_file(path):
                problems.append(f"{identifier} is met by {path}, which is no file")
    return problems


def signals(argument, evidence):
    problems = []
    covered = set()
    for identifier, mode in argument.failure_modes.items():
        if mode["direction"] not in DIRECTIONS:
            problems.append(f"{identifier} has the direction {mode['direction']}; there are {', '.join(DIRECTIONS)}")
        if mode["direction"] == "platform":  # its interfaces are not in the .dbc
            continue
        for pattern in mode["signals"]:
            found = evidence.matching_signals(pattern, mode["direction"])
            if found and mode.get("awaited"):
                problems.append(f"{identifier} awaits {pattern}, which is there now; take `awaited` away")
            if not found and not mode.get("awaited"):
                problems.append(f"{identifier} is about {pattern}, of which nothing is {mode['direction']} by the ECU")
            # A statement on a whole frame does not yet cover each of its signals.
            if "*" not in pattern.split(".")[-1]:
                covered.update(found)
    for signal, direction in evidence.signals.items():
        if signal not in covered:
            problems.append(f"the signal {signal}, {direction} by the ECU, has no failure mode in failure_modes.toml")
    return problems


def codes(argument, evidence):
    """Each diagnostic code answers a failure mode, and each that is named can be sent; silent while none can be sent."""
    if not evidence.codes:
        return []
    named = {code: identifier for identifier, mode in argument.failure_modes.items() for code in mode["codes"]}
    return [f"the diagnostic code '{code}' is in no failure mode" for code in evidence.codes if code not in named] + [
        f"{identifier} names the diagnostic code '{code}', which the .dbc does not have"
        for code, identifier in named.items()
        if code not in evidence.codes
    ]


def references(argument, evidence):
    del evidence
    problems = []
    used = set()
    for entries in argument.by_kind.values():
        for identifier, entry in entries.items():
            for key in ("hazards", "goals", "assumptions", "requirements"):
                for other in entry.get(key, []):
                    used.add(other)
                    if other not in argument.by_kind[key[:-1]]:
                        problems.append(f"{identifier} names {other}, which is no {key[:-1]}")
    for identifier, requirement in argument.requirements.items():
        if not requirement["goals"]:
            problems.append(f"{identifier} serves no goal")
    for identifier, mode in argument.failure_modes.items():
        if not mode["requirements"] and not mode["assumptions"]:
            problems.append(f"{identifier} is answered by no requirement and no assumption")
    wanted = {"hazard": "no goal answers it", "goal": "no requirement serves it", "assumption": "nothing relies on it"}
    for kind, complaint in wanted.items():
        for identifier in argument.by_kind[kind]:
            if identifier not in used:
                problems.append(f"{identifier} is not used: {complaint}")
    return problems


def pages_name_what_exists(argument, pages):
    """`pages`: name to text of every page of the argument."""
    return [
        f"{name} names {identifier}, which does not exist"
        for name, text in pages.items()
        for identifier in sorted(set(IDENTIFIER.findall(text)) - argument.identifiers())
    ]


def all_problems(argument, evidence):
    problems = list(argument.problems)
    for check in (verification, code, signals, codes, references):
        problems += check(argument, evidence)
    return problems
