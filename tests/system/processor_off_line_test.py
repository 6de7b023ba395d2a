"""The Cortex-R5F's image under QEMU by itself: its account of its cycles, and what it makes of wrong parameter sections.

Needs no CAN interface: what the emulated controller sends is taken from QEMU's trace."""

import contextlib
import pathlib
import struct
import subprocess
import tempfile
import time
import unittest
import zlib

import processor
import programs

IMAGE = processor.CORTEX_R5F / "firmware/images/zynqmp_r5/rsi-ecu-r5f-emulator.elf"


def sealed(section):
    """With the checksum that belongs to what is in it."""
    return section[:-4] + struct.pack("<I", zlib.crc32(section[:-4]))


def changed(section, at, new):
    return section[:at] + new + section[at + len(new):]


class Image(unittest.TestCase):
    """Shared by the tests of the image."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="rsi_system_")))
        section = cls.folder / "section.bin"
        finished = programs.run("rsi-sil", "parameters", "--parameters", programs.CALIBRATION, "--output", section)
        if finished.returncode != 0:
            raise AssertionError(finished.stderr)
        cls.good = section.read_bytes()

    @contextlib.contextmanager
    def running(self, section):
        """The emulator with this section in the image; gives the function that reads what was sent so far."""
        (self.folder / "section.bin").write_bytes(section)
        image = self.folder / "image.elf"
        subprocess.run(
            ["arm-none-eabi-objcopy", "--update-section", f".parameters={self.folder}/section.bin", IMAGE, image],
            check=True,
        )
        trace = self.folder / "trace"
        with open(self.folder / "messages", "w", encoding="ascii") as messages:
            emulator = processor.start_emulator(image, messages, *processor.traced_to(trace))

        def sent():
            if emulator.poll() is not None:
                self.fail("the emulator ended: " + (self.folder / "messages").read_text(encoding="ascii"))
            return processor.frames_of(trace.read_text(encoding="ascii"))

        try:
            yield sent
        finally:
            emulator.kill()
            emulator.wait()

    def wait_for_cycles(self, sent, count):
        """The status frames, as soon as there are `count`."""
        deadline = time.monotonic() + programs.LONGEST_S
        while time.monotonic() < deadline:
            statuses = [data for identifier, data in sent() if identifier == programs.STATUS_IDENTIFIER]
            if len(statuses) >= count:
                return statuses
            time.sleep(0.005)
        self.fail("the image sends too little: " + (self.folder / "messages").read_text(encoding="ascii"))


class OffLine(Image):
    def observed_cycles(self):
        """As programs.drift wants them; until there are 300, or the count of missed ones ends."""
        observed = []
        with self.running(self.good) as sent:
            while not observed or observed[-1][1] < 300:
                statuses = self.wait_for_cycles(sent, observed[-1][1] + 1 if observed else 1)
                missed = programs.cycle_overruns_of(statuses[-1])
                if missed >= programs.MOST_OVERRUNS:
                    break
                observed.append((time.monotonic(), len(statuses), missed))
        return observed

    def test_each_cycle_is_kept_or_counted_as_missed(self):
        # The firmware's clock is that of the machine, however busy it is.
        for _ in range(5):
            observed = self.observed_cycles()
            if len(observed) >= programs.Cycles.LEAST:
                break
        self.assertGreaterEqual(len(observed), programs.Cycles.LEAST, "the count of missed cycles ended at once, five times")
        drift = programs.drift(observed)
        print(f"{observed[-1][1]} cycles kept, {observed[-1][2]} missed; {drift:+.2f} from one half to the other")
        self.assertLess(abs(drift), 5.0)

    def first_frames(self, section):
        """The last frame of each identifier after three cycles."""
        with self.running(section) as sent:
            self.wait_for_cycles(sent, 3)
            return dict(sent())

    def check(self, section, refusal):
        frames = self.first_frames(section)
        warning = bytes.fromhex(frames[programs.WARNING_IDENTIFIER])
        status = int.from_bytes(bytes.fromhex(frames[programs.STATUS_IDENTIFIER]), "little")
        self.assertEqual(warning[2] & 0x7, 0, "unavailable")
        self.assertEqual(warning[2] >> 5, refusal, "RolloverWarning.ParametersRefusal")
        self.assertEqual(warning[3:], bytes.fromhex("FF0F000280"), "nothing is said but that nothing is known")
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
