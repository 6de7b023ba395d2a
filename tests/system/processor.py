"""The Cortex-R5F's image under QEMU, on the interface or on a bus within QEMU, and a stand-in for the sensors that goes in lock-step."""

import collections
import contextlib
import os
import pathlib
import re
import select
import socket
import struct
import subprocess
import tempfile
import threading
import time

import programs

ECU_IDENTIFIERS = ("0D0", "230", "232", "233", "234", "235", "236", programs.STATUS_IDENTIFIER)
CORTEX_R5F = programs.PROJECT / "build/cortex-r5f"
TRACED = re.compile(r"ID: 0x0*([0-9a-f]+) DLC: 0x(\w+) DATA:((?: 0x\w\w)+)")
SUPERVISOR = CORTEX_R5F / "firmware/images/zynqmp_r5/release-r5.elf"


class Processor(programs.Ecu):
    """rsi-ecu-r5f instead of rsi-ecu, with the calibration that its image was built with."""

    PROGRAM = programs.PROJECT / "sil/apps/rsi-ecu-r5f"
    DEFAULTS = ()


def start_emulator(image, output, *options, stdin=subprocess.DEVNULL):
    """QEMU with the image on its board, whose first CAN controller is on the bus `bus`; what QEMU says goes to `output`."""
    command = ["qemu-system-aarch64", "-M", "xlnx-zcu102", "-smp", "6", "-m", "128", "-nodefaults", "-display", "none",
               "-serial", "none", "-monitor", "none", "-object", "can-bus,id=bus", "-machine", "canbus0=bus",
               "-device", f"loader,file={image}", "-device", f"loader,file={SUPERVISOR},cpu-num=0", *options]
    return subprocess.Popen(command, stdin=stdin, stdout=output, stderr=output, env=dict(os.environ, QEMU_AUDIO_DRV="none"))


def traced_to(path):
    """Options of the emulator: what each CAN controller sends is written into a file."""
    path.write_text("", encoding="ascii")
    return "-trace", "xlnx_can_tx_data", "-D", str(path)


def frames_of(trace):
    """The frames in the text of such a file, as (identifier, data)."""
    return [
        (name.upper().zfill(3), data.replace(" 0x", "").upper()[:2 * int(length, 16)])
        for name, length, data in TRACED.findall(trace)
    ]


