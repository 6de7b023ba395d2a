"""Tests of the tools that measure and judge: each must find what it is there for, and be quiet otherwise."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "support")]

import binary_tools
import call_graph
import exported_build
import image_size
import image_symbols
import instruction_trace
import library_stack
import limits
import measurement
import report_page
import table


class FakeProgram:
    """Functions of instructions of four bytes each; a mask is given for each instruction."""

    def __init__(self, names, **functions):
        self.names = names
        self.functions, self.mnemonics, self.lengths, self.masks, self.function_at = {}, {}, {}, {}, {}
        for number, (function, instructions) in enumerate(functions.items(), start=1):
            start = number * 0x100
            self.functions[function] = start
            for i, (mnemonic, mask) in enumerate(instructions):
                address = start + 4 * i
                self.mnemonics[address] = mnemonic
                self.lengths[address] = 4
                self.masks[address] = mask
                self.function_at[address] = start
        self.starts = set(self.functions.values())


def trace_of(*blocks, processor=0):
    """Lines of QEMU's log: each block (first address, number of instructions) is translated once, then executed."""
    lines, known = [], set()
    for start, count in blocks:
        if (start, count) not in known:
            known.add((start, count))
            lines += ["----------------\n", "IN: somewhere\n"]
            lines += [f"0x{start + 4 * i:08x}:  e320f000  nop\n" for i in range(count)] + ["\n"]
        lines.append(f"Trace {processor}: 0x7f00 [00800400/{start:08x}/00000110/ff000200] name\n")
    return lines


class InstructionTrace(unittest.TestCase):
    # main at 0x100 calls step at 0x200, which calls inner at 0x300 and jumps on to tail at 0x400.
    program = FakeProgram(
        ["inner", "inlined", "tail", "step"],
        main=[("mov", 0), ("bl", 0), ("mov", 0)],
        step=[("push", 8), ("vadd.f32", 8 | 2), ("bl", 8), ("vmla.f32", 8), ("b", 8)],
        inner=[("vmul.f32", 1), ("bx", 1)],
        tail=[("vldr", 4), ("bx", 4)],
    )
    blocks = [(0x100, 2), (0x200, 3), (0x300, 2), (0x20C, 2), (0x400, 2), (0x108, 1)]

    def read(self, lines, **options):
        return instruction_trace.read(lines, self.program, ["step"], **options)

    def test_counts_a_call_and_what_is_within_it(self):
        (call,) = self.read(trace_of(*self.blocks))
        self.assertEqual(call.instructions, 9)
        self.assertEqual(call.operations, 4)  # one each, and two in the multiply-add
        self.assertEqual(dict(call.within), {"inner": 2, "inlined": 1, "tail": 2, "step": 9})
        self.assertEqual(call.operations_within["inner"], 1)

    def test_every_call_counts_by_itself(self):
        first, second = self.read(trace_of(*self.blocks, *self.blocks))
        self.assertEqual(first.instructions, second.instructions)

    def test_the_target_of_a_jump_is_still_within_its_function(self):
        (call,) = self.read(trace_of((0x100, 2), (0x200, 3), (0x300, 2), (0x20C, 2), (0x400, 2), (0x108, 1)))
        self.assertEqual(call.within["step"], call.instructions)

    def test_other_processors_do_not_count(self):
        lines = trace_of(*self.blocks, processor=4)
        self.assertEqual(len(self.read(lines, processor=4)), 1)
        self.assertEqual(self.read(lines, processor=0), [])

    def test_a_trace_that_ends_within_a_call_is_refused(self):
        with self.assertRaisesRegex(instruction_trace.TraceError, "ends within step"):
            self.read(trace_of(*self.blocks[:-1]))

    def test_a_root_that_is_not_in_the_image_is_refused(self):
        with self.assertRaisesRegex(instruction_trace.TraceError, "no function gone"):
            instruction_trace.read([], self.program, ["gone"])

    def test_blocks_never_translated_are_refused(self):
        lines = [line for line in trace_of(*self.blocks) if not line.startswith("0x")]
        with self.assertRaisesRegex(instruction_trace.TraceError, "00000100 .*not in"):
            self.read(lines)

    def test_code_that_is_not_in_the_image_is_refused(self):
        with self.assertRaisesRegex(instruction_trace.TraceError, "00000900 .*not in the image"):
            self.read(trace_of((0x100, 2), (0x900, 1)))

    def test_another_processor_s_lines_may_stand_between_a_block_and_its_execution(self):
        lines = trace_of(*self.blocks, processor=4)
        at = next(i for i, line in enumerate(lines) if line.startswith("Trace"))
        lines[at:at] = trace_of((0x80000, 2))
        self.assertEqual(self.read(lines, processor=4)[0].instructions, 9)

    def test_a_block_that_was_put_off_counts_once(self):
        lines = trace_of(*self.blocks)
        put_off = next(line for line in lines if "/00000300/" in line)
        at = lines.index(put_off)
        lines[at + 1 : at + 1] = ["Stopped execution of TB chain before 0x7f00 [00000300] inner\n", put_off]
        self.assertEqual(self.read(lines)[0].instructions, 9)
        lines.remove("Stopped execution of TB chain before 0x7f00 [00000300] inner\n")
        self.assertEqual(self.read(lines)[0].instructions, 11)


