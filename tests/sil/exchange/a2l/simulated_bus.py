"""A CAN interface for pyxcp whose bus is simulated: time goes on while a master waits for its answer, and when told."""

import queue
import subprocess
import threading

import can

ANSWER = 0x6F1
MOST_CYCLES_TO_AN_ANSWER = 5


class Cycle:
    def __init__(self, line):
        number, state, side, frames, numbers = line.split()[1:]
        self.number, self.state, self.side, self.frames = int(number), int(state), int(side), int(frames)
        self.numbers = numbers


class SimulatedBus:
    """The drive, and what came of it."""

    def __init__(self, program):
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.waiting = queue.Queue()
        self.lock = threading.Lock()
        self.cycles = []
        self.samples = []  # with the number of their cycle

    def tell(self, command):
        """The lines of its answer."""
        self.process.stdin.write(command + "\n")
        self.process.stdin.flush()
        lines = []
        while (line := self.process.stdout.readline().strip()) != "done":
            if not line or line.startswith("unknown"):
                raise RuntimeError(f"xcp-drive ended, or does not know: {command}")
            lines.append(line)
        return lines

    def drive(self, manoeuvre, seconds):
        with self.lock:
            self.cycles, self.samples = [], []
            self.tell(f"drive {manoeuvre} {seconds}")

    def step(self, cycles):
        """True when an answer has come."""
        answered = False
        for line in self.tell(f"step {cycles}"):
            if line.startswith("cycle"):
                self.cycles.append(Cycle(line))
            else:
                data = bytes.fromhex(line.split()[1])
                if data[0] < 0xFC:
                    self.samples.append((self.cycles[-1].number, data))
                answered = answered or data[0] >= 0xFE
                self.waiting.put(can.Message(arbitration_id=ANSWER, is_extended_id=False, data=data))
        return answered

    def run(self, cycles):
        with self.lock:
            self.step(cycles)

    def ask(self, data):
        """A command, and the cycles to its answer."""
        with self.lock:
            self.tell(f"send {data.hex()}")
            for _ in range(MOST_CYCLES_TO_AN_ANSWER):
                if self.step(1):
                    return

    def end(self):
        self.process.stdin.close()
        self.process.wait()


class Interface:
    """The bus of one master, as far as pyxcp uses one of python-can."""

    filters = None
    state = can.BusState.ACTIVE

    def __init__(self, bus):
        self.bus = bus
        self.waiting = bus.waiting = queue.Queue()

    def set_filters(self, filters):
        self.filters = filters

    def recv(self, timeout=None):
        try:
            return self.waiting.get(timeout=timeout)
        except queue.Empty:
            return None

    def send(self, message):
        self.bus.ask(bytes(message.data))
