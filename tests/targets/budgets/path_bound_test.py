"""Tests of the bound by the longest path, on functions assembled for both kinds of instructions: counts that were made
by hand, and planted faults, each of which must be refused."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import binary_tools
import control_flow
import loop_watch
import path_bound

PROCESSORS = {"thumb": ("-mcpu=cortex-m4", "-mthumb"), "arm": ("-mcpu=cortex-r5", "-marm")}

# Instructions of each in its comment, counted by hand.
COMMON = """
    .syntax unified
    .text
    .macro begin name
    .global \\name
    .type \\name, %function
\\name:
    .endm
    .macro finish name
    .size \\name, . - \\name
    .endm

begin either_side  @ 6: the longer side
    cmp r0, #0
    beq 1f
    adds r0, r0, #1
    bx lr
1:  adds r0, r0, #2
    adds r0, r0, #3
    adds r0, r0, #4
    bx lr
finish either_side

begin counted_down  @ 2 + 5 * 3 + 1
    movs r3, #5
    movs r2, #0
1:  adds r2, r2, r3
    subs r3, r3, #1
    bne 1b
    bx lr
finish counted_down

begin tested_first  @ 1 + 5 * 2 + 4 * 2 + 1: the fifth test ends it
    movs r3, #5
1:  subs r3, r3, #1
    beq 2f
    adds r0, r0, #1
    b 1b
2:  bx lr
finish tested_first

begin to_an_address  @ 3 + 4 * 3 + 1
    mov r1, r0
    add r2, r1, #16
    mov r3, r0
1:  ldr r0, [r3], #4
    cmp r3, r2
    bne 1b
    bx lr
finish to_an_address

begin compared_before  @ 1 + 4 * 4 + 2 + 1: the fifth comparison ends it
    movs r3, #0
1:  cmp r3, #4
    beq 2f
    adds r3, r3, #1
    b 1b
2:  bx lr
finish compared_before

begin begins_at_either  @ 3 + 1 + 9 * 2 + 1
    movs r3, #5
    cmp r0, #0
    beq 1f
    movs r3, #9
1:  subs r3, r3, #1
    bne 1b
    bx lr
finish begins_at_either

begin two_counters  @ 2 + 5 * 4 + 1: the first ends it, but the other way out is as near
    movs r3, #5
    movs r2, #9
1:  subs r3, r3, #1
    beq 2f
    subs r2, r2, #1
    bne 1b
2:  bx lr
finish two_counters

begin two_ways_out  @ 1 + 3 * 10 + 9 + 1, with four turns by its entry
    movs r3, #4
1:  cmp r0, #0
    beq 3f
    subs r3, r3, #1
    bne 1b
2:  bx lr
3:  adds r0, r0, #1
    adds r0, r0, #2
    adds r0, r0, #3
    adds r0, r0, #4
    adds r0, r0, #5
    cmp r1, #0
    beq 2b
    b 1b
finish two_ways_out

begin nested  @ 1 + 2 * (1 + 3 * 3 + 2) + 1
    movs r1, #2
1:  movs r2, #3
2:  adds r0, r0, #1
    subs r2, r2, #1
    bne 2b
    subs r1, r1, #1
    bne 1b
    bx lr
finish nested

begin left_from_within  @ 1 + 9 * 4 + 2 + 4: nine whole turns, and out of the tenth by the longer way
    movs r3, #10
1:  cmp r0, r3
    beq 2f
    subs r3, r3, #1
    bne 1b
    bx lr
2:  adds r0, r0, #1
    adds r0, r0, #2
    adds r0, r0, #3
    bx lr
finish left_from_within

begin calls  @ 1 + 3 * (1 + 18 + 2) + 1
    push {r4, lr}
    movs r4, #3
1:  bl counted_down
    subs r4, r4, #1
    bne 1b
    pop {r4, pc}
finish calls

begin ends_with_a_jump  @ 2 + 18: the other returns in its place
    adds r0, r0, #1
    b counted_down
finish ends_with_a_jump

begin copy  @ 1 + 2 * r2
1:  subs r2, r2, #1
    bne 1b
    bx lr
finish copy

