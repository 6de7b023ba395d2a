"""Drives campaigns of a population with and without a reaction to warnings, and writes the page on what it prevents.

Use: study.py PROGRAM POPULATION FOLDER PAGE RUNS

Called by sil/studies/prevention/run.
"""

import csv
import json
import pathlib
import subprocess
import sys
import tomllib
import typing

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(PROJECT / folder) for folder in ("sil/studies/campaign", "sil/judge", "sil/page", "cmake/environment")]

import file_io  # noqa: E402
import goals  # noqa: E402
import judge  # noqa: E402
import markdown  # noqa: E402
import report  # noqa: E402

ERRORS, CLEAN, ORDINARY = "errors", "clean", "ordinary"
TEMPLATE = pathlib.Path(__file__).with_name("prevention.md.in")
LADDER = 1.01  # thresholds of a row are powers of it (sil/judge/index_score.hpp)
MOST_ORDINARY_DRIVES = 600  # of ten minutes each


class Warning(typing.NamedTuple):
    """The warning that is reacted to."""

    name: str
    index: str  # `warning`: the firmware's
    level: float | None = None  # threshold; the firmware has its own

    def untouched(self, row):
        """Whether it begins nowhere in this run without lift-off, which then goes on as without a reaction."""
        if self.level is None:
            return int(row["warnings"]) == 0
        # The next step of the ladder did not warn either; a little more, for the digits of a row.
        return 1.001 * LADDER * float(row[f"{self.index}_threshold"]) < self.level


class Reaction(typing.NamedTuple):
    """The reaction; all of it goes into the settings."""

    kind: str
    delay_s: float
    ramp_s: float
    size: float  # deceleration in m/s2, or the share by which the handwheel is turned back

    def toml(self):
        key = "deceleration_mps2" if self.kind == "brake" else "steer_back_share"
        return f'kind = "{self.kind}"\ndelay_s = {self.delay_s}\nramp_s = {self.ramp_s}\n{key} = {self.size}\n'


BRAKE = Reaction("brake", 0.1, 0.2, 4.0)
DRIVER = Reaction("driver", 0.75, 0.2, 0.5)
DELAYS_S = (0.0, 0.1, 0.2, 0.3, 0.5)
DECELERATIONS_MPS2 = (2.0, 6.0)  # besides


class Variant(typing.NamedTuple):
    warning: Warning
    reaction: Reaction

    def toml(self):
        level = "" if self.warning.level is None else f"level = {self.warning.level!r}\n"
        return f'\n[intervention]\nindex = "{self.warning.index}"\n{level}{self.reaction.toml()}'

    def folder(self):
        level = "" if self.warning.level is None else f"_{self.warning.level:g}"
        return f"{self.warning.index}{level}_" + "_".join(map(str, self.reaction))


class Refused(Exception):
    """The program did not accept what it was given."""


def say(text):
    print(f"prevention: {text}", file=sys.stderr, flush=True)


def call(program, *arguments):
    if subprocess.run([program, "campaign", *map(str, arguments)], stdout=subprocess.DEVNULL, check=False).returncode:
        raise Refused(f"rsi-sil campaign {arguments[0]} has failed, as it says above")


def rows(folder):
    with (folder / "runs.csv").open(encoding="utf-8", newline="") as file:
        yield from csv.DictReader(file)


def runs(folder):
    """report.Run by number."""
    return {int(row["run"]): report.Run(
        row["vehicle"], row["class"], row["manoeuvre"], row["two_wheel_lift_time_s"] != "", float(row["largest_ltr"]),
        float(row["end_time_s"]), float(row["distance_m"]), int(row["interventions"])) for row in rows(folder)}


def take_over(baseline, folder, warning):
    """Rows of runs in which nothing is reacted to are those of the baseline; all others are left to be driven, how many."""
    table = folder / "runs.csv"
    there = [] if not table.exists() else table.read_text(encoding="utf-8").splitlines(keepends=True)[1:]
    missing = {row["run"] for row in rows(baseline)} - {line.partition(",")[0] for line in there}
    untouched = {row["run"] for row in rows(baseline) if not row["two_wheel_lift_time_s"] and warning.untouched(row)} & missing
    with (baseline / "runs.csv").open(encoding="utf-8") as lines, file_io.growing(table) as file:
        file.write("".join([next(lines), *there]).encode("utf-8"))
        for line in lines:
            if line.partition(",")[0] in untouched:
                file.write(line.encode("utf-8"))
    return len(missing) - len(untouched)


