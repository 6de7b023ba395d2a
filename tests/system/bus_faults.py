"""Faults on a real CAN interface, injected between recorded sensor frames and rsi-ecu; what the ECU answers, and how fast.

Faults of frames in lock-step, where the answer is the same each time; faults of the bus and of the process in real time. The
names of the faults and of what is demanded are those of docs/reports/safety/fault_matrix.md."""

import contextlib
import dataclasses
import fcntl
import signal
import socket
import struct
import tempfile
import threading
import time

import programs

UNAVAILABLE, READY = 0, 1
CYCLE_MS = 10
SYNC_IDENTIFIER = 0x7F0
# In cycles: good frames, the fault, good frames again.
GOOD, FAULTY, AFTER = 60, 60, 40
SIOCGIFFLAGS, SIOCSIFFLAGS, IFF_UP = 0x8913, 0x8914, 1
# linux/can/error.h
ERROR_FRAME, CONTROLLER_PROBLEM, BUS_OFF = 0x20000000, 0x4, 0x40
RECEIVE_PASSIVE, ERROR_ACTIVE = 0x10, 0x40

def checksum(data_identifier, payload):
    """CRC-8 of profile 11 over the low byte of the data identifier, a zero byte and the payload from byte 1 on."""
    crc = 0
    for byte in bytes((data_identifier & 0xFF, 0)) + payload[1:]:
        crc ^= byte
        for _ in range(8):
            crc = (crc << 1 ^ 0x1D if crc & 0x80 else crc << 1) & 0xFF
    return crc


# ---- Faults of a frame: from the frames of one cycle to those that are sent, each behind its delay in cycles.

IMU, ROLL_ANGLE = 0x120, 0x121
IMU_DATA_IDENTIFIER = 935


def of_imu(change):
    return lambda number, frames: [
        item for frame in frames for item in (change(number, *frame) if frame[0] == IMU else [(0, *frame)])
    ]


def with_counter(payload, counter):
    changed = bytes((0, payload[1] & 0xF0 | counter)) + payload[2:]
    return bytes((checksum(IMU_DATA_IDENTIFIER, changed),)) + changed[1:]


def all_lost(*_):
    return []


def swapped(_, frames):
    other = {IMU: ROLL_ANGLE, ROLL_ANGLE: IMU}
    return [(0, other.get(identifier, identifier), payload) for identifier, payload in frames]


def delayed(cycles):
    return of_imu(lambda _, identifier, payload: [(cycles, identifier, payload)])


lost = of_imu(lambda *_: [])
doubled = of_imu(lambda _, identifier, payload: 2 * [(0, identifier, payload)])
wrong_length = of_imu(lambda _, identifier, payload: [(0, identifier, payload[:7])])
bad_crc = of_imu(lambda _, identifier, payload: [(0, identifier, bytes((payload[0] ^ 0xFF,)) + payload[1:])])
counter_stands = of_imu(lambda _, identifier, payload: [(0, identifier, with_counter(payload, 3))])


# ---- Faults of the bus and of the process: what happens for the time of the fault.


def inject_error(identifier, second_byte=0):
    with programs.can_socket() as bus:
        bus.send(programs.FRAME.pack(ERROR_FRAME | identifier, 8, bytes((0, second_byte, 0, 0, 0, 0, 0, 0))))


@contextlib.contextmanager
def error_passive(_):
    inject_error(CONTROLLER_PROBLEM, RECEIVE_PASSIVE)
    yield
    inject_error(CONTROLLER_PROBLEM, ERROR_ACTIVE)


@contextlib.contextmanager
def bus_off(_):
    inject_error(BUS_OFF)
    yield


