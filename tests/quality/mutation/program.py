"""A test program of the mutated build that runs and answers requests (main.cpp), and what its tests execute."""

import concurrent.futures
import hashlib
import json
import subprocess
import sys


class Program:
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
    """Cost of each test (ms of CPU time), and the tests in which a mutant makes another value somewhere: no other can notice."""

    def __init__(self, content, is_asked=lambda mutant, program: True, longest_ms=900):
        """`is_asked`: whether a program is asked about a mutant, by its number. Tests that take longer than `longest_ms` while
        recorded are not asked: hours of driving, millions of random frames look for what gets lost in the long run, and
        each survivor would cost seconds."""
        self.executed = {mutant for _, _, _, differing, same in content for mutant in differing + same}
        self.tests_of, self.cost, self.breadth = {}, {}, {}
        for program, test, ms, differing, _ in content:
            if ms <= longest_ms:
                self.cost[program, test], self.breadth[program, test] = ms, len(differing)
                for mutant in (mutant for mutant in differing if is_asked(mutant, program)):
                    self.tests_of.setdefault(mutant, []).append((program, test))


def digest(programs):
    together = hashlib.sha256()
    for path in programs.values():
        together.update(path.read_bytes())
    return together.hexdigest()[:16]


def _recorded(name, path, folder, longest_ms):
    file = folder / f"record_{name}_{digest({name: path})}.json"
    if not file.is_file():
        print(f"mutation: finding out what the tests of {name} execute", file=sys.stderr)
        program = Program(path)
        content = []
        for test in program.tests():
            answer = program.ask(f"record {longest_ms + 150} {test}")
            if answer == "failed":
                raise SystemExit(f"mutation: {name} fails without a mutant: {test}")
            (ms, *differing), same = (list(map(int, part.split())) for part in answer.split("|"))
            content.append((name, test, ms, differing, same))
        program.end()
        for old in folder.glob(f"record_{name}_*.json"):
            old.unlink()
        file.write_text(json.dumps(content))
    return json.loads(file.read_text())


def recorded(programs, folder, jobs, is_asked=lambda mutant, program: True, longest_ms=900):
    """Runs every test once, but those of programs that have been recorded already."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        content = sum(pool.map(lambda item: _recorded(*item, folder, longest_ms), programs.items()), [])
    return Record(content, is_asked, longest_ms)
