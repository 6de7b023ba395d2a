"""Two independent DBC libraries behind one face: cantools (PyPI) and canmatrix (Debian)."""
import logging
import sys
from decimal import Decimal
from fractions import Fraction

from expectation import Signal


def fraction(number):
    return Fraction(Decimal(str(number)))


class Cantools:
    """Frames of a DBC file as cantools reads them."""

    def __init__(self, path):
        import cantools
        self.database = cantools.database.load_file(path)

    def frames(self):
        for message in self.database.messages:
            yield message.name, message.length, [self._signal(signal) for signal in message.signals]

    @staticmethod
    def _signal(signal):
        return Signal(signal.name, signal.length, signal.is_signed, fraction(signal.scale), fraction(signal.offset),
                      fraction(signal.minimum), fraction(signal.maximum), int(signal.raw_initial or 0),
                      {int(raw): str(text) for raw, text in (signal.choices or {}).items()})

    def encode(self, frame, raws):
        return bytes(self.database.get_message_by_name(frame).encode(raws, scaling=False, strict=False))

    def decode(self, frame, payload):
        """Raw values and physical values of a payload."""
        message = self.database.get_message_by_name(frame)
        return (message.decode(payload, scaling=False, decode_choices=False),
                message.decode(payload, scaling=True, decode_choices=False))


class Canmatrix:
    """Frames of a DBC file as canmatrix reads them."""

    def __init__(self, path):
        logging.disable(logging.CRITICAL)
        import canmatrix.formats
        self.database = canmatrix.formats.loadp_flat(str(path))

    def frames(self):
        for frame in self.database.frames:
            yield frame.name, frame.size, [self._signal(signal) for signal in frame.signals]

    @staticmethod
    def _signal(signal):
        start = int(signal.attributes.get("GenSigStartValue", 0))
        return Signal(signal.name, int(signal.size), bool(signal.is_signed), fraction(signal.factor),
                      fraction(signal.offset), fraction(signal.min), fraction(signal.max), start,
                      {int(raw): str(text) for raw, text in signal.values.items()})

    def encode(self, frame, raws):
        return bytes(self.database.frame_by_name(frame).encode({name: Decimal(raw) for name, raw in raws.items()}))

    def decode(self, frame, payload):
        """Raw values and physical values of a payload."""
        decoded = self.database.frame_by_name(frame).decode(bytes(payload))
        return ({name: int(signal.raw_value) for name, signal in decoded.items()},
                {name: signal.phys_value for name, signal in decoded.items()})


LIBRARIES = {"cantools": Cantools, "canmatrix": Canmatrix}
REMEDIES = {
    "cantools": "cmake/environment/set_up",
    "canmatrix": "cmake/environment/set_up",
    "crccheck": "cmake/environment/set_up",
}


def give_up(package):
    """Ends the test as failed, saying how to get a missing package."""
    sys.exit(f"Python package '{package}' is missing for {sys.executable}.\nRun: {REMEDIES[package]}")


def open_library(name, path):
    try:
        return LIBRARIES[name](path)
    except ModuleNotFoundError as missing:
        if missing.name != name:
            raise
        give_up(name)
