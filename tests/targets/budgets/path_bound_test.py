"""Tests of the bound by the longest path, on functions assembled for both kinds of instructions: counts that were made
by hand, and planted faults, each of which must be refused."""

import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import binary_tools
import control_flow
import loop_table
import loop_watch
import path_bound

SOURCES = HERE / "paths"
PROCESSORS = {"thumb": ("-mcpu=cortex-m4", "-mthumb"), "arm": ("-mcpu=cortex-r5", "-marm")}

# Instructions of each in its comment, counted by hand.
EXPECTED = {
    "either_side": 6,
    "counted_down": 18,
    "tested_first": 1 + 5 * 2 + 4 * 2 + 1,
    "to_an_address": 16,
    "compared_before": 1 + 4 * 4 + 2 + 1,
    "begins_at_either": 3 + 1 + 9 * 2 + 1,
    "two_counters": 2 + 5 * 4 + 1,
    "to_a_literal": 2 + 4 * 3 + 1,
    "nested": 26,
    "left_from_within": 1 + 9 * 4 + 2 + 4,
    "calls": 2 + 3 * 21 + 1,
    "ends_with_a_jump": 20,
    "copies": 1 + 1 + 1 + 13 + 1 + 1 + 9 + 1,
}
OWN_EXPECTED = {"thumb": {"conditional": 6, "table": 6}, "arm": {"conditional": 5, "table": 5}}
UNCOUNTED = (
    "data_decides", "grows_unevenly", "passes_its_end", "counter_is_lost", "counter_is_lost_at_times",
    "another_result_ends_it", "begins_at_either_by_then", "counts_at_times", "counts_a_load_at_times", "wraps",
    "goes_on_if_equal", "tested_at_times", "counts_in_an_inner_loop", "end_moves", "ends_elsewhere", "copy", "copies_some",
)
REFUSED = {
    "by_pointer": r"by_pointer\+0x\d .*an indirect call: blx r0",
    "anywhere": r"anywhere\+0x\d .*an indirect jump: bx r0",
    "calls_itself": "recursion: calls_itself",
    "two_entries": r"two_entries\+0x\w+ .*leads back into the middle of a loop",
    "runs_on": r"runs_on\+0x0 .*runs on into another function",
    "calls_the_system": r"calls_the_system\+0x0 .*a jump that is not known: svc",
    "table_without_a_test": r"table_without_a_test\+0x0 .*no comparison bounds the index",
    "table_without_a_guard": r"table_without_a_guard\+0x\w+ .*no comparison bounds the index",
    "table_of_another_test": r"table_of_another_test\+0x\w+ .*no comparison bounds the index",
    "table_of_the_higher_ones": r"table_of_the_higher_ones\+0x\w+ .*no comparison bounds the index",
    "table_past_its_test": r"table_past_its_test\+0x\w+ .*a way leads past the comparison",
}
COPY = """
[argument]
copy = "r2"
[[loop]]
function = "copy"
code = "bne 1b"
per = 1
reason = "the argument"
"""
SOME = """
[[most]]
function = "copies_some"
called = "copy"
most = 3
reason = "never more"
"""
POINTERS = """
[[call]]
function = "by_pointer"
code = "blx r0"
targets = ["either_side", "counted_down"]
reason = "these two"
[[call]]
function = "anywhere"
code = "bx r0"
targets = []
reason = "never"
"""
FIVE_TURNS = """
[[loop]]
function = "data_decides"
code = "bne 1b"
times = 5
source = "constants.h"
constant = "most = 5;"
reason = "never more than most"
"""


class Images(unittest.TestCase):
    """The same functions for both kinds of instructions."""

    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.kept.name)
        (cls.folder / "constants.h").write_text("constexpr int most = 5;\n")
        cls.paths = {}
        for name, flags in PROCESSORS.items():
            cls.paths[name] = cls.folder / f"{name}.elf"
            options = [*flags, "-g", "-nostdlib", f"-Wa,-I,{SOURCES}", "-Wl,-e,calls,-Ttext=0x8000"]
            binary_tools.run("gcc", *options, SOURCES / f"{name}.s", "-o", cls.paths[name])

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def image(self, processor, entries=COPY):
        table = loop_table.LoopTable(entries, self.folder)
        return path_bound.Image(self.paths[processor], table, SOURCES), table

    def both(self, entries=COPY):
        return [(*self.image(processor, entries), processor) for processor in PROCESSORS]