class Board:
    """The image with a bus within QEMU, in place of the interface, for the time of the `with` block: no CAN is asked of the
    kernel, so the emulator need not run within another one, where it is ten times as slow.

    The board's second CAN controller, which the firmware leaves alone, is on the bus, too. QEMU's test protocol (qtest)
    makes it send what is written to a socket of `can_socket`; what the firmware sends is taken from QEMU's trace, because
    a controller forgets what it has received when the firmware resets the board."""

    CONTROLLER = 0xFF070000
    RESET, MODE, SENT = 0x00, 0x04, 0x30
    NORMAL_MODE, RESET_ALL, ENABLE = 0, 1, 2
    POLLED_EVERY_S = 0.001

    def __init__(self, image):
        self.image = image
        self.peers = []  # (socket of this side, identifiers)
        self.own = collections.deque()  # sent by this side, not yet seen in the trace
        self.ended = False
        self.bridge = None
        self.qtest = socket.socket(socket.AF_UNIX)

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(prefix="rsi_board_")
        self.messages = pathlib.Path(self.folder.name) / "messages"
        trace = pathlib.Path(self.folder.name) / "trace"
        door = pathlib.Path(self.folder.name) / "qtest"
        with open(self.messages, "wb") as output:
            # Stopped until the controller of this side listens: an image in lock-step says a single time that it is there.
            self.emulator = start_emulator(
                self.image, output, *traced_to(trace), "-machine", "canbus1=bus", "-S", "-qmp", "stdio",
                "-qtest", f"unix:{door},server=on", "-qtest-log", "none", stdin=subprocess.PIPE,
            )
        try:
            deadline = time.monotonic() + programs.LONGEST_S
            while self.qtest.connect_ex(str(door)) != 0:
                self._check_emulator(time.monotonic() < deadline)
                time.sleep(0.01)
            self.answers = self.qtest.makefile("r", encoding="ascii")
            self.bridge = threading.Thread(target=self._move_frames, args=(trace,), daemon=True)
            start = self.can_socket(programs.STATUS_IDENTIFIER)
            self.bridge.start()
            self.emulator.stdin.write(b'{"execute": "qmp_capabilities"}\n{"execute": "cont"}\n')
            self.emulator.stdin.flush()
            start.recv(programs.FRAME.size)
            start.close()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        self.ended = True
        self.emulator.kill()
        self.emulator.wait()
        self.emulator.stdin.close()
        if self.bridge:
            self.bridge.join()
        self.qtest.close()
        self.folder.cleanup()

    def can_socket(self, *only):
        """As programs.can_socket, on this board's bus."""
        mine, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        mine.setblocking(False)
        theirs.settimeout(programs.LONGEST_S)
        self.peers.append((mine, {int(identifier, 16) for identifier in only}))
        return theirs

    def _check_emulator(self, in_time=True):
        if self.emulator.poll() is not None or not in_time:
            raise RuntimeError("the emulator does not run: " + self.messages.read_text(encoding="utf-8", errors="replace"))

    def _demand(self, request):
        self.qtest.sendall(request.encode("ascii") + b"\n")
        answer = self.answers.readline().split()
        if not answer:
            raise ConnectionError(f"QEMU ended with {self.emulator.wait()}: {self.messages.read_text(errors='replace')}")
        if answer[0] != "OK":
            raise ConnectionError(f"QEMU answers {answer} to {request}")
        return answer

    def _write(self, register, value):
        self._demand(f"writel {self.CONTROLLER + register:#x} {value:#x}")

    def _read(self, register):
        return int(self._demand(f"readl {self.CONTROLLER + register:#x}")[1], 16)

    def _move_frames(self, trace):
        try:
            with open(trace, encoding="ascii") as lines:
                self._move_frames_of(lines)
        except OSError:
            if not self.ended:
                raise
        finally:
            for peer, _ in self.peers:
                peer.close()  # a reader that waits gets an empty frame

    def _move_frames_of(self, trace):
        line = ""
        while not self.ended:
            ready, _, _ = select.select([peer for peer, _ in self.peers], [], [], self.POLLED_EVERY_S)
            for peer in ready:
                self._send(peer)
            while (rest := trace.readline()):
                line += rest
                if line.endswith("\n"):
                    for frame in frames_of(line):
                        self._receive(frame)
                    line = ""

    def _send(self, peer):
        try:
            frame = peer.recv(programs.FRAME.size)
        except ConnectionError:
            frame = b""
        if not frame:  # closed
            self.peers = [pair for pair in self.peers if pair[0] is not peer]
            peer.close()
            return
        if self._read(self.RESET) != self.ENABLE:  # at the start, and when the firmware has reset the board
            # A reset between the words of a frame leaves the rest of them, and QEMU aborts on a frame that is not whole.
            self._write(self.RESET, self.RESET_ALL)
            self._write(self.MODE, self.NORMAL_MODE)
            self._write(self.RESET, self.ENABLE)
        identifier, length, payload = programs.FRAME.unpack(frame)
        self.own.append((f"{identifier:03X}", payload[:length].hex().upper()))
        for number, value in enumerate((identifier, length << 28, *struct.unpack("<II", payload))):
            self._write(self.SENT + 4 * number, value)

    def _receive(self, frame):
        if frame in self.own:
            while self.own.popleft() != frame:  # lost in a reset of the board
                pass
            return
        identifier, data = int(frame[0], 16), bytes.fromhex(frame[1])
        for peer, only in self.peers:
            if not only or identifier in only:
                # A socket that is full loses the frame, as one on an interface does; one that is closed wants none.
                with contextlib.suppress(BlockingIOError, ConnectionError):
                    peer.send(programs.FRAME.pack(identifier, len(data), data.ljust(8, b"\0")))


class Bus:
    """Frames as (identifier, data), both as candump writes them, to and from a socket of `can_socket`."""

    def __init__(self, opened):
        self.socket = opened

    def send(self, identifier, data):
        payload = bytes.fromhex(data)
        self.socket.send(programs.FRAME.pack(int(identifier, 16), len(payload), payload.ljust(8, b"\0")))

    def receive(self):
        identifier, length, payload = programs.FRAME.unpack(self.socket.recv(programs.FRAME.size))
        return f"{identifier:03X}", payload[:length].hex().upper()

    def close(self):
        self.socket.close()


def cycles_of(frames):
    """The frames of a log, gathered by their time stamps: cycle number to frames."""
    cycles = {}
    for time_s, identifier, data in frames:
        cycles.setdefault(round(time_s / programs.CYCLE_S), []).append((identifier, data))
    return cycles


def answers(bus, sensor_frames):
    """Answers of the ECU, in lock-step, to the sensor frames of a log that begins at time 0."""
    cycles = cycles_of(sensor_frames)
    answered = []
    for number in range(max(cycles) + 1):
        for identifier, data in cycles.get(number, []):
            bus.send(identifier, data)
        bus.send(programs.SYNC_IDENTIFIER, struct.pack("<I", number).hex())
        while not answered or answered[-1][0] != number or answered[-1][1] != programs.STATUS_IDENTIFIER:
            answered.append((number, *bus.receive()))
    return answered
