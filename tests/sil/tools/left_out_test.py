"""Logs of frames with what is damaged, foreign or no data frame: all else comes out, and that is counted."""

import base64
import contextlib
import io
import pathlib
import struct
import sys
import tempfile
import unittest
import zlib

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(PROJECT / "sil/tools"), str(PROJECT / "cmake/environment")]

import bus_log_writers
import progress
from bus_frame import Frame
from bus_logs import BusLog
from log_error import LogError

FRAMES = [Frame(round(0.01 * number, 6), 1, 0x120 + number % 3, False, bytes([number, 255 - number, 3, 4, 5, 6, 7, 8]), False,
                False, False) for number in range(60)]
YEAR_2000_S = 946_684_800
ASC_HEADER = "date Mon Jan 1 10:00:00.000 am 2024\nbase hex  timestamps absolute\ninternal events logged\n"


def asc_line(frame, way="Rx"):
    return (f"   {frame.time_s:.6f} 1  {frame.identifier:X}             {way}   d {len(frame.data)} {frame.data.hex(' ').upper()}"
            "  Length = 0 BitCount = 0 ID = 0\n")


def blf(content, contained=True, compressed=True):
    """A BLF of objects, in one container or without."""
    if contained:
        packed = zlib.compress(content) if compressed else content
        content = struct.pack("<4sHHLLH6xL4x", b"LOBJ", 16, 1, 32 + len(packed), 10, 2 if compressed else 0, len(content)) + packed
    size = 144 + len(content)
    return struct.pack("<4sLBBBBBBBBQQLL32x", b"LOGG", 144, 5, 0, 0, 0, 2, 6, 8, 1, size, size, 0, 0).ljust(144, b"\0") + content


def blf_object(frame, version=1, size=None, direction=0):
    content = struct.pack("<HBBL8s", frame.bus, direction, len(frame.data), frame.identifier, frame.data)
    header = {1: 32, 2: 40, 3: 32}[version]
    return struct.pack("<4sHHLLLHHQ", b"LOBJ", header, version, header + len(content) if size is None else size, 1, 2, 0, 0,
                       round(frame.time_s * 1e9)).ljust(header, b"\0") + content


