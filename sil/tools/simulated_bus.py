"""A CAN bus without an interface: ecu-drive, whose time goes on while a tester waits for its answer, and when told."""

import contextlib
import pathlib
import queue
import subprocess
import threading

import can
import isotp
import udsoncan
from log_error import LogError
from udsoncan.connections import BaseConnection

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = PROJECT / "build/release/sil/ecu-drive"
VEHICLE = PROJECT / "sil/vehicles/large_suv.toml"
PARAMETERS = PROJECT / "firmware/calibrations/large_suv.toml"
BENCH = "bench"
XCP_ANSWER, XCP_COMMAND = 0x6F1, 0x6F0
MOST_CYCLES_TO_AN_ANSWER = 5
CYCLES_PER_S = 100
LONGEST_ANSWER_CYCLES = 200


class Cycle:
    def __init__(self, line):
        number, state, side, frames, numbers = line.split()[1:]
        self.number, self.state, self.side, self.frames = int(number), int(state), int(side), int(frames)
        self.numbers = numbers


class SimulatedBus:
    """The drive, and what came of it."""

    def __init__(self, program=PROGRAM, vehicle=VEHICLE, parameters=PARAMETERS):
        if not pathlib.Path(program).is_file():
            raise LogError(f"there is no {program}; make it: cmake/environment/build release ecu-drive")
        self.process = subprocess.Popen([program, vehicle, parameters], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        text=True)
        self.answers = queue.Queue()  # of XCP, samples among them
        self.waiting = []  # frames of the diagnosis: identifier and data
        self.lock = threading.Lock()
        self.cycles = []
        self.samples = []  # with the number of their cycle

    def tell(self, command):
        """The lines of its answer."""
        try:
            self.process.stdin.write(command + "\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            pass  # the answer is missing below
        lines = []
        while (line := self.process.stdout.readline().strip()) != "done":
            if line.startswith("wrong "):
                self.process.stdout.readline()
                raise LogError(line.removeprefix("wrong "))
            if not line:
                raise LogError("the simulated drive has ended; its reason is above")
            lines.append(line)
        return lines

    def drive(self, manoeuvre, seconds=0.0, lost=()):
        """`lost`: sensor values that no sensor measures."""
        with self.lock:
            self.cycles, self.samples, self.waiting = [], [], []
            self.tell(" ".join(["drive", manoeuvre, str(seconds), *lost]))

    def take(self, lines):
        """True when an answer of XCP has come."""
        answered = False
        for line in lines:
            if line.startswith("cycle "):
                self.cycles.append(Cycle(line))
            elif line.startswith("frame "):
                identifier, _, data = line.split()[1].partition("#")
                identifier, data = int(identifier, 16), bytes.fromhex(data)
                if identifier != XCP_ANSWER:
                    self.waiting.append((identifier, data))
                    continue
                if data[0] < 0xFC:
                    self.samples.append((self.cycles[-1].number, data))
                answered = answered or data[0] >= 0xFE
                self.answers.put(can.Message(arbitration_id=identifier, is_extended_id=False, data=data))
        return answered

    def run(self, cycles):
        with self.lock:
            self.take(self.tell(f"step {cycles}"))

    def finish(self):
        """The rest of the manoeuvre; behind it the vehicle is driven on."""
        with self.lock:
            self.take(self.tell("finish"))

    def send(self, identifier, data):
        with self.lock:
            self.tell(f"send {identifier:03X}#{bytes(data).hex()}")

    def ask(self, data):
        """A command of XCP, and the cycles to its answer."""
        with self.lock:
            self.tell(f"send {XCP_COMMAND:03X}#{data.hex()}")
            for _ in range(MOST_CYCLES_TO_AN_ANSWER):
                if self.take(self.tell("step 1")):
                    return

    def end(self):
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait()


def add_options(parser, after):
    """Options of a tool's command line that choose a drive."""
    parser.add_argument("--in-process", metavar="MANOEUVRE|bench")
    parser.add_argument("--lost", action="append", default=[], metavar="SENSOR")
    parser.add_argument("--after", type=float, default=after, metavar="SECONDS")


@contextlib.contextmanager
def driven(options):
    """The bus of a drive that has gone on for --after seconds; None without --in-process."""
    if options.in_process is None:
        yield None
        return
    bus = SimulatedBus()
    try:
        bus.drive(options.in_process, lost=options.lost)
        bus.run(round(options.after * CYCLES_PER_S))
        yield bus
    finally:
        bus.end()


class Interface:
    """The bus of one master of XCP, as far as pyxcp uses one of python-can."""

    filters = None
    state = can.BusState.ACTIVE

    def __init__(self, bus):
        self.bus = bus
        self.answers = bus.answers = queue.Queue()

    def set_filters(self, filters):
        self.filters = filters

    def recv(self, timeout=None):
        try:
            return self.answers.get(timeout=timeout)
        except queue.Empty:
            return None

    def send(self, message):
        self.bus.ask(bytes(message.data))


class IsoTpConnection(BaseConnection):
    """can-isotp between udsoncan and a bus with `waiting`, `send` and `run`; a second passes in a hundred cycles."""

    def __init__(self, bus, request, response, **parameters):
        super().__init__("simulated bus")
        self.bus = bus
        address = isotp.Address(isotp.AddressingMode.Normal_11bits, rxid=response, txid=request)
        self.stack = isotp.TransportLayerLogic(rxfn=self.receive_frame, txfn=self.send_frame, address=address,
                                               params={"blocking_send": False, **parameters})

    def receive_frame(self, timeout):
        del timeout
        if not self.bus.waiting:
            return None
        identifier, data = self.bus.waiting.pop(0)
        return isotp.CanMessage(arbitration_id=identifier, data=data, dlc=len(data))

    def send_frame(self, message):
        self.bus.send(message.arbitration_id, message.data)

    def open(self):
        return self

    def close(self):
        pass

    def is_open(self):
        return True

    def empty_rxqueue(self):
        while self.stack.available():
            self.stack.recv()

    def specific_send(self, payload, timeout=None):
        del timeout
        self.stack.send(payload)
        self.stack.process(rx_timeout=0)

    def specific_wait_frame(self, timeout=2):
        """The first frame within the time-out, the whole answer within two seconds."""
        cycles = round(timeout * CYCLES_PER_S)
        while cycles >= 0:
            if self.bus.waiting:
                cycles = LONGEST_ANSWER_CYCLES
            self.stack.process(rx_timeout=0)
            if self.stack.available():
                return bytes(self.stack.recv())
            self.bus.run(1)
            cycles -= 1
        raise udsoncan.exceptions.TimeoutException("no answer")
