"""Longest way through a function whose loops have bounds."""

_NEVER = -1


def instructions(flow, found, times, cost, end_cost):
    """Instructions on the longest way from the begin of a function to an end, or None if there is no way.

    The loops of `found` have loops.of_function's order. `times`: most executions of their headers; `cost`: instructions
    of the blocks, `end_cost`: the same where the function ends after them; all by address.
    """
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

    longest = region(flow.entry, set(flow.order), None)[2]
    return None if longest == _NEVER else longest