def node(title, size, kind="static"):
    return f'node: {{ title: "{title}" label: "{title}\\nfile.cpp:1:1\\n{size} bytes ({kind})" }}\n'


def edge(caller, called):
    return f'edge: {{ sourcename: "{caller}" targetname: "{called}" }}\n'


class CallGraph(unittest.TestCase):
    def worst(self, *lines, library=None):
        return call_graph.CallGraph(["".join(lines)]).worst("root", library or {})

    def test_the_deepest_way_counts(self):
        nodes = node("root", 8), node("a.cpp:f", 16), node("g", 24), node("h", 32)
        edges = edge("root", "a.cpp:f"), edge("root", "g"), edge("a.cpp:f", "h")
        self.assertEqual(self.worst(*nodes, *edges), (56, ("root", "f", "h")))

    def test_a_constructor_goes_by_either_name(self):
        lines = node("root", 8), node("_ZN1AC2Ev", 16), edge("root", "_ZN1AC1Ev")
        self.assertEqual(self.worst(*lines)[0], 24)

    def test_the_library_counts(self):
        lines = node("root", 8), edge("root", "memcpy")
        self.assertEqual(self.worst(*lines, library={"memcpy": 4})[0], 12)
        with self.assertRaisesRegex(call_graph.CallGraphError, "root calls memcpy, which is unknown"):
            self.worst(*lines)

    def test_recursion_is_refused(self):
        with self.assertRaisesRegex(call_graph.CallGraphError, "recursion: root -> f -> root"):
            self.worst(node("root", 8), node("f", 8), edge("root", "f"), edge("f", "root"))

    def test_an_indirect_call_is_refused_and_named(self):
        lines = node("root", 8), edge("root", "__indirect_call")
        with self.assertRaisesRegex(call_graph.CallGraphError, "root makes an indirect call"):
            self.worst(*lines)
        self.assertEqual(call_graph.CallGraph(["".join(lines)]).indirect_callers(), ["root"])

    def test_a_stack_that_grows_with_its_data_is_refused(self):
        with self.assertRaisesRegex(call_graph.CallGraphError, "root grows with its data"):
            self.worst(node("root", 8, "dynamic"))

    def test_a_root_that_is_missing_is_refused(self):
        with self.assertRaisesRegex(call_graph.CallGraphError, "an unknown function calls root"):
            self.worst(node("other", 8))


MAP = """\
Discarded input sections

 .text.unused   0x00000000       0x40 firmware/librsi.a(component.cpp.obj)

Linker script and memory map

 .text.step     0x00000100       0x20 firmware/librsi.a(component.cpp.obj)
                0x00000100                rsi_step
 .text._ZN3rsi9Component4stepERK10rsi_inputsR11rsi_outputs
                0x00000120      0x100 firmware/librsi.a(component.cpp.obj)
 .text.main     0x00000220       0x10 main.cpp.obj
 .rodata.curve  0x00000230        0x8 firmware/librsi.a(parameters.cpp.obj)
 .bss.counter   0x20000000        0x4 firmware/librsi.a(component.cpp.obj)
 .debug_info    0x00000000     0x9999 firmware/librsi.a(component.cpp.obj)
"""


