"""Runs the programs on one target under the emulator and takes together what they and their images say."""

import json
import pathlib
import shutil
import struct
import subprocess
import tomllib

import binary_tools
import call_graph
import exported_build
import image_size
import image_symbols
import instruction_trace
import library_stack
import loop_table
import loop_watch
import path_bound

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
RECORDINGS = PROJECT / "build/budgets"
LIBRARY_FUNCTIONS = {"memcpy", "memset", "memmove"}
# Instructions in a tick of the counter, and the emulator's number of the processor.
TARGETS = {
    "cortex-r5f": {"instructions_in_a_tick": 1.0, "processor": 4, "image": "firmware/images/zynqmp_r5/rsi-ecu-r5f.elf"},
    "cortex-m4f": {"instructions_in_a_tick": 40.0 / 1024.0, "processor": 0, "image": None},
}
DEFAULT = "consider_kalman"
MANOEUVRES = ("j-turn-110", "fishhook-1a")
# Recorded sensor frames for whole cycles of the ECU; the last has faults of bus and sensors.
LOGS = PROJECT / "tests/application/regression/logs"
FAULTY_LOG = "bus-faults-noise"
CALIBRATION = PROJECT / "firmware/calibrations/large_suv.toml"
CYCLE = "rsi::application::RolloverEcu::step"
# The same with XCP and diagnosis linked and not connected; code executed only in a cycle in which a trouble code
# changes or the trouble memory is stored.
CYCLE_WITH_ACCESSES = "budgets::EcuWithAccesses::cycle"
RESET = "_ZN3rsi9Component5resetERK14rsi_parameters"
EVENTS = ["rsi::diagnosis::TroubleMemory::take_change", "rsi::diagnosis::KeptData::store"]
ECU_LIBRARIES = ("librsi.a", "librsi_application.a")
ACCESS_LIBRARIES = {
    "XCP": ("librsi_xcp.a", "librsi_calibration_pages.a"),
    "UDS, ISO-TP and trouble memory": ("librsi_diagnosis.a",),
    "seed and key, for both": ("librsi_access.a",),
}


class BudgetError(Exception):
    """Something could not be measured, or two ways of measuring contradict each other."""


def stages(of="step"):
    return tomllib.loads((HERE / "stages.toml").read_text())[of]


def functions_of(root):
    return [name for stage in stages(root) for name in stage["functions"]]


def build():
    script = PROJECT / "cmake/environment/build"
    subprocess.run([script, "release", "budgets_record", "budgets_floor_test", "write_parameters"], check=True)
    programs = ["steps", "least_squares", "least_image", "replay_frames", "replay_with_accesses", "access_sizes"]
    subprocess.run([script, "cortex-m4f", *programs], check=True)
    subprocess.run([script, "cortex-r5f", *programs, "release-r5", "rsi-ecu-r5f"], check=True)


def record():
    RECORDINGS.mkdir(parents=True, exist_ok=True)
    subprocess.run([PROJECT / "build/release/tests/targets/budgets/budgets_record", RECORDINGS], check=True)
    writer = PROJECT / "build/release/tests/targets/write_parameters"
    subprocess.run([writer, CALIBRATION, RECORDINGS / "cycle.parameters"], check=True)


def floor_operations():
    """Operations that the equations of the least squares need."""
    output = subprocess.run(
        [PROJECT / "build/release/tests/targets/budgets/budgets_floor_test"], check=True, capture_output=True, text=True
    ).stdout
    for line in output.splitlines():
        if line.startswith("operations: "):
            return int(line.split()[1])
    raise BudgetError("budgets_floor_test no longer prints its count of operations")


def loop_bounds():
    return loop_table.LoopTable((HERE / "loop_bounds.toml").read_text(), PROJECT)


def unused_bounds(measurements):
    """Bounds of loops that are in no image."""
    return loop_bounds().unused(set().union(*(m.used_bounds for m in measurements)))


class Figures:
    """Least, mean and most of some counts."""

    def __init__(self, values):
        values = list(values)
        self.least, self.most = min(values), max(values)
        self.mean = sum(values) / len(values)


