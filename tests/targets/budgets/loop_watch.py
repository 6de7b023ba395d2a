"""Compares what is executed on the target with what path_bound.py rests on: no way that it does not know, no loop that
turns more often than its bound."""


class Watch:
    """Takes the blocks that instruction_trace reads, function by function; `loops` and `ways` are those of the image."""

    def __init__(self, loops, ways):
        self._loops = loops
        self._ways = ways
        self._last = []  # address of the last instruction, of every function that has not returned
        self._turns = {}
        self._seen = {}  # what a block does to the loops, by the instruction before it and the block
        self.most = dict.fromkeys(loops, 0)  # executions of a header each time that its loop was entered
        self.unknown = set()  # pairs of instructions that followed each other, of which that was not known

    def enter(self):
        self._last.append(None)

    def leave(self):
        self._last.pop()

    def executed(self, addresses):
        before = self._last[-1]
        key = before, addresses[0], len(addresses)
        if key not in self._seen:
            self._seen[key] = self._effects(before, addresses)
        for header, is_entry in self._seen[key]:
            turns = 1 if is_entry else self._turns[header] + 1
            self._turns[header] = turns
            self.most[header] = max(self.most[header], turns)
        self._last[-1] = addresses[-1]

    def _effects(self, before, addresses):
        """Headers of loops in a block, each with whether its loop is entered there."""
        effects = []
        for earlier, address in zip([before, *addresses], addresses):
            if address not in self._ways or earlier is not None and address not in self._ways[earlier]:
                self.unknown.add((earlier, address))
            if address in self._loops:
                effects.append((address, earlier not in self._loops[address].body))
        return effects

    def problems(self, place):
        """Contradictions, each as a sentence; `place` names an address."""
        for header, turns in self.most.items():
            loop = self._loops[header]
            if turns > loop.times:
                yield f"{place(header)}: the loop `{loop.code}` of {loop.name} turned {turns} times, its bound is {loop.times}"
        for earlier, address in sorted(self.unknown, key=str):
            after = f"after {place(earlier)}" if earlier is not None else "by a call"
            yield f"{place(address)} was executed {after}, which the analysis of paths does not know"