class Study:
    def __init__(self, program, population, folder, count):
        self._program, self._population, self._folder, self._count = program, population, folder, count
        self._driven = {}

    def baseline(self, name):
        """The folder of the campaign without a reaction."""
        folder = self._folder / name / "no_reaction"
        if name not in self._driven:
            say(f"{name}, {self._count[name]} runs without a reaction")
            call(self._program, "run", "--settings", self._population / f"settings_report_{name}.toml", "--runs", self._count[name],
                 "--output", folder)
            self._driven[name] = runs(folder)
        return folder

    def without(self, name):
        self.baseline(name)
        return self._driven[name]

    def having(self, name, variant):
        """The runs with a reaction. Settings are those of the baseline; its vehicles have absolute paths there."""
        baseline, folder = self.baseline(name), self._folder / name / variant.folder()
        key = (name, variant.folder())
        if key not in self._driven:
            settings = self._folder / name / f"{variant.folder()}.toml"
            file_io.write(settings, (baseline / "campaign.toml").read_text(encoding="utf-8") + variant.toml())
            if not (folder / "campaign.toml").exists():
                call(self._program, "begin", "--settings", settings, "--output", folder)
            say(f"{name}, {variant.folder()}: {take_over(baseline, folder, variant.warning)} runs that it can change")
            call(self._program, "run", "--settings", settings, "--runs", self._count[name], "--output", folder)
            self._driven[key] = runs(folder)
        return self._driven[key]

    def compared(self, name, variant):
        return report.compare(self.without(name), self.having(name, variant))

    def warnings(self, name, calibration):
        """The warnings of this campaign, their levels at equal alarms as its report has them."""
        found = json.loads((self.baseline(name) / "report.json").read_text(encoding="utf-8"))
        own = calibration["warning_on"]
        listed = [Warning("default warning", "warning"), Warning("published RSI, its own level", "published", 1.0),
                  Warning(report.TRUE_AT_OWN, report.TRUTH, own)]
        for limit in sorted(goals.EQUAL_ALARMS, reverse=True):
            for text, index in (("default index", calibration["warning_indicator"]), ("published RSI", "published"),
                                ("true load transfer", report.TRUTH)):
                threshold = goals.best_point(found["all"], index, limit)["threshold"]
                listed.append(Warning(text + report.at_alarms(limit), index, threshold))
        return listed


def reached(warning):
    """False: the index has no level with so few alarms."""
    return warning.index == "warning" or warning.level is not None


def prevention_table(study, calibration):
    cells = {}
    order = []
    for name in (ERRORS, CLEAN):
        for reaction in (BRAKE, DRIVER):
            for warning in study.warnings(name, calibration):
                if reaction == DRIVER and warning.name.endswith(report.FEWEST_ALARMS):
                    continue  # too late for a driver
                key = f"{report.REACTIONS[reaction.kind]}: {warning.name}"
                order += [key] if key not in order else []
                # The truth has no errors: both campaigns are the same then.
                campaign = ERRORS if warning.index == report.TRUTH else name
                found = study.compared(campaign, Variant(warning, reaction)) if reached(warning) else None
                cells[key, name] = report.cells(found, warning.level)
    return report.prevention([(key, cells[key, ERRORS], cells[key, CLEAN]) for key in order])


def delay_table(study, warnings):
    variants = [Variant(warning, BRAKE._replace(delay_s=delay_s)) for warning in warnings for delay_s in DELAYS_S]
    variants += [Variant(warnings[0], BRAKE._replace(size=size)) for size in DECELERATIONS_MPS2]
    return report.delays([(variant.warning.name, variant.reaction, study.compared(ERRORS, variant)) for variant in variants])


def cost_table(study, warnings):
    return report.costs([(warning.name, study.compared(ERRORS, Variant(warning, BRAKE)), study.compared(ORDINARY, Variant(warning, BRAKE)))
                         for warning in warnings])


def page_of(study, calibration):
    warnings = [warning for warning in study.warnings(ERRORS, calibration) if reached(warning)]
    chosen = [warning for warning in warnings if warning.name in report.CHOSEN]
    compared = [(warning.name, study.compared(ERRORS, Variant(warning, BRAKE)))
                for warning in warnings if warning.name in (*report.CHOSEN, report.TRUE_AT_OWN)]
    errors, clean, ordinary = (study.without(name) for name in (ERRORS, CLEAN, ORDINARY))
    values = {
        "vehicles": str(len({run.vehicle for run in errors.values()})),
        "runs": str(len(errors)),
        "lifted_errors": str(sum(run.lifted for run in errors.values())),
        "lifted_clean": str(sum(run.lifted for run in clean.values())),
        "brake_delay": f"{BRAKE.delay_s:g}",
        "brake_ramp": f"{BRAKE.ramp_s:g}",
        "deceleration": f"{BRAKE.size:g}",
        "driver_delay": f"{DRIVER.delay_s:g}",
        "driver_ramp": f"{DRIVER.ramp_s:g}",
        "steer_back": f"{100 * DRIVER.size:g}",
        "prevention": prevention_table(study, calibration),
        "classes": report.groups(compared, "in_class"),
        "manoeuvres": report.groups(compared, "manoeuvre"),
        "delays": delay_table(study, chosen),
        "costs": cost_table(study, warnings),
        "drives": str(len(ordinary)),
        "hours": f"{sum(run.end_s for run in ordinary.values()) / 3600:.1f}",
    }
    return markdown.filled(TEMPLATE, values)


def main():
    program, population, folder, page = map(pathlib.Path, sys.argv[1:5])
    count = int(sys.argv[5])
    judge.use(program)
    calibration = tomllib.loads((PROJECT / "firmware/calibrations/large_suv.toml").read_text(encoding="utf-8"))
    study = Study(program, population, folder, {ERRORS: count, CLEAN: count, ORDINARY: min(MOST_ORDINARY_DRIVES, count * 6 // 100 + 1)})
    try:
        file_io.write(page, page_of(study, calibration))
    except Refused as error:
        sys.exit(f"sil/studies/prevention/run: {error}")


if __name__ == "__main__":
    main()
