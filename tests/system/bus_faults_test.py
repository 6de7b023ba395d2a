"""Every fault on the interface is answered as docs/reports/safety/faults_on_vcan.md says.

With --document PAGE writes that page instead: tests/system/faults_on_vcan."""

import sys
import unittest

import bus_faults
import bus_load_test
import programs

sys.path.append(str(programs.PROJECT / "cmake/environment"))

import file_io  # noqa: E402

PAGE = programs.PROJECT / "docs/reports/safety/faults_on_vcan.md"
TEXT = """<!-- Written by tests/system/faults_on_vcan; do not edit. -->
# Faults on a CAN interface

[The fault matrix](fault_matrix.md) is measured in one process. This page is measured between processes: `rsi-ecu` and
recorded sensor frames (a rough turn of 0.3 g) on `vcan0`, with the faults that only an interface and a kernel have.
`tests/run vcan` injects them all again. All times are in milliseconds. "ImuTimeout 30": that flag of `RolloverStatus`,
30 ms after the first frame that was missing or wrong. "back": from the end of the fault to the first state that is not
`unavailable`.

## Frames, in lock-step
Simulated time, so the answer is the same each time, and the test compares this table.

| fault | of | expected | measured |
|---|---|---|---|
{frames}

A constant delay of 20 ms leaves counter and receive time in order. Only a clock in the frame would show it. The code comes
when the delay ends and frames overtake each other.

## Bus and process, in real time
Times are the kernel's stamps in candump's log, in the small virtual machine. This is one run; others differ slightly. The
test judges in the ECU's own cycles, because the machine may delay them, and only requires that the ECU returns. If no frame
of the ECU is received, "silent" says for how long, and the other figures count from its first frame after that.

| fault | of | expected | measured |
|---|---|---|---|
{live}

- **bus-off, error-passive**: an error frame written onto `vcan0`, which has no controller; the restart takes the interface
  down and up. `System.bus_off` (`tests/run vcan`) covers a bus-off that a kernel driver reports, on a serial adapter
  played by the test. No wire and no silicon was involved.
- **process stopped, 2000 ms**: beyond 500 ms the watchdog ends `rsi-ecu` after one more cycle, which says `unavailable`.
  The supervisor that started it must start it again.

## 10,000 foreign frames a second
| filters | result |
|---|---|
| in the kernel, as always | {filtered} |
| none (`--receive-everything`) | {unfiltered} |

With filters no sensor frame and no frame of the ECU is lost. Without them the ECU reads 64 frames a cycle and the rest
overflows the socket's buffer: each is received or counted as lost, and `ReceiveOverflow` reports it. A second ECU on an
interface without flood shows what the machine does to a cycle of 10 ms anyway. `System.bus_load` requires what holds on
every machine: each frame is received or counted, and no frame of the ECU is lost. `System.bus_load_pace`
(`tests/run real_time`, for a machine that does nothing else) requires that the ECU in the flood misses no more than 2 % of
its cycles and twice what the second one misses, in one of four tries: the processor of this virtual machine is emulated,
shared with the sender of the flood, and stops whenever its host is busy. **It does not show that no cycle is missed.** That
needs a target with a CAN interface of its own.
"""


class Faults(unittest.TestCase):
    def test_every_fault_of_a_frame_is_answered_as_expected_and_as_the_page_says(self):
        page = PAGE.read_text(encoding="utf-8")
        for fault in bus_faults.FRAME_FAULTS:
            with self.subTest(fault=fault.name, of=fault.place):
                got, wrong = bus_faults.run(fault)
                self.assertEqual(wrong, [], bus_faults.cell(got, wrong))
                self.assertIn(bus_faults.row(fault, got, wrong), page, "renew the page: tests/system/faults_on_vcan")

    def test_every_fault_of_bus_and_process_is_answered_as_expected(self):
        for fault in bus_faults.LIVE_FAULTS:
            with self.subTest(fault=fault.name):
                got, wrong = bus_faults.run(fault)
                print(bus_faults.row(fault, got, wrong))
                self.assertEqual(wrong, [], bus_faults.cell(got, wrong))


def table(faults):
    return "\n".join(bus_faults.row(fault, *bus_faults.run(fault)) for fault in faults)


def document(path):
    bus_load_test.setUpModule()
    held, fast_enough = bus_load_test.FloodedRun.cycle_held, bus_load_test.FloodedRun.flood_was_fast_enough
    page = TEXT.format(
        frames=table(bus_faults.FRAME_FAULTS),
        live=table(bus_faults.LIVE_FAULTS),
        filtered=bus_load_test.flooded_run(good=held).describe(),
        unfiltered=bus_load_test.flooded_run("--receive-everything", good=fast_enough).describe(),
    )
    file_io.write(path, page)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--document"]:
        document(sys.argv[2])
    else:
        unittest.main()
