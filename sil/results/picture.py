"""Pictures by gnuplot, through draw_picture, which leaves a file whole or as it was."""

import pathlib
import subprocess

HERE = pathlib.Path(__file__).resolve().parent


def draw(file, script, words):
    """Draws `file` with a gnuplot script, which finds `words` (strings and numbers) and `scripts`, the folder of the style, as its
    variables. Returns the finished process; its stderr says what went wrong."""
    words = {"scripts": str(HERE), **words}
    assignments = "; ".join(f"{name} = " + ("'" + word.replace("'", "''") + "'" if isinstance(word, str) else f"{word:.6g}")
                            for name, word in words.items())
    return subprocess.run(["/bin/bash", "-c", 'source "$0/draw_picture"; draw_picture "$1" "$2" "$3"', HERE, file, script,
                           assignments], stderr=subprocess.PIPE, text=True, check=False)
