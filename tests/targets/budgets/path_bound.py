"""Upper bound of the instructions of a call, over every path through its functions: the longest path, each loop as
often as its bound allows. A conditional instruction counts whether or not its condition holds, as in
instruction_trace."""

import dataclasses

import binary_tools
import control_flow
import longest_path
import loop_count
import loops

COUNTED = "counted by its instructions"


@dataclasses.dataclass
class FoundLoop:
    """A loop in an image: where it is, and how often its header may be executed each time the loop is entered."""

    name: str  # of its function
    code: str  # its line of source
    header: int
    body: frozenset  # addresses of its instructions
    times: int
    reason: str  # why it turns no more often


class Image:
    """Bounds of the functions of an image."""

    def __init__(self, path, table, project):
        self._listing = control_flow.Listing(path, self._targets_of)
        self._table = table
        self._project = project
        self._flows = {}
        self._bounds = {}
        self._turns = {}
        self.loops = {}  # by the address of the header
        self.problems = {}  # by the address of the loop
        self._places = {}

    def bound(self, function):
        """Most instructions of a call of the function."""
        return self._bound(self.address(function), None, ())

    def address(self, function):
        if function not in self._listing.functions:
            raise control_flow.FlowError(f"{self._listing.path.name} has no function {function}")
        return self._listing.functions[function]

    def bound_with(self, function, turns):
        """The same where no loop turns more often than in `turns`, by the address of its header."""
        kept, self._bounds, self._turns = self._bounds, {}, turns
        try:
            return self.bound(function)
        finally:
            self._bounds, self._turns = kept, {}

    def ways(self):
        """Addresses that can be executed after each instruction of the functions that were bounded."""
        after = {}
        for flow, _, _ in self._flows.values():
            for block in flow.blocks.values():
                addresses = [i.address for i in block.instructions]
                after.update((one, {other}) for one, other in zip(addresses, addresses[1:]))
                after[block.last.address] = {*block.successors, *block.jumps_to}
        return after

    def calls(self):
        """Functions that each calling instruction may call."""
        blocks = [block for flow, _, _ in self._flows.values() for block in flow.blocks.values()]
        return {block.instructions[index].address: called for block in blocks for index, called in block.calls}

    def place(self, address):
        return self._listing.place(address)

    def _bound(self, entry, argument, above):
        if entry in above:
            raise control_flow.FlowError(f"recursion: {self._listing.place(entry)}")
        if (entry, argument) not in self._bounds:
            self._bounds[entry, argument] = self._of_paths(entry, argument, above + (entry,))
        return self._bounds[entry, argument]

    def _of_paths(self, entry, argument, above):
        flow, found, values = self._flow(entry)
        times = {}
        for i, loop in enumerate(found):
            most = self._times(flow, found, i, values, argument)
            times[loop.header] = min(most, self._turns.get(loop.header, most))
        cost, end_cost = {}, {}
        for address, block in flow.blocks.items():
            cost[address] = len(block.instructions)
            for index, called in block.calls:
                cost[address] += self._dearest(called, values, address, index, above)
            last = len(block.instructions) - 1
            end_cost[address] = cost[address] + self._dearest(block.jumps_to, values, address, last, above)
        longest = longest_path.instructions(flow, found, times, cost, end_cost)
        if longest is None:
            raise control_flow.FlowError(f"{self._listing.place(entry)} never ends")
        return longest

    def _dearest(self, functions, values, address, index, above):
        """Most instructions of those that the instruction `index` of a block may call; none for no function."""
        bounds = [self._bound(f, self._argument(values, f, address, index), above) for f in functions]
        return max(bounds, default=0)

    def _targets_of(self, address):
        """Functions that loop_bounds.toml gives for a call through a pointer."""
        name, code = self._place([address])
        names = self._table.targets(name, code)
        if names is None:
            return None
        for name in names:
            if not self._listing.named(name):
                raise control_flow.FlowError(
                    f"{self.place(address)} calls {name} by loop_bounds.toml, which is not in the image"
                )
        return tuple(start for name in names for start in self._listing.named(name))

    def _flow(self, entry):
        if entry not in self._flows:
            flow = loops.Flow(control_flow.blocks_of(self._listing, entry), entry)
            found = loops.of_function(self._listing, flow)
            self._flows[entry] = flow, found, loop_count.Values(flow)
        return self._flows[entry]

    def _argument(self, values, called, address, index):
        """The most that a function of `arguments` is called with, or None."""
        called_name = self._listing.plain_name(called)
        register = self._table.arguments.get(called_name)
        if register is None:
            return None
        name, number = values.before(register, address, index)
        return number if name is None else self._table.most(self._listing.plain_name(values.entry), called_name)

    def _times(self, flow, found, index, values, argument):
        loop = found[index]
        inner = [other for other in found[:index] if other.header in loop.body]
        if loop.header not in self._places:
            nested = set().union(*(other.body for other in inner))
            last = flow.blocks[max(loop.latches)].last.address
            own = [i.address for a in sorted(loop.body - nested) for i in flow.blocks[a].instructions]
            self._places[loop.header] = self._place([last, *own])
        name, code = self._places[loop.header]
        times, reason = loop_count.times(flow, loop, inner, values), COUNTED
        if times is None:
            times, reason = self._table.times(name, code, argument) or (None, "")
        if times is None:
            self.problems[loop.header] = (
                f"{self.place(loop.header)}: a loop without a bound: function = {name!r}, code = {code!r}; add it with its "
                "reason to loop_bounds.toml"
            )
            times = 1
        body = frozenset(i.address for a in loop.body for i in flow.blocks[a].instructions)
        before = self.loops.get(loop.header)
        most = max(times, before.times) if before else times
        self.loops[loop.header] = FoundLoop(name, code, loop.header, body, most, reason)
        return times

    def _place(self, addresses):
        """Function and line of source that a loop goes by, those of its last instruction, which comes first: the
        innermost function that is the project's, else the innermost; of its lines in the loop the one that begins a
        loop, if there is one."""
        name = place = None
        for _, frames in binary_tools.inline_places(self._listing.path, addresses):
            function, file, line = next((frame for frame in frames if self._source(frame[1])), frames[0])
            source = self._source(file)
            code = f"{file.rsplit('/', 1)[-1]}:{line}"
            if source and line:
                code = source.read_text().splitlines()[line - 1].strip()
            if name is None:
                name, place = function, code
            if function == name and code.startswith(("for (", "while (", "do {")):
                return name, code
        return name, place

    def _source(self, file):
        """The project's file of that name in the debug information, or None."""
        source = self._project / file.rsplit("/./", 1)[-1]
        return source if self._project in source.parents and source.is_file() else None