def set_interface_up(up):
    """As `ip link set` does, but at once: a program takes its time to start."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as control:
        request = struct.pack("16s16x", programs.INTERFACE.encode("ascii"))
        name, flags = struct.unpack("16sH14x", fcntl.ioctl(control, SIOCGIFFLAGS, request))
        flags = flags | IFF_UP if up else flags & ~IFF_UP
        fcntl.ioctl(control, SIOCSIFFLAGS, struct.pack("16sH14x", name, flags))


@contextlib.contextmanager
def interface_down(_):
    set_interface_up(False)
    yield
    set_interface_up(True)


@contextlib.contextmanager
def stopped(process):
    process.send_signal(signal.SIGSTOP)
    yield
    process.send_signal(signal.SIGCONT)


# ---- The faults


@dataclasses.dataclass(frozen=True)
class FrameFault:
    name: str
    place: str
    demand: str  # no change; code, usable; code, unavailable
    frames: object


@dataclasses.dataclass(frozen=True)
class LiveFault:
    name: str
    place: str
    demand: str  # code; code, usable; code, unavailable
    flags: tuple  # one of these tells of it
    happening: object
    seconds: float
    silences_ecu: bool = True  # it is not received meanwhile: all times count from its first frame thereafter
    ends_ecu: bool = False  # by its watchdog


FRAME_FAULTS = (
    FrameFault("lost", "Imu", "code, unavailable", lost),
    FrameFault("lost", "all sensor frames", "code, unavailable", all_lost),
    FrameFault("delayed, 20 ms", "Imu", "no change", delayed(2)),
    FrameFault("delayed, 100 ms", "Imu", "code, unavailable", delayed(10)),
    FrameFault("bad CRC", "Imu", "code, unavailable", bad_crc),
    FrameFault("counter stands", "Imu", "code, unavailable", counter_stands),
    FrameFault("identifier of the next frame", "Imu", "code, unavailable", swapped),
    FrameFault("doubled", "Imu", "code, usable", doubled),
    FrameFault("wrong DLC", "Imu", "code, unavailable", wrong_length),
)

STOP_FLAGS = ("CycleOverrun", "ImuTimeout")
LIVE_FAULTS = (
    LiveFault("error-passive", "bus", "code, usable", ("BusError",), error_passive, 0.6, silences_ecu=False),
    LiveFault("bus-off", "bus", "code", ("BusError",), bus_off, 0.6),
    LiveFault("interface down and up", "bus", "code, unavailable", ("BusError", "ImuTimeout"), interface_down, 0.6),
    LiveFault("process stopped, 200 ms", "processor", "code, unavailable", STOP_FLAGS, stopped, 0.2),
    LiveFault("process stopped, 2000 ms", "processor", "code, unavailable", STOP_FLAGS, stopped, 2.0, ends_ecu=True),
)


# ---- One run


@dataclasses.dataclass
class Answer:
    """Answers of the ECU: times in milliseconds, None for missing ones."""

    flag: str
    flag_ms: float
    unavailable_ms: float
    back_ms: float
    reaction_cycles: int = 0  # until all that is demanded was said, as the ECU counts
    silent_ms: float = None
    lost: int = 0  # warning frames, by their counters
    ended: bool = False


def recorded_cycles(first, count):
    """Sensor frames of so many cycles of a turn, as (identifier, payload)."""
    log = programs.read_log(programs.PROJECT / "tests/application/regression/logs/rough-turn.sensors.log")
    cycles = {}
    for stamp, identifier, data in log:
        if identifier in programs.SENSOR_IDENTIFIERS:
            cycles.setdefault(round(stamp / programs.CYCLE_S), []).append((int(identifier, 16), bytes.fromhex(data)))
    return [cycles[number] for number in range(first, first + count)]


def put(bus, identifier, payload):
    bus.send(programs.FRAME.pack(identifier, len(payload), payload.ljust(8, b"\0")))


def take_answer(bus):
    """The ECU's frames of one cycle of lock-step: (state, flags)."""
    state = None
    while True:
        identifier, length, data = struct.unpack("=IB3x8s", bus.recv(16))
        text = data[:length].hex()
        if f"{identifier:03X}" == programs.WARNING_IDENTIFIER:
            state = programs.state_of(text)
        elif f"{identifier:03X}" == programs.STATUS_IDENTIFIER:
            return state, programs.flags_of(text)


