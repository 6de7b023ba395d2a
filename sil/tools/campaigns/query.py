"""Questions to the rows of a campaign: SQL files beside, one a question, answered by DuckDB from Parquet."""

import csv
import io
import math
import os
import pathlib
import shlex

import duckdb
import judge
import numpy
import pyarrow

import parquet
import scoring
import file_io
from campaign_error import CampaignError

QUERIES = pathlib.Path(__file__).resolve().parent / "queries"
VIEWS = QUERIES / "views"
MOST_LINES = 100
LIFTED = "two wheels lift"  # in place of a band


def names():
    """Each question with what its first line says."""
    return {path.stem: path.read_text(encoding="utf-8").splitlines()[0].removeprefix("-- ")
            for path in sorted(QUERIES.glob("*.sql"))}


def quoted(text):
    return "'" + str(text).replace("'", "''") + "'"


def judged(lift_off_times_s, leads_s, largest_ltrs):
    """The judge's word on runs side by side, as a struct."""
    each = judge.each(*(numpy.array(column.to_pylist(), dtype=float) for column in (lift_off_times_s, largest_ltrs, leads_s)))
    names = [*judge.bands(), LIFTED]
    bands = [LIFTED if lifted else names[band] for lifted, band in zip(each["lifted"], each["band"])]
    return pyarrow.StructArray.from_arrays(
        [pyarrow.array(each[name], pyarrow.uint8()).cast(pyarrow.bool_()) for name in judge.EACH[:-1]] + [pyarrow.array(bands)],
        judge.EACH)


def open_rows(folder, program):
    """A connection with the tables runs, drawn, index_scores and statements, and with the function drive_again."""
    files = parquet.convert(folder, program)
    judge.use(program)
    connection = duckdb.connect()
    connection.create_function(
        "judged", judged, ["DOUBLE"] * 3,
        duckdb.struct_type({**dict.fromkeys(judge.EACH[:-1], "BOOLEAN"), judge.EACH[-1]: "VARCHAR"}), type="arrow",
        null_handling="special")
    connection.execute(f"CREATE VIEW runs AS SELECT * FROM read_parquet([{', '.join(map(quoted, files))}])")
    connection.execute((VIEWS / "drawn.sql").read_text(encoding="utf-8"))
    ending = "_threshold_100ms"
    indices = [name.removesuffix(ending) for name in connection.table("runs").columns if name.endswith(ending)]
    connection.execute("CREATE VIEW index_scores AS " + " UNION ALL ".join(
        f"SELECT run, vehicle, class, manoeuvre, largest_ltr, lifted, calm, band, {quoted(index)} AS index_name, "
        f"{index}_threshold AS threshold, {index}_threshold_100ms AS threshold_100ms, "
        f"{index}_threshold_200ms AS threshold_200ms, "
        f"{index}_lead_time_s AS lead_time_s FROM drawn" for index in indices))
    connection.execute("CREATE TABLE given (entry VARCHAR, run BIGINT, lead_time_s DOUBLE, alarm BOOLEAN)")
    connection.execute((VIEWS / "statements.sql").read_text(encoding="utf-8"))
    again = (f"(cd {shlex.quote(os.getcwd())} && {shlex.quote(str(program))} campaign one ",
             f" --settings {shlex.quote(str(folder / 'campaign.toml'))} --output {shlex.quote(str(folder))})")
    connection.execute(f"CREATE MACRO drive_again(number) AS {quoted(again[0])} || number || {quoted(again[1])}")
    return connection


def text_of(value):
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return "-"
    return f"{value:.10g}" if isinstance(value, float) else str(value)


def table_of(head, rows):
    cells = [head, *([text_of(value) for value in row] for row in rows[:MOST_LINES])]
    left = [bool(rows) and isinstance(rows[0][column], str) for column in range(len(head))]
    widths = [max(len(row[column]) for row in cells) for column in range(len(head))]
    lines = ["  ".join(cell.ljust(width) if is_left else cell.rjust(width)
                       for cell, width, is_left in zip(row, widths, left)).rstrip() for row in cells]
    if len(rows) > MOST_LINES:
        lines.append(f"The first {MOST_LINES} of {len(rows)}; --csv FILE has all.")
    return "\n".join(lines)


def csv_of(head, rows):
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(head)
    writer.writerows(rows)
    return text.getvalue()


def answer(folder, program, name, sql, target, given=()):
    """The printed text. `given`: NAME=FILE of indicators to score beside."""
    if sql is None and name not in names():
        raise CampaignError(f"there is no question {name}; there are: {' '.join(names())}")
    connection = open_rows(folder.resolve(), program.resolve())
    for text in given:
        scoring.add_entry(connection, folder, text)
    try:
        result = connection.execute(sql or (QUERIES / f"{name}.sql").read_text(encoding="utf-8"))
        head, rows = [column[0] for column in result.description], result.fetchall()
    except duckdb.Error as error:
        raise CampaignError(f"{'--sql' if sql else name}: {error}") from None
    if target is not None:
        file_io.write(target, csv_of(head, rows))
        return f"{len(rows)} rows are in {target}"
    return table_of(head, rows) if rows else "There are none."