class WithLogs(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def read(self, content, kind=None):
        """The frames of a log, and what was said of those left out."""
        file = self.folder / "log"
        file.write_bytes(content.encode("latin-1") if isinstance(content, str) else content)
        log = BusLog(file)
        if kind:
            self.assertEqual(log.kind, kind)
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            frames = list(progress.reported(log))
        return frames, said.getvalue().removeprefix(f"{file}: left out: ").rstrip("\n")

    def expect(self, content, frames, said="", kind=None):
        self.assertEqual(self.read(content, kind), (frames, said))

    def written(self, kind, frames=FRAMES):
        file = self.folder / f"written.{kind}"
        getattr(bus_log_writers, f"write_{kind}")(file, iter(frames))
        return file.read_bytes()


class Candump(WithLogs):
    LINES = [bus_log_writers.candump_line(frame._replace(bus="can0")) for frame in FRAMES]
    FRAMES = [frame._replace(bus="can0") for frame in FRAMES]

    def with_line(self, line):
        return "".join(self.LINES[:30] + [line] + self.LINES[30:])

    def test_frames_without_data_are_counted_by_kind(self):
        for line, said in (("(0.295000) can0 20000080#0000000000000000\n", "1 error frames"),
                           ("(0.295000) can0 120#R\n", "1 remote frames"), ("(0.295000) can0 18FEF100#R8_A T\n", "1 remote frames"),
                           ("(0.295000) can0 00123#81:00:12345678#112233\n", "1 CAN XL frames"),
                           ("DROPCOUNT: dropped 5 CAN frames on 'can0' socket (total drops 5)\n",
                            "1 notes of frames that the recorder lost"), ("\n", ""), ("# a remark\n", "")):
            self.expect(self.with_line(line), self.FRAMES, said, "candump")

    def test_a_raw_length_code_and_nanoseconds_are_read(self):
        for line, data in (("(0.295000) can0 123#1122334455667788_E\n", "1122334455667788"), ("(0.295000123) can0 123#11 R\n", "11")):
            frames, said = self.read(self.with_line(line))
            self.assertEqual((frames[30].data.hex(), round(frames[30].time_s, 6), said), (data, 0.295, ""))

    def test_a_damaged_line_costs_that_line(self):
        for line, reason in (("(0.29x000) can0 120#00\n", "it is no line of `candump -L`, such as (0.010000) can0 123#AABB"),
                             ("(0.295000) can0 120#0\n", "it is no line of `candump -L`, such as (0.010000) can0 123#AABB"),
                             *((f"(0.295000) can0 120{data}\n", "it is no line of `candump -L`, such as (0.010000) can0 123#AABB")
                               for data in ("#1122334455667788_8", "#11223344556677_9", "##11122334455667788_9")),
                             ("(0.295000) can0 120#112233445566778899\n", "no classic frame has 9 bytes"),
                             ("(0.295000) can0 120##1112233445566778899\n", "no CAN FD frame has 9 bytes"),
                             ("(0.295000) can0 820#00\n", "there is no standard identifier 820"),
                             ("(1000.295000) can0 120#00\n", "its time is 1000.295000 s, between 0.290000 s and 0.300000 s")):
            self.expect(self.with_line(line), self.FRAMES, f"1 damaged part, the first at line 31: {reason}")
        frames, said = self.read(self.with_line(200_000 * "x" + "\n"))
        self.assertEqual(frames, self.FRAMES)
        self.assertTrue(said.startswith("2 damaged parts, the first at line 31: it is too long"), said)

    def test_a_last_line_without_its_end_is_left_out(self):
        self.expect("".join(self.LINES)[:-1], self.FRAMES[:-1],
                    "1 damaged part, the first at line 60: it has no line end: the file was cut off")

    def test_a_real_jump_of_the_clock_stays(self):
        later = [frame._replace(time_s=round(frame.time_s + 5000.0, 6)) for frame in self.FRAMES]
        self.expect("".join(map(bus_log_writers.candump_line, self.FRAMES + later)), self.FRAMES + later)
        self.expect("".join(map(bus_log_writers.candump_line, self.FRAMES + later[:1])), self.FRAMES + later[:1])


class Asc(WithLogs):
    BODY = "".join(asc_line(frame) for frame in FRAMES)

    def test_a_request_to_send_is_no_second_frame(self):
        body = "".join(asc_line(frame, "TxRq") + asc_line(frame, "Tx") for frame in FRAMES)
        self.expect(ASC_HEADER + body, FRAMES, "60 requests to send (TxRq)", "ASC")

    def test_flexible_frames_and_the_starts_of_a_measurement(self):
        body = "".join(f"   {frame.time_s:.6f} CANFD   1 Rx        {frame.identifier:X}              1 0 8 8 {frame.data.hex(' ')}"
                       "   0  0   323040 0 0 0 0 0\n" for frame in FRAMES)
        self.expect(ASC_HEADER + "Begin Triggerblock Mon Jan 1 10:00:00.000 am 2024\n   0.000000 CANFD   Start of measurement\n"
                    "   0.000000 Start of measurement\n" + body + "   0.700000 CANFD 1 Rx ErrorFrame Not Acknowledge error\n"
                    "End TriggerBlock", [frame._replace(flexible=True, bit_rate_switch=True) for frame in FRAMES], "1 error frames")

    def test_headers_of_others_lose_no_frame(self):
        for header in ("date Mon Jan 1 10:00:00.000 am 2024\nbase hex  timestamps absolute\n", "base hex timestamps absolute\n",
                       "// version 9.0.0\nbase hex  timestamps absolute\n// by another tool\n", "base hex\nno internal events logged\n",
                       "***BUSMASTER Ver 3.2.2***\ndate Mon Jan 1 10:00:00.000 am 2024\nbase hex  timestamps absolute\n",
                       ASC_HEADER + "base hex  timestamps absolute\nBegin Triggerblock Mon Jan 1 10:00:00.000 am 2024\n"):
            self.expect(header + self.BODY, FRAMES, "", "ASC")

    def test_a_beginning_of_many_remarks_is_decided_at_once(self):
        with self.assertRaisesRegex(LogError, "this is no log that can be read"):
            self.read("// " * 1300 + "\n" + "*// " * 1000)

    def test_decimal_numbers_are_read(self):
        body = "".join(f"   {frame.time_s:.6f} 1  {frame.identifier} Rx d {len(frame.data)} {' '.join(map(str, frame.data))}\n"
                       for frame in FRAMES)
        self.expect("base dec timestamps absolute\n" + body, FRAMES)

    def test_frames_without_data_and_events_are_counted(self):
        self.expect(ASC_HEADER + self.BODY + "   0.700000 1  ErrorFrame\n   0.710000 1  123             Rx   r\n"
                    "   0.720000 1  Statistic: D 0 R 0 XD 0 XR 0 E 0 O 0 B 0.0%\n", FRAMES,
                    "1 error frames; 1 lines of other events; 1 remote frames")

    def test_a_damaged_line_costs_that_line(self):
        lines = self.BODY.splitlines(keepends=True)
        for damaged, reason in (("   0.295000 1  12G             Rx   d 1 00\n", "the line cannot be understood ("),
                                ("   0.295000 1  120             Rx   d 9z 00\n", "the line cannot be understood ("),
                                ("   0.295000 1  820             Rx   d 1 00\n", "the line cannot be understood ("),
                                ("x  0.295000 1  120             Rx   d 1 00\n", "it is no line of an ASC")):
            frames, said = self.read(ASC_HEADER + "".join(lines[:30] + [damaged] + lines[30:]))
            self.assertEqual(frames, FRAMES, damaged)
            self.assertTrue(said.startswith(f"1 damaged part, the first at line 34: {reason}"), said)


class Trc(WithLogs):
    def body(self, line):
        return "".join(line(number, frame) for number, frame in enumerate(FRAMES, 1))

    def expect_lines(self, header, line, others, said, bus=1):
        for ending, expected in (("", said), ("  1x)  zz\n", f"{said}; 1 damaged part, the first at line ")):
            frames, told = self.read(header + self.body(line) + others + ending, "TRC")
            self.assertEqual([frame._replace(time_s=round(frame.time_s % YEAR_2000_S, 4)) for frame in frames],
                             [frame._replace(bus=bus) for frame in FRAMES])
            self.assertTrue(told.startswith(expected), told)
            self.assertLess(len(told), len(expected) + 60)

    def test_every_version_is_read(self):
        self.expect_lines(";   made.trc\n;   Start time: 01.01.2024 10:00:00.000.0\n;---+--  ------+------  ---+--\n",
                          lambda number, frame: f"{number:6})  {frame.time_s * 1000:9.1f}  {frame.identifier:04X}  8  "
                                                f"{frame.data.hex(' ').upper()}\n",
                          "    61)     600.0  FFFFFFFF  4  00 00 00 08 BUSHEAVY\n", "1 status lines")
        self.expect_lines(";$FILEVERSION=1.1\n;$STARTTIME=36526.0\n;\n",
                          lambda number, frame: f"{number:6})  {frame.time_s * 1000:9.1f}  Rx  {frame.identifier:04X}  8  "
                                                f"{frame.data.hex(' ').upper()}\n",
                          "    61)     600.0  Warng  FFFFFFFF  4  00 00 00 08 BUSHEAVY\n    62)  601.0  Rx  0120  0  RTR\n"
                          "    63)  602.0  Error  0008  4  00 19 08 08\n", "1 error frames; 1 remote frames; 1 status lines")
        self.expect_lines(";$FILEVERSION=1.3\n;$STARTTIME=36526.0\n;\n",
                          lambda number, frame: f"{number:6})  {frame.time_s * 1000:9.1f} 2  Rx  {frame.identifier:04X}  -  8  "
                                                f"{frame.data.hex(' ').upper()}\n",
                          "    61)     600.0 2  Warng  FFFFFFFF  -  4  00 00 00 08 BUSHEAVY\n", "1 status lines", bus=2)
        for columns, bus in (("N,O,T,I,d,L,D", ""), ("N,O,T,B,I,d,R,L,D", "1 ")):
            self.expect_lines(f";$FILEVERSION=2.{len(bus) // 2}\n;$STARTTIME=36526.0\n;$COLUMNS={columns}\n;\n",
                              lambda number, frame: f"{number:7} {frame.time_s * 1000:13.3f} DT {bus}{frame.identifier:8X} Rx "
                                                    f"{'- ' * bool(bus)}8 {frame.data.hex(' ').upper()}\n",
                              f"     61      600.000 ER {bus}         Rx {'- ' * bool(bus)}5 04 00 02 00 00\n"
                              f"     62      601.000 ST {bus}         Rx {'- ' * bool(bus)}4 00 00 00 08\n", "1 error frames; "
                              "1 status lines")

    def test_a_damaged_start_time_costs_the_date(self):
        frames, said = self.read(";$FILEVERSION=1.1\n;$STARTTIME=4x.5\n;\n     1)  10.0  Rx  0120  2  01 02\n")
        self.assertEqual([frame.time_s for frame in frames], [0.01])
        self.assertEqual(said, "1 damaged part, the first at line 2: the start time is no number, so times begin at 0")


class Blf(WithLogs):
    def test_objects_of_every_header_version_in_containers_and_without(self):
        for version in (1, 2, 3):
            objects = b"".join(blf_object(frame, version) for frame in FRAMES)
            for contained, compressed in ((True, True), (True, False), (False, False)):
                self.expect(blf(objects, contained, compressed), FRAMES, "", "BLF")

    def test_an_object_of_a_damaged_size_costs_itself(self):
        for size in (0, 8, 16, 40, 60, 96, 100, 5000, 0xFFFFFFFF):
            objects = b"".join(blf_object(frame, size=size if number == 30 else None) for number, frame in enumerate(FRAMES))
            for contained in (True, False):
                frames, said = self.read(blf(objects, contained))
                if size in (60, 96):  # the frame is there, and nothing tells whether the size is right
                    self.assertIn(FRAMES[29], frames)
                    self.assertIn(FRAMES[32], frames)
                else:
                    self.assertEqual(frames, FRAMES[:30] + FRAMES[31:], size)
                    place = 144 if contained else 144 + 30 * 48
                    self.assertRegex(said, f"^[12] damaged parts?, the first at byte {place}: ")

    def test_objects_go_on_in_the_next_container(self):
        objects = b"".join(map(blf_object, FRAMES))
        pieces = [objects[at:at + 100] for at in range(0, len(objects), 100)]
        self.expect(blf(b"".join(blf(piece)[144:] for piece in pieces), contained=False), FRAMES)

    def test_a_damaged_container_costs_that_container(self):
        containers = [blf(b"".join(map(blf_object, FRAMES[first:first + 20])))[144:] for first in (0, 20, 40)]
        damaged = bytearray(containers[1])
        damaged[60] ^= 4
        frames, said = self.read(blf(containers[0] + bytes(damaged) + containers[2], contained=False))
        self.assertEqual(frames, FRAMES[:20] + FRAMES[40:])
        self.assertTrue(said.startswith(f"1 damaged part, the first at byte {144 + len(containers[0])}: a container that cannot be "
                                        "unpacked (Error -3 while decompressing data: "), said)

    def test_the_size_that_a_container_states_does_not_matter(self):
        content = bytearray(blf(b"".join(map(blf_object, FRAMES))))
        content[144 + 24:144 + 28] = struct.pack("<L", 100)
        self.expect(bytes(content), FRAMES)

    def test_a_packed_container_without_its_end_spoils_no_other(self):
        objects = [blf(b"".join(map(blf_object, FRAMES[first:first + 30])))[144:] for first in (0, 30)]
        packed = objects[0][32:-20]
        short = struct.pack("<4sHHLLH6xL4x", b"LOBJ", 16, 1, 32 + len(packed), 10, 2, 30 * 48) + packed
        frames, said = self.read(blf(short + objects[1], contained=False))
        self.assertEqual(frames, FRAMES[:len(frames) - 30] + FRAMES[30:])
        self.assertGreater(len(frames), 40)
        self.assertRegex(said, r"^\d damaged parts?, the first at byte 144: a container that cannot be unpacked \(it was cut off\)")

    def test_a_cut_file_gives_what_is_there(self):
        whole = blf(b"".join(map(blf_object, FRAMES)), compressed=False)
        frames, said = self.read(whole[:-100])
        self.assertEqual(frames, FRAMES[:-3])
        self.assertEqual(said, "2 damaged parts, the first at byte 144: cut off in the middle of an object")
        packed = self.written("blf")
        frames, said = self.read(packed[:-40])
        self.assertEqual(frames, FRAMES[:len(frames)])
        self.assertGreater(len(frames), 20)
        self.assertIn("cut off", said)

    def test_other_objects_and_frames_are_counted(self):
        other = struct.pack("<4sHHLL16x", b"LOBJ", 32, 1, 40, 92).ljust(40, b"t")
        error = struct.pack("<4sHHLL16x", b"LOBJ", 32, 1, 56, 73).ljust(56, b"\0")
        remote, request = (blf_object(FRAMES[0], direction=flags) for flags in (0x80, 2))
        self.expect(blf(b"".join(map(blf_object, FRAMES)) + other + error + remote + request), FRAMES,
                    "1 error frames; 1 other objects than frames of CAN; 1 remote frames; 1 requests to send (TxRq)")

    def test_flexible_frames_are_those_of_python_can(self):
        import can

        frames = [frame._replace(flexible=True, bit_rate_switch=True, data=bytes(range(length)))
                  for frame, length in zip(FRAMES, (8, 12, 64, 20))]
        content = self.written("blf", frames)
        self.expect(content, frames)
        again = [bytes(message.data) for message in can.BLFReader(io.BytesIO(content))]
        self.assertEqual(again, [frame.data for frame in frames])


class Mf4(WithLogs):
    def made(self, without=(), invalid=()):
        import asammdf
        import numpy
        from asammdf.blocks import v4_blocks, v4_constants

        names = [name for name in bus_log_writers.FRAME_TYPE.names if name.rpartition(".")[2] not in without]
        file = self.folder / "made.mf4"
        with asammdf.MDF(self.written_file()) as mdf:
            samples, start_time = mdf.get("CAN_DataFrame").samples, mdf.header.start_time
        kept = numpy.zeros(len(samples), dtype=[(name, bus_log_writers.FRAME_TYPE[name]) for name in names])
        for name in names:
            kept[name] = samples[name]
        source = v4_blocks.SourceInformation(source_type=v4_constants.SOURCE_BUS, bus_type=v4_constants.BUS_TYPE_CAN)
        bits = numpy.isin(numpy.arange(len(samples)), invalid) if invalid else None
        mdf = asammdf.MDF(version="4.10")
        mdf.header.start_time = start_time
        mdf.append(asammdf.Signal(kept, numpy.array([frame.time_s for frame in FRAMES]), name="CAN_DataFrame", source=source,
                                  invalidation_bits=bits), comment="frames")
        mdf.save(file)
        mdf.close()
        return file.read_bytes()

    def written_file(self):
        self.written("mf4")
        return self.folder / "written.mf4"

    def test_without_a_length_the_length_code_counts(self):
        self.expect(self.made(without=("DataLength",)), FRAMES, "", "MF4")

    def test_frames_marked_as_invalid_are_left_out(self):
        self.expect(self.made(invalid=(3, 50)), FRAMES[:3] + FRAMES[4:50] + FRAMES[51:], "2 frames marked as invalid")

    def test_without_data_it_is_refused_with_the_reason(self):
        with self.assertRaisesRegex(LogError, "no frame of this MF4 can be read .*CAN_DataFrame lacks DataBytes"):
            self.read(self.made(without=("DataBytes",)))


class TablesOfFrames(WithLogs):
    def test_gvret(self):
        header = "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\n"
        rows = "".join(f"{round(frame.time_s * 1e6)},{frame.identifier:08X},false,Rx,0,8,{frame.data.hex(',').upper()},\n"
                       for frame in FRAMES)
        self.expect(header + rows, FRAMES, "", "CSV of frames")
        older = "Time Stamp,ID,Extended,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\r\n"
        self.expect(older + rows.replace("Rx,", "").replace("\n", "\r\n"), FRAMES)
        short = [frame._replace(data=frame.data[:2], extended=True) for frame in FRAMES]
        self.expect(header + "".join(f"{round(frame.time_s * 1e6)},{frame.identifier:08X},true,Rx,0,2,{frame.data.hex(',')}\n"
                                     for frame in short) + "77,00000120,false,Rx,0,4,01,02\n", short,
                    "1 damaged part, the first at line 62: the line cannot be understood (there are 2 of 4 bytes)")

    def test_a_missing_line_end_is_noticed(self):
        for header, row in (("Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2\n", "{},00000120,false,Rx,0,2,01,02,"),
                            ("TimestampEpoch,BusChannel,ID,IDE,DLC,DataBytes\n", "{},1,120,0,2,0102")):
            rows = [row.format(number) for number in (10, 20, 30, 40)]
            frames, said = self.read(header + "\n".join(rows[:2]) + "x" + "\n".join(rows[2:]) + "\n")
            self.assertEqual(len(frames), 2, header)
            self.assertRegex(said, "^1 damaged part, the first at line 3: the line cannot be understood")
            frames, said = self.read(header.replace("\n", ",") + "\n".join(rows) + "\n")
            self.assertEqual(len(frames), 3, header)
            self.assertEqual(said, "1 damaged part, the first at line 1: a row follows the names in their line")

    def test_python_can(self):
        rows = "".join(f"{frame.time_s!r},{frame.identifier:#x},0,0,0,8,{base64.b64encode(frame.data).decode()}\n" for frame in FRAMES)
        self.expect("timestamp,arbitration_id,extended,remote,error,dlc,data\n" + rows
                    + "0.7,0x120,0,1,0,8,\n0.7,0x120,0,0,1,0,\n0.7,0x120,0,0\n", FRAMES,
                    "1 error frames; 1 remote frames; 1 damaged part, the first at line 64: the line cannot be understood (not "
                    "enough values to unpack (expected 7, got 4))", "CSV of python-can")

    def test_canedge(self):
        header = "TimestampEpoch;BusChannel;ID;IDE;DLC;DataLength;Dir;EDL;BRS;ESI;RTR;DataBytes\n"
        rows = [f"{frame.time_s:.6f};1;{frame.identifier:X};0;8;8;0;0;0;0;0;{frame.data.hex().upper()}\n" for frame in FRAMES]
        others = "0.700000;1;120;0;8;8;0;0;0;0;1;\n0.700000;1;120;2;8;8;0;0;0;0;0;0011223344556677\n"
        said = ("1 remote frames; 1 damaged part, the first at line 63: the line cannot be understood (extended is '2')")
        text = header + "".join(rows) + others
        self.expect(text, FRAMES, said, "CSV of frames")
        self.expect(text.replace(";", ","), FRAMES, said)
        self.expect(text.replace(".", ","), FRAMES, said)

    def test_a_table_of_signals_is_none(self):
        for header in ("time,id,speed\n", "Time Stamp,Lateral Acc,ID\n", "# a remark\ntime_s;ay;data\n"):
            file = self.folder / "table.csv"
            file.write_text(header + "0,1,2\n", encoding="ascii")
            with self.assertRaisesRegex(LogError, "this is no log that can be read;"):
                BusLog(file)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
