"""The generator refuses what it cannot carry, naming the place; it notices drift; and the project's DBC file is complete."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from libraries import give_up

ROOT = pathlib.Path(__file__).resolve().parents[2]
GENERATOR = ROOT / "can_dbc/generator/generate.py"
DBC = ROOT / "can_dbc/rollover_warning.dbc"
SIMULATION = ROOT / "sil/simulation/simulation.dbc"
CAN_FD = ROOT / "tests/can_dbc/can_fd.dbc"
HEADER = ROOT / "can_dbc/include/rsi/can_dbc/generated/rollover_warning.hpp"
GUIDE = ROOT / "docs/can.md"
PROTECTION = ("E2eCrc", "E2eCounter", "E2eDataIdNibble")  # described once, in the comment of the file

try:
    import cantools
except ModuleNotFoundError:
    give_up("cantools")


def generate(*arguments, options=()):
    return subprocess.run([sys.executable, *options, str(GENERATOR), *map(str, arguments)], text=True,
                          capture_output=True, check=False)


class Refusing(unittest.TestCase):
    dbc = DBC

    def refuse(self, old, new, *expected):
        text = self.dbc.read_text()
        self.assertEqual(text.count(old), 1, f"'{old}' must stand once in the DBC file")
        self.refuse_text(text.replace(old, new), *expected)

    def refuse_text(self, text, *expected):
        with tempfile.TemporaryDirectory() as folder:
            changed, header = pathlib.Path(folder, "changed.dbc"), pathlib.Path(folder, "changed.hpp")
            changed.write_text(text)
            result = generate("--dbc", changed, "--output", header)
            self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
            self.assertFalse(header.exists())
        self.assertNotIn("Traceback", result.stderr)
        for part in ("changed.dbc", *expected):
            self.assertIn(part, result.stderr)


class Refusals(Refusing):
    """Each changes one thing in the project's DBC file."""

    def test_multiplexed_signals(self):
        self.refuse("SG_ State : 16", "SG_ State M : 16", "RolloverWarning", "State", "multiplexed")

    def test_overlapping_signals(self):
        self.refuse("Speed : 16|16", "Speed : 17|16", "VehicleMotion", "Speed", "overlapping")

    def test_signals_beyond_the_frame(self):
        self.refuse("SteeringWheelAngle : 48|16", "SteeringWheelAngle : 49|16", "SteeringWheelAngle")

    def test_a_range_that_the_bits_cannot_hold(self):
        self.refuse("(0.01,0) [0|400]", "(0.01,0) [0|700]", "Speed", "70000", "65535")

    def test_a_not_available_code_within_the_range(self):
        self.refuse('VAL_ 290 Speed 65535 "not available"', 'VAL_ 290 Speed 40000 "not available"', "Speed",
                    "within the physical range")

    def test_a_start_value_out_of_range(self):
        self.refuse('SG_ 290 Speed 65535;', 'SG_ 290 Speed 50000;', "Speed", "GenSigStartValue")

    def test_a_missing_start_value_of_a_signal_that_can_be_missing(self):
        line = 'BA_ "GenSigStartValue" SG_ 290 Speed 65535;'
        self.refuse(f"{line}\n", "", "VehicleMotion", "Speed", line)

    def test_a_missing_cycle_time(self):
        line = 'BA_ "GenMsgCycleTime" BO_ 290 10;'
        self.refuse(f"{line}\n", "", "VehicleMotion", line)

    def test_a_missing_range(self):
        self.refuse("(0.01,0) [0|400]", "(0.01,0) [0|0]", "Speed", "no range")

    def test_a_missing_comment(self):
        self.refuse("CM_ SG_ 290 Speed", "CM_ SG_ 290 SpeedOfOld", "VehicleMotion", "CM_ SG_ 290 Speed ")
        self.refuse("CM_ BO_ 290", "CM_ BU_ VehicleGateway", "VehicleMotion", "CM_ BO_ 290 ")

    def test_an_unknown_unit(self):
        self.refuse('[0|400] "km/h"', '[0|400] "furlong"', "Speed", "furlong", "UNIT_ENDINGS")

    def test_value_names_that_give_no_enumerators(self):
        self.refuse('2 "advisory"', '2 "ready"', "State", "ready", "twice")
        self.refuse('2 "advisory"', '2 "17"', "State", "17")

    def test_scaled_signals_with_named_values(self):
        self.refuse('Speed 65535 "not available"', 'Speed 65534 "error" 65535 "not available"', "Speed", "scaled")

    def test_a_protected_message_without_data_identifier(self):
        self.refuse('BA_ "E2EDataId" BO_ 290 1457;\n', "", "VehicleMotion", 'BA_ "E2EDataId" BO_ 290 ')

    def test_a_message_of_the_default_profile_without_a_line_of_its_protection(self):
        block = re.search(r"BO_ 290 .*?\n\n", DBC.read_text(), re.DOTALL).group()
        for line in re.findall(r" SG_ E2e.*\n", block):
            self.refuse(block, block.replace(line, ""), "VehicleMotion", line)

    def test_every_line_that_a_new_frame_lacks_at_once(self):
        lines = [' SG_ E2eCrc : 0|8@1+ (1,0) [0|255] "-" VehicleGateway',
                 ' SG_ E2eCounter : 8|4@1+ (1,0) [0|14] "-" VehicleGateway',
                 ' SG_ E2eDataIdNibble : 12|4@1+ (1,0) [0|15] "-" VehicleGateway',
                 'CM_ BO_ 567 "TEXT";', 'CM_ SG_ 567 Level "TEXT";', 'BA_ "GenMsgCycleTime" BO_ 567 10;',
                 'BA_ "E2EDataId" BO_ 567 NUMBER;', 'BA_ "GenSigStartValue" SG_ 567 Level 4095;']
        frame = 'BO_ 567 New: 8 RolloverEcu\n SG_ Level : 16|12@1+ (0.0005,0) [0|2] "-" VehicleGateway\n\n'
        text = DBC.read_text().replace("BO_ 561 RolloverStatus", f"{frame}BO_ 561 RolloverStatus")
        text += 'VAL_ 567 Level 4095 "not available" ;\n'
        self.refuse_text(text, "message New: these lines are missing:\n" + "\n".join(lines) + "\n")

    def test_a_data_identifier_used_twice(self):
        self.refuse('BO_ 290 1457;', 'BO_ 290 935;', "935", "twice")

    def test_a_protected_message_with_its_counter_elsewhere(self):
        text = DBC.read_text()
        block = re.search(r"BO_ 290 .*?\n\n", text, re.DOTALL).group()
        moved = block.replace("E2eCounter : 8|4", "E2eCounter : 12|4").replace("E2eDataIdNibble : 12|4",
                                                                              "E2eDataIdNibble : 8|4")
        self.refuse(block, moved, "VehicleMotion", "E2eCounter", "8|4")

    def test_profile_11_in_a_can_fd_frame(self):
        before = 'BA_ "E2EDataId" BO_ 290 '
        self.refuse(before, f'BA_ "VFrameFormat" BO_ 290 14;\n{before}', "VehicleMotion", "profile 11", "classic", "none")

    def test_an_unknown_profile(self):
        self.refuse('BA_DEF_DEF_ "E2EProfile" "P11"', 'BA_DEF_DEF_ "E2EProfile" "P01"', "Imu", "P01", "none and P11")

    def test_ieee_floating_point(self):
        self.refuse('VAL_ 208 State', 'SIG_VALTYPE_ 290 Speed : 1;\nVAL_ 208 State', "SIG_VALTYPE_")

    def test_text_that_is_no_dbc_file(self):
        self.refuse("BU_: ImuSensor", "BU ImuSensor", "changed.dbc")

    def test_a_file_that_is_not_there(self):
        result = generate("--dbc", "no_such.dbc", "--output", "unused.hpp")
        self.assertEqual(result.returncode, 2)
        self.assertIn("no_such.dbc", result.stderr)
        self.assertNotIn("Traceback", result.stderr)

    def test_a_file_without_an_end(self):
        result = generate("--dbc", "/dev/zero", "--output", "unused.hpp")
        self.assertEqual(result.returncode, 2)
        self.assertIn("/dev/zero: cannot be read: it is a device or a pipe and no ordinary file", result.stderr)

    def test_a_header_that_cannot_be_written(self):
        with tempfile.TemporaryDirectory() as folder:
            for place, why in ((pathlib.Path(folder, "none", "header.hpp"), "No such file or directory"), (folder, "it is a folder")):
                result = generate("--output", place)
                self.assertEqual(result.returncode, 1)
                self.assertIn(f"cannot write {os.path.realpath(place)}: {why}", result.stderr)
                self.assertNotIn("Traceback", result.stderr)

    def test_a_python_without_its_packages(self):
        result = generate("--check", options=("-S",))
        self.assertEqual(result.returncode, 1)
        for command in ("cmake/environment/set_up", "build/venv/bin/python3 can_dbc/generator/generate.py", "pip install -r"):
            self.assertIn(command, result.stderr)


    def test_a_source_that_is_no_name(self):
        self.refuse('SG_ 563 Rsi "rsi"', 'SG_ 563 Rsi "outputs.rsi"', "RollIndicesClassic", "Rsi", "outputs.rsi", "name")

    def test_a_source_in_a_unit_without_a_factor(self):
        self.refuse('"time_to_rollover_s"', '"time_to_rollover_rad"', "TimeToRollover", "time_to_rollover_rad", "unit",
                    "CONVERSIONS")