class Steps:
    """Steps of one recorded drive: instructions by the counter and, where it was traced, what is within them."""

    def __init__(self, counts, calls=None):
        self.counts = counts
        self.calls = calls

    def within(self, names):
        """Instructions of each step in all of `names` together."""
        return [sum(call.within[name] for name in names) for call in self.calls]


def check_trace(where, counts, calls):
    """The counter's instructions of every step must be the trace's."""
    if len(counts) != len(calls):
        raise BudgetError(f"{where}: the counter saw {len(counts)} steps, the trace {len(calls)}")
    for number, (count, call) in enumerate(zip(counts, calls)):
        if count != call.instructions:
            raise BudgetError(
                f"step {number} of {where} has {count} instructions by the counter and {call.instructions} by the trace"
            )


def check_paths(where, problems):
    """Every path must have a bound, and what is executed must keep to it."""
    problems = list(problems)
    if problems:
        raise BudgetError(f"{where}: " + "; ".join(problems))


def check_bound(where, most, bound):
    """A call must not execute more instructions than the longest path has."""
    if most > bound:
        raise BudgetError(f"{where} took {most} instructions, and its longest path has {bound}")


def check_stack(where, painted, bound):
    """A call must not use more stack than its bound, nor so little that the two cannot be of the same program."""
    if not 0.5 * bound <= painted <= bound:
        raise BudgetError(f"{where} used {painted} bytes of stack, and the call graph gives a bound of {bound}")


