"""Natural loops of a function's control flow, each with the blocks in it."""

import dataclasses

import control_flow


@dataclasses.dataclass
class Loop:
    header: int  # address of the block through which the loop is entered
    body: set  # addresses of its blocks, those of loops within it among them
    latches: list  # addresses of the blocks that lead back to the header


def order_of(blocks, entry):
    """Addresses so that a block comes before those it leads to, unless it leads back (reverse post-order)."""
    seen, finished = {entry}, []
    stack = [(entry, iter(blocks[entry].successors))]
    while stack:
        address, ways = stack[-1]
        for way in ways:
            if way not in seen:
                seen.add(way)
                stack.append((way, iter(blocks[way].successors)))
                break
        else:
            finished.append(address)
            stack.pop()
    return finished[::-1]


def _dominators(blocks, order):
    """The nearest block on every way to each block (Cooper, Harvey and Kennedy)."""
    number = {address: i for i, address in enumerate(order)}
    predecessors = {address: [] for address in order}
    for address in order:
        for way in blocks[address].successors:
            predecessors[way].append(address)
    nearest = {order[0]: order[0]}

    def common(one, other):
        while one != other:
            while number[one] > number[other]:
                one = nearest[one]
            while number[other] > number[one]:
                other = nearest[other]
        return one

    changed = True
    while changed:
        changed = False
        for address in order[1:]:
            known = [p for p in predecessors[address] if p in nearest]
            found = known[0]
            for other in known[1:]:
                found = common(found, other)
            if nearest.get(address) != found:
                nearest[address] = found
                changed = True
    return nearest, predecessors


class Flow:
    """Blocks of a function in an order in which they can be executed, and those that every way to a block passes."""

    def __init__(self, blocks, entry):
        self.blocks, self.entry = blocks, entry
        self.order = order_of(blocks, entry)
        self.number = {address: i for i, address in enumerate(self.order)}
        self.nearest, self.predecessors = _dominators(blocks, self.order)

    def dominates(self, above, address):
        while self.number[address] > self.number[above]:
            address = self.nearest[address]
        return address == above


def of_function(listing, flow):
    """The loops, those within others first. Flow that enters a loop at two places is refused."""
    blocks, number, predecessors = flow.blocks, flow.number, flow.predecessors
    loops = {}
    for address in flow.order:
        for way in blocks[address].successors:
            if number[way] > number[address]:
                continue
            if not flow.dominates(way, address):
                raise control_flow.FlowError(
                    f"{listing.place(blocks[address].last.address)} leads back into the middle of a loop, "
                    f"to {way:#x}: no bound of such a loop is known"
                )
            loop = loops.setdefault(way, Loop(way, {way}, []))
            loop.latches.append(address)
            reached = [address]
            while reached:
                block = reached.pop()
                if block not in loop.body:
                    loop.body.add(block)
                    reached += predecessors[block]
    return sorted(loops.values(), key=lambda loop: len(loop.body))
