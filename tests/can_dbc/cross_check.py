"""Compares the C++ codec with a DBC library: every signal of every frame, limits and random values, both directions."""
import argparse
import math
import random
import sys

from expectation import Signal, to_float
from libraries import LIBRARIES, open_library
from probe import ask

SEED = 20090
ROUNDS = 200
PROTECTION = ("E2eCrc", "E2eCounter", "E2eDataIdNibble")  # not the codec's to fill: zero in its payloads
SHOWN_FAULTS = 20


def integer_type_limits(signal):
    """Range of the C++ integer of an unscaled signal."""
    if signal.length == 1 and not signal.is_signed and not signal.is_enumeration:
        return 0, 1
    bits = next(bits for bits in (8, 16, 32) if signal.length <= bits)
    return (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) if signal.is_signed else (0, (1 << bits) - 1)


def interesting_values(signal):
    """Values to encode that stand at a border of what the signal can carry."""
    if not signal.is_scaled:
        low, high = integer_type_limits(signal)
        wanted = {low, high, *signal.interesting_raws(), *(raw - 1 for raw in signal.interesting_raws())}
        return sorted(value for value in wanted if low <= value <= high)
    physical = [signal.physical(raw + step) for raw in signal.interesting_raws() for step in (-0.5, 0, 0.5)]
    extremes = [math.nan, math.inf, -math.inf, 1e30, -1e30, 3.4028235e38, -3.4028235e38, 0.0, -0.0, 1e-45, -1e-38]
    return [to_float(value) for value in dict.fromkeys((*physical, *extremes))]


def random_value(signal, generator):
    if not signal.is_scaled:
        return generator.randint(*integer_type_limits(signal))
    low, high = signal.raw_limits
    return to_float(signal.physical(generator.uniform(1.1 * low - 1, 1.1 * high + 1)))


def rounds(signals, interesting, random_one):
    """Dictionaries of one item a signal: each signal meets all its interesting ones while the others are random."""
    for signal in signals:
        for item in interesting(signal):
            yield {other.name: item if other is signal else random_one(other) for other in signals}
    for _ in range(ROUNDS):
        yield {signal.name: random_one(signal) for signal in signals}


def check_encoding(library, program, frame, length, signals, generator):
    """The codec's payload must hold the expected code of every signal, and be what the library makes of these codes."""
    carried = [signal for signal in signals if signal.name not in PROTECTION]
    cases = list(rounds(carried, interesting_values, lambda signal: random_value(signal, generator)))
    answers = ask(program, [f"encode {frame} " + " ".join(f"{name}={value!r}" for name, value in case.items())
                            for case in cases])
    for case, answer in zip(cases, answers):
        payload = bytes.fromhex(answer)
        raws, _ = library.decode(frame, payload)
        for signal in carried:
            choices = signal.encoded_choices(case[signal.name])
            if raws[signal.name] not in choices:
                yield f"{frame}.{signal.name}: {case[signal.name]!r} is sent as {raws[signal.name]}, not {choices}"
        again = library.encode(frame, {signal.name: raws[signal.name] if signal in carried else 0 for signal in signals})
        if len(payload) != length or again != payload:
            yield f"{frame}: {case} is sent as {answer}; the library lays it out as {again.hex().upper()}"


def check_decoding(library, program, frame, length, signals, generator):
    """The codec's values and statuses must follow from the codes that the library finds in a payload."""
    carried = [signal for signal in signals if signal.name not in PROTECTION]
    cases = [library.encode(frame, case) for case in
             rounds(signals, Signal.interesting_raws, lambda signal: generator.randint(*signal.raw_limits))]
    cases += [generator.randbytes(length) for _ in range(ROUNDS)]
    answers = ask(program, [f"decode {frame} {payload.hex()}" for payload in cases])
    for payload, answer in zip(cases, answers):
        raws, physicals = library.decode(frame, payload)
        values = dict(item.split("=") for item in answer.split())
        if set(values) != {signal.name for signal in carried}:
            yield f"{frame}: the codec knows {sorted(values)}"
            continue
        for signal in carried:
            text = values[signal.name]
            if not signal.decoded_is_right(raws[signal.name], text):
                yield f"{frame}.{signal.name}: {raws[signal.name]} in {payload.hex().upper()} is read as {text}"
            value = float(text.split(":")[0])
            library_value = float(physicals[signal.name])
            if text.endswith(":0") and not math.isclose(value, library_value, rel_tol=1e-6, abs_tol=1e-5 * abs(signal.offset)):
                yield f"{frame}.{signal.name}: read as {value}, by the library as {library_value}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--library", choices=sorted(LIBRARIES), required=True)
    parser.add_argument("--dbc", required=True)
    parser.add_argument("--probe", required=True, help="the built codec_probe")
    arguments = parser.parse_args()
    library = open_library(arguments.library, arguments.dbc)
    generator = random.Random(SEED)
    faults, frames, count = [], 0, 0
    for frame, length, signals in library.frames():
        frames, count = frames + 1, count + len(signals)
        for check in (check_encoding, check_decoding):
            faults += check(library, arguments.probe, frame, length, signals, generator)
    for fault in faults[:SHOWN_FAULTS]:
        print(fault)
    print(f"{arguments.dbc} against {arguments.library}: {frames} frames, {count} signals, {len(faults)} differences")
    return 1 if faults or not count else 0


if __name__ == "__main__":
    sys.exit(main())
