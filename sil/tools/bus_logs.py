"""Logs of vehicle buses, frame by frame. None is held as a whole; what is damaged is left out and counted."""

import errno
import pathlib
import re

import blf_log
import bus_frame
import file_io
import frame_tables
import mf4_frames
import text_logs
from left_out import LeftOut
from log_error import LogError

Frame = bus_frame.Frame
READERS = {"BLF": blf_log.frames, "ASC": text_logs.asc, "MF4": mf4_frames.frames, "candump": text_logs.candump,
           "TRC": text_logs.trc, "CSV of python-can": frame_tables.python_can, "CSV of frames": frame_tables.table}
SEEMS_CSV = (", and it seems to be a CSV: `rsi-sil replay` reads it as it is, where its columns have the names of "
             "docs/drives.md, and `sil/tools/logs drive` without --dbc any other")
LONGEST_STEP_S = 60.0  # from frame to frame; a frame that stands further off than both its neighbours is damaged
LONGEST_STEP_BACK_S = 1.0


class BusLog:
    """A log to be read once. Afterwards `left_out` says what it had that did not come out as a frame."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.left_out = LeftOut()
        self.size, beginning = self._look()
        self.kind = kind_of(beginning)
        self.position = lambda: 0    # in bytes, for the account of progress
        self.place = lambda: "byte 0"  # the same as a person reads it
        if self.kind is None:
            raise LogError(f"{self.path}: this is no log that can be read; there are MF4, BLF, ASC and TRC, the log of "
                           "`candump -L`, and tables of frames as of GVRET, python-can and CANedge"
                           + (SEEMS_CSV if re.search(rb"[,;\t]", beginning.split(b"\n")[0]) else ""))

    def _look(self):
        try:
            if self.path.exists() and not self.path.is_file():
                raise OSError(errno.EINVAL, "it is a folder" if self.path.is_dir() else file_io.NO_ORDINARY_FILE)
            with self.path.open("rb") as file:
                beginning = file.read(4096)
            if not beginning:
                raise LogError(f"{self.path}: the file is empty; was the recording or the copy finished?")
            return self.path.stat().st_size, beginning
        except OSError as error:
            raise LogError(f"{self.path}: cannot be read: {error.strerror}") from error

    def frames(self):
        """All data frames, in the order of the file."""
        is_any = False
        try:
            for frame in self._sound(READERS[self.kind](self)):
                is_any = True
                yield frame
        except OSError as error:
            raise LogError(f"{self.path}: cannot be read: {error.strerror}") from error
        if not is_any and self.left_out.damaged:
            raise LogError(f"{self.path}: no frame of this {self.kind} can be read ({self.left_out}); copy or export it again")

    def _sound(self, frames):
        """Without those whose time alone jumps away from both neighbours: it is damaged, the clock was not set."""
        previous_s = suspect = place = None
        for frame in frames:
            if suspect is not None and is_jump(previous_s, frame.time_s):
                yield suspect
                previous_s = suspect.time_s
            elif suspect is not None:
                self.left_out.damage(place, f"its time is {suspect.time_s:.6f} s, between {previous_s:.6f} s and "
                                            f"{frame.time_s:.6f} s")
            suspect = None
            if previous_s is not None and is_jump(previous_s, frame.time_s):
                suspect, place = frame, self.place()
            else:
                yield frame
                previous_s = frame.time_s
        if suspect is not None:
            yield suspect


def is_jump(one_s, next_s):
    return not -LONGEST_STEP_BACK_S <= next_s - one_s <= LONGEST_STEP_S


def kind_of(beginning):
    """Which kind of log of frames begins so; None for any other file."""
    if beginning.startswith(b"LOGG"):
        return "BLF"
    if beginning.startswith((b"MDF     ", b"UnFinMF ")):
        return "MF4"
    text = beginning.decode("latin-1").lstrip("\ufeff\u00ef\u00bb\u00bf \t\r\n")
    if text.startswith("(") or text.startswith("DROPCOUNT"):
        return "candump"
    if re.match(r"((//|\*)[^\n]*\n\s*)*(date\s|base\s+(hex|dec)|begin\s+triggerblock)", text, re.IGNORECASE):
        return "ASC"
    if text.startswith(";") and re.search(r"^;(\$FILEVERSION|.*start time)", text, re.IGNORECASE | re.MULTILINE):
        return "TRC"
    return frame_tables.kind_of(text)
