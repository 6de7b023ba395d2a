"""Scores, and the page that shows them."""

import collections
import hashlib

GOAL = 0.9


def draw(mutants, count, seed):
    """A random sample in which a mutant's place depends on itself alone: a change of the sources elsewhere does not change
    it, and a smaller sample of one seed is part of a larger one."""
    def place(mutant):
        return hashlib.sha256(repr((seed, mutant.key())).encode()).digest()
    return sorted(sorted(mutants, key=place)[:count], key=lambda mutant: mutant.id)


def only_compiled(mutant, record):
    """A constant that only the compiler uses: no run of a program can have it changed."""
    return mutant.id not in record.executed


def _killed(answers):
    return sum(answer != "survived" for answer in answers)


def _share(answers):
    return f"{100 * _killed(answers) / len(answers):.1f} %" if answers else ""


def summary(results, wanted):
    answers = list(results.values())
    how = collections.Counter(answers)
    part = f"Of {wanted} mutants, {len(answers)} were tried, most of them drawn at random. " if len(answers) < wanted else ""
    return (f"{part}{_killed(answers)} of {len(answers)} mutants are killed, {_share(answers)}: {how['killed by a test']} by a failing "
            f"test, {how['killed by a crash']} by a crash, {how['killed by the time limit']} by the time limit; "
            f"{how['survived']} survive.\n")


def missed_goal(results):
    killed, tried = _killed(results.values()), len(results)
    if tried and killed < GOAL * tried:
        return [f"{killed} of {tried} mutants are killed, {100 * killed / tried:.1f} %; the goal is {100 * GOAL:.0f} %"]
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


def page(mutants, wanted, results, reviewed):
    """What the documentation shows of a run."""
    compiled = len(mutants) - len(wanted)
    rows = [summary(results, len(wanted))]
    rows += _table("file", mutants, results, lambda mutant: f"`{mutant.file}`")
    rows += _table("operator", mutants, results, lambda mutant: mutant.operator)
    rows += [f"Not mutated, or not tried: {compiled} mutants of constants that only the compiler evaluates; "
             + "; ".join(f"{why}: {count}" for why, count in mutants.skipped.most_common()) + ".", ""]
    rows += ["## The survivors", ""]
    for group in sorted(reviewed.groups, key=lambda group: group["file"]):
        names = [f"`{name}`" for name in group["mutants"]]
        rows += [f"**`{group['file']}`** {group['why']}", ""] + [f"- {name}" for name in names] + [""]
    return "\n".join(rows)
