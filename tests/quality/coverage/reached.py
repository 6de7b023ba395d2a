"""From llvm-cov's exports to what was reached in each source file, over all programs and all instances of a template.

Everything is known by its source text, not by its line: the reviewed list must survive a change elsewhere in the file.
"""

import collections
import dataclasses
import re
import subprocess

SOURCES = ("firmware/rsi/", "firmware/rsi/ecu/monitoring/", "firmware/rsi/ecu/access/", "firmware/rsi/ecu/xcp/", "firmware/rsi/ecu/application/", "firmware/rsi/ecu/diagnosis/", "can_dbc/include/rsi/can_dbc/codec/", "can_dbc/include/rsi/can_dbc/e2e/", "can_dbc/include/rsi/can_dbc/generated/")
BRANCH, CONDITION = 4, 6  # kinds of llvm's branch regions; a condition is a branch within a decision


@dataclasses.dataclass(frozen=True)
class Item:
    """One thing that is not reached: a line, a branch (text is `true` or `false`), or a condition's effect alone."""
    file: str
    function: str
    kind: str  # line, true, false, condition
    text: str
    line: int = dataclasses.field(compare=False)

    def key(self):
        return self.file, self.function, self.kind, self.text

    def __str__(self):
        what = {"line": "line", "true": "never true:", "false": "never false:",
                "condition": "never decides alone:"}[self.kind]
        return f"{self.file}:{self.line} {self.function}(): {what} {self.text}"


class SourceFile:
    def __init__(self, name, text):
        self.name = name
        self._rows = text.split("\n")
        self.lines = collections.Counter()       # line: executions
        self.branches = {}                       # region: [true, false]
        self._kinds = {}                         # region: kind
        self.conditions = {}                     # region of the condition: decides alone
        self._functions = {}                     # region: name

    def text_of(self, region):
        first, start, last, end = region
        rows = self._rows[first - 1:last]
        rows[-1] = rows[-1][:end - 1]
        rows[0] = rows[0][start - 1:]
        return re.sub(r"\s+", " ", " ".join(rows)).strip()

    def add_function(self, region, name):
        self._functions[region] = name

    def add_lines(self, segments):
        """As llvm-cov itself counts lines (LineCoverageStats)."""
        by_line = collections.defaultdict(list)
        for segment in segments:
            by_line[segment[0]].append(segment)
        wrapped = None
        for line in range(min(by_line, default=1), max(by_line, default=0) + 1):
            here = by_line[line]
            starting = [s for s in here if s[3] and s[4] and not s[5]]
            skipped = here and not here[0][3] and here[0][4]
            mapped = (not skipped and ((wrapped and wrapped[3]) or starting)) or any(s[3] and s[4] for s in here)
            if mapped:
                self.lines[line] += max([wrapped[2] if wrapped else 0] + [s[2] for s in starting])
            if here:
                wrapped = here[-1]

    def add_branches(self, branches):
        for branch in branches:
            region = tuple(branch[:4])
            counts = self.branches.setdefault(region, [0, 0])
            counts[0] += branch[4]
            counts[1] += branch[5]
            self._kinds[region] = max(branch[8], self._kinds.get(region, 0))

    def add_decisions(self, decisions):
        for decision in decisions:
            first, start, last, end = decision[:4]
            within = sorted(region for region, kind in self._kinds.items() if kind == CONDITION
                            and (first, start) <= region[:2] and region[2:] <= (last, end))
            covered = decision[-1]
            if len(within) != len(covered):
                raise SystemExit(f"coverage: {self.name}:{first}: a decision of {len(covered)} conditions, "
                                 f"but {len(within)} were found in it")
            for region, alone in zip(within, covered):
                self.conditions[region] = self.conditions.get(region, False) or alone

    def _function_at(self, line, column):
        around = [region for region in self._functions if region[:2] <= (line, column) <= region[2:]]
        return self._functions[max(around)] if around else ""

    def _item(self, kind, region, text):
        return Item(self.name, self._function_at(*region[:2]), kind, text, region[0])

    def unreached(self):
        items = []
        for line, count in sorted(self.lines.items()):
            row = self._rows[line - 1]
            if count == 0:
                items.append(self._item("line", (line, len(row)), row.strip()))
        for region, counts in sorted(self.branches.items()):
            items += [self._item(kind, region, self.text_of(region))
                      for kind, count in zip(("true", "false"), counts) if count == 0]
        items += [self._item("condition", region, self.text_of(region))
                  for region, alone in sorted(self.conditions.items()) if not alone]
        return items

    def unmeasured(self):
        """Decisions that the compiler did not count (it cannot where one is an operand within another)."""
        problems = []
        for region, kind in sorted(self._kinds.items()):
            before = (" ".join(self._rows[:region[0] - 1]) + " " + self._rows[region[0] - 1][:region[1] - 1])
            after = self._rows[region[2] - 1][region[3] - 1:] + " " + " ".join(self._rows[region[2]:region[2] + 2])
            joined = re.search(r"(&&|\|\|)[\s(!]*$", before[-200:]) or re.match(r"[\s)]*(&&|\|\|)", after)
            if kind == BRANCH and joined:
                problems.append(f"{self.name}:{region[0]}: clang counts no MC/DC of this decision: "
                                f"{self.text_of(region)}; give an operand that is a decision itself a name")
        return problems

    def line_figures(self):
        return sum(count > 0 for count in self.lines.values()), len(self.lines)

    def branch_figures(self):
        sides = [count > 0 for counts in self.branches.values() for count in counts]
        return sum(sides), len(sides)

    def condition_figures(self):
        return sum(self.conditions.values()), len(self.conditions)


def _plain_names(mangled):
    """Function names without parameters, template arguments and namespaces."""
    named = subprocess.run(["llvm-cxxfilt-19", "--no-params"], input="\n".join(mangled), check=True,
                           capture_output=True, text=True).stdout.splitlines()
    names = {}
    for symbol, name in zip(mangled, named):
        name = name.split(":", 1)[1] if re.match(r"[\w./-]+\.[ch]pp:", name) else name  # of internal linkage: file first
        while (shorter := re.sub(r"<[^<>]*>", "", name)) != name:
            name = shorter
        name = name.replace("(anonymous namespace)::", "").split(" ")[-1]
        names[symbol] = re.sub(r"^(rsi|application|can_dbc|section|e2e|::)*::", "", name)
    return names


def merge(reports, project, sources=SOURCES):
    files = {}

    def file_of(path):
        name = path.removeprefix(str(project) + "/")
        if not name.startswith(sources):
            return None
        if name not in files:
            files[name] = SourceFile(name, (project / name).read_text())
        return files[name]

    names = _plain_names(sorted({f["name"].split(":")[-1] for report in reports for f in report["functions"]}))
    for report in reports:
        for function in report["functions"]:
            file = file_of(function["filenames"][0])
            if file:
                file.add_function(tuple(function["regions"][0][:4]), names[function["name"].split(":")[-1]])
        for entry in report["files"]:
            file = file_of(entry["filename"])
            if file:
                file.add_lines(entry["segments"])
                file.add_branches(entry["branches"])
    for report in reports:
        for entry in report["files"]:
            if file := file_of(entry["filename"]):
                file.add_decisions(entry["mcdc_records"])
    return [files[name] for name in sorted(files)]


def left_out(files, project, sources=SOURCES):
    """Sources that no program contains: nothing of them is counted at all."""
    there = {str(path.relative_to(project)) for folder in sources for path in (project / folder).rglob("*.cpp")}
    return sorted(there - {file.name for file in files})