class ImageSize(unittest.TestCase):
    def test_discarded_or_foreign_code_does_not_count(self):
        self.assertEqual(
            image_size.of_library(MAP, "librsi.a"), {"code": 0x120, "constants": 8, "data": 0, "zeroed data": 4}
        )

    def test_a_library_that_is_not_there_is_refused(self):
        with self.assertRaisesRegex(ValueError, "no code of libother.a"):
            image_size.of_library(MAP, "libother.a")


class ImageSymbols(unittest.TestCase):
    def test_every_kind_is_found(self):
        for name in (
            "malloc free realloc calloc _sbrk _malloc_r _Znwj _ZdlPv abort __assert_func __cxa_throw __cxa_atexit "
            "printf vsnprintf _printf_float puts _Unwind_Resume __gnu_unwind_frame __aeabi_unwind_cpp_pr0 "
            "__aeabi_dadd __aeabi_dmul __aeabi_f2d __aeabi_d2f __aeabi_i2d __aeabi_dcmplt __aeabi_cdcmple __adddf3 "
            "__extendsfdf2 __truncdfsf2 __aeabi_fadd __aeabi_fmul __aeabi_f2iz __aeabi_fcmplt __addsf3 __floatsisf"
        ).split():
            self.assertEqual(len(image_symbols.forbidden_symbols([name])), 1, name)

    def test_ordinary_ones_are_left_alone(self):
        names = "rsi_step memcpy memset memmove reset __aeabi_uldivmod __aeabi_idiv _ZN3rsi9Component4initE freeze exit_"
        self.assertEqual(image_symbols.forbidden_symbols(names.split()), [])


class Limits(unittest.TestCase):
    text = "[a]\ngoal = 10\nlimit = { m4 = 20, r5 = 30 }\n[b]\nlimit = 5\n"

    def test_a_goal_is_met_or_missed_and_a_limit_exceeded(self):
        held_to = limits.Limits(self.text)
        self.assertEqual(held_to.verdict("a", "m4", 10), limits.MET)
        self.assertEqual(held_to.verdict("a", "m4", 11), limits.MISSED)
        self.assertEqual(held_to.verdict("a", "m4", 21), limits.OVER)
        self.assertEqual(held_to.verdict("a", "r5", 21), limits.MISSED)
        self.assertEqual(held_to.verdict("b", "r5", 5), limits.MET)

    def test_a_limit_that_holds_nothing_is_noticed(self):
        held_to = limits.Limits(self.text)
        held_to.verdict("a", "m4", 1)
        self.assertEqual(held_to.unused(), ["b"])

    def test_a_limit_far_above_a_figure_that_misses_its_goal_is_noticed(self):
        held_to = limits.Limits("[a]\ngoal = 10\nlimit = 200\n")
        self.assertFalse(held_to.is_slack("a", "m4", 195))
        self.assertTrue(held_to.is_slack("a", "m4", 150))
        self.assertFalse(held_to.is_slack("a", "m4", 9))


class Table(unittest.TestCase):
    def test_a_row_over_its_limit_is_reported_and_shown(self):
        result = table.Table(limits.Limits("[a]\ngoal = 10\nlimit = 20\n"))
        result.row("fine", {"cortex-r5f": [1, 2, 3, 4], "cortex-m4f": [9]}, "a")
        self.assertEqual(result.broken, [])
        result.row("dear", {"cortex-r5f": [1, 2, 3, 21], "cortex-m4f": [9]}, "a")
        self.assertEqual(result.broken, ["dear on cortex-r5f: 21, the limit is 20 (a in limits.toml)"])
        self.assertIn(limits.OVER, result.markdown())


class Loops(unittest.TestCase):
    def test_a_row_shows_the_bound_and_what_was_traced_on_each_target(self):
        class Measured:
            def __init__(self, target, loops):
                self.target, self.loops = target, loops

        both = [
            Measured("cortex-r5f", {("f", "for (;;) {"): [(5, 2, "counted"), (7, 1, "counted")]}),
            Measured("cortex-m4f", {("f", "for (;;) {"): [(5, 5, "argument")], ("g", "a | b"): [(1, 0, "constant")]}),
        ]
        rows = table.loops(both).splitlines()[-2:]
        self.assertEqual(rows[0], "| `f` | `for (;;) {` | 7 | 2 | 5 | 5 | counted; argument |")
        self.assertEqual(rows[1], "| `g` | `a \\| b` |  |  | 1 | 0 | constant |")


