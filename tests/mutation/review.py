"""The reviewed list of survivors, with the reason of each."""

import tomllib

FIELDS = {"file", "function", "operator", "original", "mutated", "why"}


class Review:
    def __init__(self, text):
        self.entries = tomllib.loads(text).get("survivor", [])
        self._reasons = {}
        for entry in self.entries:
            if set(entry) != FIELDS or not entry["why"].strip():
                raise SystemExit(f"mutation: survivors.toml: an entry has {', '.join(sorted(FIELDS))} and no more, and why "
                                 f"is said; this one is not so: {entry}")
            key = tuple(entry[field] for field in ("file", "function", "operator", "original", "mutated"))
            if key in self._reasons:
                raise SystemExit(f"mutation: survivors.toml names twice: {entry}")
            self._reasons[key] = entry["why"]

    def reason(self, mutant):
        return self._reasons.get(mutant.key())

    def problems(self, mutants, results, whole):
        """Survivors that nobody explains; explanations of what is killed or gone. In a sample (`whole` is false) only
        explanations of what was tried can be found killed."""
        of_key = {}
        for mutant in mutants:
            of_key.setdefault(mutant.key(), []).append(mutant)
        problems = [f"{mutant} survives; write a test, or explain it in tests/mutation/survivors.toml"
                    for mutant in mutants if results.get(mutant.id) == "survived" and not self.reason(mutant)]
        for key in self._reasons:
            there = of_key.get(key, [])
            tried = [results[mutant.id] for mutant in there if mutant.id in results]
            if not there:
                problems.append(f"survivors.toml explains what is no longer there; take it out: {' | '.join(key)}")
            elif len(tried) == len(there) and "survived" not in tried:
                problems.append(f"survivors.toml explains what is killed; take it out: {' | '.join(key)}")
        return problems
