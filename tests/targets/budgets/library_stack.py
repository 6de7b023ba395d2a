"""Stack of the C library's small functions (memcpy and its like), by their instructions: the compiler wrote no call
graph for them."""

import re

import binary_tools

_PUSH = re.compile(r"\t(?:push|stmfd\s+sp!,|stmdb\s+sp!,|vpush)(?:\.w)?\s*\{([^}]*)\}")
_SUB = re.compile(r"\tsubw?(?:\.w)?\s+sp, (?:sp, )?#(\d+)")
_STORE = re.compile(r"\tstr\w*(?:\.w)?\s+\w+, \[sp, #-(\d+)\]!")
_CALL = re.compile(r"\tblx?\s")


def bytes_pushed(listing):
    """Bytes that all pushes of a function take together, or None when it calls another."""
    total = 0
    for line in listing.splitlines():
        if _CALL.search(line):
            return None
        push = _PUSH.search(line)
        if push:
            total += sum(_width(register) for register in push[1].split(","))
        for pattern in (_SUB, _STORE):
            match = pattern.search(line)
            total += int(match[1]) if match else 0
    return total


def _width(register):
    first, _, last = register.strip().partition("-")
    count = int(last[1:]) - int(first[1:]) + 1 if last else 1
    return count * (8 if first.startswith("d") else 4)


def of_functions(path, names):
    """Bytes of each of `names` that is in the image and calls no function."""
    sizes = {}
    for name in binary_tools.functions(path).keys() & names:
        pushed = bytes_pushed(binary_tools.run("objdump", f"--disassemble={name}", path))
        if pushed is not None:
            sizes[name] = pushed
    return sizes