class Contradictions(unittest.TestCase):
    def test_trace_and_counter_must_agree(self):
        call = instruction_trace.Call("step")
        call.instructions = 100
        measurement.check_trace("here", [100], [call])
        with self.assertRaisesRegex(measurement.BudgetError, "step 0 of here has 101 .* and 100"):
            measurement.check_trace("here", [101], [call])
        with self.assertRaisesRegex(measurement.BudgetError, "2 steps, the trace 1"):
            measurement.check_trace("here", [100, 100], [call])

    def test_a_path_without_a_bound_or_beyond_it_is_refused(self):
        measurement.check_paths("steps", [])
        with self.assertRaisesRegex(measurement.BudgetError, "^steps: a loop without a bound; a turn too many$"):
            measurement.check_paths("steps", iter(["a loop without a bound", "a turn too many"]))

    def test_a_call_must_not_be_dearer_than_its_bound(self):
        measurement.check_bound("step", 100, 100)
        with self.assertRaisesRegex(measurement.BudgetError, "step took 101 .* 100"):
            measurement.check_bound("step", 101, 100)

    def test_the_painted_stack_must_be_within_the_bound(self):
        measurement.check_stack("step", 100, 100)
        with self.assertRaisesRegex(measurement.BudgetError, "step used 104 .* 100"):
            measurement.check_stack("step", 104, 100)

    def test_a_bound_that_is_far_off_is_no_bound_of_this_program(self):
        with self.assertRaisesRegex(measurement.BudgetError, "step used 40 .* 100"):
            measurement.check_stack("step", 40, 100)


class Document(unittest.TestCase):
    def test_a_report_is_written_whole_and_a_difference_seen(self):
        with tempfile.TemporaryDirectory() as folder:
            project = pathlib.Path(folder)
            report = report_page.Report("page.md", "Title", "tests/targets/budgets/measure --document", "What it is.")
            self.assertFalse(report.holds(project, "| 1 |\n"))
            report.put(project, "| 1 |\n")
            self.assertTrue(report.holds(project, "| 1 |\n"))
            self.assertFalse(report.holds(project, "| 2 |\n"))
            page = project / "page.md"
            self.assertIn("tests/targets/budgets/measure --document", page.read_text().splitlines()[0])
            page.write_text(page.read_text().replace("What it is.", "What it was."))
            self.assertFalse(report.holds(project, "| 1 |\n"))
            self.assertIn("page.md", report.out_of_date())


PLANTED = """
extern "C" void* malloc(unsigned);
extern "C" { float product(float a) { return static_cast<float>(static_cast<double>(a) * 0.1); } }
extern "C" float by_pointer(float (*f)(float), float a) { return f(a) + 1.0F; }
extern "C" void* heap() { return malloc(16U); }
extern "C" int deep(int n) { volatile char bytes[64]; bytes[0] = char(n); return n > 0 ? deep(n - 1) + bytes[0] : 0; }
"""


class PlantedViolations(unittest.TestCase):
    """A file with a breach of every rule, compiled for both targets."""

    def compiled(self, folder, *flags):
        source = pathlib.Path(folder, "planted.cpp")
        source.write_text(PLANTED)
        compiler = binary_tools.PREFIX + "g++"
        options = [*flags, "-mfloat-abi=hard", "-O1", "-fcallgraph-info=su", "-fno-optimize-sibling-calls"]
        subprocess.run([compiler, *options, "-c", source, "-o", source.with_suffix(".o")], check=True, cwd=folder)
        return source.with_suffix(".o"), call_graph.CallGraph(f.read_text() for f in pathlib.Path(folder).glob("*.ci"))

    def test_on_a_processor_with_double_precision(self):
        with tempfile.TemporaryDirectory() as folder:
            planted, graph = self.compiled(folder, "-mcpu=cortex-r5", "-marm", "-mfpu=vfpv3-d16")
            listing = binary_tools.run("objdump", "--disassemble", planted)
            self.assertRegex(image_symbols.double_instructions(listing)[0], r"^product: vcvt\.f64\.f32")
            self.assertIn("malloc (heap)", image_symbols.forbidden_symbols(image_symbols.symbols(planted)))
            self.assertEqual(graph.indirect_callers(), ["by_pointer"])
            with self.assertRaisesRegex(call_graph.CallGraphError, "recursion: deep -> deep"):
                graph.worst("deep", {})

    def test_on_a_processor_without(self):
        with tempfile.TemporaryDirectory() as folder:
            planted, _ = self.compiled(folder, "-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16")
            found = " ".join(image_symbols.forbidden_symbols(image_symbols.symbols(planted)))
            self.assertRegex(found, r"__aeabi_dmul \(double\).*malloc \(heap\)")


