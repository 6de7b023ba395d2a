"""Keys of a control unit out of a file, as sil/files/key_file.hpp reads it. Never on a command line, which others can see."""

import stat
import sys
import tomllib

import file_io
from log_error import LogError

TEST = "test"  # in place of a file
TEST_KEYS = {"calibration": b"test key for XCP", "diagnosis": b"test key for UDS"}
LENGTH = 16


def read(path, slot):
    """The key of `slot`. A LogError names the file and what is wrong, and never what is in it."""
    if str(path) == TEST:
        return TEST_KEYS[slot]
    advice = f"write a line {slot} = \"{2 * LENGTH} hexadecimal digits\""
    try:
        table = tomllib.loads(file_io.read(path))
    except OSError as error:
        raise LogError(f"--key {path}: {error.strerror}; name a key file, or `{TEST}`") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError):
        raise LogError(f"--key {path}: it is no TOML file; {advice}") from None
    try:
        key = bytes.fromhex(table[slot])
    except KeyError:
        raise LogError(f"--key {path}: it has no key for {slot}; {advice}") from None
    except (TypeError, ValueError):
        key = b""
    if len(key) != LENGTH:
        raise LogError(f"--key {path}: {slot} is no key of AES-128; {advice}")
    if path.stat().st_mode & (stat.S_IRGRP | stat.S_IROTH):
        print(f"others can read {path}; chmod 600 {path}", file=sys.stderr)
    return key
