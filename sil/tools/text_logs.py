"""Logs of one frame a line: candump, ASC and TRC."""

import re

import can

from bus_frame import LARGEST_EXTENDED, Frame, checked
from log_error import LogError
from text_lines import frames_by, is_comment, lines_of

CANDUMP_LINE = re.compile(
    r"\((\d+\.\d{6,9})\) (\S+) ([0-9A-Fa-f]{3}|[0-9A-Fa-f]{8})#(?:#([0-9A-Fa-f]))?((?:[0-9A-Fa-f]{2})*)"
    r"(?:(?<=#[0-9A-Fa-f]{16})_[9A-Fa-f])?(?: [RT])?")  # _9 to _F: a raw length code of `candump -8`, for 8 bytes
CANDUMP_OTHERS = (
    ("remote frames", re.compile(r"\(\d+\.\d{6,9}\) \S+ [0-9A-Fa-f]+#[Rr]\w*(?: [RT])?")),
    ("error frames", re.compile(r"\(\d+\.\d{6,9}\) \S+ [2-3][0-9A-Fa-f]{7}#.*")),
    ("CAN XL frames", re.compile(r"\(\d+\.\d{6,9}\) \S+ [0-9A-Fa-f]+#[0-9A-Fa-f]{2}:[0-9A-Fa-f]{2}:[0-9A-Fa-f]*#.*")),
    ("notes of frames that the recorder lost", re.compile(r"(?:\(\d+\.\d+\) )?(?:\S+ )?DROPCOUNT.*")))


def candump(log):
    with log.path.open("rb") as file:
        for text in lines_of(log, file):
            match = CANDUMP_LINE.fullmatch(text)
            if match is None or int(match[3], 16) > LARGEST_EXTENDED:
                kind = next((kind for kind, pattern in CANDUMP_OTHERS if pattern.fullmatch(text)), None)
                if kind:
                    log.left_out.kinds[kind] += 1
                elif text.strip() and not is_comment(text):
                    log.left_out.damage(log.place(), "it is no line of `candump -L`, such as (0.010000) can0 123#AABB")
                continue
            time, bus, identifier, flags, data = match.groups()
            flag_bits = int(flags or "0", 16)
            try:
                yield checked(Frame(float(time), bus, int(identifier, 16), len(identifier) == 8, bytes.fromhex(data),
                                    flags is not None, bool(flag_bits & 1), bool(flag_bits & 2)))
            except ValueError as error:
                log.left_out.damage(log.place(), error)


ASC_HEADER = re.compile(r"date\s|base\s|(no\s+)?internal events|[\d.]+\s.*start of measurement$|(begin|end)\s*triggerblock|\*",
                        re.IGNORECASE)
ASC_BASE = re.compile(r"base\s+(hex|dec)(?:\s+timestamps\s+(absolute|relative))?", re.IGNORECASE)
ASC_TIMED = re.compile(r"-?\d+\.\d+\s")
ASC_FRAME = re.compile(r"\d+\.\d+\s+(?:\d+\s+(?:\w+\s+(?P<way>Rx|TxRq|Tx)\b|ErrorFrame)|"
                       r"CANFD\s+\d+\s+(?:(?P<way_fd>Rx|TxRq|Tx)\b|ErrorFrame))", re.IGNORECASE)


def asc(log):
    with log.path.open("rb") as file:
        base = "hex"

        def frame_lines():
            nonlocal base
            for text in (line.strip() for line in lines_of(log, file)):
                frame = ASC_FRAME.match(text)
                if frame and "txrq" not in ((frame["way"] or "") + (frame["way_fd"] or "")).lower():
                    yield text
                elif frame:
                    log.left_out.kinds["requests to send (TxRq)"] += 1
                elif ASC_TIMED.match(text) and not text.lower().endswith("start of measurement"):
                    log.left_out.kinds["lines of other events"] += 1
                elif header := ASC_BASE.match(text):
                    base = header[1].lower()
                    if (header[2] or "").lower() == "relative":
                        raise LogError(f"{log.path}:{log.place().split()[1]}: the times are relative, each to the line before; "
                                       "record or export the ASC with absolute ones")
                elif text and not is_comment(text) and not ASC_HEADER.match(text):
                    log.left_out.damage(log.place(), "it is no line of an ASC")

        # python-can takes one line that is no header for the end of the header, and loses it.
        yield from frames_by(can.ASCReader, log, frame_lines(), lambda: [f"base {base}  timestamps absolute", ""], first_bus=1)


TRC_TYPE_COLUMNS = {"1.1": 2, "1.3": 3}
TRC_TYPES = {"ER": "error frames", "Error": "error frames", "Warng": "status lines", "ST": "status lines", "EC": "status lines",
             "EV": "status lines"}


def trc(log):
    with log.path.open("rb") as file:
        head = {}

        def frame_lines():
            for text in (line.strip() for line in lines_of(log, file)):
                key, _, value = text.partition("=")
                if key in (";$FILEVERSION", ";$COLUMNS") or key == ";$STARTTIME" and re.fullmatch(r"\d+(\.\d+)?", value):
                    head[key] = text
                elif key == ";$STARTTIME":
                    log.left_out.damage(log.place(), "the start time is no number, so times begin at 0")
                elif not text or text.startswith(";"):
                    continue
                elif kind := TRC_TYPES.get(trc_type(text.split(), head)):
                    log.left_out.kinds[kind] += 1
                else:
                    yield text

        yield from frames_by(can.TRCReader, log, frame_lines(), head.values)


def trc_type(fields, head):
    """The word that says whether a line has a frame."""
    version = head.get(";$FILEVERSION", "").partition("=")[2]
    columns = head.get(";$COLUMNS", "").partition("=")[2].split(",")
    place = columns.index("T") if "T" in columns else TRC_TYPE_COLUMNS.get(version, 2)
    word = fields[place] if place < len(fields) else ""
    return "ST" if word == "FFFFFFFF" else word
