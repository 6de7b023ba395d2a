"""Counts, in a trace of QEMU, the instructions of every call of a function and of the functions within it.

The trace is that of `-d exec,nochain,in_asm` without -icount: each executed block by its first address, and, the first
time, the addresses in it. Inlined code is found by the debug information, so that a function counts
whether or not it is one in the image. A conditional instruction counts whether or not its condition holds.
"""

import collections

import binary_tools

ARITHMETIC = ("vadd", "vsub", "vmul", "vnmul", "vdiv", "vsqrt")
MULTIPLY_ADD = ("vmla", "vmls", "vnmla", "vnmls", "vfma", "vfms", "vfnma", "vfnms")  # two operations
CALLS = ("bl", "blx")
NO_CALLS = ("ble", "blt", "bls")


class TraceError(Exception):
    """The trace is not what it should be."""


class Call:
    """One call of a root function: instructions, and arithmetic on floats (add, subtract, multiply, divide, root)."""

    def __init__(self, root):
        self.root = root
        self.instructions = 0
        self.operations = 0
        self.within = collections.Counter()  # instructions by name
        self.operations_within = collections.Counter()


def operations_of(mnemonic):
    if mnemonic.startswith(ARITHMETIC):
        return 1
    return 2 if mnemonic.startswith(MULTIPLY_ADD) else 0


class Program:
    """Description of an image: its instructions, its functions, and in which of `names` each instruction is."""

    def __init__(self, path, names):
        self.names = list(names)
        self.mnemonics, self.lengths = binary_tools.instructions(path)
        self.functions = binary_tools.functions(path)
        self.starts = set(self.functions.values())
        self.function_at = binary_tools.function_of_addresses(self.functions, self.mnemonics)
        bits = {name: 1 << i for i, name in enumerate(self.names)}
        found = set()
        self.masks = {}
        for address, frames in binary_tools.inline_frames(path, self.mnemonics):
            here = bits.keys() & frames
            found |= here
            self.masks[address] = sum(bits[name] for name in here)
        self.missing = [name for name in self.names if name not in found]


class _Block:
    """Instructions that are executed one after the other."""

    def __init__(self, program, addresses):
        self.addresses = addresses
        last = addresses[-1]
        mnemonic = program.mnemonics[last]
        self.start = addresses[0]
        self.after = last + program.lengths[last]
        self.ends_with_call = mnemonic.startswith(CALLS) and not mnemonic.startswith(NO_CALLS)
        self.last_mask = program.masks[last]
        self.last_function = program.function_at[last]
        self.begins_function = self.start in program.starts
        counts = collections.defaultdict(lambda: [0, 0])
        for address in addresses:
            entry = counts[program.masks[address]]
            entry[0] += 1
            entry[1] += operations_of(program.mnemonics[address])
        self.contents = [(mask, *entry) for mask, entry in counts.items()]


def _summary(program, root, executed):
    call = Call(root)
    by_mask = collections.defaultdict(lambda: [0, 0])
    for (block, mask), times in executed.items():
        for own, instructions, operations in block.contents:
            entry = by_mask[mask | own]
            entry[0] += instructions * times
            entry[1] += operations * times
    for mask, (instructions, operations) in by_mask.items():
        call.instructions += instructions
        call.operations += operations
        for i, name in enumerate(program.names):
            if mask >> i & 1:
                call.within[name] += instructions
                call.operations_within[name] += operations
    return call


def _executed_blocks(lines, program, processor):
    """The blocks that a processor executed, one after the other."""
    blocks, translating = {}, []
    begun = None  # executed unless the log says otherwise
    mark = f"Trace {processor}: "
    for line in lines:
        if line.startswith(mark):
            if begun:
                yield begun
            key = line.split("/", 2)[1]
            try:
                begun = blocks[key[-8:]]
            except KeyError:
                raise TraceError(f"code at {key} was executed that is not in the image or the trace") from None
        elif line.startswith("0x"):
            translating.append(int(line[:10], 16))
        elif line == "\n" and translating:
            # Blocks of any processor: the log does not say which. Another one's code is not in the image.
            if all(address in program.mnemonics for address in translating):
                blocks[f"{translating[0]:08x}"] = _Block(program, translating)
            translating = []
        elif line.startswith("Stopped execution"):
            # The emulator was called away before the block, which will be executed later.
            if begun and int(line.split("[", 1)[1].split("]", 1)[0], 16) == begun.start:
                begun = None
    if begun:
        yield begun


class NoWatch:
    """Follows the calls of the roots and of what they call, block by block; this one does nothing with them."""

    def enter(self):
        pass

    def leave(self):
        pass

    def executed(self, addresses):
        pass


def read(lines, program, roots, processor=0, watch=NoWatch()):
    """The calls of `roots` (symbols of the image), one after the other."""
    absent = [root for root in roots if root not in program.functions]
    if absent:
        raise TraceError(f"the image has no function {absent[0]}")
    root_at = {program.functions[root]: root for root in roots}
    calls = []
    before = root = None
    frames = []  # of the functions that were called and have not returned: where to, and what they are within
    executed = collections.defaultdict(int)
    for block in _executed_blocks(lines, program, processor):
        if frames:
            if block.start == frames[-1][0]:
                frames.pop()
                watch.leave()
                if not frames:
                    calls.append(_summary(program, root, executed))
                    executed.clear()
            elif before.ends_with_call and block.start != before.after:
                frames.append((before.after, frames[-1][1] | before.last_mask))
                watch.enter()
            elif block.begins_function and before.last_function != block.start:
                # The function before ended with a jump into this one.
                frames[-1] = (frames[-1][0], frames[-1][1] | before.last_mask)
        elif block.start in root_at:
            root = root_at[block.start]
            if not before.ends_with_call:
                raise TraceError(f"{root} was entered without a call")
            frames.append((before.after, 0))
            watch.enter()
        if frames:
            watch.executed(block.addresses)
            executed[block, frames[-1][1]] += 1
        before = block
    if frames:
        raise TraceError(f"the trace ends within {root}")
    return calls
