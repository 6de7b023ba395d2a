"""Asks the C++ codec many questions at once."""
import subprocess


def ask(program, requests):
    """The codec_probe's answers to a list of requests, in order."""
    result = subprocess.run([program], input="".join(f"{request}\n" for request in requests), text=True,
                            capture_output=True, check=False)
    if result.returncode != 0:
        raise SystemExit(f"{program} failed with {result.returncode}: {result.stderr}")
    answers = result.stdout.splitlines()
    if len(answers) != len(requests):
        raise SystemExit(f"{program} gave {len(answers)} answers to {len(requests)} requests")
    return answers
