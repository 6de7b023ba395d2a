"""Control flow of a function in a linked image, from its disassembly: blocks, ways between them, calls, returns.

Only what an Arm compiler writes is known. An instruction that changes the program counter in another way is refused, so
that no way is overlooked.
"""

import dataclasses
import re

import binary_tools
import loop_count

_CONDITIONS = loop_count.CONDITIONS
_BRANCH = re.compile(rf"(bx|blx|bl|b)({_CONDITIONS})?(?:\.[nw])?")
_TABLE_LOAD = re.compile(rf"ldr({_CONDITIONS})?(?:\.w)? pc, \[(\w+), (\w+), lsl #2\]")
_TABLE_BRANCH = re.compile(r"tb(b|h) \[pc, (\w+)(?:, lsl #1)?\]")
_RETURN = re.compile(
    rf"bx({_CONDITIONS})? lr|(pop\w*(\.w)? |ldm\w*(\.w)? sp!, )\{{.*\bpc\}}|ldr({_CONDITIONS})?(\.w)? pc, \[sp\], #\d+"
)
_WRITES_PC = re.compile(r"\S+ (pc\b|.*\{.*\bpc\b.*\})|tb[bh] .*|(svc|bkpt|udf|hvc|smc|eret|rfe\w*|wfi)\b.*")
_LITERAL = re.compile(r"[;@] \(?([0-9a-f]+) <")
_LINE = re.compile(r"^ *([0-9a-f]+):\t([0-9a-f ]+?)\s*\t(\S+)(?:\t(.*))?$")


class FlowError(Exception):
    """Flow that has no bound that could be known; says where and why."""


@dataclasses.dataclass(frozen=True)
class Instruction:
    address: int
    length: int
    is_thumb: bool
    mnemonic: str
    operands: str
    constant: int | None  # loaded from a constant place

    @property
    def text(self):
        return f"{self.mnemonic} {self.operands}".strip()

    @property
    def after(self):
        return self.address + self.length

    def target(self):
        """Address of a direct branch: the last operand."""
        return int(self.operands.split(",")[-1].split()[0], 16)


class Listing:
    """Instructions of an image by their addresses, the constants between them, and its functions."""

    def __init__(self, path, targets_of=lambda address: None):
        self.path = path
        self.targets_of = targets_of  # functions that an instruction may call through a pointer, or None
        self.instructions, self._data = {}, {}
        parts = []
        for line in binary_tools.run("objdump", "--disassemble", path).splitlines():
            match = _LINE.match(line)
            if not match:
                continue
            address, coded = int(match[1], 16), match[2].split()
            if match[3].startswith("."):
                for word in coded:
                    for byte in reversed(bytes.fromhex(word)):
                        self._data[address] = byte
                        address += 1
                continue
            length = sum(map(len, coded)) // 2
            parts.append((address, length, len(coded[0]) == 4, match[3], match[4] or ""))
        for address, length, is_thumb, mnemonic, rest in parts:
            operands = re.sub(r"\s+", " ", re.split(r"\s*[;@]", rest)[0].strip())
            constant = self._loaded(rest) if mnemonic in ("ldr", "ldr.w", "ldr.n") and "[pc, #" in operands else None
            self.instructions[address] = Instruction(address, length, is_thumb, mnemonic, operands, constant)
        self.functions = binary_tools.functions(path)
        self.name_at = {address: name for name, address in sorted(self.functions.items(), reverse=True)}
        readable = binary_tools.demangled(list(self.name_at.values()))
        self._plain = {address: binary_tools.short_name(name) for address, name in zip(self.name_at, readable)}
        self._function_at = None

    def _loaded(self, operands):
        place = _LITERAL.search(operands)
        return self.number(int(place[1], 16), 4) if place and int(place[1], 16) in self._data else None

    def number(self, address, size):
        try:
            return int.from_bytes(bytes(self._data[address + i] for i in range(size)), "little")
        except KeyError:
            raise FlowError(f"no table of jumps is at {address:#x}") from None

    def place(self, address):
        """Function and offset of an address, for a reader."""
        if self._function_at is None:
            self._function_at = binary_tools.function_of_addresses(self.functions, self.instructions)
        start = self._function_at.get(address, address)
        return f"{self.plain_name(start)}+{address - start:#x} ({address:#x})"

    def plain_name(self, start):
        """Name of the function that begins at an address."""
        return self._plain.get(start, "?")

    def named(self, name):
        """Addresses of the functions of that plain name."""
        return tuple(address for address, its_name in self._plain.items() if its_name == name)


@dataclasses.dataclass
class Block:
    """Instructions that are executed one after the other, the functions that they call, and where they lead."""

    start: int
    instructions: list
    calls: list  # index of the calling instruction, addresses of the functions that it may call
    successors: list  # addresses of blocks
    ends: bool  # the function may end after it
    jumps_to: tuple  # functions that may be executed in place of what comes after it

    @property
    def last(self):
        return self.instructions[-1]


def _is_conditional(instruction):
    return bool(loop_count.CONDITION.search(instruction.mnemonic))


