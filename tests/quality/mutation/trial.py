"""Tries mutants on the tests in which they make a difference, until one notices."""

import concurrent.futures
import json
import random
import sys
import threading
import time

import program as test_program

QUICK_MS = 30      # tests up to here go together into one process ...
TOGETHER_MS = 60   # ... so many of them
SURVIVED = "survived"


class Trial:
    """Results are written down one by one, and taken up again by the next run of the very same programs. Runs of other programs
    give a hint: the killer of a mutant is tried first."""

    def __init__(self, programs, record, folder, anew=False):
        self._programs = programs
        self._record = record
        name = test_program.digest(programs)
        self._file = folder / f"results_{name}.jsonl"
        self._results, self._killer = {}, {}
        if anew:
            for old in folder.glob("results_*.jsonl"):
                old.unlink()
        for file in sorted(folder.glob("results_*.jsonl"), key=lambda path: path.stat().st_mtime):
            self._take_hints(file)
        self._kills = {}  # test: how many mutants it has killed
        self._lock = threading.Lock()

    def _take_hints(self, file):
        results = [json.loads(line) for line in file.read_text().splitlines()]
        if file == self._file:
            self._results = {number: answer for number, _, answer, _ in results}
        self._killer.update({tuple(key): tuple(killer) for _, key, _, killer in results if killer})

    def _cost(self, tests):
        return sum(self._record.cost[test] for test in tests)

    def _together(self, tests):
        """Groups of quick tests of one program; those that are about the least first."""
        group = []
        for test in sorted(tests, key=lambda test: self._record.breadth[test]):
            if group and self._cost(group + [test]) > TOGETHER_MS:
                yield group
                group = []
            group.append(test)
        if group:
            yield group

    def _groups(self, mutant):
        """Tests in which it makes a difference, in the order in which they are tried: a group is of one program."""
        record = self._record
        tests = record.tests_of.get(mutant.id, [])
        killer = self._killer.get(mutant.key())
        if killer in tests:
            yield [killer]
        quick = {}
        for test in tests:
            if record.cost[test] <= QUICK_MS:
                quick.setdefault(test[0], []).append(test)
        groups = [group for of_program in quick.values() for group in self._together(of_program)]
        yield from sorted(groups, key=self._price)
        rest = [[test] for test in tests if record.cost[test] > QUICK_MS]
        yield from sorted(rest, key=self._price)

    def _price(self, group):
        """Probability of a kill, from experience."""
        return (1 + self._cost(group)) / (1 + sum(self._kills.get(test, 0) for test in group))

    def _try(self, mutant, running):
        """Its result, and the test that killed it."""
        for group in self._groups(mutant):
            program = group[0][0]
            if program not in running:
                running[program] = test_program.Program(self._programs[program])
            limit_ms = 300 + 10 * self._cost(group)
            answer = running[program].ask(f"try {mutant.id} {limit_ms} {':'.join(test for _, test in group)}")
            if answer != SURVIVED:
                how, killer = answer.split("\t")
                return how, (program, killer)
        return SURVIVED, None

    def run(self, mutants, jobs, minutes=None):
        """Number of each mutant: "survived" or "killed ...". Share of the tried ones: a run may end after a number of minutes.
        First come those of earlier runs, then the others in a random order, so that what was tried is a random sample."""
        waiting = [mutant for mutant in mutants if mutant.id not in self._results]
        random.Random(1).shuffle(waiting)
        waiting.sort(key=lambda mutant: mutant.key() in self._killer)
        start, whole = time.monotonic(), len(waiting)

        def report():
            tried = whole - len(waiting)
            if tried % 100 == 0:
                survive = sum(answer == SURVIVED for answer in self._results.values())
                print(f"mutation: {tried} tried, {len(waiting)} to go, {time.monotonic() - start:.0f} s; of all "
                      f"{len(self._results)} tried so far {survive} survive", file=sys.stderr)

        def work(file):
            running = {}
            while True:
                with self._lock:
                    if not waiting or (minutes is not None and time.monotonic() > start + 60 * minutes):
                        break
                    mutant = waiting.pop()
                how, killer = self._try(mutant, running)
                with self._lock:
                    self._results[mutant.id] = how
                    if killer:
                        self._kills[killer] = self._kills.get(killer, 0) + 1
                    file.write(json.dumps([mutant.id, mutant.key(), how, killer]) + "\n")
                    file.flush()
                    report()
            for program in running.values():
                program.end()

        with self._file.open("a") as file, concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            list(pool.map(work, [file] * jobs))
        return {mutant.id: self._results[mutant.id] for mutant in mutants if mutant.id in self._results}
