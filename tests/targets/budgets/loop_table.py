"""loop_bounds.toml: bounds of the loops whose instructions do not give them, and of what is called."""

import tomllib


class LoopTable:
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
        if "source" in entry:
            source = self._project / entry["source"]
            if not source.is_file():
                yield f"the bound of {entry['function']} rests on {entry['source']}, which is not there"
            elif entry["constant"] not in source.read_text():
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
