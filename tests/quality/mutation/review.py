"""The reviewed list of survivors, with the reason of each."""

import tomllib

FIELDS = {"file", "why", "mutants"}
EQUIVALENT = {"equivalent"}  # true, or not there


class Review:
    def __init__(self, name, text):
        """`name`: the file that `text` is of."""
        self.name = name
        self.groups = tomllib.loads(text).get("survivors", [])
        self._reasons = {}
        self._equivalent = set()
        for group in self.groups:
            if set(group) - EQUIVALENT != FIELDS or not group["why"].strip() or not group["mutants"]:
                raise SystemExit(f"mutation: {name}: a group has {', '.join(sorted(FIELDS))} and no more but equivalent, none "
                                 f"of them empty; this one is not so: {group}")
            if group.get("equivalent", True) is not True:
                raise SystemExit(f"mutation: {name}: equivalent is true or left out; here it is neither: {group}")
            for mutant in group["mutants"]:
                if (group["file"], mutant) in self._reasons:
                    raise SystemExit(f"mutation: {name} names twice: {group['file']}: {mutant}")
                self._reasons[group["file"], mutant] = group["why"]
                if "equivalent" in group:
                    self._equivalent.add((group["file"], mutant))

    def reason(self, mutant):
        return self._reasons.get(mutant.key())

    def is_equivalent(self, mutant):
        """No input whatever shows a difference: no test could kill it."""
        return mutant.key() in self._equivalent

    def unexplained(self, mutants, results, known=frozenset()):
        """`known`: survivors that need no explanation yet."""
        return [f"{mutant} survives; write a test, or explain it in tests/quality/mutation/{self.name}"
                for mutant in mutants
                if results.get(mutant.id) == "survived" and not self.reason(mutant) and mutant.key() not in known]

    def outdated(self, mutants, results):
        """Explanations of what is killed or gone; of what was not tried only the latter can be said."""
        of_key = {}
        for mutant in mutants:
            of_key.setdefault(mutant.key(), []).append(mutant)
        problems = []
        for key in self._reasons:
            there = of_key.get(key, [])
            tried = [results[mutant.id] for mutant in there if mutant.id in results]
            if not there:
                problems.append(f"{self.name} explains what is no longer there; take it out: {': '.join(key)}")
            elif len(tried) == len(there) and "survived" not in tried:
                problems.append(f"{self.name} explains what is killed; take it out: {': '.join(key)}")
        return problems
