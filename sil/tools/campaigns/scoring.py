"""Indicators of others, scored on a campaign's runs: their files become the warnings in force, the queries judge them.

A file is CSV or Parquet with the columns run and time_s, ascending in each run, and one of
  side           changes of the warning in force: left, right or none from then on. A run without rows has no warning.
  level, side    a time series; a level of 1 says "warn", towards side (left or right)
  right, left    a time series of the levels towards either side
A time series drives the firmware's own warning states, as the campaign's own indices do (docs/drives.md, What counts),
with the calibration of the run, which `rsi-sil campaign run --traces` leaves.
"""

import pathlib
import tomllib

import duckdb
import judge

from campaign_error import CampaignError

READERS = {".csv": "read_csv(?, all_varchar = true)", ".parquet": "read_parquet(?)"}
FORMS = ({"side"}, {"level", "side"}, {"right", "left"})


def read(connection, path):
    """The table `given_file`. Raises CampaignError for what cannot be scored."""
    reader = READERS.get(path.suffix)
    if reader is None:
        raise CampaignError(f"{path}: wants a file whose name ends in {' or '.join(READERS)}")
    try:
        columns = {column[0] for column in connection.execute(f"SELECT * FROM {reader} LIMIT 0", [str(path)]).description}
        levels = columns - {"run", "time_s"}
        if not {"run", "time_s"} <= columns or levels not in FORMS:
            raise CampaignError(f"{path}: has the columns {', '.join(sorted(columns))}; wants run, time_s, and side, or level "
                                "and side, or right and left")
        casts = ", ".join(name if name == "side" else f'CAST("{name}" AS DOUBLE) AS "{name}"' for name in sorted(levels))
        connection.execute("CREATE OR REPLACE TEMP TABLE given_file AS SELECT CAST(run AS BIGINT) AS run, "
                           f"CAST(time_s AS DOUBLE) AS time_s, {casts} FROM {reader}", [str(path)])
    except duckdb.Error as error:
        raise CampaignError(f"{path}: {'; '.join(str(error).splitlines()[:3])}") from None
    checks(connection, path, levels)
    return levels


def checks(connection, path, levels):
    def refuse(where, what):
        found = connection.execute(f"SELECT run, time_s FROM ({where}) LIMIT 1").fetchone()
        if found:
            raise CampaignError(f"{path}: run {found[0]}, time_s {found[1]}: {what}")

    refuse("SELECT * FROM given_file WHERE run IS NULL OR time_s IS NULL OR NOT isfinite(time_s)", "run and time are wanted")
    refuse("SELECT * FROM given_file ANTI JOIN runs USING (run)", "there is no such run in the campaign")
    refuse("SELECT * FROM (SELECT run, time_s, lag(time_s) OVER (PARTITION BY run ORDER BY rowid) AS before FROM given_file) "
           "WHERE time_s <= before", "the times of a run must increase")
    if "side" in levels:
        sides = "'left', 'right'" + (", 'none'" if levels == {"side"} else "")
        refuse(f"SELECT * FROM given_file WHERE side IS NULL OR side NOT IN ({sides})", f"side wants one of {sides}")
    for level in sorted(levels - {"side"}):
        refuse(f"SELECT * FROM given_file WHERE \"{level}\" IS NULL OR NOT isfinite(\"{level}\")", f"{level} wants a number")
    if levels != {"side"}:
        refuse("SELECT run, 0 AS time_s FROM drawn ANTI JOIN given_file USING (run)", "is missing: every run wants its series")


def calibration_of(folder, run):
    path = folder / "traces" / f"{run}.toml"
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise CampaignError(f"{path}: {error.strerror}; a time series is scored on a campaign made with `rsi-sil campaign "
                            "--traces`; changes of a warning on any") from None


def series_of(connection, levels):
    """Run: its columns, those of the file in their order."""
    columns = ["side"] if levels == {"side"} else ["right", "left"] if "right" in levels else [
        "CASE side WHEN 'right' THEN level ELSE 0 END", "CASE side WHEN 'left' THEN level ELSE 0 END"]
    columns = ", ".join(f'"{name}"' if name.isalpha() else name for name in columns)
    series = {}
    for run, *sample in connection.execute(f"SELECT run, time_s, {columns} FROM given_file ORDER BY run, time_s").fetchall():
        series.setdefault(run, []).append(sample)
    return {run: list(zip(*samples)) for run, samples in series.items()}


def statement_of_changes(times_s, sides, lift_s, falling_side):
    """(lead, alarm) of the warning that is in force with these sides from these times on."""
    lead_s = None if lift_s is None else judge.lead_s(times_s, sides, lift_s, falling_side)
    return lead_s, any(side != "none" for side in sides)


def statement_of_series(calibration, series, lift_s, falling_side):
    """(lead, alarm) of an index behind the firmware's warning states."""
    index = judge.Index(calibration, *series)
    return None if lift_s is None else index.lead_s(1.0, lift_s, falling_side), index.alarms(1.0)


def add_entry(connection, folder, text):
    """NAME=FILE: the file's warnings as the entry NAME of `statements`."""
    name, equals, file = text.partition("=")
    if not (name and equals and file):
        raise CampaignError(f"wants NAME=FILE, not {text}")
    if name in [row[0] for row in connection.execute("SELECT DISTINCT entry FROM statements").fetchall()]:
        raise CampaignError(f"there is an entry {name} already; give another name")
    levels = read(connection, pathlib.Path(file))
    series = series_of(connection, levels)
    statements = []
    for run, *truth in connection.execute("SELECT run, two_wheel_lift_time_s, falling_side FROM drawn").fetchall():
        statement = (statement_of_changes(*series.get(run, ([], [])), *truth) if levels == {"side"} else
                     statement_of_series(calibration_of(folder, run), series[run], *truth))
        statements.append((name, run, *statement))
    connection.executemany("INSERT INTO given VALUES (?, ?, ?, ?)", statements)