class CallGraphs(unittest.TestCase):
    def test_objects_no_longer_in_the_archive_are_left_out(self):
        with tempfile.TemporaryDirectory() as folder:
            here = pathlib.Path(folder)
            for name in ("kept", "gone"):
                (here / f"{name}.cpp.obj").write_bytes(b"")
                (here / f"{name}.cpp.ci").write_text(node(name, 8))
            binary_tools.run("ar", "rc", here / "lib.a", here / "kept.cpp.obj")
            graph = call_graph.CallGraph(binary_tools.call_graphs(here / "lib.a", here))
            self.assertEqual(graph.bytes, {"kept": 8})
            (here / "kept.cpp.ci").unlink()  # as a compiler cache leaves it
            with self.assertRaisesRegex(FileNotFoundError, "kept.cpp.ci is not below .* build without"):
                binary_tools.call_graphs(here / "lib.a", here)


class ExportedBuild(unittest.TestCase):
    def compiled(self, folder, name, flags):
        source = folder / "source.c"
        source.write_text("float f(float a, float b, float c) { return a * b + c; }\n")
        binary_tools.run("gcc", "-mcpu=cortex-m7", "-mthumb", "-mfpu=fpv5-d16", "-mfloat-abi=hard", *flags, "-c", source,
                         "-o", folder / name)
        return exported_build.code(folder / name)

    def test_the_same_flags_give_the_same_code_whatever_the_file_is_called(self):
        with tempfile.TemporaryDirectory() as folder:
            one = self.compiled(pathlib.Path(folder), "one.o", ["-O2", "-ffp-contract=off"])
            other = self.compiled(pathlib.Path(folder), "other.o", ["-O2", "-ffp-contract=off", "-g"])
            self.assertTrue(any("vmul" in line for line in one))
            self.assertEqual(exported_build.first_difference(one, other), "")

    def test_a_flag_that_only_one_has_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            one = self.compiled(pathlib.Path(folder), "one.o", ["-O2", "-ffp-contract=off"])
            other = self.compiled(pathlib.Path(folder), "other.o", ["-O2", "-ffp-contract=fast"])
            self.assertIn("vfma", exported_build.first_difference(one, other))
            self.assertEqual(exported_build.first_difference(one, one[:-1]), f"{len(one)} and {len(one) - 1} lines")

    def test_the_processors_flags_are_those_of_the_toolchain_file(self):
        self.assertEqual(exported_build.processor_flags('set(processor_flags "-mcpu=x -mthumb")\n'), "-mcpu=x -mthumb")
        with self.assertRaisesRegex(exported_build.ExportError, "no processor_flags"):
            exported_build.processor_flags("set(flags)")


class LibraryStack(unittest.TestCase):
    def test_pushes_are_added_up(self):
        listing = "\n".join(
            f"   10:\tb570 \t{text}"
            for text in ("push\t{r4, r5, r6, lr}", "vpush\t{d8-d9}", "sub\tsp, #24", "stmdb\tsp!, {r7, lr}", "bx\tlr")
        )
        self.assertEqual(library_stack.bytes_pushed(listing), 16 + 16 + 24 + 8)

    def test_a_function_that_calls_has_no_size(self):
        self.assertIsNone(library_stack.bytes_pushed("   10:\tf000 \tbl\t200 <other>\n"))


if __name__ == "__main__":
    unittest.main()
