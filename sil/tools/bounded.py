"""Bounds for a library that reads a file: on a damaged one some never end, or take all memory."""

import contextlib
import pathlib
import resource
import signal
import threading

LEAST_S, BYTES_PER_S = 20.0, 1.0e6
LEAST_BYTES, BYTES_PER_BYTE = 1 << 30, 16


@contextlib.contextmanager
def bounded(size):
    """Ends the block with an error after more processor time or memory than a sound file of `size` bytes can need."""
    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    pages = int(pathlib.Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
    most = pages * resource.getpagesize() + LEAST_BYTES + BYTES_PER_BYTE * size
    is_main = threading.current_thread() is threading.main_thread()  # others cannot have a timer
    if soft == resource.RLIM_INFINITY or most < soft:
        resource.setrlimit(resource.RLIMIT_AS, (most, hard))
    if is_main:
        previous = signal.signal(signal.SIGPROF, end)
        signal.setitimer(signal.ITIMER_PROF, LEAST_S + size / BYTES_PER_S, 1.0)  # again, if the library goes on
    try:
        yield
    finally:
        if is_main:
            signal.setitimer(signal.ITIMER_PROF, 0.0)
            signal.signal(signal.SIGPROF, previous)
        resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


def end(*_):
    raise TimeoutError("its reading takes longer than that of any sound file of its size")
