"""Runs the missing parts of a campaign by Dask, on this machine or on a cluster."""

import asyncio
import concurrent.futures
import contextlib
import fcntl
import json
import logging
import os
import shutil
import subprocess
import sys
import time

import dask
import dask.distributed

import parquet
import parts
import work
from campaign_error import CampaignError

# The class of dask-jobqueue, and the command by which it puts jobs in.
CLUSTERS = {"slurm": ("SLURMCluster", "sbatch"), "pbs": ("PBSCluster", "qsub"), "lsf": ("LSFCluster", "bsub"),
            "sge": ("SGECluster", "qsub"), "htcondor": ("HTCondorCluster", "condor_submit")}


@contextlib.contextmanager
def alone(folder):
    """The system gives the lock back when the program ends, however it ends."""
    lock = os.open(folder / ".lock", os.O_CREAT | os.O_RDWR | os.O_CLOEXEC, 0o644)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        raise CampaignError(f"{folder}: another campaign is writing into this folder; wait for it or end it") from None
    try:
        yield
    finally:
        os.close(lock)


def begin(options):
    """The folder with its campaign.toml."""
    command = [options.program, "campaign", "begin", "--output", options.output]
    for name in ("settings", "runs", "seed"):
        if getattr(options, name) is not None:
            command += [f"--{name}", getattr(options, name)]
    for name in ("vehicle", "set"):
        for value in getattr(options, name):
            command += [f"--{name}", value]
    call(command)


def call(command):
    """A program that says itself what is wrong."""
    try:
        finished = subprocess.run([str(word) for word in command], stdout=subprocess.DEVNULL, check=False)
    except OSError as error:
        raise CampaignError(f"{command[0]}: {error.strerror}; make it with cmake/environment/build release rsi-sil, or name "
                            "another: --program FILE") from None
    if finished.returncode != 0:
        sys.exit(finished.returncode)


def job_option(text):
    name, _, value = text.partition("=")
    try:
        return name, json.loads(value)
    except ValueError:
        return name, value


def cluster_of(options):
    if options.scheduler:
        return None
    if options.cluster is None:
        workers = options.workers or os.cpu_count()
        return dask.distributed.LocalCluster(n_workers=workers, threads_per_worker=1, memory_limit=0,
                                             dashboard_address="127.0.0.1:8787",
                                             silence_logs=logging.CRITICAL)  # the reason of a part's failure is reported below
    import dask_jobqueue

    name, submits = CLUSTERS[options.cluster]
    if shutil.which(submits) is None:
        raise CampaignError(f"--cluster {options.cluster}: there is no {submits} here; start this where jobs are put in, or "
                            "without --cluster on this machine")
    wanted = dict(job_option(text) for text in options.job)
    wanted.setdefault("processes", wanted.get("cores"))  # a core each: what is killed takes one part with it
    wanted.setdefault("log_directory", str(options.output / "logs"))
    try:
        cluster = getattr(dask_jobqueue, name)(**wanted)
    except (TypeError, ValueError) as error:
        raise CampaignError(f"--job: {error}") from None
    cluster.adapt(minimum_jobs=options.jobs, maximum_jobs=options.jobs)  # jobs that end are put in again
    return cluster


def command_for(part, options):
    return [str(options.program), "campaign", "part", "--settings", str(options.output / "campaign.toml"), "--first", str(part.first),
            "--count", str(part.count), "--output", str(options.output / part.file_name()), "--jobs", "1"]


class Progress:
    def __init__(self, runs, missing):
        self.runs, self.done, self.begin_s = runs, runs - sum(part.count for part in missing), time.monotonic()
        self.before = self.done

    def tell(self, part, workers):
        self.done += part.count
        rate = (self.done - self.before) / max(time.monotonic() - self.begin_s, 1e-3)
        left_s = (self.runs - self.done) / rate
        print(f"{self.done} of {self.runs} runs, {rate:.1f} runs/s, {workers} workers, {left_s / 60:.1f} min left",
              file=sys.stderr, flush=True)


def make(client, missing, options, runs):
    """The parts whose work failed, with the reason."""
    client.upload_file(work.__file__)  # also for workers that come later
    here, columns, progress, failed = os.getcwd(), parquet.columns_of(options.program), Progress(runs, missing), []
    futures = {client.submit(work.make_part, command_for(part, options), here, key=part.file_name(), pure=False): part
               for part in missing}
    for future in dask.distributed.as_completed(futures):
        part = futures.pop(future)
        if future.status in ("error", "cancelled"):
            failed.append(f"{part.file_name()}: {future.exception() if future.status == 'error' else 'cancelled'}")
        else:  # finished; or it was, and pends again because its worker is lost with what it gave back, which is nothing
            progress.tell(part, len(client.nthreads()))
            source = options.output / part.file_name()
            if source.exists():  # a network's file system may show it later; the last conversion is of all
                parquet.convert_file(source, options.output, options.program, columns)
    return failed


def run(options):
    begin(options)
    options.output = options.output.resolve()
    options.program = options.program.resolve()
    with alone(options.output):
        runs = parts.described(options.output)["runs"]
        missing = parts.missing(parts.there(options.output), runs, options.part_runs)
        if missing:
            make_missing(missing, options, runs)
            if parts.missing(parts.there(options.output), runs, options.part_runs):
                raise CampaignError(f"parts were made that are not in {options.output}; it must be the same folder on all "
                                    "machines")
        parquet.convert(options.output, options.program)
    call([options.program, "campaign", "report", "--output", options.output])
    print(f"{runs} runs are in {options.output}: report.md, report.html to look into. Ask more: sil/tools/campaign query "
          f"{options.output} NAME; --list in place of both names the questions.")


def make_missing(missing, options, runs):
    # Ten workers may be lost with a part before it is taken for what kills them.
    dask.config.set({"distributed.scheduler.allowed-failures": 10, "distributed.comm.timeouts.connect": "60s"})
    logging.getLogger("distributed").setLevel(logging.ERROR)
    logging.getLogger("distributed.client").setLevel(logging.CRITICAL)  # its errors reach the caller, and are reported below
    with contextlib.ExitStack() as stack:
        cluster = cluster_of(options)
        if cluster is not None:
            stack.enter_context(cluster)
        try:
            client = stack.enter_context(dask.distributed.Client(cluster or options.scheduler))
        except (OSError, ValueError) as error:
            raise CampaignError(f"--scheduler {options.scheduler}: {error}") from None
        print(f"{len(missing)} parts are to be made; look on: {client.dashboard_link}", file=sys.stderr, flush=True)
        try:
            failed = make(client, missing, options, runs)
        except (OSError, ValueError, asyncio.TimeoutError, concurrent.futures.CancelledError):
            if client.status == "running":
                raise
            failed = missing
        if failed and client.status != "running":  # then the client has cancelled what was not done
            raise CampaignError("the scheduler is lost; the parts that are there are kept, the same command with a scheduler "
                                "goes on")
    if failed:
        raise CampaignError(f"{len(failed)} of {len(missing)} parts failed, the others are there; the same command tries them "
                            "again. " + "; ".join(failed[:3]))
