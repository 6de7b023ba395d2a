"""The programs under test and what listens to them: started, watched and ended by the tests of this folder."""

import functools
import os
import pathlib
import re
import signal
import socket
import statistics
import struct
import subprocess
import time

PROJECT = pathlib.Path(os.environ["RSI_PROJECT"])
PROGRAMS = pathlib.Path(os.environ["RSI_PROGRAMS"])
INTERFACE = os.environ.get("RSI_CAN_INTERFACE", "vcan0")
VEHICLE = PROJECT / "sil/vehicles/large_suv.toml"
DBC = PROJECT / "can_dbc/rollover_warning.dbc"
CALIBRATION = PROJECT / "firmware/calibrations/large_suv.toml"

SENSOR_IDENTIFIERS = ("120", "121", "122")
WARNING_IDENTIFIER = "0D0"
STATUS_IDENTIFIER = "231"
OBSERVER_IDENTIFIER = "234"
SYNC_IDENTIFIER = "7F0"
ECU_FRAMES_A_CYCLE = len(re.findall(r"^BO_ \d+ \w+: \d+ RolloverEcu$", DBC.read_text(encoding="utf-8"), re.MULTILINE))
FRAME = struct.Struct("=IB3x8s")  # of a raw socket: identifier, length, data
CYCLE_S = 0.01
ALL_AND_ERRORS = ",0:0,#FFFFFFFF"  # filters for candump: every frame and every error frame
MOST_OVERRUNS = 255  # where CycleOverruns ends
LONGEST_S = 300  # a process that takes so long hangs, however busy the machine is


def run(program, *arguments, timeout=LONGEST_S):
    """Runs rsi-ecu or rsi-sil to its end; output and errors as text."""
    return subprocess.run(
        [PROGRAMS / program, *map(str, arguments)], capture_output=True, text=True, timeout=timeout
    )


def run_manoeuvre(name, output, *options, timeout=LONGEST_S):
    return run(
        "rsi-sil", "run", name, "--interface", INTERFACE, "--vehicle", VEHICLE, "--output", output, *options,
        timeout=timeout,
    )


class EcuEnded(Exception):
    """An ECU whose watchdog expired, because the machine stood still."""


def repeated_if_machine_stands_still(test):
    """For a test in which the watchdog of an ECU must not expire: again, at most four times, if it did and the test failed."""

    @functools.wraps(test)
    def repeat(self):
        for _ in range(4):
            try:
                return test(self)
            except EcuEnded as ended:
                print(f"again, because the machine stood still: {ended}", flush=True)
        return test(self)

    return repeat


class Ecu:
    """rsi-ecu on the interface, from the moment it listens to the end of the `with` block."""

    PROGRAM = PROGRAMS / "rsi-ecu"
    DEFAULTS = ("--parameters", CALIBRATION)

    def __init__(self, *options, interface=None):
        command = [self.PROGRAM, "--interface", interface or INTERFACE, *self.DEFAULTS, *options]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.output = line = self.process.stdout.readline()
        while line and "listening" not in line:  # a line on a stored section comes before
            line = self.process.stdout.readline()
            self.output += line
        if not line:
            self.output += self.process.communicate()[0]
            raise RuntimeError(f"rsi-ecu did not start: {self.output}")

    def stop(self, with_signal=signal.SIGTERM):
        """Ends it; its exit status."""
        self.process.send_signal(with_signal)
        self.output += self.process.communicate(timeout=LONGEST_S)[0]
        return self.process.returncode

    def __enter__(self):
        return self

    def __exit__(self, failure, *_):
        # Asked first: a launcher that is killed would leave its emulator behind, which goes on sending.
        if self.process.poll() is None:
            self.process.terminate()
            try:
                self.process.wait(timeout=LONGEST_S)
            except subprocess.TimeoutExpired:
                self.process.kill()
        self.output += self.process.communicate()[0] or ""
        if failure is not None and "the watchdog expired" in self.output:
            raise EcuEnded(self.output)


