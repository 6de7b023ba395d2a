"""pyxcp, by the A2L, against the firmware in a drive: unlock, read, change while the vehicle turns, switch, store, measure."""

import pathlib
import struct
import subprocess
import sys
import tempfile
import tomllib
import unittest

sys.dont_write_bytecode = True
A2L = pathlib.Path(sys.argv.pop(1))
PROGRAM = sys.argv.pop(1)
PROJECT = pathlib.Path(__file__).resolve().parents[4]
sys.path[1:1] = [str(PROJECT / "sil/tools"), str(PROJECT / "cmake/environment")]

import a2l_objects  # noqa: E402
import asammdf  # noqa: E402
import calibration  # noqa: E402
import pyxcp.types  # noqa: E402
import simulated_bus  # noqa: E402
import xcp_session  # noqa: E402
from log_error import LogError  # noqa: E402
from xcp_session import ECU, MASTER, REFERENCE, WORKING  # noqa: E402

CALIBRATION = tomllib.loads((PROJECT / "firmware/calibrations/large_suv.toml").read_text())
LOWER = 0.8125  # of warning_on; a float has it exactly
DRIVE = ("j-turn-110", 4.0)
FRAMES_OF_THE_ECU = 8
WARNING = 3


def flat(table):
    for name, value in table.items():
        if isinstance(value, dict):
            yield from flat(value)
        else:
            yield name, value


def as_float(value):
    return struct.unpack("<f", struct.pack("<f", value))[0]


