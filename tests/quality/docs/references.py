"""References of a page: links and anchors, paths in code, commands with their groups, targets and options."""

import fnmatch
import re
import subprocess

from page import Page

# Folders that only a build or a run makes.
MADE = ("build/", "output/", "/tmp/")
TOKEN = re.compile(r"[\w.{}*+-]+(?:/[\w.{}*+-]+)+/?")
SOURCE_NAME = re.compile(r"^[\w.-]+\.(?:hpp|cpp|py|cmake)$")
OPTION = re.compile(r"(?<![\w-])--[a-z][\w-]*")
COMMAND_END = re.compile(r"[|;&#]|\s#")


def link_problems(page, pages):
    problems = []
    for place, target in page.links():
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = (page.project / page.path).parent / path if path else page.project / page.path
        if not file.exists():
            problems.append(f"{place}: dead link: {target}")
        elif anchor and file.suffix == ".md":
            name = str(file.resolve().relative_to(page.project.resolve()))
            if name not in pages:
                pages[name] = Page(page.project, name)
            if anchor not in pages[name].anchors():
                problems.append(f"{place}: dead anchor: {target}")
    return problems


class Commands:
    """Groups, commands, options and targets of the project's programs and scripts."""

    def __init__(self, project, files):
        self.project, self.files = project, files
        self.folders = {"/".join(name.split("/")[:depth]) for name in files for depth in range(1, name.count("/") + 1)}
        self.tops = {name.split("/")[0] for name in files if "/" in name}
        self.names = {name.rsplit("/", 1)[-1] for name in files}
        self.cmake = self._text("*CMakeLists.txt") + self._text("*.cmake")
        self.programs = self._text("sil/apps/*")
        self.groups = self._groups()
        self.presets = set(re.findall(r'"name": "([\w-]+)"', self._text("CMakePresets.json")))

    def _text(self, pattern):
        return "\n".join((self.project / name).read_text(encoding="utf-8", errors="replace")
                         for name in fnmatch.filter(self.files, pattern))

    def _groups(self):
        run = self.project / "tests/run"
        if not run.is_file():
            return set()
        done = subprocess.run([str(run), "--help"], capture_output=True, text=True, check=False)
        leaves = {folder.rsplit("/", 1)[-1] for folder in self.folders if folder.startswith("tests/")}
        return set(re.findall(r"^  (\w+) +\S", done.stdout, re.MULTILINE)) | leaves

    def exists(self, path):
        path = path.rstrip("/.")
        if path in self.folders or path in self.files:
            return True
        pattern = re.sub(r"\{[^}]*\}|\b[A-Z][A-Z_]+\b", "*", path)
        return "*" in pattern and any(fnmatch.fnmatchcase(name, pattern) for name in [*self.files, *self.folders])

    def path_problems(self, place, text):
        problems = []
        for found in TOKEN.finditer(text):
            path = found[0].removeprefix("./")
            before = text[: found.start()]
            if before.endswith(("/", "$", "~", ":/", "=/")) or re.search(r"[\w.]$", before):
                continue
            if path.startswith(MADE) or path.split("/")[0] not in self.tops:
                continue
            if not self.exists(path):
                problems.append(f"{place}: no such path: {path}")
        if SOURCE_NAME.match(text) and text not in self.names:
            problems.append(f"{place}: no file is called {text}")
        return problems

    def command_problems(self, place, text):
        problems = []
        for command in re.split(r"&&|;|\|", text):
            words = command.split("  #")[0].split(" # ")[0].split()
            words = [word for word in words if "=" not in word.split("/")[0] or word.startswith("--")]
            while words and words[0] in ("sudo", "time", "nice"):
                words.pop(0)
            if words:
                problems += [f"{place}: {problem}" for problem in self._one(words)]
        return problems

    def _one(self, words):
        _, *rest = words
        presets = [after for word, after in zip(words, rest) if word == "--preset" or word.endswith("environment/build")]
        return [f"CMakePresets.json has no preset {preset}" for preset in presets
                if re.fullmatch(r"[a-z][\w-]*", preset) and preset not in self.presets] + self._understood(words)

    def _understood(self, words):
        program, *rest = words
        name = program.rsplit("/", 1)[-1]
        if program == "tests/run":
            plain = [word for before, word in zip(words, rest) if not word.startswith("-") and not before.startswith("-")]
            found = [f"tests/run knows no group {group}" for group in plain
                     if re.fullmatch(r"[a-z_]+", group) and group not in self.groups]
            return found + self._options(program, name, rest)
        if name == "rsi-sil" and rest and re.fullmatch(r"[a-z]+", rest[0]) and f'"{rest[0]}"' not in self.programs:
            return [f"rsi-sil has no command {rest[0]}"]
        if name in ("cmake", "ninja") and "--target" in rest:
            named = [word for word in rest[rest.index("--target") + 1:] if re.fullmatch(r"\w+", word)]
            return [f"no CMake file has the target {target}" for target in named
                    if target not in ("package", "install", "all") and not re.search(rf"\b{target}\b", self.cmake)]
        return self._options(program, name, rest)

    def _options(self, program, name, rest):
        options = [option for option in OPTION.findall(" ".join(rest)) if option != "--help"]
        if not options:
            return []
        folder = program.rpartition("/")[0]
        if program in self.files and (self.project / program).read_bytes().startswith(b"#!"):
            beside = [file for file in self.files if file.rpartition("/")[0] == folder]
            known = "".join((self.project / file).read_text(encoding="utf-8", errors="ignore") for file in beside)
            if program == "sil/run":
                known += self.programs
        elif name in ("rsi-sil", "rsi-ecu"):
            known = self.programs
        else:
            return []
        return [f"{name} knows no option {option}" for option in options
                if option not in known and f'"{option[2:]}"' not in known]


def report_problems(page, commands, pages):
    """A report names only files that are there: code, tests and tools of today."""
    found = link_problems(page, pages)
    for number, line in enumerate(page.lines, 1):
        found += commands.path_problems(f"{page.path}:{number}", line)
    return found


def pages_elsewhere(project, files):
    """Pages that a source, a script or a message names."""
    problems = []
    for name in files:
        if name.endswith((".md", ".png", ".svg", ".zip", "planted_faults_test.py")):
            continue
        text = (project / name).read_text(encoding="utf-8", errors="ignore")
        for found in re.finditer(r"\bdocs/[\w/]+\.md\b", text):
            if found[0] not in files:
                problems.append(f"{name}:{text.count(chr(10), 0, found.start()) + 1}: there is no page {found[0]}")
    return problems


def problems(page, commands, pages):
    return link_problems(page, pages) + code_problems(page, commands)


def code_problems(page, commands):
    """Paths and commands."""
    spans, lines = page.code()
    found = []
    for place, text in spans:
        found += commands.path_problems(place, text) + commands.command_problems(place, text)
    joined = ""
    for place, text in lines:
        found += commands.path_problems(place, text)
        joined += text.rstrip().removesuffix("\\") + " "
        if not text.rstrip().endswith("\\"):
            found += commands.command_problems(place, joined)
            joined = ""
    return found
