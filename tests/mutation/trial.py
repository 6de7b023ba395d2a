"""Tries mutants on test programs: which test executes which mutant, and which mutant is noticed."""

import concurrent.futures
import hashlib
import json
import subprocess
import sys
import threading
import time

QUICK_MS = 30      # tests up to here go together into one process
SLOW_MS = 600      # tests beyond are the last resort: hours of driving, millions of random frames
MOST_SLOW = 2      # so many of them at most, those that are about the least: they seldom see what the others do not


class Program:
    """One running test program, which answers requests."""

    def __init__(self, path):
        self._process = subprocess.Popen([path], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                         stderr=subprocess.DEVNULL, text=True)

    def ask(self, request):
        self._process.stdin.write(request + "\n")
        self._process.stdin.flush()
        answer = self._process.stdout.readline()
        if not answer:
            raise SystemExit(f"mutation: a test program ended at the request: {request[:200]}")
        return answer.strip()

    def tests(self):
        names = []
        line = self.ask("tests")
        while line != "end":
            names.append(line.removeprefix("test "))
            line = self._process.stdout.readline().strip()
        return names

    def end(self):
        self._process.stdin.close()
        self._process.stdout.close()
        self._process.wait()


class Record:
    """What each test costs (ms of CPU time) and executes."""

    def __init__(self, content):
        self.cost = {(program, test): ms for program, test, ms, _ in content}
        self.breadth = {(program, test): len(executed) for program, test, _, executed in content}
        self.tests_of = {}
        for program, test, _, executed in content:
            for mutant in executed:
                self.tests_of.setdefault(mutant, []).append((program, test))


def _digest(programs):
    together = hashlib.sha256()
    for path in programs.values():
        together.update(path.read_bytes())
    return together.hexdigest()


def recorded(programs, folder):
    file = folder / f"record_{_digest(programs)[:16]}.json"
    if not file.is_file():
        print("mutation: finding out which test executes what", file=sys.stderr)

        def record(name):
            program = Program(programs[name])
            content = []
            for test in program.tests():
                answer = program.ask(f"record {test}")
                if answer == "failed":
                    raise SystemExit(f"mutation: {name} fails without a mutant: {test}")
                ms, *executed = map(int, answer.split())
                content.append((name, test, ms, executed))
            program.end()
            return content

        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            content = sum(pool.map(record, programs), [])
        file.write_text(json.dumps(content))
    return Record(json.loads(file.read_text()))


class Trial:
    def __init__(self, programs, record, folder, anew=False):
        self._programs = programs
        self._record = record
        self._file = folder / f"results_{_digest(programs)[:16]}.jsonl"
        if anew:
            self._file.unlink(missing_ok=True)
        self._results = {}
        if self._file.is_file():
            self._results = dict(map(json.loads, self._file.read_text().splitlines()))
        self._kills = {}  # test: how many mutants it has killed
        self._lock = threading.Lock()

    def _stages(self, mutant):
        """Groups of tests of one program, the quickest first."""
        tests = sorted(self._record.tests_of.get(mutant, []), key=lambda test: self._record.cost[test])
        quick = {}
        for program, test in tests:
            if self._record.cost[program, test] <= QUICK_MS:
                quick.setdefault(program, []).append(test)
        yield from ((program, names) for program, names in quick.items())
        rest = [test for test in tests if QUICK_MS < self._record.cost[test] <= SLOW_MS]
        rest.sort(key=lambda test: self._record.cost[test] / (1 + self._kills.get(test, 0)))
        yield from ((program, [test]) for program, test in rest)
        slow = [test for test in tests if self._record.cost[test] > SLOW_MS]
        slow.sort(key=lambda test: self._record.breadth[test])
        yield from ((program, [test]) for program, test in slow[:MOST_SLOW])

    def _try(self, mutant, running):
        for program, tests in self._stages(mutant):
            if program not in running:
                running[program] = Program(self._programs[program])
            limit_ms = 500 + 10 * sum(self._record.cost[program, test] for test in tests)
            answer = running[program].ask(f"try {mutant} {limit_ms} {':'.join(tests)}")
            if answer != "survived":
                if len(tests) == 1:
                    self._kills[program, tests[0]] = self._kills.get((program, tests[0]), 0) + 1
                return answer
        return "survived"

    def run(self, mutants, jobs):
        """Number of each mutant: "survived" or "killed ..."."""
        waiting = [mutant for mutant in mutants if mutant.id not in self._results]
        done, start = 0, time.monotonic()

        def work(file):
            nonlocal done
            running = {}
            while True:
                with self._lock:
                    if not waiting:
                        break
                    mutant = waiting.pop(0)
                answer = self._try(mutant.id, running)
                with self._lock:
                    self._results[mutant.id] = answer
                    file.write(json.dumps([mutant.id, answer]) + "\n")
                    file.flush()
                    done += 1
                    if done % 100 == 0:
                        print(f"mutation: {done} tried, {len(waiting)} to go, {time.monotonic() - start:.0f} s",
                              file=sys.stderr)
            for program in running.values():
                program.end()

        with self._file.open("a") as file, concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            list(pool.map(work, [file] * jobs))
        return {mutant.id: self._results[mutant.id] for mutant in mutants}
