"""Whole files for the tools: an ordinary one read, and one written so that no reader ever sees half of it under its name.

sil/files/file_io.hpp is the same for the programs, cmake/environment/file_io for shell scripts."""

import contextlib
import errno
import os
import pathlib
import sys

LONGEST_BYTES = 64 * 1024 * 1024
NO_ORDINARY_FILE = "it is a device or a pipe and no ordinary file"


def read(path):
    """The text of a file. Raises OSError for what cannot be read, has no end or is too long, and UnicodeDecodeError for
    what is no text."""
    path = pathlib.Path(path)
    if path.exists() and not path.is_file() and not path.is_dir():
        raise OSError(errno.EINVAL, NO_ORDINARY_FILE, str(path))
    with path.open("rb") as file:
        content = file.read(LONGEST_BYTES + 1)
    if len(content) > LONGEST_BYTES:
        raise OSError(errno.EFBIG, f"it is longer than {LONGEST_BYTES // 1024 // 1024} MiB", str(path))
    return content.decode("utf-8")


def write(path, content):
    """Writes a text, or bytes, beside `path` and renames. If that fails, it ends the program with a sentence, and `path` is as
    it was."""
    with growing(path) as file:
        file.write(content.encode("utf-8") if isinstance(content, str) else content)


@contextlib.contextmanager
def growing(path):
    """For a content that is not held as a whole: a binary file beside `path`, renamed when the block has ended well. The
    writer may close it. If that fails, as with write()."""
    path = pathlib.Path(os.path.realpath(path))
    partial = path.with_name(f"{path.name}.{os.getpid()}.tmp")
    try:
        if path.exists() and not path.is_file():
            raise OSError(errno.EINVAL, "it is a folder" if path.is_dir() else NO_ORDINARY_FILE)
        with partial.open("wb") as file:
            yield file
        partial.replace(path)
    except OSError as error:
        sys.exit(f"cannot write {path}: {error.strerror}; check that its folder exists, may be written and has room")
    finally:
        partial.unlink(missing_ok=True)
