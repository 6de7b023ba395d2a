"""A CAN adapter on a serial line (SLCAN), played by the test: the kernel's driver is real, its controller is not."""

import fcntl
import os
import re
import struct
import subprocess
import termios
import threading
import time
import tty

N_SLCAN = 17  # the line discipline of include/uapi/linux/tty.h
SIOCGIFNAME = 0x8910


class Adapter:
    """The interface that the kernel makes for the adapter, up; `received` are its frames on the bus."""

    def __init__(self):
        self.received = []  # (seconds, identifier, data), as in candump's log
        self._line, self._tty = os.openpty()
        tty.setraw(self._line)
        tty.setraw(self._tty)
        fcntl.ioctl(self._tty, termios.TIOCSETD, struct.pack("i", N_SLCAN))
        name = fcntl.ioctl(self._tty, SIOCGIFNAME, bytes(16))
        self.interface = name.split(b"\0")[0].decode("ascii")
        subprocess.run(["ip", "link", "set", self.interface, "up"], check=True)
        threading.Thread(target=self._listen, daemon=True).start()

    def put_frame(self, identifier, data):
        """A frame arrives from the bus."""
        self._say(f"t{identifier}{len(data) // 2}{data}")

    def put_state(self, state, receive_errors, transmit_errors):
        """The controller's state changes: a (active), p (passive), b (bus-off)."""
        self._say(f"s{state}{receive_errors:03}{transmit_errors:03}")

    def times_bus_off(self):
        """How often the kernel has seen the controller go bus-off."""
        shown = subprocess.run(
            ["ip", "-details", "-statistics", "link", "show", self.interface],
            check=True, capture_output=True, text=True,
        ).stdout
        names, counts = re.search(r"(re-started .*bus-off)\s*\n\s*([\d ]+)", shown).groups()
        return dict(zip(names.split(), map(int, counts.split())))["bus-off"]

    def close(self):
        os.close(self._tty)
        os.close(self._line)

    def _say(self, command):
        os.write(self._line, command.encode("ascii") + b"\r")

    def _listen(self):
        rest = b""
        while True:
            try:
                rest += os.read(self._line, 4096)
            except OSError:
                return
            now = time.monotonic()
            *commands, rest = rest.split(b"\r")
            for command in commands:
                if command.startswith(b"t"):
                    self.received.append((now, command[1:4].decode("ascii"), command[5:].decode("ascii")))