class PyXcp(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.a2l = a2l_objects.read(A2L)
        cls.parameters = [name for name, entry in cls.a2l.objects.items() if entry.is_parameter]

    def setUp(self):
        self.bus = simulated_bus.SimulatedBus(PROGRAM)
        self.addCleanup(self.bus.end)
        self.bus.drive(*DRIVE)

    def session(self, key=xcp_session.TEST_KEY):
        return xcp_session.Session(self.a2l, simulated_bus.Interface(self.bus), key)

    def undisturbed(self):
        """The whole drive without a master, and a new one begun."""
        self.bus.finish()
        cycles = self.bus.cycles
        self.bus.drive(*DRIVE)
        return cycles

    def first(self, cycles, state):
        return next(cycle.number for cycle in cycles if cycle.state == state)

    def refusal(self, command, *arguments):
        with self.assertRaises(pyxcp.types.XcpResponseError) as caught:
            command(*arguments)
        return str(caught.exception)

    def test_reads_every_parameter_where_the_a2l_says(self):
        with self.session() as session:
            self.assertEqual(session.xcp.identifier(0x01), A2L.stem)
            seen = 0
            for name, value in flat(CALIBRATION):
                if name in self.a2l.objects:
                    self.assertEqual(session.read(name), value if isinstance(value, str) else as_float(value), name)
                    seen += 1
            self.assertEqual(seen, len(self.parameters))

    def test_an_a2l_of_another_version_is_refused(self):
        other = a2l_objects.File(**{**vars(self.a2l), "epk": self.a2l.epk.replace("rsi", "RSI")})
        with self.assertRaisesRegex(LogError, "of another version"):
            xcp_session.Session(other, simulated_bus.Interface(self.bus)).__enter__()

    def test_changes_nothing_without_the_key(self):
        with self.session() as session, self.assertRaisesRegex(LogError, "ERR_ACCESS_LOCKED"):
            session.write({"warning_on": "0.8"})
        with self.session(bytes(16)) as session, self.assertRaisesRegex(LogError, "the key is wrong"):
            session.unlock()

    def test_an_earlier_warning_comes_earlier_in_the_same_drive(self):
        before = self.undisturbed()
        with self.session() as session:
            session.unlock()
            self.bus.run(self.first(before, WARNING) - 20 - len(self.bus.cycles))
            session.write({"warning_on": str(LOWER)})
            self.bus.finish()
        changed = self.bus.cycles[:len(before)]
        self.assertLess(self.first(changed, WARNING), self.first(before, WARNING))
        self.assertEqual([cycle.number for cycle in changed], list(range(len(before))))  # none is lost
        self.assertEqual({cycle.frames for cycle in changed}, {FRAMES_OF_THE_ECU})
        # No other output has moved by a bit.
        self.assertEqual([cycle.numbers for cycle in changed], [cycle.numbers for cycle in before])

    def test_a_refused_value_names_its_field_and_changes_nothing(self):
        before = self.undisturbed()
        with self.session() as session:
            session.unlock()
            with self.assertRaisesRegex(LogError, "refused for warning_on"):
                session.write({"warning_on": "1.3"})
            with self.assertRaisesRegex(LogError, "not a number"):
                session.write({"warning_on": "much"})
            with self.assertRaisesRegex(LogError, "not one of its choices"):
                session.write({"warning_indicator": "luck"})
            self.assertEqual(session.differences(), {})
            self.bus.finish()
        self.assertEqual([(cycle.state, cycle.side, cycle.numbers) for cycle in self.bus.cycles[:len(before)]],
                         [(cycle.state, cycle.side, cycle.numbers) for cycle in before])

    def test_several_values_are_taken_over_at_once(self):
        with self.session() as session:
            session.unlock()
            session.write({"advisory_on": "0.5", "advisory_off": "0.25", "warning_on": "0.75", "warning_off": "0.5"})
            self.assertEqual(session.read("page_in_use"), "working")
            self.assertEqual(set(session.differences()), {"advisory_on", "advisory_off", "warning_on", "warning_off"})
            with self.assertRaisesRegex(LogError, "refused for advisory_on"):
                session.write({"advisory_on": "0.875", "warning_hold_s": "1.5"})
            self.assertEqual(session.read("advisory_on"), 0.5)
            self.assertEqual(session.read("warning_hold_s"), dict(flat(CALIBRATION))["warning_hold_s"])
            session.reset()
            self.assertEqual(session.differences(), {})

    def test_a_change_that_is_broken_off_leaves_all_as_it_was(self):
        good = dict(flat(CALIBRATION))
        with self.session() as session:
            session.unlock()
            for second, problem in (("warning_off=abc", "not a number"), ("state=ready", "is an output"), ("paint=1", "no paint")):
                name, text = second.split("=")
                with self.assertRaisesRegex(LogError, problem):
                    session.write({"warning_on": str(LOWER), name: text})
            ask, asked = session.xcp.download, []

            def download(data):
                asked.append(data)
                if len(asked) == 2:
                    raise KeyboardInterrupt
                return ask(data)

            session.xcp.download = download
            with self.assertRaises(KeyboardInterrupt):
                session.write({"warning_off": "0.5", "warning_on": str(LOWER)})
            session.xcp.download = ask
            self.assertEqual(len(asked), 4)  # one of two, and both put back
            self.assertEqual(session.read("page_in_use"), "working")
            self.assertEqual(session.differences(), {})
            self.assertEqual(session.read("warning_on"), as_float(good["warning_on"]))

    def test_nothing_is_written_while_the_ecu_works_with_the_reference_page(self):
        with self.session() as session:
            session.unlock()
            session.use("reference")
            self.assertEqual(session.read("page_in_use"), "reference")
            with self.assertRaisesRegex(LogError, "calibrate use working"):
                session.write({"warning_on": str(LOWER)})
            session.use("working")
            session.write({"warning_on": str(LOWER)})
            self.assertEqual(session.read("warning_on"), LOWER)

    def test_pages_checksum_and_store(self):
        good = as_float(dict(flat(CALIBRATION))["warning_on"])
        begin = min(self.a2l.objects[name].address for name in self.parameters)
        length = 4 * len(self.parameters)
        with self.session() as session:
            xcp = session.xcp
            session.unlock()
            session.write({"warning_on": str(LOWER)})
            xcp.setMta(begin)
            working = xcp.buildChecksum(length)
            self.assertEqual(str(working.checksumType), "XCP_CRC_32")
            xcp.setCalPage(ECU | MASTER, 0, REFERENCE)
            self.assertEqual(session.read("warning_on"), good)
            self.assertEqual(session.read("page_in_use"), "reference")
            xcp.setMta(begin)
            self.assertNotEqual(xcp.buildChecksum(length).checksum, working.checksum)
            self.assertIn("ERR_WRITE_PROTECTED", self.refusal(xcp.download, bytes(4)))
            xcp.setCalPage(ECU | MASTER, 0, WORKING)
            self.assertEqual(session.read("warning_on"), LOWER)
            xcp.setSegmentMode(1, 0)
            session.store()
        self.bus.drive(*DRIVE)  # power off and on
        with self.session() as session:
            session.unlock()
            self.assertEqual(session.differences(), {"warning_on": (good, LOWER)})

    def test_twenty_values_at_100_hz_for_a_minute_without_a_gap(self):
        outputs = [entry for entry in self.a2l.objects.values() if not entry.is_parameter]
        names = [entry.name for entry in outputs if entry.form == "<f"][:15] + [
            entry.name for entry in outputs if entry.form == "<B"][:5]
        self.assertEqual(len(names), 20)
        self.bus.drive("straight", 70.0)
        with self.session() as session:
            session.unlock()
            times, columns = session.measure(names, lambda: self.bus.run(6000))
            self.assertEqual(session.samples.overloads, 0)
            seen = session.read("lateral_acceleration_threshold_mps2")
        self.assertGreaterEqual(len(times), 6000)
        self.assertEqual([round(time / 0.01) for time in times], list(range(len(times))))
        self.assertEqual({cycle.frames for cycle in self.bus.cycles}, {FRAMES_OF_THE_ECU})
        self.assertEqual({len(column) for column in columns.values()}, {len(times)})
        self.assertEqual(set(columns["state"]), {1})
        # The same value as an upload reads a moment later, on a straight road.
        self.assertAlmostEqual(columns["lateral_acceleration_threshold_mps2"][-1], seen, delta=0.1)
        begin = self.bus.samples[0][0]
        parts = {number: 0 for number, _ in self.bus.samples}
        for number, _ in self.bus.samples:
            parts[number] += 1
        self.assertEqual(list(parts), list(range(begin, begin + len(parts))))
        self.assertLessEqual(max(parts.values()), 20)
        self.assertEqual(len(set(parts.values())), 1)

    def test_measures_into_csv_and_mf4(self):
        names = ["state", "warning_level", "rsi"]
        for ending in (".csv", ".mf4"):
            self.bus.drive(*DRIVE)
            with tempfile.TemporaryDirectory() as folder, self.session() as session:
                session.unlock()
                path = pathlib.Path(folder) / f"run{ending}"
                options = calibration.parse(["measure", *names, "--seconds", "3", "--output", str(path)])
                calibration.measure(session, options, lambda seconds: self.bus.run(round(100 * seconds)))
                self.assertEqual([entry.name for entry in pathlib.Path(folder).iterdir()], [path.name])
                if ending == ".csv":
                    rows = [line.split(",") for line in path.read_text().splitlines()]
                    self.assertEqual(rows[0], ["time_s", *names])
                    told = [[float(row[at]) for row in rows[1:]] for at in range(1, 4)]
                else:
                    with asammdf.MDF(path) as measured:
                        told = [list(measured.get(name).samples) for name in names]
                        self.assertEqual(measured.get("state").comment, self.a2l.objects["state"].text)
            first = self.bus.samples[0][0]
            states = [cycle.state for cycle in self.bus.cycles if cycle.number >= first]
            self.assertEqual([int(value) for value in told[0]], states[:len(told[0])])
            self.assertGreaterEqual(len(told[0]), 250)
            self.assertIn(WARNING, told[0])
            self.assertEqual([len(column) for column in told], [len(told[0])] * 3)


    def test_measures_into_a_picture(self):
        names = ["state", "warning_level"]
        with tempfile.TemporaryDirectory() as folder, self.session() as session:
            session.unlock()
            path = pathlib.Path(folder) / "it's measured.png"
            options = calibration.parse(["measure", *names, "--seconds", "1", "--output", str(path)])
            calibration.measure(session, options, lambda seconds: self.bus.run(round(100 * seconds)))
            self.assertEqual([entry.name for entry in pathlib.Path(folder).iterdir()], [path.name])
            width, height = struct.unpack(">II", path.read_bytes()[16:24])
            self.assertEqual((width, height), (1000, 50 + 170 * len(names)))
            options.output = pathlib.Path(folder) / "nosuch" / "a.png"
            with self.assertRaisesRegex(LogError, "was not drawn"):
                calibration.measure(session, options, lambda seconds: self.bus.run(round(100 * seconds)))


class TheCommand(unittest.TestCase):
    def run_it(self, *arguments):
        return subprocess.run([PROJECT / "sil/tools/calibrate", *arguments], capture_output=True, text=True, check=False)

    def test_explains_itself_and_refuses_what_it_does_not_know(self):
        self.assertEqual(self.run_it("--help").returncode, 0)
        for wrong in (["paint"], [], ["read", "--paint"], ["write", "warning_on"], ["measure", "rsi", "--seconds", "0",
                      "--output", "a.csv"], ["measure", "rsi", "--seconds", "1", "--output", "a.txt"], ["store", "--after", "-1"]):
            self.assertEqual(self.run_it(*wrong).returncode, 2, wrong)

    def test_says_what_is_wrong_with_the_interface_and_the_a2l(self):
        finished = self.run_it("read", "--interface", "nosuch", "--a2l", str(A2L))
        self.assertEqual((finished.returncode, finished.stdout), (1, ""))
        self.assertRegex(finished.stderr, r"^sil/tools/calibrate: the interface cannot be used: .*\n$")
        finished = self.run_it("read", "--a2l", "/nowhere.a2l")
        self.assertRegex(finished.stderr, r"^sil/tools/calibrate: there is no /nowhere.a2l; make it: .*\n$")


if __name__ == "__main__":
    unittest.main()
