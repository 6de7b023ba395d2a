"""A campaign in parts by Dask: killed workers and a killed driver lose nothing and do nothing twice."""

import collections
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
COMMAND = PROJECT / "sil/tools/campaigns/command.py"
RUNS, PART_RUNS = 40, 5
# Stands before rsi-sil: notes each part that is begun, and once kills a given process in the middle of one. The test
# waits for a killed process: a part goes on for ever unless it ends with its worker. A killed scheduler takes none along.
WRAPPER = """\
#!/bin/bash
case " $* " in
    *" --first $KILLED_AT "*)
        if mkdir "$SCRATCH/killed_$KILLED_AT" 2>/dev/null; then
            echo $$ >"$SCRATCH/hangs"
            case $KILLED in
                worker) kill -9 $PPID ;;
                none) echo "rsi-sil: cannot write it: No space left on device" >&2; exit 1 ;;
                scheduler) kill -9 "$(cat "$SCRATCH/scheduler")" ;;
                driver) kill -9 "$(cat "$SCRATCH/driver")" ;;
            esac
            [ "$KILLED" = scheduler ] || exec sleep 1000
        fi
        ;;&
    *" --first "*) echo "$*" | sed 's/.*--first \\([0-9]*\\) .*/\\1/' >>"$SCRATCH/begun" ;;
esac
exec "$PROGRAM" "$@"
"""


def rows_of(folder):
    """The rows of all parts, as of one file."""
    texts = [path.read_text(encoding="utf-8").splitlines()[1:] for path in sorted(folder.glob("part-*.csv"))]
    return "\n".join([texts[0][0], *(line for text in texts for line in text[1:])]) + "\n"


