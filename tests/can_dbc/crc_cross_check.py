"""Compares the C++ checksum and profile 11 with crccheck, on random data."""
import argparse
import random
import sys

from libraries import give_up
from probe import ask

SEED = 849
ROUNDS = 2000

try:
    from crccheck.crc import Crc8Base, Crc8SaeJ1850
except ModuleNotFoundError:
    give_up("crccheck")


class EffectiveCrc(Crc8Base):
    """The CRC of profile 11 as it works out: polynomial 0x1D, start value 0, no final xor."""
    _poly, _initvalue, _xor_output = 0x1D, 0x00, 0x00


def protected_11(data_id, counter, payload):
    header = bytes([(data_id >> 8) << 4 | counter])
    crc = EffectiveCrc.calc(bytes([data_id & 0xFF, 0]) + header + payload[2:])
    return bytes([crc]) + header + payload[2:]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--probe", required=True, help="the built codec_probe")
    program = parser.parse_args().probe
    generator = random.Random(SEED)
    texts = [generator.randbytes(generator.randint(1, 64)) for _ in range(ROUNDS)]
    frames = [(generator.randint(0, 0xFFF), generator.randint(0, 14), generator.randbytes(8)) for _ in range(ROUNDS)]
    questions = [(f"crc8 {text.hex()}", str(Crc8SaeJ1850.calc(text))) for text in texts]
    questions += [(f"protect11 {data_id} {counter} {payload.hex()}",
                   protected_11(data_id, counter, payload).hex().upper()) for data_id, counter, payload in frames]
    requests, expected = zip(*questions)
    faults = [(request, answer, right) for request, answer, right in zip(requests, ask(program, requests), expected)
              if answer != right]
    for request, answer, right in faults[:20]:
        print(f"{request}: {answer}, but crccheck gives {right}")
    print(f"{len(requests)} checksums against crccheck, {len(faults)} differences")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