begin copies  @ 1 + 1 + 1 + 13 + 1 + 1 + 9 + 1
    push {r4, lr}
    movs r2, #6
    bl copy
    movs r2, #4
    bl copy
    pop {r4, pc}
finish copies

begin to_a_literal  @ 2 + 4 * 3 + 1
    ldr r3, =0x12345670
    ldr r2, =0x12345680
1:  ldr r0, [r3], #4
    cmp r3, r2
    bne 1b
    bx lr
    .ltorg
finish to_a_literal

begin copies_some
    push {r4, lr}
    bl copy
    pop {r4, pc}
finish copies_some

begin data_decides
1:  subs r0, r0, #1
    bne 1b
    bx lr
finish data_decides

begin grows_unevenly
    movs r3, #8
1:  cmp r0, #0
    beq 2f
    subs r3, r3, #1
2:  subs r3, r3, #1
    bne 1b
    bx lr
finish grows_unevenly

begin passes_its_end
    movs r3, #7
1:  subs r3, r3, #2
    cmp r3, #0
    bne 1b
    bx lr
finish passes_its_end

begin begins_at_either_by_then
    movs r3, #5
    cmp r0, #0
    beq 2f
    movs r3, #9
2:  adds r0, r0, #1
1:  subs r3, r3, #1
    bne 1b
    bx lr
finish begins_at_either_by_then

begin counts_at_times
    movs r3, #8
1:  cmp r0, #0
    beq 2f
    subs r3, r3, #1
2:  cmp r3, #0
    bne 1b
    bx lr
finish counts_at_times

begin counts_a_load_at_times
    mov r3, r0
    add r2, r0, #16
1:  cmp r1, #0
    it ne
    ldrne r1, [r3], #4
    cmp r3, r2
    bne 1b
    bx lr
finish counts_a_load_at_times

begin wraps
    movs r3, #0
1:  adds r3, r3, #1
    cmp r3, #0
    bne 1b
    bx lr
finish wraps

begin goes_on_if_equal
    movs r3, #3
1:  adds r3, r3, #1
    cmp r3, #4
    bne 2f
    adds r0, r0, #1
    bne 1b
2:  bx lr
finish goes_on_if_equal

begin tested_at_times
    movs r3, #8
1:  subs r3, r3, #1
    cmp r0, #0
    beq 2f
    cmp r3, #0
    beq 3f
2:  adds r0, r0, #1
    bne 1b
3:  bx lr
finish tested_at_times

begin counts_in_an_inner_loop
    movs r3, #9
1:  movs r2, #2
2:  subs r3, r3, #1
    subs r2, r2, #1
    bne 2b
    cmp r3, #0
    bne 1b
    bx lr
finish counts_in_an_inner_loop

begin end_moves
    movs r2, #4
    movs r3, #0
1:  adds r3, r3, #1
    adds r2, r2, #2
    cmp r3, r2
    bne 1b
    bx lr
finish end_moves

begin ends_elsewhere
    mov r3, r0
    add r2, r1, #16
1:  ldr r0, [r3], #4
    cmp r3, r2
    bne 1b
    bx lr
finish ends_elsewhere

begin counter_is_lost
    push {r4, lr}
    movs r3, #5
1:  bl counted_down
    subs r3, r3, #1
    bne 1b
    pop {r4, pc}
finish counter_is_lost

begin counter_is_lost_at_times
    push {r4, lr}
    movs r3, #5
1:  cmp r0, #0
    it ne
    blne counted_down
    subs r3, r3, #1
    bne 1b
    pop {r4, pc}
finish counter_is_lost_at_times

begin another_result_ends_it
    movs r3, #5
1:  subs r3, r3, #1
    cmp r3, #0
    it ne
    subsne r0, r0, r1, lsl #1
    bne 1b
    bx lr
finish another_result_ends_it

begin by_pointer
    push {r4, lr}
    blx r0
    pop {r4, pc}
finish by_pointer

begin anywhere
    adds r1, r1, #1
    bx r0
finish anywhere

begin calls_itself
    push {r4, lr}
    bl calls_itself
    pop {r4, pc}
finish calls_itself

begin two_entries
    cmp r0, #0
    beq 2f
