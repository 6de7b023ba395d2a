"""rsi-sil watch as a process of its own, for tests."""
import contextlib
import pathlib
import re
import signal
import subprocess

PROJECT = pathlib.Path(__file__).resolve().parents[3]
LIMIT_S = 120


@contextlib.contextmanager
def live_drive(program, output, *options):
    """The port on which a drive of the large SUV is served; ended by SIGINT, which must be no failure."""
    process = subprocess.Popen(
        [program, "watch", "--vehicle", PROJECT / "sil/vehicles/large_suv.toml", "--parameters",
         PROJECT / "firmware/calibrations/large_suv.toml", "--output", output, *options],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        port = int(re.search(r"http://127\.0\.0\.1:(\d+)/", next(line for line in process.stdout if "http" in line)).group(1))
        # The account goes on; a full pipe would stop the drive.
        with open(pathlib.Path(output, "account.txt"), "w", encoding="utf-8") as account:
            drain = subprocess.Popen(["cat"], stdin=process.stdout, stdout=account)
        yield port
        process.send_signal(signal.SIGINT)
        assert process.wait(LIMIT_S) == 0, process.stderr.read()
        drain.wait(LIMIT_S)
    finally:
        process.kill()
        process.wait()
        process.stdout.close()
        process.stderr.close()
