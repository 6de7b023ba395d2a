"""Upper bound of the instructions of a call, over every path through its functions: the longest path, each loop as
often as its bound allows. A conditional instruction counts whether or not its condition holds, as in
instruction_trace."""

import dataclasses
import tomllib

import binary_tools
import control_flow
import loop_count
import loops

COUNTED = "counted by its instructions"
_NEVER = -1


@dataclasses.dataclass
class FoundLoop:
    """A loop in an image: where it is, and how often its header may be executed each time the loop is entered."""

    name: str  # of its function
    code: str  # its line of source
    header: int
    body: frozenset  # addresses of its instructions
    times: int
    reason: str  # why it turns no more often


class LoopTable:
    """loop_bounds.toml: bounds of the loops whose instructions do not give them, and of what is called."""

    def __init__(self, text, project):
        self._project = project
        tables = tomllib.loads(text)
        self.arguments = tables.pop("argument", {})
        self._entries = [(kind, entry) for kind, entries in tables.items() for entry in entries]
        self.used = set()  # numbers of entries
        self.problems = [problem for _, entry in self._entries for problem in self._contradiction(entry)]

    def _contradiction(self, entry):
        """An entry has a reason, and the constant that it rests on stands in the source."""
        if not entry.get("reason"):
            yield f"loop_bounds.toml gives no reason for {entry['function']}"
        if "source" in entry and entry["constant"] not in (self._project / entry["source"]).read_text():
            yield f"the bound of {entry['function']} rests on `{entry['constant']}`, which is not in {entry['source']}"

    def _find(self, kind, **wanted):
        for number, (its_kind, entry) in enumerate(self._entries):
            if its_kind == kind and all(entry[key] == value for key, value in wanted.items()):
                self.used.add(number)
                return entry
        return None

    def times(self, function, code, argument):
        """Most turns of a loop and why, or None: by the function that it is in and its line of source."""
        entry = self._find("loop", function=function, code=code)
        most = entry and _most(entry, argument)
        return None if most is None else (most, entry["reason"])

    def targets(self, function, code):
        """Names of the functions that a call through a pointer may call, or None; by where it is, like a loop."""
        entry = self._find("call", function=function, code=code)
        return entry and entry["targets"]

    def most(self, function, called):
        """Most that the function calls a function of `arguments` with where that is no constant, or None."""
        entry = self._find("most", function=function, called=called)
        return entry and entry["most"]

    def unused(self, used):
        """Entries that no image needs; `used`: those of all images together."""
        return [
            f"nothing needs the [[{kind}]] of {entry['function']} (`{entry.get('code', entry.get('called'))}`) in "
            "loop_bounds.toml"
            for number, (kind, entry) in enumerate(self._entries)
            if number not in used
        ]


def _most(entry, argument):
    """Bound of a loop: a number, or one turn for so many of an argument, or the lower of the two."""
    bounds = [entry["times"]] if "times" in entry else []
    if "per" in entry and argument is not None:
        bounds.append(argument // entry["per"] + entry.get("plus", 0))
    return min(bounds, default=None)


def _longest(flow, found, times, cost, end_cost):
    """Instructions on the longest way through a function; the loops of `found` have loops.of_function's order."""
    parents = [next((o for o in found[i + 1 :] if loop.header in o.body), None) for i, loop in enumerate(found)]

    def region(header, nodes, loop):
        """Most of a turn back to the header, of the ways out by their targets, and of the ways that end the function."""
        inner = {other.header: other for other, parent in zip(found, parents) if parent is loop}
        reached, turn, out, end = {header: 0}, _NEVER, {}, _NEVER

        def lead(target, instructions):
            nonlocal turn
            if target == header and loop is not None:
                turn = max(turn, instructions)
            elif target in nodes:
                reached[target] = max(reached.get(target, _NEVER), instructions)
            else:
                out[target] = max(out.get(target, _NEVER), instructions)

        for address in flow.order:
            if address not in nodes or address not in reached:
                continue
            before = reached[address]
            if address in inner:
                if times[address] == 0:
                    continue
                turns, ways, ends = region(address, inner[address].body, inner[address])
                before += (times[address] - 1) * max(turns, 0)
                for target, instructions in ways.items():
                    lead(target, before + instructions)
                if ends != _NEVER:
                    end = max(end, before + ends)
                continue
            block = flow.blocks[address]
            if block.ends:
                end = max(end, before + end_cost[address])
            for target in block.successors:
                lead(target, before + cost[address])
        return turn, out, end

    return region(flow.entry, set(flow.order), None)[2]


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
        longest = _longest(flow, found, times, cost, end_cost)
        if longest == _NEVER:
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
