"""The Cortex-R5F's image under QEMU on the interface, and a stand-in for the sensors that goes in lock-step with it."""

import socket
import struct

import programs

ECU_IDENTIFIERS = ("0D0", "230", "232", "233", "234", "235", "236", programs.STATUS_IDENTIFIER)


class Processor(programs.Ecu):
    """rsi-ecu-r5f instead of rsi-ecu, with the calibration that its image was built with."""

    PROGRAM = programs.PROJECT / "sil/apps/rsi-ecu-r5f"
    DEFAULTS = ()


class Bus:
    """Frames as (identifier, data), both as candump writes them, to and from the interface."""

    FRAME = struct.Struct("=IB3x8s")

    def __init__(self, timeout_s=programs.LONGEST_S, only=()):
        """Hears every identifier, or `only` some."""
        self.socket = socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
        if only:
            filters = b"".join(struct.pack("=II", int(identifier, 16), 0x7FF) for identifier in only)
            self.socket.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_FILTER, filters)
        self.socket.settimeout(timeout_s)
        self.socket.bind((programs.INTERFACE,))

    def send(self, identifier, data):
        payload = bytes.fromhex(data)
        self.socket.send(self.FRAME.pack(int(identifier, 16), len(payload), payload))

    def receive(self):
        identifier, length, payload = self.FRAME.unpack(self.socket.recv(self.FRAME.size))
        return f"{identifier:03X}", payload[:length].hex().upper()

    def close(self):
        self.socket.close()


def cycles_of(frames):
    """The frames of a log, gathered by their time stamps: cycle number to frames."""
    cycles = {}
    for time, identifier, data in frames:
        cycles.setdefault(round(time / programs.CYCLE_S), []).append((identifier, data))
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
