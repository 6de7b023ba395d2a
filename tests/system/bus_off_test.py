"""rsi-ecu on a CAN controller that goes error-passive and bus-off, as the kernel's driver of a serial adapter sees it.

A virtual CAN interface has no controller, so this needs a kernel with the driver (slcan) and the right to use it."""

import tempfile
import threading
import time
import unittest

import programs
import serial_line_adapter

READY = 1

# Error frames (linux/can/error.h).
CONTROLLER_PROBLEM = "20000204"  # with the error counters
BUS_OFF = "20000040"
# Frames that the ECU has sent may still come out of driver and line so long after the kernel's report.
ON_ITS_WAY_S = 0.05


def has_bus_error(data):
    """Bit 29 of RolloverStatus."""
    return bool(int(data[6:8], 16) & 0x20)


def passive_reported(frames):
    """Seconds from the kernel's report to the first status that tells of it."""
    start = next(time for time, identifier, data in frames if identifier == CONTROLLER_PROBLEM)
    return next(
        time - start
        for time, identifier, data in frames
        if identifier == programs.STATUS_IDENTIFIER and time > start and has_bus_error(data)
    )


def silences_after_bus_off(frames):
    """Seconds from each bus-off to the ECU's next frame, not counting what was on its way at the bus-off."""
    warnings = [time for time, identifier, _ in frames if identifier == programs.WARNING_IDENTIFIER]
    silences = []
    for start in (time for time, identifier, _ in frames if identifier == BUS_OFF):
        arrived = start + ON_ITS_WAY_S
        last = max((time for time in warnings if start < time <= arrived), default=start)
        silences.append(next(time for time in warnings if time > arrived) - last)
    return silences


class Sensors:
    """Recorded sensor frames, one cycle every 10 ms, over and over, while `on`."""

    def __init__(self, adapter):
        log = programs.read_log(programs.PROJECT / "tests/application/regression/logs/straight-noise.sensors.log")
        frames = [frame for frame in log if frame[1] in programs.SENSOR_IDENTIFIERS]
        self.on = True
        self._ended = False
        self._thread = threading.Thread(target=self._send, args=(adapter, frames), daemon=True)
        self._thread.start()

    def end(self):
        self._ended = True
        self._thread.join()

    def _send(self, adapter, frames):
        while not self._ended:
            for start in range(0, len(frames), 3):
                if self._ended:
                    return
                if self.on:
                    for _, identifier, data in frames[start : start + 3]:
                        adapter.put_frame(identifier, data)
                time.sleep(0.01)


class BusOff(unittest.TestCase):
    def setUp(self):
        self.adapter = serial_line_adapter.Adapter()
        self.addCleanup(self.adapter.close)
        programs.INTERFACE = self.adapter.interface

    def wait_for(self, what, seconds, condition):
        """Every frame received from now on is offered to `condition`; the first that it takes is returned."""
        seen = len(self.adapter.received)
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            while seen < len(self.adapter.received):
                frame = self.adapter.received[seen]
                seen += 1
                if condition(frame):
                    return frame
            time.sleep(0.001)
        self.fail(f"within {seconds} s there was no {what}; last received: {self.adapter.received[-3:]}")

    def wait_for_ready(self):
        return self.wait_for(
            "state ready", programs.LONGEST_S,
            lambda frame: frame[1] == programs.WARNING_IDENTIFIER and programs.state_of(frame[2]) == READY,
        )

    def wait_for_status(self, bus_error):
        return self.wait_for(
            f"status with BusError {bus_error}", programs.LONGEST_S,
            lambda frame: frame[1] == programs.STATUS_IDENTIFIER and has_bus_error(frame[2]) == bus_error,
        )

    def go_bus_off(self):
        """Bus-off, until the ECU is back and tells of it, which it cannot do before."""
        self.wait_for_status(bus_error=False)
        self.adapter.put_state("b", 256, 256)
        self.wait_for_status(bus_error=True)

    def drive(self):
        """Error-passive and back; twice bus-off while nothing else is received; once again in the midst of frames."""
        sensors = Sensors(self.adapter)
        self.addCleanup(sensors.end)
        self.wait_for_ready()
        self.wait_for_status(bus_error=False)
        self.adapter.put_state("p", 128, 0)
        self.wait_for_status(bus_error=True)
        self.adapter.put_state("a", 0, 0)
        sensors.on = False
        self.go_bus_off()
        self.go_bus_off()
        sensors.on = True
        self.wait_for_ready()
        self.go_bus_off()
        self.wait_for_ready()

    def test_the_controller_is_restarted_and_the_ecu_says_what_happened(self):
        with tempfile.NamedTemporaryFile() as log, programs.Candump(log.name, programs.ALL_AND_ERRORS, "-D") as candump:
            with programs.Ecu() as ecu:
                self.drive()
                exit_status = ecu.stop()
            frames = candump.stop()
        passive, silences = passive_reported(frames), silences_after_bus_off(frames)
        print(f"error-passive told after {1000 * passive:.1f} ms")
        print("silent after bus-off for", ", ".join(f"{1000 * silence:.1f}" for silence in silences), "ms")
        print(ecu.output)

        self.assertEqual(exit_status, 0)
        self.assertEqual(self.adapter.times_bus_off(), 3)
        # The schedule of rsi::hal::BusOffSchedule: 100 ms; 200 ms, because nothing was received in between; 100 ms.
        self.assertEqual([silence >= least for silence, least in zip(silences, (0.1, 0.2, 0.1))], 3 * [True])
        self.assertIn(f"{self.adapter.interface} is error-passive", ecu.output)
        self.assertIn(f"{self.adapter.interface} is bus-off", ecu.output)
        self.assertIn("3 times bus-off, 3 restarts", ecu.output)


if __name__ == "__main__":
    unittest.main()
