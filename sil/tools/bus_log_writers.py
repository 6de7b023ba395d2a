"""Writes frames as the logs that others read: candump, BLF, ASC and MF4."""

import datetime
import io

import can
import numpy

import file_io

# Times below are no calendar's: a simulation's, or a machine's since its start.
FIRST_CALENDAR_TIME_S = 631_152_000
RECORDS = 50_000


def interface_of(bus):
    """As python-can names it: the first bus of a recorder is can0."""
    return bus if isinstance(bus, str) else f"can{max(int(bus) - 1, 0)}"


def number_of(bus):
    """The other way round; a name without a number is the first bus."""
    if not isinstance(bus, str):
        return int(bus)
    digits = bus[len(bus.rstrip("0123456789")):]
    return int(digits) + 1 if digits else 1


def candump_line(frame):
    identifier = f"{frame.identifier:08X}" if frame.extended else f"{frame.identifier:03X}"
    flags = f"#{frame.bit_rate_switch + 2 * frame.error_state:X}" if frame.flexible else ""
    return f"({frame.time_s:.6f}) {interface_of(frame.bus)} {identifier}#{flags}{frame.data.hex().upper()}\n"


def write_candump(path, frames):
    with file_io.growing(path) as file:
        for frame in frames:
            file.write(candump_line(frame).encode("ascii"))


def message(frame):
    return can.Message(timestamp=frame.time_s, channel=number_of(frame.bus) - 1, arbitration_id=frame.identifier,
                       is_extended_id=frame.extended, data=frame.data, is_fd=frame.flexible,
                       bitrate_switch=frame.bit_rate_switch, error_state_indicator=frame.error_state)


def write_blf(path, frames):
    with file_io.growing(path) as file:
        writer = can.BLFWriter(file)
        for frame in frames:
            if writer.start_timestamp is None and frame.time_s < FIRST_CALENDAR_TIME_S:
                writer.start_timestamp = 0.0  # otherwise the first frame's, which the file cannot say
            writer.on_message_received(message(frame))
        writer.stop()


def write_asc(path, frames):
    with file_io.growing(path) as file:
        writer = can.ASCWriter(io.TextIOWrapper(file, encoding="ascii", newline="\n"))
        for frame in frames:
            if not writer.header_written and frame.time_s < FIRST_CALENDAR_TIME_S:
                writer.log_event("start of the clock", 0.0)
            writer.on_message_received(message(frame))
        writer.stop()


FRAME_TYPE = numpy.dtype([(f"CAN_DataFrame.{name}", kind) for name, kind in (
    ("BusChannel", "<u1"), ("ID", "<u4"), ("IDE", "<u1"), ("DLC", "<u1"), ("DataLength", "<u1"), ("DataBytes", "(64,)u1"),
    ("Dir", "<u1"), ("EDL", "<u1"), ("BRS", "<u1"), ("ESI", "<u1"))])


def write_mf4(path, frames):
    import asammdf  # takes a second, and others do not need it

    mdf = asammdf.MDF(version="4.10")
    mdf.header.start_time = datetime.datetime.fromtimestamp(0, datetime.timezone.utc)
    part, is_first = [], True
    for frame in frames:
        part.append(frame)
        if len(part) == RECORDS:
            is_first = add_records(mdf, part, is_first)
            part = []
    if part or is_first:
        add_records(mdf, part, is_first)
    with file_io.growing(path) as file:
        mdf.save(file, compression=2)
    mdf.close()


def add_records(mdf, frames, is_first):
    import asammdf
    from asammdf.blocks import v4_blocks, v4_constants

    samples = numpy.zeros(len(frames), dtype=FRAME_TYPE)
    for number, frame in enumerate(frames):
        data = numpy.zeros(64, dtype="u1")
        data[:len(frame.data)] = numpy.frombuffer(frame.data, dtype="u1")
        length_code = can.util.len2dlc(len(frame.data))
        samples[number] = (number_of(frame.bus), frame.identifier, frame.extended, length_code, len(frame.data), data, 0,
                           frame.flexible, frame.bit_rate_switch, frame.error_state)
    times = numpy.array([frame.time_s for frame in frames], dtype="<f8")
    if is_first:
        source = v4_blocks.SourceInformation(
            source_type=v4_constants.SOURCE_BUS, bus_type=v4_constants.BUS_TYPE_CAN)
        mdf.append(asammdf.Signal(samples, times, name="CAN_DataFrame", source=source), comment="frames")
    else:
        mdf.extend(0, [(times, None), (samples, None)])
    return False
