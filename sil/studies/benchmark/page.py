"""Scores the benchmark's entries and writes its page, what its picture is drawn from, and the drives' time series as one file.

Use: page.py PROGRAM CHOSEN REPORTED ENTRIES PAGE PICTURE_DATA [RARE]

CHOSEN and REPORTED are folders of campaigns with traces; ENTRIES has NAME.csv of the learned entries; RARE has a
campaign `plain` and one for each rare event. Called by sil/studies/benchmark/run.
"""

import hashlib
import pathlib
import sys

import pyarrow
import pyarrow.csv
import pyarrow.parquet

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(PROJECT / folder) for folder in ("sil/tools/campaigns", "sil/studies/predictors", "sil/judge", "sil/page",
                                                     "cmake/environment")]

import judge  # noqa: E402
import markdown  # noqa: E402
import query  # noqa: E402
import rare  # noqa: E402
import report  # noqa: E402
import scoring  # noqa: E402
import file_io  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
FIRMWARE = "the firmware's warning"
LEVEL = 3 + judge.LEVEL_BAND  # the place of its alarms among an entry's shares
CURVE_POINTS = [0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.8]


def shares(connection, table, entry, *warned, alarm):
    """Entry: the shares of lift-offs warned of, at all, by 0.1 s, by 0.2 s, and of runs of each band with an alarm."""
    kinds = [*(("lifted", condition) for condition in warned), *((f"band = '{band}'", alarm) for band in judge.bands())]
    counts = ", ".join(f"count(*) FILTER ({runs} AND {what}), count(*) FILTER ({runs})" for runs, what in kinds)
    found = {}
    for name, _, *cells in connection.execute(f"SELECT {entry}, vehicle, {counts} FROM {table} GROUP BY ALL ORDER BY ALL"
                                              ).fetchall():
        found.setdefault(name, []).append(list(zip(cells[::2], cells[1::2])))
    return {name: list(map(judge.share_by_vehicle, zip(*vehicles))) for name, vehicles in found.items()}


def as_they_say(connection):
    """Every entry with its own threshold."""
    return shares(connection, "statements", "entry", "warned", "warned_100ms", "warned_200ms", alarm="alarm")


def at_thresholds(connection, thresholds):
    """Every index at a threshold of its own."""
    connection.execute("CREATE OR REPLACE TEMP TABLE chosen_thresholds (index_name VARCHAR, chosen DOUBLE)")
    connection.executemany("INSERT INTO chosen_thresholds VALUES (?, ?)", list(thresholds.items()))
    return shares(connection, "(scores JOIN chosen_thresholds USING (index_name))", "index_name", "threshold >= chosen",
                  "threshold_100ms >= chosen", "threshold_200ms >= chosen", alarm="threshold >= chosen")


def matched(connection, share):
    """Index: the largest threshold with at least this share of alarms in the band."""
    of_band, level = {}, judge.bands()[judge.LEVEL_BAND]
    for name, threshold in connection.execute(f"SELECT index_name, threshold FROM scores WHERE band = '{level}' "
                                              "ORDER BY index_name, threshold DESC").fetchall():
        of_band.setdefault(name, []).append(threshold)
    return {name: judge.matched_threshold(values, share) for name, values in of_band.items()}


def table(rows, first_columns=()):
    """`rows`: (name, cells of the first columns, shares), the earliest first."""
    head = ["", *first_columns, *report.WARNED, *report.alarm_columns()]
    lines = []
    for name, cells, of_entry in sorted(rows, key=lambda row: (-row[2][2].count, row[0])):
        figures = [*map(markdown.percent, of_entry[:3]), *map(report.alone, of_entry[3:])]
        lines.append([name, *cells, *figures])
    return markdown.table(head, lines, range(1, 1 + len(first_columns)))


def point(of_entry):
    return f"{100 * of_entry[LEVEL].value():.2f} {100 * of_entry[2].value():.2f}\n"


def blocks(points):
    return "\n\n".join(f'"{name}"\n' + "".join(map(point, of_name)) for name, of_name in points.items())


def digest(folder):
    return hashlib.sha256((folder / "runs.csv").read_bytes()).hexdigest()[:16]


