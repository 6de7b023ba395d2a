"""Upper bound of the instructions of a call, over every path through its functions: the longest path, each loop as often
as its bound allows. A conditional instruction counts whether or not its condition holds, as in instruction_trace."""

import dataclasses
import tomllib

import binary_tools
import control_flow
import loop_count
import loops

_NEVER = -1


@dataclasses.dataclass
class FoundLoop:
    """A loop in an image: where it is, how often it may turn, and whether the instructions alone say so."""

    name: str
    code: str
    header: int
    body: frozenset  # addresses of its instructions
    times: int
    is_counted: bool


class LoopTable:
    """Bounds of the loops whose instructions do not tell, from loop_bounds.toml."""

    def __init__(self, text, project):
        self._project = project
        entries = tomllib.loads(text)
        self.entries = entries.get("loop", [])
        self.arguments = entries.get("argument", {})
        self.used = set()  # numbers of entries
        self.problems = [problem for entry in self.entries for problem in self._contradiction(entry)]

    def _contradiction(self, entry):
        """The constant that an entry rests on must stand in the source with the entry's number."""
        if "source" in entry:
            text = (self._project / entry["source"]).read_text()
            if entry["constant"] not in text:
                yield f"the bound of {entry['function']} rests on `{entry['constant']}`, which is not in {entry['source']}"

    def times(self, name, code, argument):
        """Most turns of a loop, or None: by the function that it is in and its line of source."""
        for number, entry in enumerate(self.entries):
            if entry["function"] == name and entry["code"] == code:
                self.used.add(number)
                return _most(entry, argument)
        return None

    def unused(self, used):
        """Entries that no loop of any image needs; `used`: numbers of entries, of all images together."""
        return [
            f"loop_bounds.toml bounds `{entry['code']}` of {entry['function']}, but no loop needs that"
            for number, entry in enumerate(self.entries)
            if number not in used
        ]


def _most(entry, argument):
    """Bound of a loop: a number, or one turn for so many of an argument, or the lower of the two."""
    bounds = [entry["times"]] if "times" in entry else []
    if "per" in entry and argument is not None:
        bounds.append(argument // entry["per"] + entry.get("plus", 0))
    return min(bounds, default=None)


def _longest(flow, found, times, cost, end_cost):
    """Instructions on the longest way through a function; the loops of `found` are ordered as loops.of_function does."""
    parents = [next((o for o in found[i + 1 :] if loop.header in o.body), None) for i, loop in enumerate(found)]

    def region(header, nodes, loop):
        """Most of a turn back to the header, of the ways out by where they lead, and of the ways that end the function."""
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
        self._listing = control_flow.Listing(path)
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
        return self._bound(self._listing.functions[function], None, ())

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
                after[block.last.address] = {*block.successors, block.jumps_to} - {None}
        return after

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
                cost[address] += self._bound(called, self._argument(values, called, address, index), above)
            end_cost[address] = cost[address]
            if block.jumps_to is not None:
                last = len(block.instructions) - 1
                end_cost[address] += self._bound(block.jumps_to, self._argument(values, block.jumps_to, address, last), above)
        longest = _longest(flow, found, times, cost, end_cost)
        if longest == _NEVER:
            raise control_flow.FlowError(f"{self._listing.place(entry)} never ends")
        return longest

    def _flow(self, entry):
        if entry not in self._flows:
            flow = loops.Flow(control_flow.blocks_of(self._listing, entry), entry)
            found = loops.of_function(self._listing, flow)
            self._flows[entry] = flow, found, loop_count.Values(flow)
        return self._flows[entry]

    def _argument(self, values, called, address, index):
        """The constant that a function of `arguments` is called with, or None."""
        register = self._table.arguments.get(self._listing.plain_name(called))
        if register is None:
            return None
        name, number = values.before(register, address, index)
        return number if name is None else None

    def _times(self, flow, found, index, values, argument):
        loop = found[index]
        inner = [other for other in found[:index] if other.header in loop.body]
        if loop.header not in self._places:
            nested = set().union(*(other.body for other in inner))
            self._places[loop.header] = self._place(flow, loop, nested)
        name, code = self._places[loop.header]
        times = loop_count.times(flow, loop, inner, values)
        is_counted = times is not None
        if not is_counted:
            times = self._table.times(name, code, argument)
        if times is None:
            self.problems[loop.header] = (
                f"{self._listing.place(loop.header)}: a loop without a bound: function = {name!r}, code = {code!r}; add it "
                "with its reason to loop_bounds.toml"
            )
            times = 1
        body = frozenset(i.address for a in loop.body for i in flow.blocks[a].instructions)
        before = self.loops.get(loop.header)
        most = max(times, before.times) if before else times
        self.loops[loop.header] = FoundLoop(name, code, loop.header, body, most, is_counted)
        return times

    def _place(self, flow, loop, nested):
        """Function and line of source that a loop goes by, those of its last instruction: the innermost function that is
        the project's, else the innermost; of its lines in the loop the one that begins a loop, if there is one."""
        last = flow.blocks[max(loop.latches)].last.address
        others = [i.address for a in sorted(loop.body - nested) for i in flow.blocks[a].instructions if i.address != last]
        name = place = None
        for _, frames in binary_tools.inline_places(self._listing.path, [last, *others]):
            function, file, line = next((frame for frame in frames if self._source(frame[1])), frames[0])
            source = self._source(file)
            code = source.read_text().splitlines()[line - 1].strip() if source else f"{file.rsplit('/', 1)[-1]}:{line}"
            if name is None:
                name, place = function, code
            if function == name and code.startswith(("for (", "while (", "do {")):
                return name, code
        return name, place

    def _source(self, file):
        """The project's file of that name in the debug information, or None."""
        source = self._project / file.rsplit("/./", 1)[-1]
        return source if self._project in source.parents and source.is_file() else None
