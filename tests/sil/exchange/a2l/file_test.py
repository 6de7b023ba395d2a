"""The A2L: strict for a2ltool and pya2l, complete, and with the ranges, units and choices of the sources."""

import pathlib
import re
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
A2L = pathlib.Path(sys.argv.pop(1))
PROJECT = pathlib.Path(sys.argv.pop(1))
sys.path[1:1] = [str(PROJECT / "sil/tools"), str(PROJECT / "cmake/environment")]

import a2l_file  # noqa: E402
import a2l_objects  # noqa: E402
from log_error import LogError  # noqa: E402

PARAMETERS = (PROJECT / "firmware/rsi/parameters.hpp").read_text()
OUTPUTS = (PROJECT / "firmware/rsi/rsi_outputs.h").read_text()
HEADER = (PROJECT / "firmware/rsi/rsi.h").read_text()
DBC = (PROJECT / "can_dbc/rollover_warning.dbc").read_text()
UNIT_ENDINGS = {"m/s^2": "m/s2", "N m": "N.m", "N m/rad": "N.m/rad", "N m s/rad": "N.m.s/rad", "-": ""}


def ranges():
    """Name to limits, read from the table without the compiler."""
    rows = re.findall(r'\{"(\w+)", &Parameters::\w+, (\S+?)F?, (\S+?)F?\},', PARAMETERS)
    return {name: (float(least), float(largest)) for name, least, largest in rows}


