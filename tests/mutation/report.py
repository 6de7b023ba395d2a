"""Scores and their confidence."""

import collections
import math
import random

GOAL = 0.9


def draw(mutants, count, seed):
    """A smaller sample of one seed is part of a larger one."""
    shuffled = list(mutants)
    random.Random(seed).shuffle(shuffled)
    return sorted(shuffled[:count], key=lambda mutant: mutant.id)


def only_compiled(mutant, record):
    """A constant that only the compiler uses: no run of a program can have it changed."""
    return mutant.id not in record.tests_of


def interval(killed, tried):
    """95 % confidence interval of a share (Wilson)."""
    z, share = 1.96, killed / tried
    middle = (share + z * z / (2 * tried)) / (1 + z * z / tried)
    half = z * math.sqrt(share * (1 - share) / tried + z * z / (4 * tried * tried)) / (1 + z * z / tried)
    return middle - half, middle + half


def _score(answers):
    return sum(answer != "survived" for answer in answers), len(answers)


def table(mutator, wanted, record, results, chosen):
    rows = ["| file | mutants | tried | killed | score |", "|---|---:|---:|---:|---:|"]
    of_file = collections.defaultdict(list)
    for mutant in wanted:
        of_file[mutant.file].append(mutant)
    for name in sorted(of_file):
        killed, tried = _score([results[m.id] for m in of_file[name] if m.id in results])
        score = f"{100 * killed / tried:.0f} %" if tried else ""
        rows.append(f"| {name} | {len(of_file[name])} | {tried} | {killed} | {score} |")
    killed, tried = _score(list(results.values()))
    compiled = sum(only_compiled(mutant, record) for mutant in wanted)
    low, high = interval(killed, tried)
    how = f"a random sample, seed {chosen.seed}, " if chosen.sample else ""
    rows += ["", f"{killed} of {tried} killed ({how}{100 * killed / tried:.1f} %"
             + (f"; 95 % confidence interval {100 * low:.1f} to {100 * high:.1f} %" if chosen.sample else "") + ").",
             f"{len(wanted)} mutants; {compiled} more places are of constants that only the compiler evaluates and are "
             "not tried.", ""]
    of_operator = collections.defaultdict(list)
    for mutant in wanted:
        if mutant.id in results:
            of_operator[mutant.operator].append(results[mutant.id])
    rows += ["| operator | tried | killed |", "|---|---:|---:|"]
    rows += [f"| {operator} | {len(answers)} | {_score(answers)[0]} |" for operator, answers in sorted(of_operator.items())]
    how_killed = collections.Counter(results.values())
    rows += ["", "Killed by a failing test: {}, by a crash: {}, by the time limit: {}.".format(
        *(how_killed[f"killed {way}"] for way in ("test", "crash", "time limit"))), ""]
    rows += ["Not mutated:", ""]
    rows += [f"- {why}: {count}" for why, count in mutator.skipped.most_common()]
    return "\n".join(rows) + "\n"


def explained(reviewed):
    whys = collections.Counter(entry["why"] for entry in reviewed.entries)
    rows = ["", "| survivors | why |", "|---:|---|"] + [f"| {count} | {why} |" for why, count in whys.most_common()]
    return "\n".join(rows) + "\n"


def missed_goal(results):
    killed, tried = _score(list(results.values()))
    if tried and killed < GOAL * tried:
        return [f"{killed} of {tried} mutants are killed, {100 * killed / tried:.1f} %; the goal is {100 * GOAL:.0f} %"]
    return []