def inject_into_frames(fault):
    """In lock-step: each cycle's frames, the frame that lets the ECU compute, its answer."""
    answers, late = [], []
    with programs.Ecu("--lock-step"), programs.can_socket() as bus:
        for number, frames in enumerate(recorded_cycles(0, GOOD + FAULTY + AFTER)):
            faulty = GOOD <= number < GOOD + FAULTY
            cycle = fault.frames(number, frames) if faulty else [(0, *frame) for frame in frames]
            late += [(number + delay, identifier, payload) for delay, identifier, payload in cycle]
            for _, identifier, payload in [item for item in late if item[0] <= number]:
                put(bus, identifier, payload)
            late = [item for item in late if item[0] > number]
            put(bus, SYNC_IDENTIFIER, struct.pack("<I", number))
            answers.append(take_answer(bus))
    states, flags = zip(*answers)
    behind = range(GOOD, len(answers))
    flagged = next((number for number in behind if flags[number]), None)
    unavailable = next((number for number in behind if states[number] == UNAVAILABLE), None)
    wrong = [number for number in behind if states[number] == UNAVAILABLE]
    back = max([GOOD + FAULTY, *(number + 1 for number in wrong)])
    reactions = [number for number in (flagged, unavailable) if number is not None]
    return Answer(
        flag=None if flagged is None else min(flags[flagged], key=programs.FLAGS.index),
        flag_ms=None if flagged is None else CYCLE_MS * (flagged - GOOD),
        unavailable_ms=None if unavailable is None else CYCLE_MS * (unavailable - GOOD),
        back_ms=None if back >= len(answers) else CYCLE_MS * (back - GOOD - FAULTY),
        reaction_cycles=max(reactions, default=GOOD) - GOOD,
    )


class Sensors:
    """Recorded sensor frames in real time."""

    def __init__(self):
        self._cycles = recorded_cycles(0, 800)
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._send, daemon=True)
        self._thread.start()

    def end(self):
        self._ended.set()
        self._thread.join()

    def _send(self):
        with programs.can_socket() as bus:
            start = time.monotonic()
            for number, frames in enumerate(self._cycles):
                while (wait := start + number * programs.CYCLE_S - time.monotonic()) > 0:
                    time.sleep(wait)
                if self._ended.is_set():
                    return
                for frame in frames:
                    with contextlib.suppress(OSError):  # an interface that is down
                        put(bus, *frame)


def inject_live(fault):
    """In real time: the fault happens for its time; the answer by candump's stamps, which are the kernel's."""
    with contextlib.ExitStack() as stack:
        log = stack.enter_context(tempfile.NamedTemporaryFile())
        candump = stack.enter_context(programs.Candump(log.name, programs.ALL_AND_ERRORS, "-D"))
        ecu = stack.enter_context(programs.Ecu())
        sensors = Sensors()
        time.sleep(GOOD * programs.CYCLE_S)
        start = time.time()
        with fault.happening(ecu.process):
            time.sleep(fault.seconds)
        end = time.time()
        time.sleep(AFTER * programs.CYCLE_S)
        sensors.end()
        status = ecu.stop()
        if (status != 0) != fault.ends_ecu:
            raise programs.EcuEnded(ecu.output)
        return live_answer(fault, candump.stop(), start, end)