class SimulationRefusals(Refusing):
    """Each changes one thing in the simulation's DBC file, whose frame is not protected."""
    dbc = SIMULATION

    def test_signals_longer_than_32_bits(self):
        self.refuse("BO_ 2032 SimulationSync: 4 Simulator\n SG_ CycleNumber : 0|32",
                    "BO_ 2032 SimulationSync: 8 Simulator\n SG_ CycleNumber : 0|33", "CycleNumber", "33 bits")

    def test_classic_frames_of_more_than_8_bytes(self):
        self.refuse("BO_ 2032 SimulationSync: 4", "BO_ 2032 SimulationSync: 9", "SimulationSync", "9 bytes",
                    "VFrameFormat")


class CanFdRefusals(Refusing):
    """Each changes one thing in a DBC file with CAN FD frames."""
    dbc = CAN_FD

    def test_lengths_that_can_fd_does_not_have(self):
        self.refuse("BO_ 769 BodyMotion: 24", "BO_ 769 BodyMotion: 25", "BodyMotion", "25 bytes", "20, 24, 32")


class Drift(unittest.TestCase):
    def test_a_header_that_matches_is_accepted(self):
        result = generate("--check")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_a_header_that_differs_is_shown_and_left_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            header = pathlib.Path(folder, "edited.hpp")
            edited = HEADER.read_text().replace("0x120U", "0x123U")
            header.write_text(edited)
            result = generate("--check", "--output", header)
            self.assertEqual(result.returncode, 1)
            self.assertRegex(result.stdout, r"(?m)^-.*0x123U")
            self.assertRegex(result.stdout, r"(?m)^\+.*0x120U")
            self.assertIn("generate.py", result.stderr)
            self.assertEqual(header.read_text(), edited)

    def test_a_missing_header_is_a_difference(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(generate("--check", "--output", pathlib.Path(folder, "none.hpp")).returncode, 1)


class Page(unittest.TestCase):
    def write(self, text, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            page, header = pathlib.Path(folder, "page.md"), pathlib.Path(folder, "header.hpp")
            page.write_text(text)
            result = generate("--output", header, "--page", page, *arguments)
            return result, page.read_text(), header.exists()

    def test_the_table_of_messages_is_written_and_the_rest_left_alone(self):
        result, page, _ = self.write("Before.\n<!-- written by generate_codec -->\n| row before |\n\nAfter.\n")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(page.startswith("Before.\n<!-- written by generate_codec -->\n| frame | identifier |"), page)
        self.assertTrue(page.endswith(" |\n\nAfter.\n"), page)
        self.assertNotIn("row before", page)
        self.assertIn("\n| RolloverWarning | 0x0D0 | 0x61E | RolloverEcu | Rollover warning", page)

    def test_a_table_that_differs_is_shown_and_left_alone(self):
        text = GUIDE.read_text().replace("| Imu | 0x120 |", "| Imu | 0x123 |")
        result, page, header_written = self.write(text, "--check")
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stdout, r"(?m)^-\| Imu \| 0x123 \|")
        self.assertIn("page.md does not match", result.stderr)
        self.assertIn("generate_codec", result.stderr)
        self.assertEqual((page, header_written), (text, False))

    def test_a_page_without_the_place_is_refused(self):
        result, page, header_written = self.write("Nothing.\n")
        self.assertEqual(result.returncode, 2)
        self.assertIn("page.md has 0 places", result.stderr)
        self.assertEqual((page, header_written), ("Nothing.\n", False))


class Completeness(unittest.TestCase):
    """Properties of the project's DBC file that readers rely on."""
    dbc = DBC

    @classmethod
    def setUpClass(cls):
        cls.text = cls.dbc.read_text()
        cls.database = cantools.database.load_file(cls.dbc)

    def test_the_header_is_vectors(self):
        keywords = "NS_DESC_ CM_ BA_DEF_ BA_ VAL_ CAT_DEF_ CAT_ FILTER BA_DEF_DEF_ EV_DATA_ ENVVAR_DATA_ SGTYPE_ " \
                   "SGTYPE_VAL_ BA_DEF_SGTYPE_ BA_SGTYPE_ SIG_TYPE_REF_ VAL_TABLE_ SIG_GROUP_ SIG_VALTYPE_ " \
                   "SIGTYPE_VALTYPE_ BO_TX_BU_ BA_DEF_REL_ BA_REL_ BA_DEF_DEF_REL_ BU_SG_REL_ BU_EV_REL_ BU_BO_REL_ " \
                   "SG_MUL_VAL_"
        self.assertTrue(self.text.startswith('VERSION ""\n\nNS_ :\n\t' + "\n\t".join(keywords.split()) + "\n\nBS_:\n"))

    def test_every_message_is_described(self):
        for message in self.database.messages:
            with self.subTest(message.name):
                self.assertTrue(message.comment)
                self.assertEqual(len(message.senders), 1)
                self.assertTrue(message.receivers)
                self.assertEqual(message.cycle_time, 10)
                self.assertFalse(message.is_fd)

    def test_every_signal_is_described(self):
        for message in self.database.messages:
            for signal in message.signals:
                with self.subTest(f"{message.name}.{signal.name}"):
                    self.assertTrue(signal.comment or signal.name in PROTECTION)
                    self.assertTrue(signal.unit)
                    self.assertIsNotNone(signal.minimum)
                    self.assertIsNotNone(signal.maximum)
                    self.assertTrue(signal.receivers)


    def test_the_comment_of_the_file_describes_the_protection(self):
        comment = re.search(r'^CM_ "(.*)";$', self.text, re.MULTILINE).group(1)
        for name in PROTECTION:
            self.assertIn(name, comment)


class SimulationCompleteness(Completeness):
    dbc = SIMULATION

    def test_the_comment_of_the_file_describes_the_protection(self):
        self.assertFalse({signal.name for message in self.database.messages for signal in message.signals}.intersection(PROTECTION))

    def test_the_guide_lists_every_message(self):
        for message in self.database.messages:
            self.assertIn(f"| {message.name} | 0x{message.frame_id:03X} | none", GUIDE.read_text())


class Simulation(unittest.TestCase):
    def test_nothing_of_it_is_in_the_vehicles_file(self):
        vehicle, simulation = (cantools.database.load_file(dbc) for dbc in (DBC, SIMULATION))
        self.assertNotIn("Simulator", {node.name for node in vehicle.nodes})
        self.assertFalse({message.name for message in simulation.messages} & {message.name for message in vehicle.messages})
        self.assertFalse({message.frame_id for message in simulation.messages} &
                         {message.frame_id for message in vehicle.messages})

    def test_nothing_of_it_is_in_what_is_flashed(self):
        for room in ("firmware", "hal", "can_dbc"):
            for path in sorted((ROOT / room).rglob("*")):
                if path.suffix in (".hpp", ".h", ".cpp", ".c", ".S", ".txt", ".dbc"):
                    with self.subTest(str(path)):
                        self.assertNotRegex(path.read_text(), r'SimulationSync|simulation_dbc|lock_step|#include "sil/|0x7F0\b')


if __name__ == "__main__":
    unittest.main()