def write_series(folder):
    """All time series of a folder as one file, series.parquet; a group of rows a run."""
    target = folder / "series.parquet"
    if target.exists():
        return
    paths = sorted((folder / "traces").glob("*.csv"), key=lambda path: int(path.stem))
    with paths[0].open(encoding="utf-8") as file:
        remarks = 0
        while (line := file.readline()).startswith("#"):
            remarks += 1
    types = {name: pyarrow.string() if name in ("state", "side") else pyarrow.float64() for name in line.strip().split(",")}
    schema = pyarrow.schema([("run", pyarrow.int64()), *types.items()])
    with file_io.growing(target) as file, pyarrow.parquet.ParquetWriter(file, schema, compression="zstd") as writer:
        for path in paths:
            rows = pyarrow.csv.read_csv(path, pyarrow.csv.ReadOptions(skip_rows=remarks),
                                        convert_options=pyarrow.csv.ConvertOptions(column_types=types))
            runs = pyarrow.array([int(path.stem)] * len(rows), pyarrow.int64())
            writer.write_table(pyarrow.table([runs, *rows.columns], schema=schema))


def rare_table(folder, program):
    """Rate in a million runs of each event that has a campaign drawn nearer to it: plain runs alone, and all weighed."""
    rows = []
    for event, (what, _) in rare.EVENTS.items():
        if (folder / event).is_dir():
            samples, _ = rare.weighed([folder / "plain", folder / event], program, what)
            plain = rare.plainly(samples[0])
            weighed = rare.estimate(samples, len(samples[0]))
            cells = [f"`{event}`"]
            for found in (plain, weighed):
                low, high = (rare.per_million(end) for end in found.interval)
                cells += [f"{rare.per_million(found.share)} ({low} to {high})", f"{found.events} in {found.runs}"]
            rows.append([*cells, f"{weighed.trials:.0f}"])
    return markdown.table(["in 1,000,000 runs", "plain runs alone", "events", "all runs, weighed", "events",
                           "worth so many plain runs"], rows, (2, 4, 5))


def main(arguments):
    program, chosen, reported, entries, page, data, *rare_folder = map(pathlib.Path, arguments)
    of_chosen, of_reported = query.open_rows(chosen, program), query.open_rows(reported, program)
    for connection in (of_chosen, of_reported):  # asked often
        connection.execute("CREATE TEMP TABLE scores AS SELECT * FROM index_scores")
    learned = {path.stem.replace("_", " "): path for path in sorted(entries.glob("*.csv"))}
    for name, path in learned.items():
        scoring.add_entry(of_reported, reported, f"{name}={path}")
    for folder in (chosen, reported):
        write_series(folder)
    own = as_they_say(of_reported)
    wanted = as_they_say(of_chosen)[FIRMWARE][LEVEL].value()
    thresholds = matched(of_chosen, wanted)
    fair = at_thresholds(of_reported, thresholds)
    equal = [(name, [f"{thresholds[name]:.3f}"], of_index) for name, of_index in fair.items()]
    equal += [(name, ["-"], own[name]) for name in (FIRMWARE, *learned)]
    curves = {}
    for share in CURVE_POINTS:
        for name, of_index in at_thresholds(of_reported, matched(of_reported, share)).items():
            curves.setdefault(name, []).append(of_index)
    text = (HERE / "benchmark.md.in").read_text(encoding="utf-8")
    for key, value in {
            "rare": rare_table(rare_folder[0], program) if rare_folder else "(Not driven for this page.)",
            "equal": table(equal, ["threshold"]),
            "own": table([(name, [], of_entry) for name, of_entry in own.items() if name not in learned]),
            "runs": str(sum(share.total for share in (own[FIRMWARE][0], *own[FIRMWARE][3:]))),
            "vehicles": str(of_reported.execute("SELECT count(DISTINCT vehicle) FROM drawn").fetchone()[0]),
            "lifted": str(own[FIRMWARE][0].total),
            "bands": ", ".join(f"{share.total} {band}" for band, share in zip(judge.bands(), own[FIRMWARE][3:])),
            "chosen_digest": digest(chosen), "reported_digest": digest(reported)}.items():
        text = text.replace(f"@{key}@", value)
    file_io.write(page, text)
    file_io.write(data.with_suffix(".curves"), blocks(curves))
    file_io.write(data.with_suffix(".points"), blocks({name: [own[name]] for name in (FIRMWARE, *learned)}))


if __name__ == "__main__":
    main(sys.argv[1:])