class Engine(unittest.TestCase):
    program = None

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.scratch = pathlib.Path(scratch.name)
        self.folder = self.scratch / "campaign"
        self.wrapper = self.scratch / "rsi-sil"
        self.wrapper.write_text(WRAPPER, encoding="utf-8")
        self.wrapper.chmod(0o755)

    def run_until_end(self, killed, first, *options):
        """The driver's status and what it said; `killed` is killed in the part that begins with `first`."""
        environment = {**os.environ, "SCRATCH": str(self.scratch), "PROGRAM": str(self.program), "KILLED": killed,
                       "KILLED_AT": str(first)}
        with (self.scratch / "said").open("w+", encoding="utf-8") as said:
            driver = subprocess.Popen([sys.executable, "-B", COMMAND, "run", "--runs", str(RUNS), "--part-runs", str(PART_RUNS),
                                       "--output", self.folder, "--program", self.wrapper, *(options or ("--workers", "2"))],
                                      cwd=PROJECT, env=environment, stdout=said, stderr=said)
            (self.scratch / "driver.new").write_text(str(driver.pid), encoding="utf-8")
            (self.scratch / "driver.new").replace(self.scratch / "driver")
            status = driver.wait(timeout=300)
            said.seek(0)
            return status, said.read()

    def wait_for_the_end_of_what_hung(self):
        pid = int((self.scratch / "hangs").read_text(encoding="utf-8"))
        handle = None
        try:
            handle = os.pidfd_open(pid)
            import select

            self.assertTrue(select.select([handle], [], [], 60)[0], "the program of a killed worker goes on")
        except ProcessLookupError:
            pass
        finally:
            if handle is not None:
                os.close(handle)

    def begun(self):
        return collections.Counter((self.scratch / "begun").read_text(encoding="utf-8").split())

    def test_a_killed_process_loses_nothing_and_does_nothing_twice(self):
        single = self.scratch / "single"
        subprocess.run([self.program, "campaign", "run", "--runs", str(RUNS), "--output", single], cwd=PROJECT, check=True,
                       capture_output=True)

        status, said = self.run_until_end("driver", 20)
        self.assertEqual(status, -signal.SIGKILL, said)
        self.wait_for_the_end_of_what_hung()
        kept = {path: path.stat().st_mtime_ns for path in self.folder.glob("part-*.csv")}
        self.assertGreaterEqual(len(kept), 1)
        self.assertLess(len(kept), RUNS // PART_RUNS)

        status, said = self.run_until_end("worker", 30)
        self.assertEqual(status, 0, said)
        self.assertTrue((self.scratch / "killed_30").is_dir())
        self.wait_for_the_end_of_what_hung()
        self.assertIn(f"{RUNS} of {RUNS} runs", said)
        self.assertEqual(rows_of(self.folder), (single / "runs.csv").read_text(encoding="utf-8"))
        self.assertEqual({path: path.stat().st_mtime_ns for path in kept}, kept)
        self.assertEqual((self.folder / "report.json").read_bytes(), (single / "report.json").read_bytes())
        self.assertEqual(list(self.folder.glob("*.tmp")), [])
        for path in kept:
            self.assertEqual(self.begun()[str(int(path.name.split("-")[1]))], 1, path)
        self.assertEqual(len(list((self.folder / "parquet").glob("*.parquet"))), RUNS // PART_RUNS)

    def expect_one_sentence(self, said, expected):
        """Behind the progress."""
        lines = said.splitlines()
        self.assertRegex(lines[-1], f"^sil/tools/campaign: {expected}")
        self.assertEqual([line for line in lines if " of " not in line and "are to be made" not in line or line == lines[-1]],
                         lines[-1:], said)

    def test_a_full_disk_is_told_in_one_sentence(self):
        status, said = self.run_until_end("none", 20)
        self.assertEqual(status, 1, said)
        self.expect_one_sentence(said, "1 of 8 parts failed, the others are there; the same command tries them again. "
                                       "part-000000020-0000005.csv: rsi-sil: cannot write it: No space left on device ")

    def test_a_lost_scheduler_is_told_in_one_sentence(self):
        def start(*arguments):
            process = subprocess.Popen([sys.executable, "-m", "dask", *arguments, "--no-dashboard"], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.PIPE, text=True, cwd=self.scratch, env={
                                           **os.environ, "SCRATCH": str(self.scratch), "PROGRAM": str(self.program),
                                           "KILLED": "scheduler", "KILLED_AT": "20"})
            self.addCleanup(process.stderr.close)
            self.addCleanup(process.wait)
            self.addCleanup(process.kill)
            return process

        scheduler = start("scheduler", "--host", "127.0.0.1", "--port", "0")
        (self.scratch / "scheduler").write_text(str(scheduler.pid), encoding="utf-8")
        address = next(line.split()[-1] for line in scheduler.stderr if "Scheduler at:" in line)
        start("worker", address, "--no-nanny", "--nthreads", "1")
        status, said = self.run_until_end("scheduler", 20, "--scheduler", address)
        self.assertEqual(status, 1, said)
        self.expect_one_sentence(said, "the scheduler is lost; the parts that are there are kept, ")
        self.assertGreaterEqual(len(list(self.folder.glob("part-*.csv"))), 4, said)

    def test_a_cluster_that_is_not_there_is_told(self):
        for arguments, expected in ((["--cluster", "slurm", "--job", "cores=1"], "--cluster slurm: there is no sbatch here"),
                                    (["--scheduler", "nonsense://x"], "--scheduler nonsense://x: ")):
            finished = subprocess.run([sys.executable, "-B", COMMAND, "run", "--runs", "5", "--output", self.folder, "--program",
                                       self.program, *arguments], cwd=PROJECT, env={**os.environ, "PATH": "/nowhere"},
                                      capture_output=True, text=True, check=False, timeout=300)
            self.assertEqual(finished.returncode, 1, finished.stderr)
            self.assertTrue(finished.stderr.startswith(f"sil/tools/campaign: {expected}"), finished.stderr)

    def test_a_worker_tells_why_a_part_failed(self):
        sys.path.insert(0, str(COMMAND.parent))
        import work

        work.make_part(["bash", "-c", "pwd >here; echo $PPID >>here"], self.scratch)
        said = (self.scratch / "here").read_text(encoding="utf-8").split()
        self.assertEqual(said, [str(self.scratch.resolve()), str(os.getpid())])
        with self.assertRaisesRegex(RuntimeError, r"^rsi-sil: run 7: no \(status 3 on "):
            work.make_part(["bash", "-c", "echo 6 of 9 runs >&2; echo rsi-sil: run 7: no >&2; exit 3"], self.scratch)
        with self.assertRaisesRegex(RuntimeError, r"^said nothing \(status 1 on "):
            work.make_part(["false"], self.scratch)


if __name__ == "__main__":
    Engine.program = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
