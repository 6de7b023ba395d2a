"""A source file that is changed in its text, at places that clang's syntax tree names."""

import collections
import re

import clang.cindex

clang.cindex.Config.set_library_file("/usr/lib/llvm-19/lib/libclang-19.so.1")


def parse(paths, arguments):
    """The declarations at the top of each file, by its path. The files are read as one source, for reading what they include
    takes far longer than they do themselves; where they cannot stand together, in two halves."""
    together = "".join(f'#include "{path}"\n' for path in paths)
    unit = clang.cindex.Index.create().parse("together.cpp", arguments, unsaved_files=[("together.cpp", together)])
    bad = [d for d in unit.diagnostics if d.severity >= clang.cindex.Diagnostic.Error]
    if bad and len(paths) > 1:
        half = len(paths) // 2
        return {**parse(paths[:half], arguments), **parse(paths[half:], arguments)}
    if bad:
        raise SystemExit(f"mutation: clang cannot read {paths[0]}: {bad[0]}")
    found = {str(path): [] for path in paths}
    for declared in unit.cursor.get_children():
        file = declared.extent.start.file
        if file is not None and file.name in found:
            found[file.name].append(declared)
    return found


class EditedSource:
    """Unchanged parts stay as they were, to the byte."""

    def __init__(self, name, path):
        self.name = name
        self._path = str(path)
        self._bytes = path.read_bytes()
        self._before, self._after, self._instead = collections.defaultdict(list), collections.defaultdict(list), {}

    # Places of the parts.
    def holds(self, cursor):
        file = cursor.extent.start.file
        return file is not None and file.name == self._path

    def start(self, cursor):
        return cursor.extent.start.offset

    def end(self, cursor):
        return cursor.extent.end.offset

    def text_of(self, cursor):
        return self._bytes[self.start(cursor):self.end(cursor)].decode()

    def before(self, cursor):
        """The last byte before it that is no blank."""
        return self._bytes[:self.start(cursor)].rstrip()[-1:]

    def behind(self, cursor):
        """The next byte after it that is no blank."""
        return self._bytes[self.end(cursor):].lstrip()[:1]

    def semicolon_behind(self, cursor):
        return self._bytes.index(b";", self.end(cursor)) + 1

    def second_semicolon_of(self, loop):
        """End of the second part of a `for`."""
        found, depth, at = 0, 0, self.start(loop)
        while found < 2:
            byte = self._bytes[at:at + 1]
            depth += (byte in b"([{") - (byte in b")]}")
            found += byte == b";" and depth == 1
            at += 1
        return at - 1

    def operator_between(self, left, right):
        """Begin, end and text of the operator between two operands; None when a macro hides it."""
        start = self.end(left)
        gap = self._bytes[start:self.start(right)].decode()
        bare = re.sub(r"//[^\n]*|/\*.*?\*/", lambda found: " " * len(found.group()), gap, flags=re.S)
        found = re.search(r"\.\*|->\*|[-+*/%<>=!&|^]+", bare)
        return found and (start + found.start(), start + found.end(), found.group())

    # Changes.
    def wrap(self, cursor, prefix, suffix=")"):
        self.insert(self.start(cursor), self.end(cursor), prefix, suffix)

    def insert(self, start, end, prefix, suffix):
        self._before[start].append(prefix)
        self._after[end].append(suffix)

    def replace(self, start, end, text):
        self._instead[start] = (end, text)

    def text(self):
        out, at = [], 0
        positions = sorted({*self._before, *self._after, *self._instead, len(self._bytes)})
        for position in positions:
            if position < at:
                raise SystemExit(f"mutation: {self.name}: two changes of one place at byte {position}")
            out.append(self._bytes[at:position].decode())
            at = position
            out += reversed(self._after.get(position, []))
            out += self._before.get(position, [])
            if position in self._instead:
                at, replacement = self._instead[position]
                out.append(replacement)
        return "".join(out)
