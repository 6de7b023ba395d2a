"""The reviewed list of what no test reaches, with the reason of each."""

import tomllib

KINDS = ("line", "true", "false", "condition")
FIELDS = {"file", "function", "kind", "text", "why"}


class Review:
    def __init__(self, text):
        self.entries = tomllib.loads(text).get("unreached", [])
        self._reasons = {}
        for entry in self.entries:
            if set(entry) != FIELDS or entry["kind"] not in KINDS or not entry["why"].strip():
                raise SystemExit(f"coverage: unreached.toml: an entry has {', '.join(sorted(FIELDS))} and no more, "
                                 f"kind is one of {', '.join(KINDS)}, why is said; this one is not so: {entry}")
            key = entry["file"], entry["function"], entry["kind"], entry["text"]
            if key in self._reasons:
                raise SystemExit(f"coverage: unreached.toml names twice: {entry}")
            self._reasons[key] = entry["why"]

    def reason(self, item):
        return self._reasons.get(item.key())

    def problems(self, missing):
        """Places that are missing and not named, or named and not missing."""
        problems = [f"{item} is not reached; write a test, or name it in tests/quality/coverage/unreached.toml"
                    for item in missing if not self.reason(item)]
        there = {item.key() for item in missing}
        problems += [f"unreached.toml names what is reached, or is no longer there; take it out: {' | '.join(key)}"
                     for key in self._reasons if key not in there]
        return problems
