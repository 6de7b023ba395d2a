"""Scores, and the page that shows them."""

import collections
import hashlib

import ledger

WEAKEST = 12


def draw(mutants, count, seed):
    """A random sample in which a mutant's place depends on itself alone: a change of the sources elsewhere does not change
    it, and a smaller sample of one seed is part of a larger one."""
    def place(mutant):
        return hashlib.sha256(repr((seed, mutant.key())).encode()).digest()
    return sorted(sorted(mutants, key=place)[:count], key=lambda mutant: mutant.id)


def only_compiled(mutant, record, all_executed):
    """A constant that only the compiler uses: no run of a program can have it changed. If not all is executed, a named one
    at most is taken for that: what no test executes survives."""
    return mutant.id not in record.executed and (all_executed or not mutant.function)


def _killed(answers):
    return sum(answer != ledger.SURVIVED for answer in answers)


def _share(killed, mutants):
    return f"{100 * killed / mutants:.1f} %"


def summary(results, wanted):
    answers = list(results.values())
    part = f"{len(answers)} of {wanted} mutants were tried, most of them drawn at random. " if len(answers) < wanted else ""
    if not answers:
        return part + "No mutant was tried.\n"
    return f"{part}{_killed(answers)} of {len(answers)} mutants are killed, {_share(_killed(answers), len(answers))}.\n"


def missed_goal(killed, tried, goal, of="mutants"):
    if tried and killed < goal * tried:
        return [f"{killed} of {tried} {of} are killed, {_share(killed, tried)}; the goal is {100 * goal:.0f} %"]
    return []


def rows(asked, mutants, wanted, results, record, known):
    """Content of the ledger for a whole run: floors, survivors, totals."""
    def counted(of):
        answers = collections.defaultdict(list)
        for mutant in wanted:
            answers[of(mutant)].append(results[mutant.id])
        return [(name, len(answers[name]), _killed(answers[name])) for name in sorted(answers)]
    floors = [ledger.Floor(asked.name, *row) for row in counted(lambda mutant: mutant.file)]
    totals = [ledger.Total(asked.name, "operator", *row) for row in counted(lambda mutant: mutant.operator)]
    how = collections.Counter(results[mutant.id] for mutant in wanted)
    totals += [ledger.Total(asked.name, "killed", name, how[name], how[name])
               for name in ("killed by a test", "killed by a crash", "killed by the time limit")]
    idle = sum(mutant.id not in record.executed for mutant in wanted)
    totals.append(ledger.Total(asked.name, "not executed", "executed by no test that is asked", idle, 0))
    skipped = [("constant that only the compiler evaluates", len(mutants) - len(wanted)), *mutants.skipped.most_common()]
    totals += [ledger.Total(asked.name, "not tried", name, count, 0) for name, count in skipped]
    return floors, ledger.reviewed(asked.name, wanted, results, known), totals


def _table(heading, counts):
    """`counts`: name, mutants, killed, equivalent."""
    heads = [heading, "mutants", "survive", "score"]
    reviewed = any(equivalent for _, _, _, equivalent in counts)
    if reviewed:
        heads += ["equivalent", "score without"]
    lines = [f"| {' | '.join(heads)} |", "|---" + "|---:" * (len(heads) - 1) + "|"]
    for name, mutants, killed, equivalent in counts:
        cells = [name, str(mutants), str(mutants - killed), _share(killed, mutants)]
        if reviewed:
            able = mutants - equivalent
            cells += [str(equivalent), _share(killed, able) if able else ""]
        lines.append(f"| {' | '.join(cells)} |")
    return lines + [""]


def _section(asked, floors, survivors, totals):
    def equivalents(of):
        return collections.Counter(of(survivor) for survivor in survivors if survivor.equivalent)
    def folder(row):
        return row.file.rpartition("/")[0]
    of_file, of_folder, of_operator = (equivalents(of) for of in (
        lambda survivor: survivor.file, folder, lambda survivor: survivor.operator))
    mutants, killed = sum(floor.mutants for floor in floors), sum(floor.killed for floor in floors)
    equivalent = sum(of_file.values())
    how = ", ".join(f"{total.mutants} {total.name.removeprefix('killed ')}" for total in totals if total.kind == "killed" and total.mutants)
    idle = sum(total.mutants for total in totals if total.kind == "not executed")
    lines = [f"## {asked.title}", "", f"{killed} of {mutants} mutants are killed, {_share(killed, mutants)}: {how}. "
             f"{mutants - killed} survive" + (f", {idle} of them executed by no test that is asked." if idle else "."), ""]
    if equivalent:
        lines[-1:] = [f"{equivalent} of the survivors are equivalent: no input shows a difference. Without them {killed} of "
                      f"{mutants - equivalent} are killed, {_share(killed, mutants - equivalent)}.", ""]
    folders = collections.defaultdict(lambda: [0, 0])
    for floor in floors:
        folders[folder(floor)][0] += floor.mutants
        folders[folder(floor)][1] += floor.killed
    lines += _table("folder", [(f"`{name}`", *folders[name], of_folder[name]) for name in sorted(folders)])
    open_in = {floor: floor.mutants - floor.killed - of_file[floor.file] for floor in floors}
    worst = sorted((floor for floor in floors if open_in[floor]), key=lambda floor: (-open_in[floor], floor.file))[:WEAKEST]
    lines += [f"Files with the most survivors that are not known to be equivalent (the first {len(worst)}):", ""]
    lines += _table("file", [(f"`{floor.file}`", floor.mutants, floor.killed, of_file[floor.file]) for floor in worst])
    lines += _table("operator", [(total.name, total.mutants, total.killed, of_operator[total.name])
                                 for total in totals if total.kind == "operator"])
    not_tried = "; ".join(f"{total.name}: {total.mutants}" for total in totals if total.kind == "not tried")
    lines += [f"Not mutated, or not tried: {not_tried}. Tests that take more than {asked.longest_ms} ms are not asked.", ""]
    if asked.left_out:
        by_reason = collections.defaultdict(list)
        for name, why in sorted(asked.left_out.items()):
            by_reason[why].append(f"`{name}`")
        lines += ["Left out:", "", *(f"- {', '.join(names)}: {why}" for why, names in sorted(by_reason.items())), ""]
    return lines


def page(scopes, kept):
    """Page on the last whole run of each scope."""
    return "\n".join(line for asked in scopes for line in _section(asked, *kept.of(asked.name)))
