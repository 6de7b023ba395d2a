"""Says how far a long reading has come, and at its end what it left out."""

import sys
import time

EVERY_S = 5.0
FRAMES = 10_000  # after so many the clock is looked at


def reported(log):
    """The frames of a log, or the lines of a table."""
    said_s = time.monotonic()
    for number, frame in enumerate(log.frames()):
        if number % FRAMES == 0 and time.monotonic() - said_s > EVERY_S:
            said_s = time.monotonic()
            share = min(100 * log.position() // max(log.size, 1), 100)
            print(f"{log.path}: {share} %, {number} read", file=sys.stderr, flush=True)
        yield frame
    if str(log.left_out):
        print(f"{log.path}: left out: {log.left_out}", file=sys.stderr)
