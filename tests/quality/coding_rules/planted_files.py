"""The planted violations, and which checks they say must catch them."""

import pathlib

from findings import PROJECT

_FOLDER = pathlib.Path(__file__).resolve().parent / "planted"
_MARK = "// Caught by:"


def paths():
    found = sorted(str(file.relative_to(PROJECT)) for file in _FOLDER.iterdir() if file.name != "planted.hpp")
    if len(found) < 2:
        raise SystemExit(f"no planted violations in {_FOLDER}: nothing was tested")
    return found


def caught_by(path):
    """The rules of the second line, and of further comment lines under it; empty for `nothing`."""
    lines = (PROJECT / path).read_text(encoding="utf-8").splitlines()
    if not lines[1].startswith(_MARK):
        raise SystemExit(f"{path}:2: say which checks catch it: {_MARK} RULE, RULE")
    text = lines[1].removeprefix(_MARK)
    for line in lines[2:]:
        if not line.startswith("// "):
            break
        text += line.removeprefix("//")
    rules = {rule.strip() for rule in text.split(",")}
    return set() if rules == {"nothing"} else rules
