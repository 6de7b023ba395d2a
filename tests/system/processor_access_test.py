"""XCP and diagnosis in the Cortex-R5F's image under QEMU, with a bus of its own and the clients of a few lines of xcp_test and diagnosis_test."""

import contextlib
import time
import unittest

import diagnosis_test
import processor
import programs
import xcp_test

IMAGE = processor.CORTEX_R5F / "sil/images/rsi-ecu-r5f-bench.elf"
LONGEST_CHANGE_S = 60.0  # a few cycles of an emulator that is held up
LONGEST_RESET_S = 60.0
LATEST_ANSWER_S = 2.0  # twice the time between two questions
EXTENDED_SESSION = (0x10, diagnosis_test.EXTENDED)


class Access(unittest.TestCase):
    """One emulator for all, and no sensors. Stored data stay until its end, so each test begins with what it needs."""

    @classmethod
    def setUpClass(cls):
        cls.board = cls.enterClassContext(processor.Board(IMAGE))

    def master(self):
        master = xcp_test.Master(self.board.can_socket)
        self.addCleanup(master.socket.close)
        return master

    def workshop(self):
        tester = diagnosis_test.Tester(self.board.can_socket)
        self.addCleanup(tester.socket.close)
        return tester

    def wait_for_change(self, master, changes):
        """Until so many changes have been taken over."""
        end = time.monotonic() + LONGEST_CHANGE_S
        while (change := master.change())[2] != changes:
            self.assertLess(time.monotonic(), end, f"the change is not taken over: {change}")
        self.assertEqual(change[:2], (0, 0), "another change is on its way, or this was refused")

    def test_the_keys_are_public_and_reported_on_the_bus(self):
        self.assertEqual(programs.protection(self.board.can_socket), "unsealed test keys")

    def test_a_parameter_is_changed_taken_over_stored_and_there_after_a_reset(self):
        master = self.master()
        self.assertEqual(master.ask(0xFF, 0), bytes((0xFF, 5, 0x80, 8, 8, 0, 1, 1)))
        self.assertEqual(master.ask(0xF9, 1), bytes((xcp_test.ERROR, 0x25)))  # locked
        master.unlock()
        changes = master.change()[2]
        self.assertNotAlmostEqual(master.read_float("warning_on"), xcp_test.LOWER)
        master.write_float("warning_on", xcp_test.LOWER)
        self.wait_for_change(master, changes + 1)
        self.assertAlmostEqual(master.read_float("warning_on"), xcp_test.LOWER, places=6)
        master.write_float("warning_on", 99.0)
        self.assertEqual(master.change(), (0, xcp_test.FIELDS.index("warning_on") + 1, changes + 1))
        master.write_float("warning_on", xcp_test.LOWER)
        self.wait_for_change(master, changes + 2)
        master.demand(0xF9, 1)  # store
        self.reset(self.workshop())
        master = self.master()
        master.demand(0xFF, 0)
        self.assertEqual(master.change(), (0, 0, 0), "the image has not started anew")
        self.assertAlmostEqual(master.read_float("warning_on"), xcp_test.LOWER, places=6)

    def reset(self, tester):
        """By the tester; until the image answers again, in the session in which it starts."""
        tester.ask(*EXTENDED_SESSION)
        self.assertEqual(tester.ask(0x11, 0x01), b"\x51\x01")
        end = time.monotonic() + LONGEST_RESET_S
        while True:
            tester.send(b"\x22\xF1\x86")
            try:
                if tester.receive_frame(within=1.0)[:5] == b"\x04\x62\xF1\x86\x01":
                    break
            except TimeoutError:
                self.assertLess(time.monotonic(), end, "the image does not come back")
        # On a busy machine answers to the questions above come late; they are not to be taken for those to the next one.
        with contextlib.suppress(TimeoutError):
            while True:
                tester.receive_frame(within=LATEST_ANSWER_S)

    def test_samples_are_whole_and_none_is_lost_without_a_word(self):
        master = self.master()
        master.unlock()
        master.measure(19)
        xcp_test.check_samples(self, master, least=5 * xcp_test.MEASURED_S)

    def test_a_tester_reads_codes_and_clears_them_with_the_key_only(self):
        tester = self.workshop()
        tester.codes_with(diagnosis_test.IMU_LOST, diagnosis_test.FAILS_NOW | diagnosis_test.CONFIRMED)
        self.assertEqual(tester.ask(*EXTENDED_SESSION)[:2], b"\x50\x03")
        self.assertEqual(tester.ask(*diagnosis_test.CLEAR), diagnosis_test.refused(0x14, 0x33))
        self.assertEqual(tester.unlock(), b"\x67\x02")
        diagnosis_test.check_cleared(self, tester)

    def test_data_written_by_a_tester_outlive_a_reset(self):
        tester = self.workshop()
        number = b"\xF1\x90" + diagnosis_test.VEHICLE_NUMBER
        self.assertEqual(tester.unlock(), b"\x67\x02")
        self.assertEqual(tester.ask(0x2E, number), b"\x6E\xF1\x90")
        self.reset(tester)
        self.assertEqual(tester.ask(0x22, b"\xF1\x90"), b"\x62" + number)


if __name__ == "__main__":
    unittest.main()
