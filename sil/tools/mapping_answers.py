"""A mapping that asks as little as can be: drafted of all logs, answered by one word, and kept."""

import contextlib
import io
import pathlib
import re
import shlex
import sys
import tempfile

import draft
import file_io
import mapping
from log_error import LogError

QUESTION = re.compile(r'sign = "\?"(.*\n#.* hardest at (\S+) s of the drive: (.+) if that was to the left, (.+) if to the right)')
ASKED_OF = "# The signs are asked of the log "
ANSWERED = "# Answered: the turn was to the "
NEEDED = ("time", "lateral_acceleration", "roll_rate", *draft.NEEDED)  # a drive without any other is worth having
ENOUGH = 3


class Unanswered(LogError):
    """Only the user knows it."""


def said(command, *parts):
    """Shows a step as the command that does it."""
    print("$ " + shlex.join(str(part) for part in (command, *parts)), flush=True)


def dbc_options(dbc):
    return [part for file in dbc or [] for part in ("--dbc", file)]


def write_draft(dbc, logs, signals):
    """The draft by the log that shows most signs and agrees best with the others on which of them are alike: on a bank or in a
    slide one log may show the contrary. Logs after ENOUGH that show as much add nothing."""
    drafts, shown, why = {}, {}, None
    with tempfile.TemporaryDirectory() as scratch:
        for number, log in enumerate(logs):
            most = max(map(len, shown.values()), default=0)
            if most and sum(len(signs) == most for signs in shown.values()) >= ENOUGH:
                break
            file = pathlib.Path(scratch, f"{number}.toml")
            print(f"looking at {log}", flush=True)
            try:
                with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
                    draft.make(dbc, log, file)
                drafts[log] = file_io.read(file)
                shown[log] = signs_if_left(drafts[log])
            except LogError as error:
                why = why or error
    if not drafts:
        raise why
    def agreement(log):
        return sum(abs(sum(sign * other.get(name, 0) for name, sign in shown[log].items())) for other in shown.values())

    log = max(drafts, key=agreement)
    said("sil/tools/logs", "draft", *dbc_options(dbc), "--log", log, "--output", signals)
    file_io.write(signals, f"{ASKED_OF}{log.name}\n{drafts[log]}")


def blocks_of(text):
    """The tables, each with the remarks below it, and what stands before them."""
    return re.split(r"\n(?=\[\w+\])", text)


def name_of(block):
    found = re.match(r"\[(\w+)\]", block)
    return found[1] if found else None


def signs_if_left(text):
    """The sign that each quantity would have if the hardest turn was one to the left."""
    found = {name_of(block): QUESTION.search(block) for block in blocks_of(text)}
    return {name: -1 if question[3].startswith(("-", '"-')) else 1 for name, question in found.items() if question}


def answer(signals, side):
    """Puts the side of the turn into the mapping, and leaves out the open questions that a drive does without."""
    text = before = mapping.read_text(signals)
    question, known = QUESTION.search(text), re.search(rf"^{ANSWERED}(\w+)", text, re.MULTILINE)
    if known and side not in (None, known[1]):
        raise LogError(f"{signals}: has the answer {known[1]} already; delete the file to answer {side}")
    if question:
        log = re.search(rf"^{ASKED_OF}(.*)", text, re.MULTILINE)
        turn = f"the turn at {question[2]} s of {log[1] if log else 'the drafted log'}"
        side = side or asked(f"Was {turn} to the left? [y/n] ", f"{signals}: was {turn} to the left or to the right? Run it again "
                                                                "with --answer left or --answer right")
        text = QUESTION.sub(lambda found: f"sign = {found[3 if side == 'left' else 4]}{found[1]}", text)
        text = text.replace(ASKED_OF, f"{ANSWERED}{side}. {ASKED_OF[2:]}")
    blocks = blocks_of(text)
    for number, block in enumerate(blocks):
        name = name_of(block)
        if name and name not in NEEDED and re.search(r'^\w+ = "\?"', block, re.MULTILINE):
            blocks[number] = re.sub(r"(?m)^(?=[^#\n])", "# ", block)
            print(f"left out: {name}; to have it, answer its \"?\" in {signals} and take away the # before its lines")
    text = "\n".join(blocks)
    if text != before:
        file_io.write(signals, text)
    still = [f"  {signals}:{number}: {line}" for number, line in enumerate(text.splitlines(), 1) if re.match(r'\w+ = "\?"', line)]
    if still:
        raise Unanswered(f"{signals}: only you know these; put an answer in place of each \"?\", or delete its table, and run it "
                         "again (a sign that no log shows needs one with a turn):\n" + "\n".join(still))


def asked(question, otherwise):
    """The answer from the terminal: left or right."""
    while sys.stdin.isatty():
        print(question, end="", flush=True)
        line = sys.stdin.readline()
        if line.strip().lower() in ("y", "yes", "n", "no"):
            return "left" if line.strip().lower().startswith("y") else "right"
        if not line:
            break
    raise Unanswered(otherwise)
