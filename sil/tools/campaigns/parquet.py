"""Rows as Parquet, with unit and meaning in the metadata of each column: DIR/parquet has one file for each file of rows."""

import json
import subprocess
import sys

import pyarrow
import pyarrow.csv
import pyarrow.parquet

import parts
import file_io
from campaign_error import CampaignError

TYPES = {"text": pyarrow.string(), "count": pyarrow.int64(), "yes_or_no": pyarrow.bool_(), "number": pyarrow.float64()}
SOURCE = b"rsi_sil.source"  # sources of the file
ROWS = 65536  # of a group


def columns_of(program):
    """Output of `rsi-sil campaign columns`."""
    try:
        return json.loads(subprocess.run([program, "campaign", "columns"], capture_output=True, check=True).stdout)
    except (OSError, subprocess.CalledProcessError) as error:
        raise CampaignError(f"{program} does not tell the columns: {error}; make it with cmake/environment/build release "
                            "rsi-sil, or name another: --program FILE") from None


def schema_of(columns):
    return pyarrow.schema([pyarrow.field(column["name"], TYPES[column["kind"]],
                                         metadata={"unit": column["unit"], "meaning": column["meaning"]}) for column in columns])


def sources(folder):
    """The files of rows."""
    found = [path for path, _, _ in parts.files_of(folder)]
    single = folder / "runs.csv"
    if not found and single.exists():
        found = [single]
    if not found:
        raise CampaignError(f"there are no rows of a campaign in {folder}; sil/tools/campaign run, or rsi-sil campaign, "
                            "makes some")
    return found


def check(folder, program):
    """The program's own reader refuses what is not as it was written, or of another campaign."""
    finished = subprocess.run([program, "campaign", "check", "--output", folder], capture_output=True, text=True, check=False)
    if finished.returncode != 0:
        raise CampaignError(finished.stderr.strip().removeprefix("rsi-sil: ") + "; nothing is asked of such rows")


def target_of(source, folder):
    return folder / "parquet" / f"{source.stem}.parquet"


def state_of(source):
    """Tells a file from what it was before."""
    status = source.stat()
    head = parts.head_of(source)
    return f"{source.name} {status.st_size} {status.st_mtime_ns} {head[1] if head else ''}".encode()


def is_current(source, target):
    try:
        return pyarrow.parquet.read_schema(target).metadata.get(SOURCE) == state_of(source)
    except (OSError, pyarrow.ArrowInvalid):
        return False


def convert_file(source, folder, program, columns):
    state, target = state_of(source), target_of(source, folder)
    schema = schema_of(columns).with_metadata({SOURCE: state, b"rsi_sil.columns": json.dumps(columns).encode(),
                                               b"rsi_sil.campaign": (folder / "campaign.toml").read_bytes()})
    target.parent.mkdir(exist_ok=True)
    try:
        with pyarrow.csv.open_csv(
                source, pyarrow.csv.ReadOptions(skip_rows=1 if parts.head_of(source) else 0, block_size=8 << 20),
                convert_options=pyarrow.csv.ConvertOptions(column_types=schema, true_values=["1"], false_values=["0"])) as rows:
            if rows.schema.names != schema.names:
                raise CampaignError(f"{source} has other columns than {program} writes; name the program that made it: --program "
                                    "FILE")
            with file_io.growing(target) as file, pyarrow.parquet.ParquetWriter(file, schema, compression="zstd") as writer:
                for batch in rows:
                    writer.write_table(pyarrow.Table.from_batches([batch]).cast(schema), row_group_size=ROWS)
    except pyarrow.ArrowInvalid as error:
        raise CampaignError(f"{source}: {error}; remove it and make it again") from None


def convert(folder, program):
    """Brings DIR/parquet up to date: what is missing or of another state of its file, and nothing that has no file. The files."""
    found = sources(folder)
    targets = {target_of(source, folder): source for source in found}
    for old in (folder / "parquet").glob("*.parquet"):
        if old not in targets:
            old.unlink()
    checked, states = folder / "parquet/checked", b"\n".join(map(state_of, found))
    if not checked.exists() or checked.read_bytes() != states:
        check(folder, program)
        checked.parent.mkdir(exist_ok=True)
        file_io.write(checked, states)
    todo = [(source, target) for target, source in targets.items() if not is_current(source, target)]
    columns = columns_of(program) if todo else None
    for number, (source, _) in enumerate(todo, 1):
        convert_file(source, folder, program, columns)
        if number % 10 == 0 or number == len(todo):
            print(f"{number} of {len(todo)} files are Parquet", file=sys.stderr, flush=True)
    return list(targets)
