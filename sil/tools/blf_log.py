"""The frames of a BLF: objects in containers, or without."""

import struct
import zlib

from can.io import blf

from bus_frame import Frame, checked
from blf_objects import HEADER, Objects
from log_error import LogError

PIECE = 256 * 1024
LARGEST_CONTAINER = 64 * 1024 * 1024  # 128 kB are usual; so much is held at once
LARGEST_OBJECT = 64 * 1024            # in a container
CONTAINER, ERRORS = blf.LOG_CONTAINER, (2, blf.CAN_ERROR_EXT, 104)  # 2 and 104: the error frames of other kinds of CAN
TIME = struct.Struct("<L4xQ")         # flags, time: at the same place in all versions of an object's header
LEAST_HEADER = HEADER.size + TIME.size
TX_REQUEST = 2


def frames(log):
    with log.path.open("rb") as file:
        if log.size < blf.FILE_HEADER_SIZE:
            raise LogError(f"{log.path}: the BLF was cut off within its header; copy it again")
        header = blf.FILE_HEADER_STRUCT.unpack(file.read(blf.FILE_HEADER_STRUCT.size))
        file.seek(header[1] if blf.FILE_HEADER_STRUCT.size <= header[1] <= log.size else blf.FILE_HEADER_SIZE)
        yield from Reader(log, blf.systemtime_to_timestamp(header[14:22]), file).frames()
        if header[10] > log.size and not log.left_out.damaged:
            log.left_out.damage(f"byte {log.size}", f"the file was cut off: it says that it has {header[10]} bytes")


class Reader:
    def __init__(self, log, start_s, file):
        self._log, self._start_s, self._file = log, start_s, file
        self._left_out = log.left_out
        begin = file.tell()
        self._at = begin
        log.position = lambda: self._at
        log.place = lambda: f"byte {self._at}"
        self._outer = Objects(log.left_out, lambda place: f"byte {begin + place}", LARGEST_CONTAINER, CONTAINER)
        self._inner = Objects(log.left_out, lambda _: f"byte {self._at}", LARGEST_OBJECT)
        self._begin = begin

    def frames(self):
        for piece in iter(lambda: self._file.read(PIECE), b""):
            yield from self._of(self._outer.feed(piece))
        yield from self._of(self._outer.end())
        yield from self._messages(self._inner.end())

    def _of(self, objects):
        for place, kind, data in objects:
            self._at = self._begin + place
            if kind != CONTAINER:
                yield from self._messages([(place, kind, data)])
                continue
            content, fault = unpacked(data)
            yield from self._messages(self._inner.feed(content))
            if fault:
                self._left_out.damage(f"byte {self._at}", f"a container that cannot be unpacked ({fault})")
                yield from self._messages(self._inner.end())
                self._inner.resume()

    def _messages(self, objects):
        for _, kind, data in objects:
            if kind in ERRORS:
                self._left_out.kinds["error frames"] += 1
            elif kind not in DECODERS:
                self._left_out.kinds["other objects than frames of CAN"] += 1
            else:
                frame = self._message(kind, data)
                if frame:
                    yield frame

    def _message(self, kind, data):
        try:
            header_size = HEADER.unpack_from(data)[1]
            if header_size < LEAST_HEADER:
                raise ValueError(f"the header of an object has {header_size} bytes")
            flags, time = TIME.unpack_from(data, HEADER.size)
            time_s = time / (1.0e5 if flags == 1 else 1.0e9) + self._start_s
            direction, is_remote, rest = DECODERS[kind](data, header_size)
            if is_remote or direction == TX_REQUEST:
                self._left_out.kinds["remote frames" if is_remote else "requests to send (TxRq)"] += 1
                return None
            bus, identifier, payload, *flexible = rest
            return checked(Frame(time_s, bus, identifier & 0x1FFFFFFF, bool(identifier & blf.CAN_MSG_EXT), payload,
                                 *map(bool, flexible)))
        except (struct.error, ValueError) as error:
            self._left_out.damage(f"byte {self._at}", f"an object that is no frame ({error})")
            return None


def unpacked(container):
    """The content, and a fault if that is not all of it."""
    if len(container) < HEADER.size + blf.LOG_CONTAINER_STRUCT.size:
        return b"", "it has no content"
    method, _ = blf.LOG_CONTAINER_STRUCT.unpack_from(container, HEADER.size)
    content = container[HEADER.size + blf.LOG_CONTAINER_STRUCT.size:]
    if method == blf.NO_COMPRESSION:
        return content, None
    if method != blf.ZLIB_DEFLATE:
        return b"", f"its method is {method}"
    stream = zlib.decompressobj()
    try:
        content = stream.decompress(content, LARGEST_CONTAINER)
    except zlib.error as error:
        return b"", error
    # One that was cut off has no checksum any more: it is taken as far as it goes.
    return content, None if stream.eof else "it was cut off" if not stream.unconsumed_tail else "it is too large"


def classic(data, at):
    bus, flags, length, identifier, payload = blf.CAN_MSG_STRUCT.unpack_from(data, at)
    return flags & 0xF, flags & blf.REMOTE_FLAG, (bus, identifier, payload[:length], False, False, False)


def flexible(data, at):
    bus, flags, _, identifier, _, _, kind, length, payload = blf.CAN_FD_MSG_STRUCT.unpack_from(data, at)
    return flags & 0xF, flags & blf.REMOTE_FLAG, (bus, identifier, payload[:length], kind & 1, kind & 2, kind & 4)


def flexible_64(data, at):
    """As above, with as many bytes as there are; the rest is 0, as in python-can."""
    (bus, _, length, _, identifier, _, flags, _, _, _, _, _, direction, further,
     _) = blf.CAN_FD_MSG_64_STRUCT.unpack_from(data, at)
    first = at + blf.CAN_FD_MSG_64_STRUCT.size
    payload = data[first:min(first + length, further or len(data))].ljust(length, b"\0")
    return direction, flags & 0x10, (bus, identifier, payload, flags & 0x1000, flags & 0x2000, flags & 0x4000)


DECODERS = {blf.CAN_MESSAGE: classic, blf.CAN_MESSAGE2: classic, blf.CAN_FD_MESSAGE: flexible, blf.CAN_FD_MESSAGE_64: flexible_64}
