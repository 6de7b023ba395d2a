"""The firmware is compiled with UBSan's checks of pointers, and nothing else is. Use: pointer_checks_test.py BUILD"""

import json
import pathlib
import re
import sys

CHECKS = "sanitize=null,object-size,pointer-overflow"


def main(build):
    commands = json.loads(pathlib.Path(build, "compile_commands.json").read_text(encoding="utf-8"))
    on = {}
    for command in commands:
        last = [part for part in command["command"].split() if part.endswith(CHECKS)][-1:]
        folder = re.search(r" -o (\S+?)/CMakeFiles/", command["command"])[1]
        if last:  # generated constants have none to check
            on.setdefault(folder, set()).add(last == [f"-f{CHECKS}"])
    wrong = [folder for folder in ("firmware", "sil/studies/campaign", "tests/rsi")
             if on.get(folder) != {folder == "firmware"}]
    for folder in wrong:
        print(f"{folder}: UBSan's checks of pointers are {sorted(on.get(folder, ['not there']))}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
