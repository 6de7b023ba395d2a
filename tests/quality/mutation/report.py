"""Scores, and the page that shows them."""

import collections
import hashlib
import re

UNEXPLAINED = "## Survivors that nobody has explained"


def draw(mutants, count, seed):
    """A random sample in which a mutant's place depends on itself alone: a change of the sources elsewhere does not change
    it, and a smaller sample of one seed is part of a larger one."""
    def place(mutant):
        return hashlib.sha256(repr((seed, mutant.key())).encode()).digest()
    return sorted(sorted(mutants, key=place)[:count], key=lambda mutant: mutant.id)


def only_compiled(mutant, record, all_executed):
    """A constant that only the compiler uses: no run of a program can have it changed. Where not all is executed, a named one
    at most is taken for that: what no test executes survives."""
    return mutant.id not in record.executed and (all_executed or not mutant.function)


def _killed(answers):
    return sum(answer != "survived" for answer in answers)


def _share(answers):
    return f"{100 * _killed(answers) / len(answers):.1f} %" if answers else ""


def summary(results, wanted, record):
    answers = list(results.values())
    idle = sum(number not in record.executed for number in results)
    how = collections.Counter(answers)
    part = f"Of {wanted} mutants, {len(answers)} were tried, most of them drawn at random. " if len(answers) < wanted else ""
    return (f"{part}{_killed(answers)} of {len(answers)} mutants are killed, {_share(answers)}: {how['killed by a test']} by a failing "
            f"test, {how['killed by a crash']} by a crash, {how['killed by the time limit']} by the time limit; "
            f"{how['survived']} survive" + (f", {idle} of them executed by no test that is asked" if idle else "") + ".\n")


def without_equivalents(mutants, results, reviewed):
    """The results of those mutants that a test could kill."""
    same = {mutant.id for mutant in mutants if reviewed.is_equivalent(mutant)}
    return {number: answer for number, answer in results.items() if number not in same or answer != "survived"}


def summary_without_equivalents(results, able):
    """`able`: what without_equivalents() leaves of the results."""
    if len(able) == len(results):
        return ""
    return (f"{len(results) - len(able)} of the survivors are equivalent: no input shows a difference. Without them "
            f"{_killed(able.values())} of {len(able)} are killed, {_share(able.values())}.\n")


def missed_goal(results, goal, of="mutants"):
    killed, tried = _killed(results.values()), len(results)
    if tried and killed < goal * tried:
        return [f"{killed} of {tried} {of} are killed, {100 * killed / tried:.1f} %; the goal is {100 * goal:.0f} %"]
    return []


def _table(heading, mutants, results, of):
    answers = collections.defaultdict(list)
    for mutant in mutants:
        if mutant.id in results:
            answers[of(mutant)].append(results[mutant.id])
    rows = [f"| {heading} | mutants | killed | survive | score |", "|---|---:|---:|---:|---:|"]
    for name in sorted(answers):
        killed, tried = _killed(answers[name]), len(answers[name])
        rows.append(f"| {name} | {tried} | {killed} | {tried - killed} | {_share(answers[name])} |")
    return rows + [""]


def _survivors_by_file(mutants):
    rows, file = [], None
    for mutant in mutants:
        if mutant.file != file:
            file = mutant.file
            rows += [""] * bool(rows) + [f"**`{file}`**", ""]
        rows.append(f"- `{mutant.name()}`")
    return rows + [""]


def listed(page):
    """The keys of the survivors that a page lists as unexplained."""
    keys, file = set(), None
    for line in page.partition(UNEXPLAINED)[2].splitlines():
        if found := re.fullmatch(r"\*\*`(.*)`\*\*", line):
            file = found.group(1)
        elif found := re.fullmatch(r"- `(.*)`", line):
            keys.add((file, found.group(1)))
    return keys


def page(scope, mutants, wanted, results, reviewed, record):
    """What the documentation shows of a run."""
    compiled = len(mutants) - len(wanted)
    rows = [summary(results, len(wanted), record)
            + summary_without_equivalents(results, without_equivalents(mutants, results, reviewed))]
    rows += _table("folder", mutants, results, lambda mutant: f"`{mutant.file.rpartition('/')[0]}`")
    rows += _table("file", mutants, results, lambda mutant: f"`{mutant.file}`")
    rows += _table("operator", mutants, results, lambda mutant: mutant.operator)
    rows += [f"Not mutated, or not tried: {compiled} mutants of constants that only the compiler evaluates; "
             + "; ".join(f"{why}: {count}" for why, count in mutants.skipped.most_common()) + ".", ""]
    if scope.left_out:
        rows += ["Left out:", ""] + [f"- `{name}`: {why}" for name, why in sorted(scope.left_out.items())] + [""]
    rows += [f"Not asked are tests that take more than {scope.longest_ms} ms.", ""]
    rows += ["## The survivors", ""] if reviewed.groups else []
    for group in sorted(reviewed.groups, key=lambda group: group["file"]):
        names = [f"`{name}`" for name in group["mutants"]]
        kind = "Equivalent. " if "equivalent" in group else ""
        rows += [f"**`{group['file']}`** {kind}{group['why']}", ""] + [f"- {name}" for name in names] + [""]
    unexplained = [mutant for mutant in wanted if results.get(mutant.id) == "survived" and not reviewed.reason(mutant)]
    if unexplained:
        rows += [UNEXPLAINED, ""] + _survivors_by_file(unexplained)
    return "\n".join(rows)
