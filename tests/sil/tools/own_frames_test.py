"""Logs of the project's own frames in every container: the candump log comes out as it was, and replays as it did."""

import support

import bus_log_writers
import bus_logs


class OwnFrames(support.WithRun):
    def written(self, kind, change=lambda frame: [frame]):
        """The run's log in another container, its frames changed."""
        file = self.folder / f"drive.{kind}"
        frames = (new for frame in bus_logs.BusLog(self.original).frames() for new in change(frame))
        getattr(bus_log_writers, f"write_{kind}")(file, frames)
        return file

    def converted(self, file, *options):
        self.logs("convert", file, "--output", self.folder / file.suffix[1:], *options)
        return self.folder / file.suffix[1:] / "drive.log"

    def test_every_container_gives_the_same_log_and_the_same_warnings(self):
        text = self.original.read_text(encoding="ascii")
        warnings = self.replay(self.original)
        self.assertIn("warning,right", warnings)
        for kind, name in (("blf", "BLF"), ("asc", "ASC"), ("mf4", "MF4"), ("candump", "candump")):
            file = self.written(kind)
            self.assertEqual(bus_logs.BusLog(file).kind, name)
            log = self.converted(file)
            self.assertEqual(log.read_text(encoding="ascii").replace(" can0 ", " vcan0 "), text, kind)
            self.assertEqual(self.replay(log), warnings, kind)

    def test_calendar_times_stay(self):
        start_s = 1_700_000_000.123456
        moved = lambda frame: [frame._replace(time_s=frame.time_s + start_s)]
        lines = self.converted(self.written("candump", moved)).read_text(encoding="ascii").replace("vcan0", "can0")
        self.assertTrue(lines.startswith("(1700000000.123456) "))
        for kind in ("blf", "mf4"):
            self.assertEqual(self.converted(self.written(kind, moved)).read_text(encoding="ascii"), lines, kind)

    def test_extended_and_flexible_frames_stay(self):
        def with_others(frame):
            return [frame, frame._replace(identifier=0x18FEF100, extended=True),
                    frame._replace(identifier=0x321, flexible=True, bit_rate_switch=True, data=bytes(range(24)))]

        lines = self.converted(self.written("candump", with_others)).read_text(encoding="ascii").replace("vcan0", "can0")
        self.assertIn(" 18FEF100#", lines)
        self.assertIn(" 321##1000102", lines)
        for kind in ("blf", "asc", "mf4"):
            self.assertEqual(self.converted(self.written(kind, with_others)).read_text(encoding="ascii"), lines, kind)

    def test_a_recorder_of_two_buses_is_asked_for_one(self):
        both = lambda frame: [frame._replace(bus=1), frame._replace(bus=2)]
        for kind in ("blf", "asc", "mf4"):
            file = self.written(kind, both)
            self.refused(f"{file}: Imu comes on the buses 1 and 2; choose one with --bus 1", "convert", file, "--output",
                         self.folder / "none")
            self.assertEqual(list((self.folder / "none").iterdir()), [])
            self.assertEqual(self.converted(file, "--bus", "2").read_text(encoding="ascii"),
                             self.original.read_text(encoding="ascii").replace(" vcan0 ", " can1 "))
            self.refused(f"{file}: there is none of this project's sensor frames (0x120, 0x121, 0x122, 0x123) on bus 7 (there "
                         "are: 1, 2); ", "convert", file, "--output", self.folder / "none", "--bus", "7")

    def test_bad_logs_are_refused_with_the_place(self):
        def refused(content, expected, name="bad.log"):
            file = self.folder / name
            file.write_bytes(content)
            self.refused(f"{file}{expected}", "convert", file, "--output", self.folder / "none")
            self.assertEqual(list((self.folder / "none").glob("*")), [])

        refused(b"", ": the file is empty; ")
        refused(b"time_s,speed_kmh\n0.0,50.0\n", ": this is no log that can be read; there are MF4, BLF, ASC and ")
        refused(b"(0.010000) can0 120#A\n", ": no frame of this candump can be read (1 damaged part, the first at line 1: it is no "
                                            "line of `candump -L`, ")
        refused(b"(0.010000) can0 120#AABB", ": no frame of this candump can be read (1 damaged part, the first at line 1: it has "
                                             "no line end: the file was cut off); ")
        refused(b"(0.010000) can0 7FF#AABB\n", ": there is none of this project's sensor frames (0x120, ")
        blf = self.written("blf").read_bytes()
        refused(blf[:100], ": the BLF was cut off within its header; ")
        refused(blf[:150], ": no frame of this BLF can be read (1 damaged part, the first at byte 144: cut off); ")
        asc = self.written("asc").read_text(encoding="ascii")
        refused(asc.replace("absolute", "relative").encode("ascii"), ":2: the times are relative, ")
        mf4 = self.written("mf4").read_bytes()
        refused(mf4[:len(mf4) // 2], ": the MF4 is damaged (")
        self.refused(f"{self.folder}: cannot be read: it is a folder", "convert", self.folder, "--output", self.folder / "none")

    def test_the_end_that_is_missing_is_said(self):
        whole = self.written("blf")
        cut = self.folder / "cut" / "drive.blf"
        cut.parent.mkdir()
        cut.write_bytes(whole.read_bytes()[:-1000])
        said = self.logs("convert", cut, "--output", cut.parent)
        self.assertRegex(said, rf"^{cut}: left out: 3 damaged parts, the first at byte \d+: cut off in the middle of an object\n")
        lines = (cut.parent / "drive.log").read_text(encoding="ascii").splitlines()
        self.assertEqual(lines, self.original.read_text(encoding="ascii").replace("vcan0", "can0").splitlines()[:len(lines)])
        self.assertGreater(len(lines), 800)

    def test_a_log_is_not_replaced_by_its_result(self):
        log = self.folder / "drive.log"
        log.write_bytes(self.original.read_bytes())
        self.refused(f"{log}: the result would take its place; ", "convert", log, "--output", self.folder)
        self.assertEqual(log.read_bytes(), self.original.read_bytes())


if __name__ == "__main__":
    support.main()
