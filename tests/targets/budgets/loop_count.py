"""How often a loop is executed, if its instructions alone give it: a register starts at one value, grows by a constant
in every turn and ends the loop at another value that is a constant apart."""

import re

_REGISTER = r"(?:r\d+|sb|sl|fp|ip|sp|lr)"
CONDITIONS = "eq|ne|cs|hs|cc|lo|mi|pl|vs|vc|hi|ls|ge|lt|gt|le"
CONDITION = re.compile(rf"({CONDITIONS})(?:\.[nw])?$")
_CALL = re.compile(rf"blx?(?:{CONDITIONS})?")
_CALLED = ("r0", "r1", "r2", "r3", "ip", "lr")  # that a called function may change
_READS = re.compile(r"(str(?!ex)|stm|push|cmp|cmn|tst|teq|vcmp|vst|vpush|b|cb|nop|it|pld|dmb|dsb|isb)")
_READS_BUT = ("bic", "bfc", "bfi")
_TWO = re.compile(r"(ldrd|ldrexd|[us]mull|[us]mlal|umaal|smls?ld|vmov)")
_ALL = re.compile(r"(mcr|mrr?c|cdp|ldc|stc|strex|swp|cps|msr)")
_SETS_FLAGS = re.compile(rf"cmp|cmn|tst|teq|vmrs|msr|{_CALL.pattern}$|(?!v)\w*s(?:{CONDITIONS})?$")
_ON_EQUAL_OR_NOT = re.compile(r"b(eq|ne)(?:\.[nw])?")


def _base(mnemonic):
    return mnemonic.split(".")[0]


def changed_registers(instruction):
    """Core registers that the instruction may change: too many rather than too few."""
    mnemonic, operands = instruction.mnemonic, instruction.operands
    if _CALL.fullmatch(_base(mnemonic)):
        return set(_CALLED)
    outside = re.sub(r"\[.*?\]", "", operands)
    mentioned = re.findall(rf"\b{_REGISTER}\b", outside)
    changed = {*re.findall(rf"\[({_REGISTER})[^\]]*\](?:!|, )", operands), *re.findall(rf"\b({_REGISTER})!", operands)}
    if mnemonic.startswith(("push", "pop", "vpush", "vpop")):
        changed.add("sp")
    if _ALL.match(mnemonic) or re.search(rf"{_REGISTER}-{_REGISTER}", outside):
        return changed | set(mentioned) | {f"r{n}" for n in range(13)} | {"sb", "sl", "fp", "ip", "lr"}
    if _READS.match(mnemonic) and not mnemonic.startswith(_READS_BUT):
        return changed
    if mnemonic.startswith(("ldm", "pop")):
        return changed | set(re.findall(rf"\b{_REGISTER}\b", operands.partition("{")[2]))
    return changed | set(mentioned[: 2 if _TWO.match(mnemonic) else 1])


def sets_flags(instruction):
    return _SETS_FLAGS.match(_base(instruction.mnemonic)) is not None


def _number(text):
    match = re.fullmatch(r"#(-?\d+)", text)
    return int(match[1]) if match else None


class Values:
    """Values of registers in a function, each as a name that stands for something unknown and a number added to it."""

    def __init__(self, flow):
        self._blocks = flow.blocks
        self.entry = flow.entry
        self._nearest = flow.nearest
        self._predecessors = flow.predecessors
        self._changes = {a: set().union(*map(changed_registers, b.instructions)) for a, b in flow.blocks.items()}

    def at_end(self, register, address):
        return self.before(register, address, len(self._blocks[address].instructions))

    def before(self, register, address, index):
        """Value before the instruction `index` of a block."""
        while True:
            for position in range(index - 1, -1, -1):
                instruction = self._blocks[address].instructions[position]
                if register in changed_registers(instruction):
                    return self._result(instruction, register, address, position)
            if address == self.entry:
                return (("entry", register), 0)
            above = self._nearest[address]
            if any(register in self._changes[block] for block in self._between(above, address)):
                return ((address, register), 0)
            address, index = above, len(self._blocks[above].instructions)

    def _between(self, above, address):
        """Blocks on the ways from `above` to the begin of `address`, which is among them if it leads to itself."""
        found, reached = set(), list(self._predecessors[address])
        while reached:
            block = reached.pop()
            if block != above and block not in found:
                found.add(block)
                reached += self._predecessors[block]
        return found

    def _result(self, instruction, register, address, position):
        unknown = ((instruction.address, register), 0)
        parts = [part.strip() for part in instruction.operands.split(",")]
        mnemonic = _base(instruction.mnemonic)
        step = constant_step(instruction, register)
        if step is not None:
            name, number = self.before(register, address, position)
            return name, number + step
        if not parts or parts[0] != register or changed_registers(instruction) != {register}:
            return unknown
        if instruction.constant is not None:
            return None, instruction.constant
        if mnemonic in ("mov", "movs", "movw") and len(parts) == 2:
            number = _number(parts[1])
            if number is not None:
                return None, number
            return self.before(parts[1], address, position) if re.fullmatch(_REGISTER, parts[1]) else unknown
        if mnemonic == "movt":
            name, number = self.before(register, address, position)
            return (None, (number & 0xFFFF) | _number(parts[1]) << 16) if name is None else unknown
        if mnemonic in ("add", "adds", "addw", "sub", "subs", "subw") and len(parts) == 3:
            number = _number(parts[2])
            if number is not None and re.fullmatch(_REGISTER, parts[1]):
                name, before = self.before(parts[1], address, position)
                return name, before + (number if mnemonic.startswith("add") else -number)
        return unknown