class TheFile(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.module = a2l_file.module_of(A2L)
        cls.objects = a2l_file.objects(cls.module)
        cls.units = {entry["Name"]["Value"]: entry.get("Unit", {}).get("Value", "") for entry in cls.module["COMPU_METHOD"]}

    def test_is_accepted_by_a2ltool(self):
        finished = subprocess.run([a2l_file.BINARIES / "a2ltool", A2L, "--check", "--strict", "--show-xcp"],
                                  capture_output=True, text=True, check=False)
        self.assertEqual(finished.returncode, 0, finished.stdout + finished.stderr)
        self.assertIn("No problems found", finished.stdout)
        self.assertIn("CAN id master: 0x6F0", finished.stdout)
        self.assertIn("CAN id slave: 0x6F1", finished.stdout)

    def test_keeps_to_its_version_for_pya2l(self):
        """Without IF_DATA, of which pya2l says that its blocks come twice when they come once."""
        bare = A2L.with_suffix(".bare.a2l")
        bare.write_text(re.sub(r" */begin IF_DATA.*?/end IF_DATA\n", "", A2L.read_text(), flags=re.S))
        finished = subprocess.run([a2l_file.BINARIES / "pya2l", "-c", bare, "to_json", "-o", "/dev/null"],
                                  capture_output=True, text=True, check=False)
        bare.unlink()
        self.assertEqual((finished.returncode, finished.stdout + finished.stderr), (0, ""))

    def test_that_is_wrong_is_refused_by_a2ltool(self):
        """Else the test before says nothing."""
        wrong = A2L.with_suffix(".wrong.a2l")
        wrong.write_text(A2L.read_text().replace("RL_value 0 CM_kg ", "RL_value 0 CM_none_such ", 1))
        finished = subprocess.run([a2l_file.BINARIES / "a2ltool", wrong, "--check", "--strict"], capture_output=True,
                                  text=True, check=False)
        wrong.unlink()
        self.assertNotIn("No problems found", finished.stdout)

    def test_has_every_parameter_with_its_range(self):
        expected = ranges()
        self.assertEqual(len(expected), int(re.search(r"ParameterField, (\d+)>", PARAMETERS)[1]))
        for name, (least, largest) in expected.items():
            entry = self.objects[name]
            self.assertEqual((entry.kind, entry.data_type), ("CHARACTERISTIC", "RL_value"), name)
            self.assertEqual((entry.least, entry.largest), (least, largest), name)
            self.assertTrue(entry.text, name)

    def test_has_every_selection_with_its_choices(self):
        tables = {entry["Name"]["Value"]: entry for entry in self.module["COMPU_VTAB"]}
        lists = dict(re.findall(r"(\w+)_choices\{\s*\{(.*?)\}\};", PARAMETERS, re.S))
        lists["warning_indicator"] = ",".join(
            f'"{choice}"' for choice in re.findall(r"INDEX\(\w+, \"[^\"]+\", \w+, \w+, \d+, (\w+),", OUTPUTS))
        names = re.findall(r'\{"(\w+)", &Parameters::\w+, \w+\.data\(\)', PARAMETERS)
        self.assertEqual(len(names), 5)
        for name in names:
            entry = self.objects[name]
            choices = re.findall(r'"(\w+)"', lists[name])
            self.assertEqual((entry.kind, entry.data_type, entry.largest), ("CHARACTERISTIC", "RL_selection", len(choices) - 1))
            pairs = tables[f"VT_{name}"]["InValOutVal"]
            self.assertEqual([pair["OutVal"]["Value"] for pair in pairs], choices)

    def test_has_every_output_with_its_unit(self):
        rows = re.findall(r"\b(?:NUMBER|INDEX)\((\w+), \"([^\"]+)\", (?:turns|stays)", OUTPUTS)
        codes = re.findall(r"\bCODE\((\w+), ([A-Z]\w+|0),", OUTPUTS)
        self.assertGreater(len(rows), 30)
        self.assertEqual(len(codes), 5)
        for name, unit in rows:
            entry = self.objects[name]
            self.assertEqual((entry.kind, entry.data_type), ("MEASUREMENT", "FLOAT32_IEEE"), name)
            self.assertEqual(self.units[entry.method], UNIT_ENDINGS.get(unit, unit), name)
            self.assertTrue(entry.text, name)
        for name, _ in codes:
            self.assertEqual((self.objects[name].kind, self.objects[name].data_type), ("MEASUREMENT", "UBYTE"), name)
        status = {"page_in_use", "change_pending", "refused_parameter", "changes_taken_over"}
        measured = {name for name, entry in self.objects.items() if entry.kind == "MEASUREMENT"}
        self.assertEqual(measured - status - set(self.inputs()) - set(self.codes()),
                         {name for name, _ in rows} | {name for name, _ in codes})

    def inputs(self):
        body = re.search(r"typedef struct \{([^{}]*)\} rsi_inputs;", HEADER)[1]
        return re.findall(r"^ +float\s+(\w+);", body, re.M)

    def codes(self):
        """Bits by name: the numbers of the DBC file, and behind the set codes those that are confirmed."""
        values = re.search(r'VAL_ \d+ Code (.*);', DBC)[1]
        numbers = {name.replace(" ", "_"): int(number) for number, name in re.findall(r'(\d+) "([^"]*)"', values)}
        return {f"{kind}_{name}": number + offset for kind, offset in (("code", 0), ("confirmed", 64))
                for name, number in numbers.items() if number}

    def test_has_every_input_with_its_unit_and_range(self):
        begin = self.objects["lateral_specific_force_mps2"].address
        inputs = self.inputs()
        self.assertEqual(len(inputs), 9)
        for place, name in enumerate(inputs):
            entry = self.objects[name]
            self.assertEqual((entry.kind, entry.data_type, entry.address), ("MEASUREMENT", "FLOAT32_IEEE", begin + 4 * place), name)
        force, mass = self.objects["lateral_specific_force_mps2"], self.objects["vehicle_mass_kg"]
        self.assertEqual((force.least, force.largest, self.units[force.method], self.units[mass.method]), (-60, 60, "m/s2", "kg"))

    def test_has_every_code_as_a_bit(self):
        codes = self.codes()
        self.assertGreater(len(codes), 100)
        begin = self.objects["code_imu_lost"].address
        for name, bit in codes.items():
            entry = self.objects[name]
            self.assertEqual((entry.data_type, entry.address, entry.mask), ("UBYTE", begin + bit // 8, 1 << bit % 8), name)

    def test_every_text_has_words_and_not_a_symbol_alone(self):
        for name, entry in self.objects.items():
            words = re.findall(r"(?<![\w'])[a-z]{4,}(?![\w'])", entry.text)
            self.assertTrue(words, f"{name}: {entry.text}")
            self.assertFalse(entry.kind == "CHARACTERISTIC" and entry.text.startswith("rsi_"), name)

    def test_the_tools_read_of_it_what_another_parser_reads(self):
        read = a2l_objects.read(A2L)
        self.assertEqual(list(read.objects), list(self.objects))
        for name, theirs in self.objects.items():
            ours = read.objects[name]
            self.assertEqual((ours.is_parameter, ours.text, ours.address, ours.form, ours.least, ours.largest, ours.unit,
                              ours.mask),
                             (theirs.kind == "CHARACTERISTIC", theirs.text, theirs.address, a2l_objects.FORMS[theirs.data_type],
                              theirs.least, theirs.largest, self.units[theirs.method], theirs.mask), name)
        tables = {table["Name"]["Value"][3:]: [pair["OutVal"]["Value"] for pair in table["InValOutVal"]]
                  for table in self.module["COMPU_VTAB"]}
        self.assertEqual({name: entry.choices for name, entry in read.objects.items() if entry.choices and not entry.mask},
                         {name: choices for name, choices in tables.items() if name != "bit"})
        self.assertEqual(read.objects["code_imu_lost"].choices, tables["bit"])
        memory = self.module["MOD_PAR"]
        self.assertEqual((read.epk, read.epk_at), (memory["EPK"]["Identifier"]["Value"],
                                                   int(memory["ADDR_EPK"][0]["Address"]["Value"])))
        self.assertEqual((read.command_identifier, read.answer_identifier), (0x6F0, 0x6F1))

    def test_the_tools_say_what_is_no_a2l_of_the_project(self):
        cut = A2L.with_suffix(".cut.a2l")
        cut.write_text(A2L.read_text().replace("CAN_ID_SLAVE", "CAN_ID"))
        self.addCleanup(cut.unlink)
        with self.assertRaisesRegex(LogError, "is no A2L of this project; make it"):
            a2l_objects.read(cut)

    def test_no_two_lie_at_the_same_address(self):
        addresses = [(entry.address, entry.mask) for entry in self.objects.values()]
        self.assertEqual(len(addresses), len(set(addresses)))

    def test_every_object_is_in_a_group_and_no_text_is_empty(self):
        grouped = set(re.findall(r"'Value': '(\w+)'", str(self.module["GROUP"])))
        self.assertEqual(set(self.objects) - grouped, set())
        self.assertEqual([name for name, entry in self.objects.items() if not entry.text], [])


if __name__ == "__main__":
    unittest.main()
