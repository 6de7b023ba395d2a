"""Goals and limits, and what a figure is worth beside them."""

import tomllib

MET, MISSED, OVER = "met", "goal missed", "OVER THE LIMIT"


class Limits:
    def __init__(self, text):
        self._entries = tomllib.loads(text)
        self._asked = set()

    def goal(self, key):
        return self._entries[key].get("goal")

    def limit(self, key, target):
        self._asked.add(key)
        limit = self._entries[key]["limit"]
        return limit[target] if isinstance(limit, dict) else limit

    def verdict(self, key, target, value):
        if value > self.limit(key, target):
            return OVER
        goal = self.goal(key)
        return MISSED if goal is not None and value > goal else MET

    def is_slack(self, key, target, value):
        """Whether a goal that is not reached has a limit that would let the figure grow by a twentieth."""
        return self.verdict(key, target, value) == MISSED and self.limit(key, target) > 1.05 * value

    def unused(self):
        """Entries that no figure was held to: a slip in a name would switch a check off."""
        return sorted(self._entries.keys() - self._asked)