def constant_step(instruction, register):
    """The constant that the instruction adds to the register, or None when it does something else to it."""
    mnemonic = _base(instruction.mnemonic)
    parts = [part.strip() for part in instruction.operands.split(",")]
    if mnemonic in ("add", "adds", "addw", "sub", "subs", "subw") and parts[0] == register:
        number = _number(parts[-1])
        if number is not None and (len(parts) == 2 or parts[1] == register):
            return number if mnemonic.startswith("add") else -number
    after = re.search(rf"\[{register}\], #(-?\d+)$|\[{register}, #(-?\d+)\]!$", instruction.operands)
    if after and mnemonic.startswith(("ldr", "str", "vldr", "vstr")) and not CONDITION.search(mnemonic):
        return int(after[1] or after[2])
    several = re.fullmatch(rf"{register}!, \{{(s|d)(\d+)(?:-[sd](\d+))?\}}", instruction.operands)
    if several and mnemonic in ("vldmia", "vstmia"):
        count = int(several[3] or several[2]) - int(several[2]) + 1
        return count * (4 if several[1] == "s" else 8)
    return None


def _tests(blocks, loop, always):
    """Comparisons for equality that end the loop, in blocks that every turn goes through: registers and constants
    compared, block, index of the comparing instruction."""
    for address in always:
        block = blocks[address]
        condition = _ON_EQUAL_OR_NOT.fullmatch(block.last.mnemonic)
        if not condition:
            continue
        taken = block.last.target()
        on_equal = taken if condition[1] == "eq" else block.last.after
        if on_equal in loop.body:
            continue
        for index in range(len(block.instructions) - 2, -1, -1):
            instruction = block.instructions[index]
            if not sets_flags(instruction):
                continue
            parts = [part.strip() for part in instruction.operands.split(",")]
            if _base(instruction.mnemonic) == "cmp" and len(parts) == 2:
                yield parts[0], parts[1], address, index
                yield parts[1], parts[0], address, index
            elif _base(instruction.mnemonic) == "subs":
                yield parts[0], "#0", address, index + 1
            break


def times(flow, loop, inner, values):
    """Most executions of the loop's first block each time the loop is entered, or None if that is not known."""
    blocks, dominates = flow.blocks, flow.dominates
    nested = set().union(*(other.body for other in inner)) if inner else set()
    always = [a for a in loop.body - nested if all(dominates(a, latch) for latch in loop.latches)]
    outside = [p for p in flow.predecessors[loop.header] if p not in loop.body]
    counts = []
    for counter, limit, address, index in _tests(blocks, loop, always):
        changes = [
            (a, i)
            for a in loop.body
            for i, instruction in enumerate(blocks[a].instructions)
            if counter in changed_registers(instruction)
        ]
        if len(changes) != 1 or changes[0][0] not in always:
            continue
        (at, position), = changes
        step = constant_step(blocks[at].instructions[position], counter)
        if not step:
            continue
        is_counted_before = (at == address and position < index) or (at != address and dominates(at, address))
        number = _number(limit)
        if number is None and any(limit in changed_registers(i) for a in loop.body for i in blocks[a].instructions):
            continue
        found = []
        for block in outside:
            first = values.at_end(counter, block)
            last = (None, number) if number is not None else values.at_end(limit, block)
            distance = last[1] - first[1]
            if first[0] != last[0] or distance % step or distance // step < (1 if is_counted_before else 0):
                found = []
                break
            found.append(distance // step + (0 if is_counted_before else 1))
        if found:
            counts.append(max(found))
    return min(counts, default=None)