class LongestPath(Images):
    def test_the_bounds_are_those_counted_by_hand(self):
        for image, table, processor in self.both():
            found = {name: image.bound(name) for name in EXPECTED | OWN_EXPECTED[processor]}
            self.assertEqual(found, EXPECTED | OWN_EXPECTED[processor])
            self.assertEqual(list(image.problems.values()) + table.unused(table.used), [])

    def test_every_planted_fault_is_refused_with_its_place(self):
        for image, _, _ in self.both():
            for function, message in REFUSED.items():
                with self.assertRaisesRegex(control_flow.FlowError, message):
                    image.bound(function)
            with self.assertRaisesRegex(control_flow.FlowError, "forever.* never ends"):
                image.bound("forever")

    def test_a_loop_that_does_not_count_to_a_constant_needs_an_entry(self):
        for function in UNCOUNTED:
            for image, _, _ in self.both():
                image.bound(function)
                (problem,) = image.problems.values()
                inner = function.replace("copies_some", "copy")
                self.assertRegex(problem, rf"^{inner}\+0x\w+ .*a loop without a bound: .*code = 'bne 1b'")

    def test_an_entry_bounds_its_loop(self):
        for image, table, _ in self.both(FIVE_TURNS):
            self.assertEqual(image.bound("data_decides"), 5 * 2 + 1)
            self.assertEqual(list(image.problems.values()) + table.problems + table.unused(table.used), [])

    def test_the_dearest_way_out_of_a_loop_counts(self):
        four_turns = '[[loop]]\nfunction = "two_ways_out"\ncode = "b 1b"\ntimes = 4\nreason = "never more"\n'
        for image, _, _ in self.both(four_turns):
            self.assertEqual(image.bound("two_ways_out"), 1 + 3 * 10 + 9 + 1)

    def test_an_argument_that_is_no_constant_has_the_bound_of_its_entry(self):
        for image, table, _ in self.both(COPY + SOME):
            self.assertEqual(image.bound("copies_some"), 1 + 1 + (1 + 2 * 3) + 1)
            self.assertEqual(list(image.problems.values()) + table.unused(table.used), [])

    def test_the_dearest_of_the_functions_behind_a_pointer_counts(self):
        for image, table, _ in self.both(POINTERS):
            self.assertEqual((image.bound("by_pointer"), image.bound("anywhere")), (1 + 1 + 18 + 1, 2))
            self.assertEqual(table.unused(table.used), [])

    def test_a_function_behind_a_pointer_that_is_not_in_the_image_is_refused(self):
        for image, _, _ in self.both(POINTERS.replace("counted_down", "gone")):
            with self.assertRaisesRegex(control_flow.FlowError, r"by_pointer\+0x\d .*calls gone by loop_bounds.toml"):
                image.bound("by_pointer")

    def test_an_entry_without_a_reason_is_refused(self):
        _, table = self.image("arm", SOME.replace("never more", ""))
        self.assertEqual(table.problems, ["loop_bounds.toml gives no reason for copies_some"])

    def test_an_entry_for_no_loop_is_refused(self):
        for image, table, _ in self.both(FIVE_TURNS):
            image.bound("nested")
            self.assertEqual(table.unused(table.used), [
                "nothing needs the [[loop]] of data_decides (`bne 1b`) in loop_bounds.toml"
            ])

    def test_an_entry_for_a_loop_that_counts_to_a_constant_is_refused(self):
        for image, table, _ in self.both(FIVE_TURNS.replace("data_decides", "counted_down")):
            self.assertEqual(image.bound("counted_down"), EXPECTED["counted_down"])
            self.assertEqual(len(table.unused(table.used)), 1)

    def test_a_constant_that_is_no_longer_in_the_source_is_refused(self):
        _, table = self.image("arm", FIVE_TURNS.replace("most = 5;", "most = 6;"))
        (problem,) = table.problems
        self.assertEqual(problem, "the bound of data_decides rests on `most = 6;`, which is not in constants.h")

    def test_fewer_turns_shorten_the_path(self):
        image, _ = self.image("thumb")
        longest = image.bound("nested")
        self.assertEqual(image.bound_with("nested", dict.fromkeys(image.loops, 1)), 1 + 1 + 3 + 2 + 1)
        self.assertEqual(image.bound("nested"), longest)


class Executed(Images):
    """Blocks as QEMU executes them: the instructions of a function by their numbers."""

    def watched(self, function, *calls, entries=FIVE_TURNS):
        image, _ = self.image("thumb", entries)
        image.bound(function)
        watch = loop_watch.Watch(image)
        addresses = sorted(image.ways())
        for blocks in calls:
            watch.enter()
            for numbers in blocks:
                watch.executed([addresses[number] for number in numbers])
            watch.leave()
        return list(watch.problems()), watch

    def test_as_many_turns_as_the_bound_allows_are_quiet(self):
        problems, watch = self.watched("data_decides", [(0, 1)] * 5 + [(2,)], [(0, 1)] * 5 + [(2,)])
        self.assertEqual(problems, [])
        self.assertEqual(list(watch.most.values()), [5])

    def test_one_turn_more_is_found(self):
        problems, _ = self.watched("data_decides", [(0, 1)] * 6 + [(2,)])
        self.assertRegex(problems[0], r"^data_decides\+0x0 .*`bne 1b` of data_decides turned 6 times, its bound is 5$")

    def test_each_time_that_the_inner_loop_is_entered_counts_by_itself(self):
        inner = [(1, 2, 3, 4), (2, 3, 4), (2, 3, 4), (5, 6)]
        problems, watch = self.watched("nested", [(0, *inner[0]), *inner[1:], *inner, (7,)])
        self.assertEqual(problems, [])
        self.assertEqual(sorted(watch.most.values()), [2, 3])

    def test_a_way_that_is_not_known_is_found(self):
        problems, _ = self.watched("either_side", [(0, 1), (3,)])
        self.assertRegex(problems[0], r"either_side\+0x6 .*was executed after either_side\+0x2")

    def test_a_call_of_a_function_that_is_not_known_is_found(self):
        image, _ = self.image("thumb", POINTERS)
        image.bound("by_pointer")
        (call,) = (address for address, called in image.calls().items() if len(called) == 2)
        addresses = sorted(image.ways())
        start = addresses.index(call) - 1
        for target, problems in ((image.address("either_side"), 0), (image.address("data_decides"), 2)):
            watch = loop_watch.Watch(image)
            watch.enter()
            watch.executed(addresses[start : start + 2])
            watch.enter()
            watch.executed([target])
            self.assertEqual(len(list(watch.problems())), problems)

    def test_code_that_is_not_known_is_found(self):
        image, _ = self.image("thumb")
        image.bound("either_side")
        watch = loop_watch.Watch(image)
        watch.enter()
        watch.executed([0x10])
        watch.executed([0x20])
        first, then = watch.problems()
        self.assertRegex(first + then, r"0x20\) was executed after .*0x10\).*0x10\) was executed first")


if __name__ == "__main__":
    unittest.main()