1:  adds r0, r0, #1
2:  subs r0, r0, #3
    bne 1b
    bx lr
finish two_entries

begin forever
    b forever
finish forever

begin runs_on
    adds r0, r0, #1
finish runs_on

begin calls_the_system
    svc #0
    bx lr
finish calls_the_system
"""

OWN = {
    "thumb": """
begin conditional  @ 6: all count, and the second return is the last
    cmp r0, #0
    ite eq
    moveq r0, #1
    bxne lr
    adds r0, r0, #1
    bx lr
finish conditional

begin table  @ 3 + 3
    cmp r0, #2
    bhi 3f
    tbb [pc, r0]
4:  .byte (3f - 4b) / 2, (2f - 4b) / 2, (1f - 4b) / 2
    .align 1
1:  adds r0, r0, #1
2:  adds r0, r0, #2
3:  bx lr
finish table

begin table_without_a_test
    tbb [pc, r0]
4:  .byte (1f - 4b) / 2, (1f - 4b) / 2
1:  bx lr
finish table_without_a_test

begin table_without_a_guard
    cmp r0, #1
    tbb [pc, r0]
4:  .byte (1f - 4b) / 2, (1f - 4b) / 2
1:  bx lr
finish table_without_a_guard

begin table_of_another_test
    cmp r0, #1
    cmp r1, #1
    bhi 1f
    tbb [pc, r0]
4:  .byte (1f - 4b) / 2, (1f - 4b) / 2
1:  bx lr
finish table_of_another_test

begin table_of_the_higher_ones
    cmp r0, #1
    bhi 2f
    bx lr
2:  tbb [pc, r0]
4:  .byte (1f - 4b) / 2, (1f - 4b) / 2
1:  bx lr
finish table_of_the_higher_ones

begin table_past_its_test
    cmp r1, #0
    beq 5f
    cmp r0, #2
    bhi 1f
5:  tbb [pc, r0]
4:  .byte (1f - 4b) / 2, (1f - 4b) / 2, (1f - 4b) / 2
    .align 1
1:  bx lr
finish table_past_its_test
""",
    "arm": """
begin conditional  @ 5
    cmp r0, #0
    moveq r0, #1
    bxne lr
    adds r0, r0, #1
    bx lr
finish conditional

begin table  @ 2 + 3: the higher ones leave by the branch behind the jump
    cmp r0, #2
    ldrls pc, [pc, r0, lsl #2]
    b 3f
    .word 3f, 2f, 1f
1:  adds r0, r0, #1
2:  adds r0, r0, #2
3:  bx lr
finish table

begin table_without_a_test
    ldr pc, [pc, r0, lsl #2]
    nop
    .word 1f, 1f
1:  bx lr
finish table_without_a_test

begin table_of_another_test
    cmp r0, #1
    cmp r1, #1
    ldrls pc, [pc, r0, lsl #2]
    bx lr
    .word 1f, 1f
1:  bx lr
finish table_of_another_test

begin table_of_the_higher_ones
    cmp r0, #1
    bhi 2f
    bx lr
2:  ldr pc, [pc, r0, lsl #2]
    nop
    .word 1f, 1f
1:  bx lr
finish table_of_the_higher_ones

begin table_without_a_guard
    cmp r0, #1
    ldr pc, [pc, r0, lsl #2]
    nop
    .word 1f, 1f
1:  bx lr
finish table_without_a_guard

begin table_past_its_test
    cmp r1, #0
    beq 5f
    cmp r0, #2
5:  ldrls pc, [pc, r0, lsl #2]
    b 1f
    .word 1f, 1f, 1f
1:  bx lr
finish table_past_its_test
""",
}

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
            source = cls.folder / f"{name}.s"
            source.write_text(COMMON + OWN[name])
            cls.paths[name] = source.with_suffix(".elf")
            options = [*flags, "-g", "-nostdlib", "-Wl,-e,calls,-Ttext=0x8000"]
            binary_tools.run("gcc", *options, source, "-o", cls.paths[name])

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def image(self, processor, entries=COPY):
        table = path_bound.LoopTable(entries, self.folder)
        return path_bound.Image(self.paths[processor], table, self.folder), table

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
