"""The codec's result for a signal, worked out in exact decimal arithmetic from the DBC file's figures."""
import math
import struct
from dataclasses import dataclass, field
from fractions import Fraction

VALID, NOT_AVAILABLE, OUT_OF_RANGE = "0", "1", "2"


def to_float(number):
    """The float (IEEE 754, 32 bits) nearest to a number, as a Python float."""
    try:
        return struct.unpack("<f", struct.pack("<f", float(number)))[0]
    except OverflowError:
        return math.copysign(math.inf, number)


@dataclass
class Signal:
    """One signal as an independent DBC library describes it; factor, offset and limits are Fractions."""
    name: str
    length: int
    is_signed: bool
    factor: Fraction
    offset: Fraction
    minimum: Fraction
    maximum: Fraction
    start: int
    names: dict = field(default_factory=dict)  # raw value to text

    @property
    def missing(self):
        return next((raw for raw, text in self.names.items() if text == "not available"), None)

    @property
    def is_enumeration(self):
        return len(self.names) > (self.missing is not None)

    @property
    def is_scaled(self):
        return not self.is_enumeration and (self.factor != 1 or self.offset != 0 or self.missing is not None)

    @property
    def raw_limits(self):
        return (-(1 << (self.length - 1)), (1 << (self.length - 1)) - 1) if self.is_signed else (0, (1 << self.length) - 1)

    @property
    def raw_range(self):
        """The outermost raw values whose physical value is within the range."""
        ends = sorted(((self.minimum - self.offset) / self.factor, (self.maximum - self.offset) / self.factor))
        return math.ceil(ends[0]), math.floor(ends[1])

    def interesting_raws(self):
        low, high = self.raw_limits
        first, last = self.raw_range
        candidates = {low, low + 1, high, high - 1, first, first - 1, last, last + 1, 0, 1, -1, self.start, *self.names}
        return sorted(raw for raw in candidates if low <= raw <= high)

    def physical(self, raw):
        return raw * self.factor + self.offset

    def status(self, raw):
        if self.missing == raw:
            return NOT_AVAILABLE
        if self.is_enumeration:
            return VALID if raw in self.names else OUT_OF_RANGE
        first, last = self.raw_range
        return VALID if first <= raw <= last else OUT_OF_RANGE

    def decoded_is_right(self, raw, text):
        """Judges 'value:status' that the codec gave for a raw value."""
        value, status = text.split(":")
        if status != self.status(raw):
            return False
        if not self.is_scaled:
            return int(value) == (self.start if status == OUT_OF_RANGE else raw)
        if status != VALID:
            return value == "nan"
        exact = self.physical(raw)
        tolerance = 0 if self.is_exact_in_float(raw) else Fraction(max(abs(exact), abs(self.offset))) / 2**22
        return abs(Fraction(to_float(float(value))) - Fraction(to_float(exact))) <= tolerance

    def encoded_choices(self, value):
        """The range of raw values that are right for a value (an integer, or a float that 32 bits hold): more than one
        only where the rounding of float arithmetic leaves a doubt, near a half or in codes of more than 22 bits."""
        if math.isnan(value):
            return only(self.missing if self.missing is not None else self.start)
        first, last = self.raw_range
        if math.isinf(value):
            return only(last if (value > 0) == (self.factor > 0) else first)
        if self.is_enumeration:
            return only(value if value in self.names else self.start)
        exact = (Fraction(value) - self.offset) / self.factor
        doubt = Fraction(0) if self.is_exact_in_float_of(value) else (
            (abs(Fraction(value)) + abs(self.offset)) / abs(self.factor) / 2**22)
        lowest, highest = (min(max(round_half_away_from_zero(exact + error), first), last) for error in (-doubt, doubt))
        return range(lowest, highest + 1)

    def ratio(self):
        denominator = math.lcm(self.factor.denominator, self.offset.denominator)
        return self.factor * denominator, self.offset * denominator, denominator

    def is_exact_in_float(self, raw):
        """Whether all that a float computation of the physical value meets is exact, but for its last division."""
        numerator, shift, denominator = self.ratio()
        return all(holds(number) for number in (numerator, shift, denominator, raw, raw * numerator,
                                                raw * numerator + shift))

    def is_exact_in_float_of(self, value):
        numerator, shift, denominator = self.ratio()
        product = Fraction(value) * denominator
        return all(holds(number) for number in (numerator, shift, denominator, product, product - shift,
                                                (product - shift) / numerator))


def only(raw):
    return range(raw, raw + 1)


def holds(number):
    """Whether a 32-bit float holds a number exactly."""
    nearest = to_float(number)
    return math.isfinite(nearest) and Fraction(nearest) == number


def round_half_away_from_zero(number):
    whole = math.floor(abs(number) + Fraction(1, 2))
    return whole if number >= 0 else -whole
