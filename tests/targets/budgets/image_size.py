"""How much of an image belongs to a library, by the linker's map, and how large an image is, by its sections."""

import collections
import re

import binary_tools

KINDS = (
    ("code", (".text",)),
    ("constants", (".rodata", ".ARM.exidx", ".ARM.extab", ".init_array")),
    ("data", (".data",)),
    ("zeroed data", (".bss", "COMMON")),
)
_PLACED = re.compile(r"^ (\.?[\w.$]+)?\s+0x[0-9a-f]+\s+0x([0-9a-f]+) (.+)$")


def _kind(section):
    for kind, prefixes in KINDS:
        if section.startswith(prefixes):
            return kind
    return None


def of_library(map_text, archive):
    """Bytes of each kind that `archive` (librsi.a) has in the image, the sections that were thrown away left out."""
    sizes = collections.Counter({kind: 0 for kind, _ in KINDS})
    begin = map_text.index("Linker script and memory map")
    section = ""
    for line in map_text[begin:].splitlines():
        if re.match(r"^ \.?[\w.$]+$", line):
            section = line.strip()  # too long for one line: the numbers follow on the next
            continue
        placed = _PLACED.match(line)
        if placed:
            section = placed[1] or section
            if f"{archive}(" in placed[3]:
                kind = _kind(section)
                if kind:
                    sizes[kind] += int(placed[2], 16)
    if not sizes["code"]:
        raise ValueError(f"the map holds no code of {archive}")
    return dict(sizes)


_SECTION = re.compile(r"^\s*\[\s*\d+\] (\S+)\s+(\S+)\s+[0-9a-f]+ [0-9a-f]+ ([0-9a-f]+) \d+\s+(\w*)\s")


def of_image(path):
    """Bytes in flash (code and constants, initial values) and in RAM (data; stacks) of a whole image."""
    sizes = collections.Counter(flash=0, ram=0)
    for line in binary_tools.run("readelf", "--sections", "--wide", path).splitlines():
        section = _SECTION.match(line)
        if section and "A" in section[4]:
            size = int(section[3], 16)
            if section[2] != "NOBITS":
                sizes["flash"] += size
            if "W" in section[4] and "X" not in section[4]:
                sizes["ram"] += size
    return dict(sizes)
