"""Parts of a log that its reading left out: whole kinds of frames, and damaged ones."""

import collections


class LeftOut:
    def __init__(self):
        self.kinds = collections.Counter()  # "error frames", "remote frames" and others that are sound
        self.damaged = 0
        self.first = ""                     # damage: its place and reason

    def damage(self, place, reason):
        self.damaged += 1
        self.first = self.first or f"the first at {place}: {' '.join(str(reason).split())[:120]}"

    def add(self, other):
        self.kinds.update(other.kinds)
        self.damaged += other.damaged
        self.first = self.first or other.first

    def __str__(self):
        parts = [f"{count} {kind}" for kind, count in sorted(self.kinds.items()) if count]
        if self.damaged:
            parts.append(f"{self.damaged} damaged part{'s' if self.damaged > 1 else ''}, {self.first}")
        return "; ".join(parts)
