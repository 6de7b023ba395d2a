"""Whether the library that was measured is the one that an integrator gets: exported sources, documented flags."""

import re
import shutil
import subprocess

import binary_tools


class ExportError(Exception):
    """The comparison could not be made."""


def processor_flags(toolchain_text):
    found = re.search(r'^set\(processor_flags "([^"]+)"\)$', toolchain_text, re.MULTILINE)
    if not found:
        raise ExportError("the toolchain file sets no processor_flags")
    return found[1]


def build(project, target, folder):
    """The object of the exported component for the target, made as docs/examples/main_loop/Makefile makes it."""
    exported = folder / "exported"
    shutil.rmtree(exported, ignore_errors=True)
    subprocess.run([project / "firmware/export", exported], check=True, capture_output=True, text=True)
    flags = processor_flags((project / f"cmake/toolchains/{target}.cmake").read_text())
    subprocess.run(
        ["make", "-B", "-f", project / "docs/examples/main_loop/Makefile", f"RSI={exported}",
         f"CXX={binary_tools.PREFIX}g++", f"CXXFLAGS={flags}", "rsi_unit.o"],
        cwd=folder, check=True, capture_output=True, text=True,
    )
    return folder / "rsi_unit.o"


def code(path):
    """Instructions with what they refer to, by section; the lines that name the file left out."""
    text = binary_tools.run("objdump", "--disassemble", "--reloc", path)
    return [line for line in text.splitlines() if line.startswith((" ", "Disassembly ")) or line.endswith(">:")]


def first_difference(measured, exported):
    """Empty when both are the same code; else the first line in which they differ."""
    for number, (ours, theirs) in enumerate(zip(measured, exported)):
        if ours != theirs:
            return f"line {number}: {ours.strip()} and {theirs.strip()}"
    return "" if len(measured) == len(exported) else f"{len(measured)} and {len(exported)} lines"