def live_answer(fault, frames, start, end):
    warnings = [(stamp, programs.state_of(data)) for stamp, name, data in frames if name == programs.WARNING_IDENTIFIER]
    statuses = [(stamp, programs.flags_of(data)) for stamp, name, data in frames if name == programs.STATUS_IDENTIFIER]
    errors = [stamp for stamp, name, _ in frames if len(name) == 8 and int(name, 16) & ERROR_FRAME]
    start = max([start] + errors[:1])  # this program may have been held up before it sent the error frame
    silent_ms = None
    if fault.silences_ecu:
        pauses = [
            (late - early, late) for (early, _), (late, _) in zip(warnings, warnings[1:]) if start < late < end + 0.8
        ]
        if not pauses:
            raise programs.EcuEnded("no frame of the ECU was received after the fault")
        pause, start = max(pauses)
        silent_ms = 1000 * pause
        end = max(start, end) if fault.happening is not bus_off else start

    def since(stamp, origin=start):
        return None if stamp is None else max(0.0, 1000 * (stamp - origin))

    def first(items, condition):
        return next((stamp for stamp, value in items if stamp >= start and condition(value)), None)

    flag, flag_time = next(
        ((name, stamp) for stamp, flags in statuses if stamp >= start for name in fault.flags if name in flags), (None, None)
    )
    unavailable = first(warnings, lambda state: state == UNAVAILABLE)
    if unavailable is not None and unavailable > end + 0.05:
        unavailable = None
    back = next(
        (stamp for stamp, state in warnings if stamp >= max(end, unavailable or end) and state != UNAVAILABLE), None
    )
    demanded = [flag_time] + ([unavailable] if fault.demand == "code, unavailable" else [])
    told = None if None in demanded else max(demanded)
    counters = [int(data[3], 16) for _, name, data in frames if name == programs.WARNING_IDENTIFIER]
    return Answer(
        flag=flag, flag_ms=since(flag_time), unavailable_ms=since(unavailable), back_ms=since(back, end),
        reaction_cycles=None if told is None else sum(start < stamp <= told for stamp, _ in statuses),
        silent_ms=silent_ms, ended=fault.ends_ecu,
        lost=sum(late != (early + 1) % 15 for early, late in zip(counters, counters[1:])),
    )


# ---- Judgement

REACTION_MS, RECOVERY_MS = 50, 250


def shortfalls_of_frames(fault, got):
    """Differences from the demands, in words."""
    found = []
    if fault.demand != "no change" and (got.flag is None or got.flag_ms > REACTION_MS):
        found.append("no code in time")
    if fault.demand == "code, unavailable" and (got.unavailable_ms is None or got.unavailable_ms > REACTION_MS):
        found.append("not unavailable in time")
    if fault.demand != "code, unavailable" and got.unavailable_ms is not None:
        found.append("unavailable")
    if got.back_ms is None or got.back_ms > RECOVERY_MS:
        found.append("not back in time")
    return found


def shortfalls_of_live(fault, got):
    """The same, in the ECU's own cycles: a virtual machine's may come late, and then no figure in milliseconds holds."""
    found = []
    if got.reaction_cycles is None or got.reaction_cycles > REACTION_MS // CYCLE_MS + 1:
        found.append("not reported in time")
    if fault.happening is bus_off and got.silent_ms < 100:
        found.append("back on the bus too early")
    if not fault.ends_ecu and got.back_ms is None:
        found.append("not back")
    if got.lost and fault.happening is not bus_off and fault.happening is not interface_down:
        found.append("warning frames lost")
    return found


def run(fault):
    """The answer, and what is wrong with it; in real time a busy machine gets ten tries."""
    if isinstance(fault, FrameFault):
        got = inject_into_frames(fault)
        return got, shortfalls_of_frames(fault, got)
    for attempt in range(10):
        try:
            got = inject_live(fault)
        except programs.EcuEnded:
            if attempt == 9:
                raise
            continue
        wrong = shortfalls_of_live(fault, got)
        if not wrong:
            break
    return got, wrong


def cell(got, wrong):
    parts = []
    if got.silent_ms is not None:
        parts.append(f"silent for {got.silent_ms:.0f}")
    if got.unavailable_ms is not None:
        parts.append(f"unavailable {got.unavailable_ms:.0f}")
    parts.append("nothing" if got.flag is None else f"{got.flag} {got.flag_ms:.0f}")
    if got.ended:
        parts.append("then ended by its watchdog")
    else:
        parts.append("not back" if got.back_ms is None else f"back {got.back_ms:.0f}")
    return ", ".join(parts) + (f" **NOT: {'; '.join(wrong)}**" if wrong else "")


def row(fault, got, wrong):
    expected = fault.demand if fault.demand == "no change" else f"{fault.demand} {REACTION_MS}"
    return f"| {fault.name} | {fault.place} | {expected}; back {RECOVERY_MS} | {cell(got, wrong)} |"
