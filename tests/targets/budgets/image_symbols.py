"""Forbidden in an image: a heap, an end without warning, output, exceptions, arithmetic in double precision or
in software."""

import re

import binary_tools

FORBIDDEN = (
    ("heap", r"_?(malloc|free|realloc|calloc|memalign|sbrk)(_r)?|_Zn[aw]\w+|_Zd[al]\w+"),
    ("abort", r"_?_?abort|_?exit|__assert\w*|__cxa_\w+|_ZSt9terminatev"),
    ("output", r"\w*printf\w*|_?f?puts(_r)?|putchar|_?f?write(_r)?|__sinit|_fflush_r"),
    ("unwinding", r"_Unwind_\w+|__gnu_unwind\w*|__aeabi_unwind_\w+|__gxx_personality\w*"),
    ("double", r"__aeabi_(c?d\w*(add|sub|mul|div|neg|cmp)\w*|d2\w+|[a-z]+2d)|__\w*df[23]?(\w\w)?|__\w+df\w\w"),
    ("soft float", r"__aeabi_(c?f(r?sub|add|mul|div|neg|cmp\w*)|f2\w+|[a-z]+2f)|__\w+sf[23]|__(fix|float)\w*sf\w*"),
)


def forbidden_symbols(names):
    """Those of `names` that must not be in an image, each with what it stands for."""
    found = []
    for name in names:
        for what, pattern in FORBIDDEN:
            if re.fullmatch(pattern, name):
                found.append(f"{name} ({what})")
                break
    return found


def symbols(path):
    return [line.split()[-1] for line in binary_tools.run("nm", path).splitlines() if line.strip()]


_FUNCTION = re.compile(r"^[0-9a-f]+ <(.+)>:$")


def double_instructions(listing):
    """Functions of a disassembly that compute in double precision, each with its first such instruction."""
    found = {}
    function = "?"
    for line in listing.splitlines():
        header = _FUNCTION.match(line)
        if header:
            function = header[1]
        elif "\tv" in line and ".f64" in line:
            found.setdefault(function, " ".join(line.split("\t")[2:]).strip())
    return [f"{function}: {instruction}" for function, instruction in found.items()]
