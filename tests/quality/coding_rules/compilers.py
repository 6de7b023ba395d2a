"""clang-tidy, clang and g++ over the sources, as findings."""

import concurrent.futures
import dataclasses
import os
import pathlib
import re
import subprocess
import tomllib

from findings import PROJECT, Finding

HERE = pathlib.Path(__file__).resolve().parent
WARNINGS = tomllib.loads((HERE / "warnings.toml").read_text(encoding="utf-8"))
_EIGEN = ["-isystem", "/usr/include/eigen3", "-DEIGEN_DONT_VECTORIZE"]
_COMMON = ["-std=c++17", "-O2", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics", "-ffp-contract=off",
           "-fno-math-errno", f"-I{PROJECT}", f"-I{PROJECT}/firmware", f"-I{PROJECT}/hal/interface", f"-I{PROJECT}/can_dbc/include", *_EIGEN]


@dataclasses.dataclass(frozen=True)
class Platform:
    """How to compile for it: what g++ is called, and what clang needs to stand in for it."""

    gcc: str
    gcc_flags: tuple
    clang_flags: tuple


HOST = Platform("g++-12", (), ())
_R5F = ("-mcpu=cortex-r5", "-marm", "-mfpu=vfpv3-d16", "-mfloat-abi=hard", "-DRSI_ZYNQMP_POLICY_SILICON")
_NEWLIB = "/usr/lib/arm-none-eabi/include"
BOARD = Platform(
    "arm-none-eabi-g++", _R5F,
    ("--target=armv7r-none-eabihf", *_R5F, "-nostdlibinc", "-isystem", f"{_NEWLIB}/c++/12.2.1", "-isystem",
     f"{_NEWLIB}/c++/12.2.1/arm-none-eabi/arm/v5te/hard", "-isystem", _NEWLIB),
)


@dataclasses.dataclass(frozen=True)
class Unit:
    """Sources that are compiled as one, as the build compiles the component: Eigen is read once, and g++ sees all."""

    name: str
    platform: Platform
    sources: tuple  # .cpp taken in whole, headers included

    def write(self, folder):
        """The unit as one file, and where its lines come from."""
        file = folder / f"{self.name}.cpp"
        lines, origin = [], []
        for path in self.sources:
            if path.endswith((".h", ".hpp")):
                lines.append(f'#include "{path}"')
                origin.append((path, 1))
                continue
            for number, line in enumerate((PROJECT / path).read_text(encoding="utf-8").splitlines(), 1):
                lines.append(line)
                origin.append((path, number))
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return file, origin


_MESSAGE = re.compile(r"^(?P<file>[^\s:][^:\n]*):(?P<line>\d+):(?:\d+:)? (?P<kind>warning|error|fatal error): (?P<text>.*?)"
                      r"(?: \[(?P<rule>[^\[\]]+)\])?$")


def _run(command):
    return subprocess.run(command, cwd=PROJECT, capture_output=True, text=True, check=False,
                          env={**os.environ, "LC_ALL": "C"})


def _findings(output, tool, file, origin):
    found, seen = [], set()
    for line in output.splitlines():
        match = _MESSAGE.match(line)
        if not match:
            continue
        path, number = match["file"], int(match["line"])
        if pathlib.Path(path).resolve() == file.resolve():
            path, number = origin[min(number, len(origin)) - 1]
        else:
            resolved = (PROJECT / path).resolve()
            if not resolved.is_relative_to(PROJECT):
                if match["kind"] == "warning":
                    continue  # Eigen's, the library's: not ours to put right
                path = str(resolved)
            else:
                path = str(resolved.relative_to(PROJECT))
        for rule in (match["rule"] or "compile-error").split(","):
            rule = rule.removeprefix("-Werror=") if rule != "-Werror" else ""
            if rule:
                name = rule if tool == "clang-tidy" else f"{tool} {rule}"
                finding = Finding(path, number, name, match["text"])
                if finding not in seen:
                    seen.add(finding)
                    found.append(finding)
    return found


def _checked(result, tool, found):
    """A tool that failed without a finding has not checked anything."""
    if result.returncode != 0 and not found:
        raise SystemExit(f"{tool} failed:\n{result.stderr[-3000:]}{result.stdout[-3000:]}")
    return found


def clang_tidy(unit, file, origin, configuration=PROJECT / "firmware/.clang-tidy"):
    result = _run(["clang-tidy-19", f"--config-file={configuration}", "--quiet", str(file), "--", *_COMMON,
                   *unit.platform.clang_flags])
    return _checked(result, "clang-tidy", _findings(result.stdout, "clang-tidy", file, origin))


def clang(unit, file, origin):
    left_out = [f"-Wno-{name}" for name in WARNINGS["clang_left_out"]]
    result = _run(["clang++-19", *_COMMON, *unit.platform.clang_flags, "-Weverything", *left_out, "-fsyntax-only", str(file)])
    return _checked(result, "clang", _findings(result.stderr, "clang", file, origin))


def gcc(unit, file, origin):
    flags = [f"-W{name}" for name in WARNINGS["gcc"]]
    result = _run([unit.platform.gcc, *_COMMON, *unit.platform.gcc_flags, *flags, "-c", "-o", "/dev/null", str(file)])
    return _checked(result, "g++", _findings(result.stderr, "g++", file, origin))


def findings(units, folder):
    """Findings of all tools in all units; as many run at a time as there are processors."""
    jobs = []
    for unit in units:
        file, origin = unit.write(folder)
        jobs += [(tool, unit, file, origin) for tool in (clang_tidy, clang, gcc)]
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        return {finding for found in pool.map(lambda job: job[0](*job[1:]), jobs) for finding in found}


def require_tools(*more):
    for tool in ("clang-tidy-19", "clang++-19", HOST.gcc, BOARD.gcc, *more):
        if not any(os.access(pathlib.Path(folder) / tool, os.X_OK) for folder in os.environ["PATH"].split(":")):
            raise SystemExit(f"{tool} is missing. Run: cmake/environment/set_up --targets --clang")
