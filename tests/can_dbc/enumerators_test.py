"""The firmware's enumerations and those of the DBC file that carry them have the same names and numbers, all of them."""
import pathlib
import re
import sys
import unittest

from libraries import give_up

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "can_dbc/generator"))

try:
    import cantools
    from names import snake_case
except ModuleNotFoundError:
    give_up("cantools")

RSI = "firmware/rsi/rsi.h"
# Enumeration, its file, what its names begin with, and message and signal that carry it.
PAIRS = [
    ("rsi_state", RSI, "RSI_STATE_", "RolloverWarning", "State"),
    ("rsi_side", RSI, "RSI_SIDE_", "RolloverWarning", "Side"),
    ("rsi_roll_source", RSI, "RSI_ROLL_", "RollObserver", "RollSource"),
    ("ParametersRefusal", "firmware/rsi/ecu/application/parameter_section.hpp", "", "RolloverWarning", "ParametersRefusal"),
    ("Protection", "firmware/rsi/ecu/application/section_authority.hpp", "", "RollObserver", "Protection"),
    ("ResetReason", "hal/interface/rsi/hal/reset_reason.hpp", "", "RollObserver", "ResetReason"),
    ("Degradation", "firmware/rsi/ecu/monitoring/degradation.hpp", "", "RolloverDiagnosis", "Degradation"),
    ("EventStatus", "firmware/rsi/ecu/monitoring/diagnostic_event.hpp", "", "RolloverDiagnosis", "CodeStatus"),
    ("DiagnosticCode", "firmware/rsi/ecu/monitoring/diagnostic_code.hpp", "", "RolloverDiagnosis", "Code"),
]


def without_comments(text):
    return re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.DOTALL)


def enumerators(name, path, prefix):
    """Names in the DBC's spelling, with their numbers."""
    text = without_comments((ROOT / path).read_text(encoding="utf-8"))
    body = re.search(rf"enum class {name}\b[^{{;]*{{([^}}]*)}}|typedef enum {{([^}}]*)}} {name};", text)
    numbers, next_number = {}, 0
    for entry in filter(None, (part.strip() for part in (body.group(1) or body.group(2)).split(","))):
        word, _, number = (part.strip() for part in entry.partition("="))
        next_number = int(number, 0) if number else next_number
        numbers[snake_case(word.removeprefix(prefix)).rstrip("_")] = next_number
        next_number += 1
    return numbers


class Enumerators(unittest.TestCase):
    def test_are_those_of_the_dbc_file(self):
        database = cantools.database.load_file(ROOT / "can_dbc/rollover_warning.dbc")
        for name, path, prefix, message, signal in PAIRS:
            with self.subTest(name):
                choices = database.get_message_by_name(message).get_signal_by_name(signal).choices
                sent = {snake_case(str(text)): number for number, text in choices.items()}
                self.assertGreater(len(sent), 2)
                self.assertEqual(enumerators(name, path, prefix), sent)

    def test_every_enumeration_of_the_ecu_is_compared(self):
        database = cantools.database.load_file(ROOT / "can_dbc/rollover_warning.dbc")
        compared = {(message, signal) for *_, message, signal in PAIRS}
        for message in database.messages:
            for signal in message.signals:
                named = [text for text in (signal.choices or {}).values() if str(text) != "not available"]
                if named:
                    self.assertIn((message.name, signal.name), compared)


if __name__ == "__main__":
    unittest.main()
