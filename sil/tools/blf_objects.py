"""Objects of a BLF, cut from bytes that come piece by piece. A damaged one costs itself: the next begins at its signature."""

import struct

SIGNATURE = b"LOBJ"
HEADER = struct.Struct("<4sHHLL")  # signature, size of the header, its version, size of the object, its type
MOST_PADDING = 7


class Objects:
    """`largest` is the size in bytes of an object for which to wait; one of the type `useful_in_part` may lack its end."""

    def __init__(self, left_out, place, largest, useful_in_part=None):
        self._left_out, self._place, self._largest, self._useful_in_part = left_out, place, largest, useful_in_part
        self._data = bytearray()
        self._passed = 0         # bytes before those in `_data`
        self._is_lost = False    # after a damage that is counted, until the next object

    def feed(self, data):
        """The objects that are complete now: place, type, bytes."""
        self._data += data
        return self._cut(False)

    def end(self):
        """The rest."""
        return self._cut(True)

    def resume(self):
        """The next piece may begin within an object."""
        self._is_lost = True

    def _cut(self, is_end):
        data, at = self._data, 0
        while True:
            found = data.find(SIGNATURE, at)
            if found < 0:
                found = len(data) if is_end else max(at, len(data) - len(SIGNATURE) + 1)
            self._skip(at, found)
            at = found
            if len(data) - at < HEADER.size and not is_end or at == len(data):
                break
            size = self._size(at, is_end)
            if size is None:
                break
            if size:
                self._is_lost = False
                yield self._passed + at, HEADER.unpack_from(data, at)[4], bytes(data[at:at + size])
            else:
                self._is_lost = True
            at += size or len(SIGNATURE)
        self._passed += at
        del data[:at]

    def _skip(self, at, found):
        if found - at > MOST_PADDING and not self._is_lost and self._data[at:found].strip(b"\0"):
            self._damage(self._passed + at, f"{found - at} bytes that are no object")

    def _size(self, at, is_end):
        """0 for a damaged object, None where more bytes must come to know."""
        data = self._data
        if len(data) - at < HEADER.size:
            return self._damage(self._passed + at, "cut off")
        _, header_size, _, size, kind = HEADER.unpack_from(data, at)
        if not HEADER.size <= header_size <= size <= self._largest:
            return self._damage(self._passed + at, f"the size of an object is {size}")
        end = at + size
        beyond = end + MOST_PADDING + len(SIGNATURE)
        if beyond > len(data) and not is_end:
            return None
        is_followed = data.find(SIGNATURE, end, beyond) >= 0 or end <= len(data) < beyond
        holds_others = data.find(SIGNATURE, at + len(SIGNATURE), end) >= 0
        if end > len(data):
            self._damage(self._passed + at, "cut off in the middle of an object")
            return len(data) - at if kind == self._useful_in_part and not holds_others else 0
        if holds_others and not is_followed:
            return self._damage(self._passed + at, "the size of an object reaches into the next ones")
        return size

    def _damage(self, place, reason):
        self._left_out.damage(self._place(place), reason)
        return 0