def test_key(slot, seed):
    """The key for a seed of XCP (calibration) or UDS (diagnosis), by the public test key."""
    command = [os.environ["RSI_TEST_KEY"], slot, seed.hex()]
    return bytes.fromhex(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def can_socket(*only):
    """A raw socket on the interface that hears every identifier, or `only` some (as candump writes them)."""
    opened = socket.socket(socket.PF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
    if only:
        filters = b"".join(struct.pack("=II", int(identifier, 16), 0x7FF) for identifier in only)
        opened.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_FILTER, filters)
    opened.settimeout(LONGEST_S)
    opened.bind((INTERFACE,))
    return opened


PROTECTION = ("unsealed", "unsealed test keys", "sealed test keys", "sealed")


def protection(opened=can_socket):
    """RollObserver.Protection of the next such frame, as the DBC file names it."""
    with opened(OBSERVER_IDENTIFIER) as bus:
        data = FRAME.unpack(bus.recv(FRAME.size))[2]
    return PROTECTION[data[7] >> 3 & 0x3]


class Candump:
    """`candump -L` on the interface, writing to a file; `filters` as candump takes them behind the interface's name."""

    def __init__(self, path, filters="", *options):
        self.path = pathlib.Path(path)
        self.file = open(self.path, "w", encoding="ascii")
        listeners = self._listeners()
        command = ["candump", "-L", "-r", "8388608", *options, INTERFACE + filters]
        self.process = subprocess.Popen(command, stdout=self.file, stderr=subprocess.PIPE)
        deadline = time.monotonic() + LONGEST_S
        while self._listeners() <= listeners:
            if time.monotonic() > deadline or self.process.poll() is not None:
                raise RuntimeError("candump does not listen")
            time.sleep(0.02)

    @staticmethod
    def _listeners():
        """How many filters there are on the interface, as the kernel lists them."""
        lists = pathlib.Path("/proc/net/can").glob("rcvlist_*")
        return sum(len(re.findall(rf"^\s*{INTERFACE}\s+[0-9a-f]", path.read_text(), re.MULTILINE)) for path in lists)

    def stop(self):
        """Ends it after it has read what waits; the frames as (time, identifier, data)."""
        time.sleep(0.5)
        self.process.send_signal(signal.SIGTERM)
        self.process.communicate(timeout=LONGEST_S)
        self.file.close()
        return read_log(self.path)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()
        self.file.close()


def read_log(path):
    """The lines of a candump log as (seconds, identifier, data)."""
    frames = []
    for line in pathlib.Path(path).read_text(encoding="ascii").splitlines():
        stamp, _, frame = line.split()[:3]
        identifier, data = frame.split("#")
        frames.append((float(stamp.strip("()")), identifier, data))
    return frames


def reactions_ms(frames):
    """From the last sensor frame to the warning frame that follows it, once per group of sensor frames."""
    reactions, last_sensor = [], None
    for time, identifier, _ in frames:
        if identifier in SENSOR_IDENTIFIERS:
            last_sensor = time
        elif identifier == WARNING_IDENTIFIER and last_sensor is not None:
            reactions.append(1000.0 * (time - last_sensor))
            last_sensor = None
    return reactions


def median_reaction_ms(frames):
    """In the second half of a log: in the first, the ECU's cycle moves behind the frames."""
    reactions = reactions_ms(frames)
    return statistics.median(reactions[len(reactions) // 2:])


def state_of(data):
    """The state in a RolloverWarning's payload: the lowest three bits of byte 2."""
    return int(data[4:6], 16) & 0x7


# Bits 16 to 31 of RolloverStatus.
FLAGS = (
    "ImuTimeout ImuChecksumError ImuCounterError ImuSignalInvalid RollAngleTimeout RollAngleChecksumError "
    "RollAngleCounterError RollAngleSignalInvalid VehicleMotionTimeout VehicleMotionChecksumError "
    "VehicleMotionCounterError VehicleMotionSignalInvalid ReceiveOverflow BusError ParametersInvalid CycleOverrun"
).split()


def flags_of(data):
    bits = int(data[4:6], 16) | int(data[6:8], 16) << 8
    return {name for number, name in enumerate(FLAGS) if bits >> number & 1}


def cycle_overruns_of(data):
    """CycleOverruns in a RolloverStatus's payload."""
    return int(data[8:10], 16)


def drift(observed):
    """By how many cycles an ECU's account and the clock go apart. `observed`: (seconds, cycles kept, cycles counted as missed).

    A busy machine holds up the ECU; but each cycle is kept or counted, so that both together go with the clock. Observations
    may be late, by delays of the machine, but never early: the earliest of either half counts.
    """
    lateness = [seconds / CYCLE_S - kept - missed for seconds, kept, missed in observed]
    half = len(lateness) // 2
    return min(lateness[half:]) - min(lateness[:half])


class Cycles:
    """From the first RolloverStatus of a log to its last, or to where the count of missed cycles ends: how many cycles there
    were, and how many the ECU says it missed."""

    LEAST = 20  # frames; of fewer there may be none in time

    def __init__(self, frames):
        everything = [(time, cycle_overruns_of(data)) for time, identifier, data in frames if identifier == STATUS_IDENTIFIER]
        observed = [(time, kept, missed) for kept, (time, missed) in enumerate(everything) if missed < MOST_OVERRUNS]
        self.enough = len(observed) >= self.LEAST
        self.kept = self.missed = self.periods = self.drift = 0
        if self.enough:
            self.kept = len(observed) - 1
            self.missed = observed[-1][2] - observed[0][2]
            self.periods = (observed[-1][0] - observed[0][0]) / CYCLE_S
            self.drift = drift(observed)

    def __str__(self):
        return (f"{self.kept} cycles kept, {self.missed} counted as missed, in {self.periods:.1f} periods; "
                f"{self.drift:+.2f} from one half to the other")
