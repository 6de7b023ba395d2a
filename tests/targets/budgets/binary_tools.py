"""Content of an image by binutils."""

import bisect
import re
import subprocess

PREFIX = "arm-none-eabi-"


def run(tool, *arguments, stdin=None):
    return subprocess.run(
        [PREFIX + tool, *map(str, arguments)], input=stdin, check=True, capture_output=True, text=True
    ).stdout


def call_graphs(archive, folder):
    """Texts of the call graphs (.ci in `folder`) of the objects that are in the archive, not of what was there once."""
    members = run("ar", "t", archive).split()
    graphs = {path.name: path for path in folder.rglob("*.ci")}
    wanted = [member.removesuffix(".obj") + ".ci" for member in members]
    missing = [name for name in wanted if name not in graphs]
    if missing:
        raise FileNotFoundError(f"{missing[0]} is not below {folder}, though its object is in {archive}. A compiler cache "
                                "keeps no call graphs: build without CMAKE_CXX_COMPILER_LAUNCHER")
    return [graphs[name].read_text() for name in wanted]


def demangled(names):
    return run("c++filt", "--no-params", stdin="\n".join(names)).split("\n") if names else []


_INSTRUCTION = re.compile(r"^ *([0-9a-f]+):\t((?:[0-9a-f]{4,8} ?)+)\s*\t(\S+)(?:\t(.*))?$")


def instructions(path):
    """Mnemonic and length in bytes of every instruction by its address."""
    mnemonics, lengths = {}, {}
    for line in run("objdump", "--disassemble", path).splitlines():
        match = _INSTRUCTION.match(line)
        if match and not match[3].startswith("."):
            address = int(match[1], 16)
            mnemonics[address] = match[3]
            lengths[address] = len(match[2].replace(" ", "")) // 2
    return mnemonics, lengths


def functions(path):
    """Address of every function by its symbol."""
    found = {}
    for line in run("nm", "--defined-only", path).splitlines():
        address, kind, name = line.split(maxsplit=2)
        if kind in "TtWw" and not name.startswith("$"):
            found[name] = int(address, 16) & ~1
    return found


def function_of_addresses(symbols, addresses):
    """Start of the function in which each address lies."""
    starts = sorted(set(symbols.values()))
    return {a: starts[max(bisect.bisect_right(starts, a) - 1, 0)] for a in addresses}


def plain_name(name):
    """Without arguments, template arguments of functions and anonymous namespaces."""
    return name.replace("(anonymous namespace)::", "").split("(", 1)[0].split(" [clone", 1)[0]


def short_name(name):
    """Name of a function alone: no arguments, those of templates neither, no result, no anonymous namespace."""
    kept, depth = "", 0
    for character in name.replace("(anonymous namespace)::", "").split(" [clone", 1)[0]:
        depth += character in "<("
        if not depth:
            kept += character
        depth -= character in ">)"
    return kept.removesuffix(" const").split(" ")[-1]


def _frames(path, addresses):
    """For every address the functions that it is in, the innermost first: those inlined and the one around them, each as
    addr2line writes it, with its place."""
    text = "\n".join(f"{address:#x}" for address in addresses)
    address, frames, name = None, [], None
    for line in run("addr2line", "-a", "-i", "-f", "-C", "-e", path, stdin=text).splitlines():
        if line.startswith("0x"):
            if address is not None:
                yield address, frames
            address, frames, name = int(line, 16), [], None
        elif name is None:
            name = line
        else:
            frames.append((name, line))
            name = None
    if address is not None:
        yield address, frames


def inline_frames(path, addresses):
    """For every address the functions that it is in, the innermost first."""
    for address, frames in _frames(path, addresses):
        yield address, [plain_name(name) for name, _ in frames]


def inline_places(path, addresses):
    """For every address the functions that it is in with file and line, the innermost first."""
    for address, frames in _frames(path, addresses):
        places = []
        for name, place in frames:
            file, _, number = place.split(" ", 1)[0].rpartition(":")
            places.append((short_name(name), file, int(number) if number.isdigit() else 0))
        yield address, places
