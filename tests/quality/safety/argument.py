"""The safety argument as it is written down: hazards, goals, requirements, assumptions, failure modes."""

import re
import tomllib

# Each kind of entry: beginning of its identifiers, mandatory keys, optional keys.
KINDS = {
    "hazard": ("HZ", {"malfunction", "situation", "severity", "exposure", "controllability", "reasons"}, {"assumptions"}),
    "goal": ("SG", {"text", "hazards", "safe_state", "time"}, {"assumptions"}),
    "requirement": ("SR", {"theme", "text", "goals"}, {"code", "tests", "assumptions", "open", "limit"}),
    "assumption": ("AS", {"on", "text", "because"}, set()),
    "failure_mode": (
        "FM",
        {"direction", "signals", "mode", "effect", "detection", "reaction", "hazards"},
        {"requirements", "assumptions", "codes", "awaited"},
    ),
}
LISTS = {"hazards", "goals", "code", "tests", "assumptions", "signals", "requirements", "codes"}
IDENTIFIER = re.compile(r"\b(?:HZ|SG|SR|AS|FM)-\d+\b")


class ArgumentError(Exception):
    """The files cannot be read as an argument at all."""


class Argument:
    """Entries by kind and by identifier. `problems`: what is wrong with their form."""

    def __init__(self, *texts):
        self.problems = []
        self.by_kind = {kind: {} for kind in KINDS}
        for text in texts:
            try:
                content = tomllib.loads(text)
            except tomllib.TOMLDecodeError as error:
                raise ArgumentError(f"this is no TOML: {error}") from error
            for kind, entries in content.items():
                if kind not in KINDS:
                    raise ArgumentError(f"unknown table [[{kind}]]; there are {', '.join(KINDS)}")
                for entry in entries:
                    self._add(kind, entry)
        for kind, entries in self.by_kind.items():
            self.by_kind[kind] = dict(sorted(entries.items(), key=lambda item: int(item[0].split("-")[1])))

    def _add(self, kind, entry):
        prefix, required, optional = KINDS[kind]
        identifier = entry.get("id", "")
        if not re.fullmatch(prefix + r"-\d+", identifier):
            self.problems.append(f"a {kind} has the id '{identifier}'; it must be {prefix}-NUMBER")
            return
        if identifier in self.by_kind[kind]:
            self.problems.append(f"{identifier} is there twice")
        for key in sorted(required - entry.keys()):
            self.problems.append(f"{identifier} has no {key}")
        for key in sorted(entry.keys() - required - optional - {"id"}):
            self.problems.append(f"{identifier} has the unknown key {key}")
        for key in (required | optional) & LISTS:
            entry.setdefault(key, [])
        self.by_kind[kind][identifier] = entry

    def __getattr__(self, name):
        if name.endswith("s") and name[:-1] in KINDS:
            return self.by_kind[name[:-1]]
        raise AttributeError(name)

    def identifiers(self):
        return {identifier for entries in self.by_kind.values() for identifier in entries}

    # Requirements by state: open, verified but for a limit that is stated, verified.
    def open(self):
        return {i: r for i, r in self.requirements.items() if r.get("open")}

    def limited(self):
        return {i: r for i, r in self.requirements.items() if r.get("limit") and not r.get("open")}


def integrity_level(hazard):
    """The class that severity, exposure and controllability give: the sum of the three decides, from 7 (A) to 10 (D)."""
    classes = hazard["severity"], hazard["exposure"], hazard["controllability"]
    for value, pattern in zip(classes, ("S[0-3]", "E[0-4]", "C[0-3]")):
        if not re.fullmatch(pattern, value):
            raise ArgumentError(f"{hazard['id']}: {value} is no class; it must be {pattern}")
    if any(value.endswith("0") for value in classes):
        return "QM"
    return {7: "A", 8: "B", 9: "C", 10: "D"}.get(sum(int(value[1]) for value in classes), "QM")
