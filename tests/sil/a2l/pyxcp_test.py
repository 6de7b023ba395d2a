"""pyxcp, by the A2L, against the firmware in a drive: unlock, read, change while the vehicle turns, switch, store, measure."""

import pathlib
import re
import struct
import sys
import tomllib
import unittest

sys.dont_write_bytecode = True
import a2l_file  # noqa: E402
import pyxcp.types  # noqa: E402
import simulated_bus  # noqa: E402
from pyxcp.daq_stim import DaqList, DaqProcessor  # noqa: E402

A2L = pathlib.Path(sys.argv.pop(1))
PROGRAM = sys.argv.pop(1)
PROJECT = pathlib.Path(__file__).resolve().parents[3]
CALIBRATION = tomllib.loads((PROJECT / "firmware/calibrations/large_suv.toml").read_text())
LOWER = 0.8125  # of warning_on; a float has it exactly
DRIVE = ("j-turn-110", 4.0)
FRAMES_OF_THE_ECU = 8
READY, WARNING = 1, 3
WORKING, REFERENCE = 0, 1
ECU, XCP = 0x01, 0x02


def flat(table):
    for name, value in table.items():
        if isinstance(value, dict):
            yield from flat(value)
        else:
            yield name, value


class PyXcp(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        module = a2l_file.parsed(A2L)
        cls.objects = a2l_file.objects(module)
        cls.epk = module["MOD_PAR"]["EPK"]["Identifier"]["Value"]
        cls.epk_at = int(module["MOD_PAR"]["ADDR_EPK"][0]["Address"]["Value"])
        cls.choices = {entry["Name"]["Value"]: [pair["OutVal"]["Value"] for pair in entry["InValOutVal"]]
                       for entry in module["COMPU_VTAB"]}

    def setUp(self):
        self.bus = simulated_bus.SimulatedBus(PROGRAM)
        self.addCleanup(self.bus.end)
        self.bus.drive(*DRIVE)

    def read(self, xcp, name):
        entry = self.objects[name]
        form = {"RL_value": "<f", "RL_selection": "<I", "FLOAT32_IEEE": "<f", "UBYTE": "<B", "ULONG": "<I"}[entry.data_type]
        return struct.unpack(form, xcp.shortUpload(struct.calcsize(form), entry.address))[0]

    def write(self, xcp, name, value):
        entry = self.objects[name]
        self.assertEqual(entry.kind, "CHARACTERISTIC")
        xcp.setMta(entry.address)
        xcp.download(struct.pack("<f" if entry.data_type == "RL_value" else "<I", value))

    def refused(self, xcp):
        return self.choices["VT_refused_parameter"][self.read(xcp, "refused_parameter")]

    def undisturbed(self):
        """The whole drive without a master."""
        self.bus.drive(*DRIVE)
        self.bus.run(10000)
        return self.bus.cycles

    def first(self, cycles, state):
        return next(cycle.number for cycle in cycles if cycle.state == state)

    def test_reads_every_parameter_and_the_epk_where_the_a2l_says(self):
        with simulated_bus.master(self.bus) as xcp:
            xcp.connect()
            self.assertEqual(xcp.identifier(0x01), A2L.stem)
            xcp.setMta(self.epk_at)
            self.assertEqual(xcp.fetch(len(self.epk)).decode(), self.epk)
            seen = 0
            for name, value in flat(CALIBRATION):
                if name not in self.objects:
                    continue
                read = self.read(xcp, name)
                if isinstance(value, str):
                    self.assertEqual(self.choices[f"VT_{name}"][read], value, name)
                else:
                    self.assertEqual(read, struct.unpack("<f", struct.pack("<f", value))[0], name)
                seen += 1
            self.assertEqual(seen, sum(entry.kind == "CHARACTERISTIC" for entry in self.objects.values()))
            xcp.disconnect()

    def test_changes_nothing_without_the_key(self):
        with simulated_bus.master(self.bus) as xcp:
            xcp.connect()
            with self.assertRaises(pyxcp.types.XcpResponseError) as caught:
                self.write(xcp, "warning_on", 0.8)
            self.assertIn("ERR_ACCESS_LOCKED", str(caught.exception))
            xcp.disconnect()

    def test_an_earlier_warning_comes_earlier_in_the_same_drive(self):
        before = self.undisturbed()
        self.bus.drive(*DRIVE)
        with simulated_bus.master(self.bus) as xcp:
            xcp.connect()
            simulated_bus.unlock(xcp)
            self.bus.run(self.first(before, WARNING) - 20 - len(self.bus.cycles))
            self.assertEqual(self.bus.cycles[-1].state, before[len(self.bus.cycles) - 1].state)
            self.write(xcp, "warning_on", LOWER)
            self.bus.run(10000)
        changed = self.bus.cycles
        self.assertLess(self.first(changed, WARNING), self.first(before, WARNING))
        self.assertEqual(len(changed), len(before))
        self.assertEqual([cycle.number for cycle in changed], list(range(len(before))))  # none is lost
        self.assertEqual({cycle.frames for cycle in changed}, {FRAMES_OF_THE_ECU})
        # No other output has moved by a bit.
        self.assertEqual([cycle.numbers for cycle in changed], [cycle.numbers for cycle in before])

    def test_a_refused_value_names_its_field_and_changes_nothing(self):
        before = self.undisturbed()
        self.bus.drive(*DRIVE)
        with simulated_bus.master(self.bus) as xcp:
            xcp.connect()
            simulated_bus.unlock(xcp)
            self.write(xcp, "warning_on", 1.3)
            self.assertEqual(self.refused(xcp), "warning_on")
            self.bus.run(10000)
        self.assertEqual([(cycle.state, cycle.side, cycle.numbers) for cycle in self.bus.cycles],
                         [(cycle.state, cycle.side, cycle.numbers) for cycle in before])

    def test_pages_checksum_and_store(self):
        good = struct.unpack("<f", struct.pack("<f", dict(flat(CALIBRATION))["warning_on"]))[0]
        parameters = min(entry.address for entry in self.objects.values() if entry.kind == "CHARACTERISTIC")
        length = 4 * sum(entry.kind == "CHARACTERISTIC" for entry in self.objects.values())
        with simulated_bus.master(self.bus) as xcp:
            xcp.connect()
            simulated_bus.unlock(xcp)
            self.write(xcp, "warning_on", LOWER)
            xcp.setMta(parameters)
            working = xcp.buildChecksum(length)
            self.assertEqual(str(working.checksumType), "XCP_CRC_32")
            xcp.setCalPage(ECU | XCP, 0, REFERENCE)
            self.assertEqual(self.read(xcp, "warning_on"), good)
            self.assertEqual(self.read(xcp, "page_in_use"), REFERENCE)
            xcp.setMta(parameters)
            self.assertNotEqual(xcp.buildChecksum(length).checksum, working.checksum)
            with self.assertRaises(pyxcp.types.XcpResponseError) as caught:
                self.write(xcp, "warning_on", 0.7)
            self.assertIn("ERR_WRITE_PROTECTED", str(caught.exception))
            xcp.setCalPage(ECU | XCP, 0, WORKING)
            self.assertEqual(self.read(xcp, "warning_on"), LOWER)
            xcp.setSegmentMode(1, 0)
            xcp.setRequest(0x01, 0)
            xcp.disconnect()
        self.bus.drive(*DRIVE)  # power off and on
        with simulated_bus.master(self.bus) as xcp:
            xcp.connect()
            self.assertEqual(self.read(xcp, "warning_on"), LOWER)
            simulated_bus.unlock(xcp)
            xcp.copyCalPage(0, REFERENCE, 0, WORKING)
            self.assertEqual(self.read(xcp, "warning_on"), good)
            xcp.disconnect()

    def test_twenty_values_at_100_hz_without_a_gap(self):
        names = [name for name, entry in self.objects.items() if entry.kind == "MEASUREMENT"][:25]
        floats = [name for name in names if self.objects[name].data_type == "FLOAT32_IEEE"][:15]
        codes = [name for name in names if self.objects[name].data_type == "UBYTE"][:5]
        kinds = {"FLOAT32_IEEE": "F32", "UBYTE": "U8"}
        measured = [(name, self.objects[name].address, 0, kinds[self.objects[name].data_type]) for name in floats + codes]
        self.assertEqual(len(measured), 20)
        self.bus.drive("straight", 70.0)
        processor = DaqProcessor([DaqList(name="all", event_num=0, stim=False, enable_timestamps=True, measurements=measured,
                                          priority=0, prescaler=1)])
        with simulated_bus.master(self.bus) as xcp:
            processor.xcp_master = xcp
            processor.set_parameters = lambda _parameters: None
            xcp.connect()
            simulated_bus.unlock(xcp)
            processor.setup()
            processor.start()
            begin = self.bus.cycles[-1].number
            self.bus.run(6000)
            processor.stop()
            xcp.disconnect()
        parts = len({data[0] for _, data in self.bus.samples})
        by_cycle = {}
        for number, data in self.bus.samples:
            by_cycle.setdefault(number, []).append(data[0])
        numbers = sorted(by_cycle)
        self.assertEqual(numbers[0], begin)
        self.assertGreaterEqual(len(numbers), 6000)
        self.assertEqual(numbers, list(range(begin, begin + len(numbers))))
        self.assertEqual({tuple(found) for found in by_cycle.values()}, {tuple(range(parts))})
        self.assertLessEqual(parts, 20)
        self.assertEqual({cycle.frames for cycle in self.bus.cycles}, {FRAMES_OF_THE_ECU})
        stamps = [struct.unpack("<H", data[1:3])[0] for _, data in self.bus.samples if data[0] == 0]
        self.assertEqual({(after - one) % 65536 for one, after in zip(stamps, stamps[1:])}, {100})


if __name__ == "__main__":
    unittest.main()
