"""Findings of a check, and the list of what is allowed in spite of a rule."""

import dataclasses
import pathlib
import tomllib

PROJECT = pathlib.Path(__file__).resolve().parents[3]


@dataclasses.dataclass(frozen=True, order=True)
class Finding:
    path: str  # from the project's folder
    line: int
    rule: str
    message: str

    def __str__(self):
        return f"{self.path}:{self.line}: {self.rule}: {self.message}"


class Allowed:
    """allowed.toml: a finding is let pass where an entry has its rule, its file and, if it says one, a part of its line."""

    def __init__(self, path):
        self.path = path
        self.entries = tomllib.loads(path.read_text(encoding="utf-8")).get("allowed", [])
        self.used = set()
        for entry in self.entries:
            missing = [key for key in ("rule", "file", "reason") if not str(entry.get(key, "")).strip()]
            if missing:
                raise SystemExit(f"{path.name}: an entry lacks {', '.join(missing)}: {entry}")

    def lets_pass(self, finding):
        lines = _lines(finding.path)
        line = lines[finding.line - 1] if 0 < finding.line <= len(lines) else ""
        found = False
        for number, entry in enumerate(self.entries):
            if finding.rule == entry["rule"] and finding.path == entry["file"] and entry.get("text", "") in line:
                self.used.add(number)
                found = True
        return found

    def unused(self, paths=None):
        """Entries that let nothing pass; `paths`: only those of these files."""
        text = self.path.read_text(encoding="utf-8").splitlines()
        starts = [number for number, line in enumerate(text, 1) if line.strip() == "[[allowed]]"]
        return [
            Finding(
                str(self.path.relative_to(PROJECT)), starts[number], "allowed-in-use",
                f"nothing in {entry['file']} needs this exception from {entry['rule']} any more: remove the entry",
            )
            for number, entry in enumerate(self.entries)
            if number not in self.used and (paths is None or entry["file"] in paths)
        ]


_cache = {}


def _lines(path):
    if path not in _cache:
        file = PROJECT / path
        _cache[path] = file.read_text(encoding="utf-8").splitlines() if file.is_file() else []
    return _cache[path]
