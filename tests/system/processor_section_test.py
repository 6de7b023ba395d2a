"""Parameter sections that are wrong, in the Cortex-R5F's image under QEMU: refused at its start, and said on the bus.

Needs no CAN interface: what the emulated controller sends is taken from QEMU's trace."""

import os
import pathlib
import re
import struct
import subprocess
import tempfile
import time
import unittest
import zlib

import programs

BUILT = programs.PROJECT / "build/cortex-r5f/images/zynqmp_r5"
IMAGE = BUILT / "rsi-ecu-r5f-emulator.elf"
SUPERVISOR = BUILT / "release-r5.elf"
TRACED = re.compile(r"ID: 0x0*([0-9a-f]+) DLC: 0x\w+ DATA:((?: 0x\w\w)+)")
STATUS_IDENTIFIER = "231"
LONGEST_S = 60.0


def sealed(section):
    """With the checksum that belongs to what is in it."""
    return section[:-4] + struct.pack("<I", zlib.crc32(section[:-4]))


def changed(section, at, new):
    return section[:at] + new + section[at + len(new):]


class WrongSection(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="rsi_system_")))
        section = cls.folder / "section.bin"
        finished = programs.run("rsi-sil", "parameters", "--parameters", programs.CALIBRATION, "--output", section)
        if finished.returncode != 0:
            raise AssertionError(finished.stderr)
        cls.good = section.read_bytes()

    def first_frames(self, section):
        """The first frame of each identifier that the image with this section sends, in its third cycle or later."""
        (self.folder / "section.bin").write_bytes(section)
        image = self.folder / "image.elf"
        subprocess.run(
            ["arm-none-eabi-objcopy", "--update-section", f".parameters={self.folder}/section.bin", IMAGE, image],
            check=True,
        )
        trace = self.folder / "trace"
        trace.write_text("", encoding="ascii")
        command = ["qemu-system-aarch64", "-M", "xlnx-zcu102", "-smp", "6", "-m", "128", "-nodefaults", "-display", "none",
                   "-serial", "none", "-monitor", "none", "-object", "can-bus,id=bus", "-machine", "canbus0=bus",
                   "-device", f"loader,file={image}", "-device", f"loader,file={SUPERVISOR},cpu-num=0",
                   "-trace", "xlnx_can_tx_data", "-D", str(trace)]
        with open(self.folder / "messages", "w", encoding="ascii") as messages:
            emulator = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=messages, stderr=messages,
                                        env=dict(os.environ, QEMU_AUDIO_DRV="none"))
        try:
            deadline = time.monotonic() + LONGEST_S
            while trace.read_text(encoding="ascii").count("ID: 0x00000231") < 3:
                if time.monotonic() > deadline or emulator.poll() is not None:
                    self.fail("the image sent nothing: " + (self.folder / "messages").read_text(encoding="ascii"))
                time.sleep(0.02)
        finally:
            emulator.kill()
            emulator.wait()
        frames = {}
        for identifier, data in TRACED.findall(trace.read_text(encoding="ascii")):
            frames[identifier.upper().zfill(3)] = data.replace(" 0x", "").upper()
        return frames

    def check(self, section, refusal):
        frames = self.first_frames(section)
        warning = bytes.fromhex(frames[programs.WARNING_IDENTIFIER])
        status = int.from_bytes(bytes.fromhex(frames[STATUS_IDENTIFIER]), "little")
        self.assertEqual(warning[2] & 0x7, 0, "unavailable")
        self.assertEqual(warning[2] >> 5, refusal, "RolloverWarning.ParametersRefusal")
        self.assertEqual(status >> 30 & 1, int(refusal != 0), "RolloverStatus.ParametersInvalid")

    def test_the_right_one_is_taken(self):
        self.check(self.good, 0)

    def test_erased_memory(self):
        self.check(b"\xff" * len(self.good), 1)

    def test_another_version_of_the_format(self):
        self.check(sealed(changed(self.good, 4, b"\x02")), 2)

    def test_a_section_of_another_set_of_parameters(self):
        self.check(sealed(changed(self.good, 8, b"\x00\x00\x00\x00")), 3)

    def test_a_wrong_length(self):
        self.check(sealed(changed(self.good, 12, struct.pack("<I", len(self.good) + 4))), 4)

    def test_one_wrong_bit(self):
        self.check(changed(self.good, 100, bytes([self.good[100] ^ 1])), 5)

    def test_a_value_out_of_its_range(self):
        self.check(sealed(changed(self.good, 64, struct.pack("<f", -2060.0))), 6)


if __name__ == "__main__":
    unittest.main()
