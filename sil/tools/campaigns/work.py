"""Task of a worker: one call of rsi-sil. Imports nothing of ours, because this file alone travels to the workers."""

import os
import shutil
import subprocess


def make_part(command, folder):
    """Runs `command` in `folder`. A program that outlives its worker would do a part that another worker has begun again."""
    ends_with_its_worker = ["setpriv", "--pdeathsig", "KILL"] if shutil.which("setpriv") else []
    finished = subprocess.run([*ends_with_its_worker, *command], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True, check=False)
    if finished.returncode != 0:
        said = finished.stderr.strip().splitlines()[-1:]
        raise RuntimeError(f"{' '.join(said) or 'said nothing'} (status {finished.returncode} on {os.uname().nodename})")
