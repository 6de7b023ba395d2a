"""Compares what is executed on the target with the analysis of path_bound.py: no way or call that it does not know, no
loop that turns more often than its bound."""


class Watch:
    """Takes the blocks that instruction_trace reads, function by function, and compares them with an Image."""

    def __init__(self, image):
        self._image = image
        self._loops, self._ways, self._calls = image.loops, image.ways(), image.calls()
        self._last = []  # address of the last instruction, of every function that has not returned
        self._turns = {}
        self._seen = {}  # effects of a block on the loops, by the instruction before it and the block
        self.most = dict.fromkeys(self._loops, 0)  # executions of a header each time that its loop was entered
        self.unknown = set()  # pairs of instructions that followed each other, of which that was not known

    def enter(self):
        self._last.append(None)

    def leave(self):
        self._last.pop()

    def executed(self, addresses):
        before = self._last[-1]
        caller = self._last[-2] if before is None and len(self._last) > 1 else None
        key = before, caller, addresses[0], len(addresses)
        if key not in self._seen:
            if caller is not None and addresses[0] not in self._calls.get(caller, ()):
                self.unknown.add((caller, addresses[0]))
            self._seen[key] = self._effects(before, addresses)
        for header, is_entry in self._seen[key]:
            turns = 1 if is_entry else self._turns.get(header, 0) + 1
            self._turns[header] = turns
            self.most[header] = max(self.most[header], turns)
        self._last[-1] = addresses[-1]

    def _effects(self, before, addresses):
        """Headers of loops in a block, each with whether its loop is entered there."""
        effects = []
        for earlier, address in zip([before, *addresses], addresses):
            if address not in self._ways or earlier is not None and address not in self._ways.get(earlier, ()):
                self.unknown.add((earlier, address))
            if address in self._loops:
                effects.append((address, earlier not in self._loops[address].body))
        return effects

    def executed_turns(self):
        """Most turns of every loop that was executed."""
        return {header: turns for header, turns in self.most.items() if turns}

    def problems(self):
        """Contradictions, each as a sentence."""
        place = self._image.place
        for header, turns in self.most.items():
            loop = self._loops[header]
            if turns > loop.times:
                what = f"the loop `{loop.code}` of {loop.name}"
                yield f"{place(header)}: {what} turned {turns} times, its bound is {loop.times}"
        for earlier, address in sorted(self.unknown, key=str):
            after = f"after {place(earlier)}" if earlier is not None else "first"
            yield f"{place(address)} was executed {after}, which the analysis of paths does not know"
