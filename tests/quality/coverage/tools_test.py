"""The tools themselves, on a small planted source: what is not reached is found, named, and nothing is passed over."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import reached
import review
import table

PLANTED = """\
namespace planted {
constexpr int at_compile_time(int x) {
    return x + 1;
}
static_assert(at_compile_time(1) == 2);
bool both(bool a, bool b) {
    return a && b;
}
bool either(bool a, bool b, bool c) { return (a && b) || c; }
template <typename T>
T positive(T x) {
    if (x < T{}) {
        return -x;
    }
    return x;
}
bool within(bool x) { return x; }
bool nested(bool a, bool b) { return within(a && b) && b; }
}
int main() {
    const bool results[] = {planted::both(true, true), planted::both(true, false), planted::either(true, true, false),
                            planted::either(false, true, true), planted::either(false, true, false),
                            planted::either(true, false, false), planted::nested(true, true)};
    return (planted::positive(1) + static_cast<int>(planted::positive(-1.0F)) + sizeof results) == 100U;
}
"""


def measured(folder):
    source, program = folder / "planted.cpp", folder / "planted"
    source.write_text(PLANTED)
    subprocess.run(["clang++-19", "-w", "-O1", "-fprofile-instr-generate", "-fcoverage-mapping", "-fcoverage-mcdc",
                    "-o", program, source], check=True, stderr=subprocess.DEVNULL)
    subprocess.run([program], check=True, env={"LLVM_PROFILE_FILE": str(folder / "raw")})
    subprocess.run(["llvm-profdata-19", "merge", "-o", folder / "merged", folder / "raw"], check=True)
    export = subprocess.run(["llvm-cov-19", "export", "-instr-profile", folder / "merged", program], check=True,
                            capture_output=True, text=True)
    return reached.merge([json.loads(export.stdout)["data"][0]], folder, ("planted",))[0]


class Planted(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            cls.file = measured(pathlib.Path(folder))
        cls.keys = {item.key()[1:] for item in cls.file.unreached()}

    def test_a_function_of_the_compiler_alone_is_not_reached(self):
        self.assertIn(("planted::at_compile_time", "line", "return x + 1;"), self.keys)

    def test_a_branch_never_taken_is_found_by_its_side(self):
        self.assertIn(("planted::both", "false", "a"), self.keys)
        self.assertNotIn(("planted::both", "true", "a"), self.keys)
        self.assertNotIn(("planted::both", "false", "b"), self.keys)

    def test_a_condition_that_never_decides_alone_is_found(self):
        self.assertIn(("planted::both", "condition", "a"), self.keys)
        self.assertNotIn(("planted::both", "condition", "b"), self.keys)

    def test_every_condition_of_a_decision_that_is_shown_to_decide_alone_is_reached(self):
        self.assertFalse([key for key in self.keys if key[0] == "planted::either"])

    def test_a_template_is_reached_by_all_its_instances_together(self):
        self.assertFalse([key for key in self.keys if key[0] == "planted::positive"])

    def test_a_decision_that_clang_does_not_count_is_a_problem_and_not_passed_over(self):
        self.assertTrue([problem for problem in self.file.unmeasured() if "within(a && b)" in problem])

    def test_the_table_names_a_file_that_is_not_reached_in_full_beside_its_folder(self):
        text, name = table.table([self.file]), self.file.name
        self.assertIn(f"| {name} | ", text)
        self.assertIn(f"| {name.rpartition('/')[0]} | ", text)
        self.assertIn(f"\n{name},", table.data([self.file]))

    def test_a_missed_goal_is_reported(self):
        self.assertEqual(len(table.missed_goals([self.file])), 3)


class Reviewed(unittest.TestCase):
    ITEM = reached.Item("a.cpp", "f", "true", "x < 0", 7)
    ENTRY = '[[unreached]]\nfile = "a.cpp"\nfunction = "f"\nkind = "true"\ntext = "x < 0"\nwhy = "cannot be"\n'

    def test_a_place_named_with_a_reason_is_no_problem(self):
        self.assertEqual(review.Review(self.ENTRY).problems([self.ITEM]), [])

    def test_a_place_not_named_is_a_problem(self):
        self.assertEqual(len(review.Review("").problems([self.ITEM])), 1)

    def test_a_name_that_is_no_longer_needed_is_a_problem(self):
        self.assertEqual(len(review.Review(self.ENTRY).problems([])), 1)

    def test_an_entry_without_a_reason_is_refused(self):
        for bad in (self.ENTRY.replace("cannot be", " "), self.ENTRY.replace("true", "line 7"), self.ENTRY + self.ENTRY):
            with self.assertRaises(SystemExit):
                review.Review(bad)


if __name__ == "__main__":
    unittest.main()
