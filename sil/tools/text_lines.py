"""The lines of a text log, and those of them that a reader of python-can understands."""

import io
import logging

from bus_frame import Frame, checked
from log_error import LogError

logging.getLogger("can").setLevel(logging.CRITICAL)  # its complaints are counted here

LONGEST_LINE = 100_000


def lines_of(log, file):
    """Each line without its end. A character is a byte, so that comments may be in any code page."""
    number = 0
    log.place = lambda: f"line {number}"
    log.position = lambda: log.size if file.closed else file.tell()
    for raw in iter(lambda: file.readline(LONGEST_LINE), b""):
        number += 1
        text = raw.decode("latin-1").strip("\r\n\x00")
        if raw.endswith(b"\n"):
            yield text
        elif text.strip() and not text.lower().startswith("end"):  # the last line of an ASC, of which nothing depends
            log.left_out.damage(log.place(), "it has no line end: the file was cut off" if len(raw) < LONGEST_LINE
                                else "it is too long for any line of a log")


def is_comment(text):
    return text.lstrip().lower().startswith((";", "#", "//"))


class Given(io.TextIOBase):
    """Lines that python-can reads, each of which must become a message."""

    def __init__(self, log, lines):
        super().__init__()
        self._log, self._lines = log, lines
        self._head, self._next = [], None
        self.open_at = None  # place of the line of which no message has come
        self.taken = 0

    def begin(self, head):
        """Whether there is a line for one more reader, which gets `head` first."""
        if self._next is None:
            self._next = next(self._lines, None)
        self._head = list(head())
        return self._next is not None

    def __iter__(self):
        return self

    def __next__(self):
        if self._head:
            return self._head.pop(0)
        self.close_line("the line cannot be understood")
        line = next(self._lines, None) if self._next is None else self._next
        self._next = None
        if line is None:
            raise StopIteration
        self.open_at = self._log.place()
        self.taken += 1
        return line

    def close_line(self, reason):
        if self.open_at:
            self._log.left_out.damage(self.open_at, reason)
        self.open_at = None

    def close(self):
        """The log's file closes itself."""


def frames_by(reader, log, lines, head=lambda: [], first_bus=0):
    """Frames of the lines, each read by python-can. `head` are the lines with which its reader wants to begin."""
    given = Given(log, lines)
    while given.begin(head):
        before = given.taken
        try:
            for message in reader(given):
                given.open_at = None
                frame = frame_of(log, message, first_bus)
                if frame:
                    yield frame
        except (LogError, OSError):
            raise
        except Exception as error:  # the readers raise anything, and do not go on
            given.open_at = given.open_at or log.place()
            given.close_line(f"the line cannot be understood ({error})")
        if given.taken == before:
            next(given, None)


def frame_of(log, message, first_bus):
    if message.is_error_frame or message.is_remote_frame:
        log.left_out.kinds["error frames" if message.is_error_frame else "remote frames"] += 1
        return None
    bus = message.channel + first_bus if isinstance(message.channel, int) else 1
    return checked(Frame(message.timestamp, bus, message.arbitration_id, message.is_extended_id, bytes(message.data),
                         message.is_fd, message.bitrate_switch, message.error_state_indicator))
