"""The AUTOSAR description, as readers of others see it: autosar-data checks every element against the schema's release and
follows every reference, cantools reads the frames, which must be those of the DBC file."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import autosar_data
import cantools

PROJECT = pathlib.Path(sys.argv.pop(1))
WRITE = PROJECT / "sil/exchange/arxml/write"
RECEPTION = PROJECT / "firmware/rsi/ecu/application/frame_monitor.hpp"
DBC = cantools.database.load_file(PROJECT / "can_dbc/rollover_warning.dbc", sort_signals=None)
PROTECTION_FIELDS = ("E2eCrc", "E2eCounter", "E2eDataIdNibble")
COMPONENT = "/RolloverWarningEcu/ComponentTypes/RolloverWarning"


def written(output):
    return subprocess.run([sys.executable, "-B", WRITE, "--output", output], capture_output=True, text=True, check=False)


def names(choices):
    return {int(number): str(text) for number, text in (choices or {}).items()}


class Description(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = cls.enterClassContext(tempfile.TemporaryDirectory(prefix="rsi_arxml_"))
        cls.path = pathlib.Path(folder) / "rsi.arxml"
        finished = written(cls.path)
        if finished.returncode != 0:
            raise AssertionError(finished.stderr)
        cls.frames = cantools.database.load_file(cls.path, sort_signals=None)
        cls.model = autosar_data.AutosarModel()
        _, cls.warnings = cls.model.load_file(str(cls.path), True)

    def elements(self, name):
        return [element for _, element in self.model.elements_dfs if element.element_name == name]

    def test_keeps_to_the_schema_and_every_reference_leads_somewhere(self):
        self.assertEqual(self.warnings, [])
        self.assertEqual(self.model.check_references(), [])
        self.assertGreater(len(self.elements("SYSTEM-SIGNAL-REF")), 100)

    def test_a_wrong_element_or_reference_would_be_noticed(self):
        text = self.path.read_text(encoding="utf-8")
        with self.assertRaises(autosar_data.AutosarDataError):
            autosar_data.AutosarModel().load_buffer(text.replace("<PERIOD>", "<PERIODS>"), "planted.arxml", True)
        lost = autosar_data.AutosarModel()
        lost.load_buffer(text.replace("Behavior/Step<", "Behavior/Stop<"), "planted.arxml", True)
        self.assertEqual(len(lost.check_references()), 1)

    def test_has_the_frames_of_the_dbc_file(self):
        self.assertEqual({frame.name for frame in self.frames.messages}, {message.name for message in DBC.messages})
        for message in DBC.messages:
            frame = self.frames.get_message_by_name(message.name)
            for property_name in ("frame_id", "is_extended_frame", "is_fd", "length", "cycle_time", "senders"):
                self.assertEqual(getattr(frame, property_name), getattr(message, property_name), message.name)
            self.assertEqual(len(frame.signals), len(message.signals))

    def test_has_the_signals_of_the_dbc_file(self):
        for message in DBC.messages:
            signals = {signal.name: signal for signal in self.frames.get_message_by_name(message.name).signals}
            for wanted in message.signals:
                with self.subTest(message=message.name, signal=wanted.name):
                    signal = signals[f"{message.name}_{wanted.name}"]
                    for name in ("start", "length", "byte_order", "is_signed", "scale", "offset", "receivers"):
                        self.assertEqual(getattr(signal, name), getattr(wanted, name), name)
                    self.assertEqual(signal.unit or "-", wanted.unit)
                    self.assertEqual(signal.raw_initial, wanted.raw_initial or 0)
                    self.assertEqual(names(signal.choices), names(wanted.choices))
                    if self.category(message.name, wanted.name) != "TEXTTABLE":  # a text for each value, and no range
                        self.assertEqual((signal.minimum, signal.maximum), (wanted.minimum, wanted.maximum))

    def category(self, message, signal):
        path = f"/RolloverWarningEcu/CompuMethods/{message}_{signal}"
        return self.model.get_element_by_path(path).get_sub_element("CATEGORY").character_data

    def test_protects_each_frame_as_the_firmware_does(self):
        step = int(re.search(r"largest_counter_step = (\d+)U;", RECEPTION.read_text(encoding="utf-8"))[1])
        for message in DBC.messages:
            protection = self.frames.get_message_by_name(message.name).autosar.e2e
            self.assertEqual(protection.category, "PROFILE_11")
            self.assertEqual(protection.data_ids, [message.dbc.attributes["E2EDataId"].value])
            profile = self.model.get_element_by_path(f"/RolloverWarningEcu/Protection/Profile11/{message.name}").get_sub_element(
                "END-TO-END-PROFILE")
            fields = {signal.name: signal.start for signal in message.signals if signal.name in PROTECTION_FIELDS}
            for name, wanted in (("CRC-OFFSET", fields["E2eCrc"]), ("COUNTER-OFFSET", fields["E2eCounter"]),
                                 ("DATA-ID-NIBBLE-OFFSET", fields["E2eDataIdNibble"]), ("DATA-LENGTH", 8 * message.length),
                                 ("MAX-DELTA-COUNTER-INIT", step)):
                self.assertEqual(int(profile.get_sub_element(name).character_data), wanted, name)

    def test_the_component_has_a_port_for_each_frame_and_steps_in_the_cycle_of_the_warning(self):
        sent = {message.name for message in DBC.messages if "RolloverEcu" in message.senders}
        received = {message.name for message in DBC.messages if "RolloverEcu" in message.receivers}
        self.assertEqual({port.item_name for port in self.elements("P-PORT-PROTOTYPE")}, sent)
        self.assertEqual({port.item_name for port in self.elements("R-PORT-PROTOTYPE")}, received)
        self.assertTrue(sent and received)
        event = self.model.get_element_by_path(f"{COMPONENT}/Behavior/Cycle")
        cycle_ms = DBC.get_message_by_name("RolloverWarning").cycle_time
        self.assertAlmostEqual(1000.0 * float(event.get_sub_element("PERIOD").character_data), cycle_ms)
        accessed = {f"{message.name}_{signal.name}" for message in DBC.messages for signal in message.signals
                    if signal.name not in PROTECTION_FIELDS}
        self.assertEqual({access.item_name for access in self.elements("VARIABLE-ACCESS")}, accessed)

    def test_a_file_that_cannot_be_written_is_one_sentence(self):
        finished = written("/proc/nowhere/rsi.arxml")
        self.assertEqual(finished.returncode, 1)
        self.assertEqual(finished.stderr.count("\n"), 1)
        self.assertIn("check that its folder exists", finished.stderr)


if __name__ == "__main__":
    unittest.main()