class Measurement:
    """Everything about one target."""

    def __init__(self, target):
        self.target = target
        self._facts = TARGETS[target]
        self._folder = PROJECT / "build" / target
        self._scratch = RECORDINGS / target
        self._scratch.mkdir(parents=True, exist_ok=True)
        self._loop_table = loop_bounds()
        self.loops = {}  # bound, most turns that were traced and reason of each, by function and line of source

    def take(self):
        self.steps = self._drives("steps", traced=True)
        self.search = self._drives("search", traced=False)
        self._least_squares()
        logs = (*MANOEUVRES, FAULTY_LOG)
        self._cycles(logs)
        self.access_cycles = {log: self._cycle(log, "replay_with_accesses", CYCLE_WITH_ACCESSES, EVENTS) for log in logs}
        self._memory()
        self._access_memory()
        self._contents()
        self._exported()
        self._check_bounds()
        return self

    # Counts.

    def _run(self, program, *arguments, trace=None):
        option = ["--time-limit", "1500"] + (["--trace", trace] if trace else [])
        command = [PROJECT / "tests/targets/run_on_target", *option, self.target, program, *arguments]
        result = subprocess.run(command, cwd=self._scratch, capture_output=True, text=True)
        if result.returncode:
            raise BudgetError(f"{program} ended with {result.returncode} on {self.target}: {result.stderr.strip()}")

    def _words(self, name):
        data = (self._scratch / name).read_bytes()
        return struct.unpack(f"<{len(data) // 4}I", data)

    def _instructions(self, ticks, empty):
        exact = (ticks - empty) * self._facts["instructions_in_a_tick"] + 1.0  # an empty call: its return
        count = round(exact)
        if abs(exact - count) > 0.2:
            raise BudgetError(f"{ticks} ticks on {self.target} are no whole number of instructions")
        return count

    def _trace(self, program, roots, names, *arguments, watch=instruction_trace.NoWatch()):
        """The calls of the functions `roots` in a run of the program, with what is within `names`."""
        log = self._scratch / f"{program}.trace"
        elf = self._folder / f"targets/{program}.elf"
        known = instruction_trace.Program(elf, names)
        if known.missing:
            raise BudgetError("stages.toml names functions that are in no image: " + ", ".join(known.missing))
        self._run(program, *arguments, trace=log.name)
        try:
            with open(log, encoding="ascii", errors="replace") as lines:
                return instruction_trace.read(lines, known, roots, self._facts["processor"], watch)
        finally:
            log.unlink()

    def _drives(self, recording, traced):
        path = f"../{recording}.bin"
        self._run("steps", path, "counts.bin", "count")
        words = self._words("counts.bin")
        calls = None
        if traced:
            calls = self._traced_steps(path)
        drives, at, step = {}, 1, 0
        for drive in json.loads((RECORDINGS / f"{recording}.json").read_text()):
            steps = drive["steps"]
            counts = [self._instructions(ticks, words[0]) for ticks in words[at : at + steps]]
            if words[at + steps] != drive["digest"]:
                raise BudgetError(f"{drive['name']} gave other outputs on {self.target} than on this machine")
            part = calls[step : step + steps] if traced else None
            if traced:
                check_trace(f"{drive['name']} on {self.target}", counts, part)
            drives[drive["estimator"], drive["name"]] = Steps(counts, part)
            at, step = at + steps + 1, step + steps
        return drives

    def _traced_steps(self, path):
        """The calls of rsi_step, with the bounds by the longest path, which what is executed must keep to."""
        image, bounds = self._bounded("steps", "rsi_step", "rsi_init", RESET)
        self.step_bound, self.init_bound, self.reset_bound = bounds
        watch = loop_watch.Watch(image)
        roots = ["rsi_step", "rsi_init"]
        calls = self._trace("steps", roots, functions_of("step"), path, "traced.bin", "trace", watch=watch)
        self._compare_paths("steps", image, watch)
        self.step_bound_as_turned = image.bound_with("rsi_step", watch.executed_turns())
        self.init_most = max(call.instructions for call in calls if call.root == "rsi_init")
        return [call for call in calls if call.root == "rsi_step"]

    def _cycles(self, logs):
        root = self._symbol("replay_frames", CYCLE)
        image, (self.cycle_bound,) = self._bounded("replay_frames", root)
        watch = loop_watch.Watch(image)
        self.cycles = {log: self._cycle(log, "replay_frames", CYCLE, functions_of("cycle"), watch) for log in logs}
        self._compare_paths("replay_frames", image, watch)
        self.cycle_bound_as_turned = image.bound_with(root, watch.executed_turns())

    def _bounded(self, program, *functions):
        """The image of a program and the bounds of some of its functions."""
        image = path_bound.Image(self._folder / f"targets/{program}.elf", self._loop_table, PROJECT)
        bounds = [image.bound(function) for function in functions]
        check_paths(f"{program} on {self.target}", [*self._loop_table.problems, *image.problems.values()])
        return image, bounds

    def _compare_paths(self, program, image, watch):
        for header, loop in image.loops.items():
            self.loops.setdefault((loop.name, loop.code), []).append((loop.times, watch.most[header], loop.reason))
        check_paths(f"{program} on {self.target}", watch.problems())

    def _check_bounds(self):
        self.used_bounds = self._loop_table.used
        for steps in (*self.steps.values(), *self.search.values()):
            check_bound(f"rsi_step on {self.target}", max(steps.counts), self.step_bound)
        for steps in self.cycles.values():
            check_bound(f"RolloverEcu::step on {self.target}", max(steps.counts), self.cycle_bound)
        check_bound(f"rsi_init on {self.target}", self.init_most, self.init_bound)
        check_bound(f"Component::reset on {self.target}", self.reset, self.reset_bound)

    def _least_squares(self):
        calls = self._trace("least_squares", ["update_firmware", "update_textbook"], [], "../regressions.bin")
        self.firmware_update, self.textbook_update = (
            Figures(call.instructions for call in calls if call.root == name)
            for name in ("update_firmware", "update_textbook")
        )

    def _symbol(self, program, name):
        symbols = binary_tools.functions(self._folder / f"targets/{program}.elf")
        return next(symbol for symbol, its_name in zip(symbols, binary_tools.demangled(symbols)) if its_name == name)

    def _cycle(self, log, program, root_name, names, watch=instruction_trace.NoWatch()):
        """Cycles of the whole ECU on recorded sensor frames."""
        root = self._symbol(program, root_name)
        files = "../cycle.parameters", "sensors.log", "ecu.log"
        shutil.copyfile(LOGS / f"{log}.sensors.log", self._scratch / files[1])
        calls = self._trace(program, [root], names, *files, watch=watch)
        if (self._scratch / files[2]).read_bytes() != (LOGS / f"{log}.ecu.log").read_bytes():
            raise BudgetError(f"{self.target} answers {log} otherwise than recorded; see tests/run targets")
        return Steps([call.instructions for call in calls], calls)

    # Memory.

    def _memory(self):
        graph = call_graph.CallGraph(
            binary_tools.call_graphs(self._folder / "firmware/librsi.a", self._folder / "firmware/CMakeFiles/rsi.dir")
        )
        image = self._folder / "targets/least_image.elf"
        library = library_stack.of_functions(image, LIBRARY_FUNCTIONS)
        self.indirect_callers = graph.indirect_callers()
        self.step_stack, self.step_stack_way = graph.worst("rsi_step", library)
        self.init_stack, self.init_stack_way = graph.worst("rsi_init", library)
        self._run("steps", "../search.bin", "stack.bin", "stack")
        self.init_painted, self.step_painted, self.component_bytes, empty, reset = self._words("stack.bin")
        self.reset = self._instructions(reset, empty)
        check_stack(f"rsi_step on {self.target}", self.step_painted, self.step_stack)
        check_stack(f"rsi_init on {self.target}", self.init_painted, self.init_stack)
        self.library_size = image_size.of_library(image.with_suffix(".map").read_text(), "librsi.a")
        self.image_size = None
        self.application_indirect_callers = []
        if self._facts["image"]:
            self.image_size = image_size.of_image(self._folder / self._facts["image"])
            application = self._folder / "firmware/CMakeFiles/application.dir"
            self.application_indirect_callers = call_graph.CallGraph(
                binary_tools.call_graphs(self._folder / "firmware/librsi_application.a", application)
            ).indirect_callers()

    def _access_memory(self):
        """XCP and diagnosis: the linked parts of their libraries, and the bytes of their objects."""
        self._run("access_sizes", "sizes.bin")
        self.xcp_bytes, self.diagnosis_bytes, self.seed_and_key_bytes = self._words("sizes.bin")

        def bytes_of(program, libraries, *kinds):
            text = (self._folder / f"targets/{program}.map").read_text()
            return sum(image_size.of_library(text, library)[kind] for library in libraries for kind in kinds)

        linked = "replay_with_accesses"
        self.access_code = {part: bytes_of(linked, ACCESS_LIBRARIES[part], "code") for part in ACCESS_LIBRARIES}
        all_parts = [library for libraries in ACCESS_LIBRARIES.values() for library in libraries]
        # Tables that the ECU has as well are one library's or the other's, as the linker met them.
        self.access_constants = bytes_of(linked, [*all_parts, *ECU_LIBRARIES], "constants") - bytes_of(
            "replay_frames", ECU_LIBRARIES, "constants"
        )
        self.access_static = bytes_of(linked, all_parts, "data", "zeroed data")

    def _contents(self):
        """Forbidden parts in an image."""
        self.findings = []
        images = [self._folder / "targets/least_image.elf"]
        if self._facts["image"]:
            images.append(self._folder / self._facts["image"])
        for image in images:
            found = image_symbols.forbidden_symbols(image_symbols.symbols(image))
            self.findings += [f"{image.name} of {self.target} holds {symbol}" for symbol in found]
        library = binary_tools.run("objdump", "--disassemble", "--demangle", self._folder / "firmware/librsi.a")
        self.findings += [
            f"librsi.a of {self.target} computes in double precision in {place}"
            for place in image_symbols.double_instructions(library)
        ]
        self.findings += [f"{name} in librsi.a makes an indirect call" for name in self.indirect_callers]

    def _exported(self):
        """The figures are those of an exported build with the documented flags: its code is this library's."""
        exported = exported_build.build(PROJECT, self.target, self._scratch)
        difference = exported_build.first_difference(
            exported_build.code(self._folder / "firmware/librsi.a"), exported_build.code(exported)
        )
        if difference:
            self.findings.append(
                f"librsi.a of {self.target} is not what firmware/export gives with the flags of rsi.mk: {difference}"
            )
