"""Work with a library in a process of its own: on a damaged file some never end, take all memory, or crash."""

import io
import os
import pathlib
import pickle
import resource
import select
import signal

from log_error import LogError

CPU_S, BYTES_PER_CPU_S = 4, 1_000_000           # of one step; a library's import is in the first
WALL_PER_CPU = 30                               # for a step that waits, or has little of the machine
MEMORY, MEMORY_PER_BYTE = 1 << 29, 64           # beside what this process has
FILE_BYTES, FILE_BYTES_PER_BYTE = 1 << 20, 4    # some write temporary files
ENDS = {signal.SIGXCPU: "it takes longer than any sound file of its size", signal.SIGKILL: "it was killed",
        signal.SIGSEGV: "the library that reads it crashed"}


class Ended(Exception):
    """The process did not come to the end of its work."""


def items(size, work):
    """Items of the generator `work`, which runs in another process within bounds that a sound file of `size` bytes keeps.
    Its LogError is raised here, anything else as Ended."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.close(reading)
            do(size, work, writing)
        finally:
            os._exit(1)  # never back into this program
    os.close(writing)
    status = None
    try:
        with io.BufferedReader(Waiting(open(reading, "rb", buffering=0), WALL_PER_CPU * cpu_s(size))) as answers:
            yield from answered(answers)
        _, status = os.waitpid(child, 0)
    finally:
        if status is None:
            os.kill(child, signal.SIGKILL)
            _, status = os.waitpid(child, 0)
    if status != 0:
        ended_by = os.WTERMSIG(status) if os.WIFSIGNALED(status) else 0
        raise Ended(ENDS.get(ended_by, f"its reading ended with the status {status}"))


class Waiting(io.RawIOBase):
    """A pipe that is read as long as something comes within `longest_s`."""

    def __init__(self, pipe, longest_s):
        super().__init__()
        self._pipe, self._longest_s = pipe, longest_s

    def readable(self):
        return True

    def readinto(self, buffer):
        if not select.select([self._pipe], [], [], self._longest_s)[0]:
            raise Ended(f"nothing came of its reading for {self._longest_s:.0f} s")
        return self._pipe.readinto(buffer)

    def close(self):
        self._pipe.close()
        super().close()


def cpu_s(size):
    return CPU_S + size // BYTES_PER_CPU_S


def answered(answers):
    while True:
        try:
            is_error, item = pickle.load(answers)
        except (EOFError, pickle.UnpicklingError):
            return  # the status tells whether it was the end
        if is_error:
            raise item
        yield item


def do(size, work, writing):
    pages = int(pathlib.Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
    limit(resource.RLIMIT_AS, pages * resource.getpagesize() + MEMORY + MEMORY_PER_BYTE * size)
    limit(resource.RLIMIT_FSIZE, FILE_BYTES + FILE_BYTES_PER_BYTE * size)
    limit(resource.RLIMIT_CORE, 0)
    with open(writing, "wb") as answers:
        try:
            steps = work()
            while True:
                limit(resource.RLIMIT_CPU, int(sum(os.times()[:2])) + 1 + cpu_s(size))
                item = next(steps, answers)
                if item is answers:
                    break
                pickle.dump((False, item), answers)
                answers.flush()  # the other process waits for each step
        except LogError as error:
            pickle.dump((True, error), answers)
        except Exception as error:  # the libraries raise anything, and not all of it can be sent
            pickle.dump((True, Ended(f"{type(error).__name__}: {error}")), answers)
    os._exit(0)


def limit(kind, most):
    _, hard = resource.getrlimit(kind)
    resource.setrlimit(kind, (most if hard == resource.RLIM_INFINITY else min(most, hard), hard))
