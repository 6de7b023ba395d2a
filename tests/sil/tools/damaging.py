"""Files that are cut or have flipped bits, and reading them within bounds of time, memory and disk."""

import collections
import contextlib
import io
import os
import pathlib
import pickle
import random
import resource
import select
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(PROJECT / "sil/tools"), str(PROJECT / "cmake/environment")]

import progress
from bus_logs import BusLog
from log_error import LogError

SECONDS, SECONDS_A_BYTE = 3.0, 2.0e-5
BYTES, BYTES_A_BYTE = 1 << 29, 16  # memory; the libraries' own caches and pools need most of it
FILE_BYTES, FILE_BYTES_A_BYTE = 1 << 20, 4

# The result of a reading, or the sentence that refuses the file; `ended` is False where the bounds ended it.
Outcome = collections.namedtuple("Outcome", "ended result refusal said")


def cuts(content, count):
    """Beginnings of a file, from almost none to almost all of it."""
    places = [number * len(content) // (count + 1) for number in range(1, count + 1)]
    return {f"cut at {at}": content[:at] for at in places}


def flips(content, count, seed):
    """The file with one flipped bit, and with many, in turn."""
    drawn = random.Random(seed)
    damaged = {}
    for number in range(count):
        changed = bytearray(content)
        bits = 1 if number % 2 == 0 else 2 + len(content) // 500
        for _ in range(bits):
            changed[drawn.randrange(len(changed))] ^= 1 << drawn.randrange(8)
        damaged[f"{bits} flip{'s' * (bits > 1)}, number {number} of seed {seed}"] = bytes(changed)
    return damaged


def within_bounds(size, work):
    """Does `work` in a process that may use time, memory and disk in proportion to `size` bytes."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.close(reading)
            bounded(size, work, writing)
            os._exit(0)
        finally:
            os._exit(1)  # never back into the tests
    os.close(writing)
    with open(reading, "rb") as answer:
        content = answer.read() if select.select([reading], [], [], 20 * (SECONDS + SECONDS_A_BYTE * size))[0] else b""
    if not content:
        with contextlib.suppress(ProcessLookupError):
            os.kill(child, 9)
    _, status = os.waitpid(child, 0)
    return pickle.loads(content) if status == 0 else Outcome(False, None, f"ended with the status {status}", "")


def bounded(size, work, writing):
    pages = int(pathlib.Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
    for limit, most in ((resource.RLIMIT_CPU, int(SECONDS + SECONDS_A_BYTE * size) + 1),
                        (resource.RLIMIT_AS, pages * resource.getpagesize() + BYTES + BYTES_A_BYTE * size),
                        (resource.RLIMIT_FSIZE, FILE_BYTES + FILE_BYTES_A_BYTE * size), (resource.RLIMIT_CORE, 0)):
        resource.setrlimit(limit, (most, most))
    said = io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        try:
            outcome = Outcome(True, work(), None, said.getvalue())
        except LogError as error:
            outcome = Outcome(True, None, str(error), said.getvalue())
        except SystemExit as error:
            outcome = Outcome(True, None, str(error.code), said.getvalue())
    with open(writing, "wb") as answer:
        pickle.dump(outcome, answer)


def frames_of(path):
    return [tuple(frame) for frame in progress.reported(BusLog(path))]


def read(path):
    return within_bounds(path.stat().st_size, lambda: frames_of(path))


def lost(whole, part):
    """How many frames of the whole are not in the part."""
    return (collections.Counter(whole) - collections.Counter(part)).total()


class Judge:
    """Compares what is read of a damaged file with what was read of the whole one."""

    def __init__(self, test, folder, name, content):
        self._test, self._path, self._content = test, folder / name, content
        self.whole = self.outcome(content)
        test.assertTrue(self.whole.ended, f"{name}: {self.whole.refusal}")

    def outcome(self, content):
        self._path.write_bytes(content)
        return read(self._path)

    def judge(self, what, content, is_text):
        """It ends, and what it lost is said; a cut file gives no frame that the whole one has not. How many frames it gives, None
        where it is refused."""
        outcome = self.outcome(content)
        label = f"{self._path.name} {what}"
        self._test.assertTrue(outcome.ended, f"{label}: {outcome.refusal}")
        frames, whole = outcome.result or [], self.whole.result or []
        if outcome.refusal:
            self._test.assertTrue(outcome.refusal.startswith(str(self._path)), f"{label}: {outcome.refusal}")
            return None
        if what.startswith("cut"):
            self._test.assertEqual(lost(frames, whole), 0, f"{label} has frames of its own")
        is_clean = what.startswith("cut") and is_text and content.rstrip(b" \t\r").endswith(b"\n")
        if len(frames) < len(whole) and not is_clean:
            self._test.assertIn(": left out: ", outcome.said, f"{label}: {len(frames)} of {len(whole)} frames")
        return len(frames)
