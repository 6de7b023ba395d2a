"""One data frame of a CAN bus. `bus` is a number, the first one 1, or the interface's name in a candump log."""

import collections

Frame = collections.namedtuple("Frame", "time_s bus identifier extended data flexible bit_rate_switch error_state")

LARGEST_STANDARD, LARGEST_EXTENDED = 0x7FF, 0x1FFFFFFF
LENGTHS = (*range(9), 12, 16, 20, 24, 32, 48, 64)  # of the data of a frame; a classic one has the first nine


def checked(frame):
    """The frame; a ValueError for what no bus carries."""
    if frame.identifier > (LARGEST_EXTENDED if frame.extended else LARGEST_STANDARD):
        raise ValueError(f"there is no {'extended' if frame.extended else 'standard'} identifier {frame.identifier:X}")
    if len(frame.data) not in (LENGTHS if frame.flexible else LENGTHS[:9]):
        raise ValueError(f"no {'CAN FD' if frame.flexible else 'classic'} frame has {len(frame.data)} bytes")
    if not -1.0e10 < frame.time_s < 1.0e10:
        raise ValueError(f"the time is {frame.time_s:.6g} s")
    return frame