class _Decoder:
    def __init__(self, listing, entry):
        self._listing = listing
        self._entry = entry
        self._tables = []  # address of the comparison, jump

    def refuse(self, instruction, why):
        raise FlowError(f"{self._listing.place(instruction.address)}: {why}: {instruction.text}")

    def effect(self, instruction, before):
        """Ways on, functions that it may call, whether the function may end, and functions that it may jump to;
        `before` are the instructions in front of it."""
        text = instruction.text
        branch = _BRANCH.fullmatch(instruction.mnemonic)
        if _RETURN.fullmatch(text):
            return ([instruction.after] if _is_conditional(instruction) else []), (), True, ()
        if branch and branch[1] == "b":
            return self._jump(instruction, instruction.target(), branch[2] is not None)
        if instruction.mnemonic in ("cbz", "cbnz"):
            return self._jump(instruction, instruction.target(), True)
        if branch and branch[1] in ("bl", "blx"):
            if re.match(r"(r\d+|ip|lr|sl|fp)$", instruction.operands):
                return [instruction.after], self._through(instruction, "an indirect call"), False, ()
            return [instruction.after], (instruction.target(),), False, ()
        if branch:
            on = [instruction.after] if branch[2] else []
            return on, (), True, self._through(instruction, "an indirect jump")
        if _TABLE_LOAD.fullmatch(text) or _TABLE_BRANCH.fullmatch(text):
            return self._table(instruction, before), (), False, ()
        if _WRITES_PC.fullmatch(text):
            self.refuse(instruction, "a jump that is not known")
        return [instruction.after], (), False, ()

    def _through(self, instruction, what):
        """Functions behind a pointer, if they are known."""
        targets = self._listing.targets_of(instruction.address)
        if targets is None:
            self.refuse(instruction, what)
        return targets

    def _jump(self, instruction, target, conditional):
        on = [instruction.after] if conditional else []
        if target in self._listing.name_at and target != self._entry and ".cold" not in self._listing.name_at[target]:
            return on, (), True, (target,)
        return [target, *on], (), False, ()

    def _table(self, instruction, before):
        """Targets of a jump by a table, whose length is that of the comparison in front of it."""
        load = _TABLE_LOAD.fullmatch(instruction.text)
        index = load[3] if load else _TABLE_BRANCH.fullmatch(instruction.text)[2]
        entries = self._entries(instruction, index, before, load and load[1])
        if load:
            base = self._base(instruction, load[2], before)
            targets = {self._listing.number(base + 4 * i, 4) & ~1 for i in range(entries)}
            return sorted(targets | ({instruction.after} if load[1] else set()))
        size = 1 if instruction.mnemonic == "tbb" else 2
        numbers = (self._listing.number(instruction.after + size * i, size) for i in range(entries))
        return sorted({instruction.after + 2 * number for number in numbers})

    def _entries(self, instruction, index, before, condition):
        """Entries of a table, by `cmp index, #last` right in front of it and what keeps higher ones away: the condition of
        the jump, or a branch in between."""
        is_guarded, following = condition == "ls", instruction
        for earlier in reversed(before):
            compared = re.fullmatch(rf"cmp(?:\.w)? {index}, #(\d+)", earlier.text)
            if earlier.after != following.address or index in loop_count.changed_registers(earlier):
                break
            if compared and is_guarded:
                self._tables.append((earlier.address, instruction))
                return int(compared[1]) + 1
            if loop_count.sets_flags(earlier):
                break
            is_guarded = is_guarded or re.fullmatch(r"bhi(?:\.[nw])?", earlier.mnemonic) is not None
            following = earlier
        self.refuse(instruction, "no comparison bounds the index of a table of jumps")

    def _base(self, instruction, register, before):
        if register == "pc" and not instruction.is_thumb:
            return instruction.address + 8
        for earlier in reversed(before):
            match = re.fullmatch(rf"(?:add|adr)(?:\.w)? {register}, pc, #(\d+)", earlier.text)
            if match and earlier.is_thumb:
                return (earlier.address & ~3) + 4 + int(match[1])
            if register in loop_count.changed_registers(earlier):
                break
        self.refuse(instruction, "the table of jumps is at no known place")

    def check_tables(self, effects):
        """No way may lead past the comparison that bounds a table's index."""
        entered = {way for address, (ways, *_) in effects.items() for way in ways if way != self._after(address)}
        for compared, jump in self._tables:
            if any(compared < way <= jump.address for way in entered):
                self.refuse(jump, "a way leads past the comparison that bounds a table of jumps")

    def _after(self, address):
        return self._listing.instructions[address].after


def blocks_of(listing, entry):
    """Blocks of the function that begins at `entry`, by their addresses."""
    decoder = _Decoder(listing, entry)
    effects, leaders, open_ways = {}, {entry}, [(entry, ())]
    while open_ways:
        address, before = open_ways.pop()
        while address not in effects:
            if address not in listing.instructions:
                raise FlowError(f"{listing.place(entry)} leads to {address:#x}, which is no instruction")
            instruction = listing.instructions[address]
            effects[address] = ways, _, ends, _ = decoder.effect(instruction, before)
            before = (*before[-7:], instruction)
            if ways != [instruction.after] or ends:
                leaders.update(ways)
                open_ways += [(way, before) for way in ways]
                break
            if instruction.after in listing.name_at:
                raise FlowError(f"{listing.place(address)} runs on into another function: {instruction.text}")
            address = instruction.after
    decoder.check_tables(effects)
    return {start: _block(listing, start, effects, leaders) for start in leaders}


def _block(listing, start, effects, leaders):
    block = Block(start, [], [], [], False, ())
    address = start
    while True:
        ways, called, ends, jumped = effects[address]
        instruction = listing.instructions[address]
        if called:
            block.calls.append((len(block.instructions), called))
        block.instructions.append(instruction)
        if ways != [instruction.after] or ends or instruction.after in leaders:
            block.successors, block.ends, block.jumps_to = sorted(set(ways)), ends, jumped
            return block
        address = instruction.after
