"""The frames of an MF4 with a recorded CAN bus."""

import heapq
import itertools
import logging

from can.util import dlc2len

import apart
from bus_frame import LARGEST_EXTENDED, Frame, checked
from left_out import LeftOut
from log_error import LogError

logging.getLogger("asammdf").setLevel(logging.CRITICAL)  # its complaints are counted here
RECORDS = 20_000  # taken at a time
NEEDED = {"ID", "DataBytes"}


def frames(log):
    taken = 0
    log.position = lambda: taken
    log.place = lambda: f"byte {taken} or so"
    try:
        for taken, rows, left_out in apart.items(log.size, lambda: parts(log)):
            log.left_out.add(left_out)
            yield from map(Frame._make, rows)
    except apart.Ended as error:
        if taken == 0:
            raise LogError(f"{log.path}: the MF4 is damaged ({error}); copy or export it again") from error
        log.left_out.damage(log.place(), error)


def parts(log):
    """The frames part by part: how far it has come in bytes, the frames, and what was left out of them."""
    import asammdf  # takes a second, and others do not need it

    with asammdf.MDF(log.path, raise_on_multiple_occurrences=False) as mdf:
        groups = []
        for index, group in enumerate(mdf.groups):
            names = {channel.name for channel in group.channels}
            if "CAN_DataFrame" in names and group.channel_group.cycles_nr:
                groups.append(Group(log, mdf, index))
            for kind in ("Error", "Remote"):
                if f"CAN_{kind}Frame" in names:
                    log.left_out.kinds[f"{kind.lower()} frames"] += group.channel_group.cycles_nr
        if not groups:
            raise LogError(f"{log.path}: the MF4 has no frames of a CAN bus (CAN_DataFrame); it holds decoded signals "
                           "(`sil/tools/logs drive` takes it without --dbc), or nothing")
        wanted = sum(group.count for group in groups)
        merged = heapq.merge(*(group.frames() for group in groups), key=lambda frame: frame.time_s)
        is_end = False
        while not is_end:
            rows = [tuple(frame) for frame in itertools.islice(merged, RECORDS)]
            is_end = len(rows) < RECORDS
            left_out, log.left_out = log.left_out, LeftOut()
            yield max(log.size * sum(group.taken for group in groups) // wanted, 1), rows, left_out


class Group:
    """Records of one clock."""

    def __init__(self, log, mdf, index):
        self._log, self._mdf, self._index = log, mdf, index
        self.count = mdf.groups[index].channel_group.cycles_nr
        self.taken = 0

    def frames(self):
        while self.taken < self.count:
            wanted = min(RECORDS, self.count - self.taken)
            try:
                part = self._mdf.get("CAN_DataFrame", group=self._index, record_offset=self.taken, record_count=wanted,
                                     ignore_invalidation_bits=True)
                rows = list(self._rows(part))
            except Exception as error:  # the library raises anything on a damaged file
                self._end(f"{type(error).__name__}: {error}")
                return
            yield from rows
            self.taken += len(part.timestamps)
            if len(part.timestamps) < wanted:
                self._end("the file was cut off")
                return

    def _end(self, reason):
        self._log.left_out.damage(f"frame {self.taken} of {self.count} in group {self._index}", reason)

    def _rows(self, part):
        column = {name.rpartition(".")[2]: part.samples[name] for name in part.samples.dtype.names or ()}
        if not NEEDED <= set(column):
            raise ValueError(f"CAN_DataFrame lacks {' and '.join(sorted(NEEDED - set(column)))}")
        start_s = self._mdf.header.start_time.timestamp()
        count = len(part.timestamps)
        flags = [column[name].tolist() if name in column else [0] * count
                 for name in ("BusChannel", "ID", "IDE", "EDL", "BRS", "ESI", "RTR")]
        lengths = self._lengths(column, count)
        is_invalid = [False] * count if part.invalidation_bits is None else part.invalidation_bits.tolist()
        for number, (time_s, bus, identifier, extended, flexible, switch, error_state, remote) in enumerate(
                zip(part.timestamps.tolist(), *flags)):
            if is_invalid[number] or remote:
                self._log.left_out.kinds["frames marked as invalid" if is_invalid[number] else "remote frames"] += 1
                continue
            data = column["DataBytes"][number][:lengths[number]].tobytes()
            try:
                yield checked(Frame(time_s + start_s, bus, identifier & LARGEST_EXTENDED,
                                    bool(extended or identifier & 0x80000000), data, bool(flexible), bool(switch),
                                    bool(error_state)))
            except ValueError as error:
                self._log.left_out.damage(f"frame {self.taken + number} of group {self._index}", error)

    @staticmethod
    def _lengths(column, count):
        if "DataLength" in column:
            return column["DataLength"].tolist()
        return [dlc2len(code) for code in column["DLC"].tolist()] if "DLC" in column else [64] * count
