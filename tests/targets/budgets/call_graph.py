"""Worst use of the stack by the call graph that g++ writes with -fcallgraph-info=su."""

import re


class CallGraphError(Exception):
    """The stack has no bound that the graph could tell; says why."""


_NODE = re.compile(r'^node: \{ title: "([^"]+)" label: "([^"]*)"(.*)\}$')
_EDGE = re.compile(r'^edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"')
_STACK = re.compile(r"\\n(\d+) bytes \(([^)]*)\)")
INDIRECT = "__indirect_call"


class CallGraph:
    """Functions by the compiler's own names: the symbol, after the file's name where the symbol is not public."""

    def __init__(self, texts):
        self.bytes = {}
        self.unbounded = set()
        self.calls = {}
        for text in texts:
            for line in text.splitlines():
                self._take(line)

    def _take(self, line):
        node = _NODE.match(line)
        if node:
            stack = _STACK.search(node[2])
            if stack and "ellipse" not in node[3]:
                self.bytes[node[1]] = int(stack[1])
                self.calls.setdefault(node[1], set())
                if stack[2] == "dynamic":
                    self.unbounded.add(node[1])
            return
        edge = _EDGE.match(line)
        if edge:
            self.calls.setdefault(edge[1], set()).add(edge[2])

    def indirect_callers(self):
        """Callers through a pointer or a table of virtual functions."""
        return sorted(_symbol(name) for name, called in self.calls.items() if INDIRECT in called)

    def worst(self, root, library):
        """Bytes and way, from `root` down. `library` gives the bytes of functions that are not in the graph."""
        return self._worst(root, library, (), {})

    def _complete_object(self, name):
        # g++ writes the constructor of a complete object (C1) as another name of that of a base object (C2).
        other = re.sub(r"C1(?=E)", "C2", name)
        return other if name not in self.bytes and other in self.bytes else name

    def _worst(self, name, library, above, known):
        if name in above:
            cycle = " -> ".join(map(_symbol, above[above.index(name) :] + (name,)))
            raise CallGraphError(f"recursion: {cycle}")
        if name in known:
            return known[name]
        if name == INDIRECT:
            raise CallGraphError(f"{_symbol(above[-1])} makes an indirect call of unknown depth")
        name = self._complete_object(name)
        if name not in self.bytes:
            if name not in library:
                raise CallGraphError(f"{_symbol(above[-1]) if above else 'an unknown function'} calls {name}, which is unknown")
            return library[name], (name,)
        if name in self.unbounded:
            raise CallGraphError(f"the stack of {_symbol(name)} grows with its data")
        below = [self._worst(called, library, above + (name,), known) for called in sorted(self.calls[name])]
        deepest = max(below, default=(0, ()))
        known[name] = self.bytes[name] + deepest[0], (_symbol(name),) + deepest[1]
        return known[name]


def _symbol(title):
    return title.rsplit(":", 1)[-1]
