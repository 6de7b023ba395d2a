"""Builds the test programs with clang's counters, runs them, and gives what each of them reached."""

import concurrent.futures
import json
import os
import pathlib
import subprocess

PROJECT = pathlib.Path(__file__).resolve().parents[3]
BUILD = PROJECT / "build/coverage"
# Test programs of firmware and codec that need nothing of sil/.
PROGRAMS = {"rsi_tests": "tests/rsi", "monitoring_tests": "tests/monitoring", "application_test": "tests/application",
            "access_test": "tests/access", "xcp_test": "tests/xcp", "diagnosis_test": "tests/diagnosis", "codec_test": "tests/can_dbc"}
TIME_LIMIT_S = 1500


def build():
    for command in (["set_up", "--clang"], ["build", "coverage", *PROGRAMS]):
        if subprocess.run([PROJECT / "cmake/environment" / command[0], *command[1:]]).returncode != 0:
            raise SystemExit(f"coverage: cmake/environment/{' '.join(command)} failed; the reason is above")


def report_of(name):
    """llvm-cov's export of one program. Each is exported by itself: a header's function that one program does not use
    has no counters there, and llvm-cov would take the two for different functions."""
    program = BUILD / PROGRAMS[name] / name
    raw, merged = BUILD / f"{name}.profraw", BUILD / f"{name}.profdata"
    raw.unlink(missing_ok=True)
    run = subprocess.run([program, "--gtest_brief=1"], cwd=PROJECT, timeout=TIME_LIMIT_S, capture_output=True, text=True,
                         env={**os.environ, "LLVM_PROFILE_FILE": str(raw)})
    if run.returncode != 0:
        raise SystemExit(f"{run.stdout}{run.stderr}\ncoverage: {name} failed; what it reached says nothing")
    subprocess.run(["llvm-profdata-19", "merge", "-o", merged, raw], check=True)
    export = subprocess.run(["llvm-cov-19", "export", "-instr-profile", merged, program], check=True,
                            capture_output=True, text=True)
    return json.loads(export.stdout)["data"][0]


def reports():
    build()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(report_of, PROGRAMS))
