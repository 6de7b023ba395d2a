"""C functions of component.h, in the judge's library, and the structures of rsi.h as it names their fields."""

from __future__ import annotations

import ctypes
import functools
import typing

import numpy as np

from . import judge

INPUT, CODE, NUMBER, PARAMETER, SELECTION, INDEX = range(6)
RISK = np.dtype([("level", np.float32), ("side", np.float32), ("opposite", np.float32)])


class _Field(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char_p), ("meaning", ctypes.c_char_p)]


class Course(ctypes.Structure):
    _fields_ = [
        ("parameters", ctypes.c_void_p),
        ("cycles", ctypes.c_size_t),
        ("times_s", ctypes.c_void_p),
        ("risks", ctypes.c_void_p),
        ("index", ctypes.c_size_t),
    ]


class Score(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("threshold", "threshold_100ms", "threshold_200ms", "lead_s")]


class LiftOff(ctypes.Structure):
    _fields_ = [
        ("one_wheel_s", ctypes.c_double),
        ("two_wheel_s", ctypes.c_double),
        ("up_below_n", ctypes.c_double),
        ("falling_side", ctypes.c_uint8),
    ]


@functools.cache
def library() -> typing.Any:
    loaded = judge.library()
    number, size, byte, data, integer = ctypes.c_double, ctypes.c_size_t, ctypes.c_uint8, ctypes.c_void_p, ctypes.c_int
    course = ctypes.POINTER(Course)
    for name, result, arguments in (
        ("field_count", size, [integer]),
        ("field_at", _Field, [integer, size]),
        ("load", integer, [ctypes.c_char_p, size, ctypes.POINTER(ctypes.c_char_p), data, ctypes.c_char_p, size]),
        ("start", None, [data, data]),
        ("steps", None, [data, data, size, data, data, data]),
        ("index_lead_s", number, [course, number, number, byte]),
        ("index_alarms", integer, [course, number]),
        ("alarm_threshold", number, [course]),
        ("index_score", Score, [course, number, byte]),
        ("find_lift_off", LiftOff, [size, data, ctypes.POINTER(data), data, data]),
    ):
        function = getattr(loaded, f"component_{name}")
        function.restype, function.argtypes = result, arguments
    return loaded


def size_of_component() -> int:
    return ctypes.c_size_t.in_dll(library(), "component_size").value


def version() -> str:
    return (ctypes.c_char_p.in_dll(library(), "component_version").value or b"").decode()


@functools.cache
def fields(kind: int) -> dict[str, str]:
    """Names of a kind, in the order of the structure, with their meanings."""
    found = (library().component_field_at(kind, place) for place in range(library().component_field_count(kind)))
    return {field.name.decode(): field.meaning.decode() for field in found}


def _structure(floats: int, codes: int, codes_first: bool) -> np.dtype[np.void]:
    numbers = [(name, "f4") for name in fields(floats)]
    words = [(name, "i4") for name in fields(codes)]
    return np.dtype(words + numbers if codes_first else numbers + words)


@functools.cache
def inputs() -> np.dtype[np.void]:
    return np.dtype([(name, "f4") for name in fields(INPUT)])


@functools.cache
def outputs() -> np.dtype[np.void]:
    return _structure(NUMBER, CODE, codes_first=True)


@functools.cache
def parameters() -> np.dtype[np.void]:
    return _structure(PARAMETER, SELECTION, codes_first=False)
