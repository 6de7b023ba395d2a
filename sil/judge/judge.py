"""Judgement of warnings by the rules of a campaign (docs/drives.md, What counts): the C++ beside, called through judge.h.

The library rsi_judge lies beside rsi-sil; a command that takes another program names it with use(). In the package that
sil/exchange/wheel makes, it lies beside this module.
"""

from __future__ import annotations

import array
import ctypes
import functools
import math
import pathlib
import typing
from collections.abc import Iterable, Mapping, Sequence

SIDES = {"none": 0, "left": 1, "right": 2}
CALIBRATION = ("advisory_on", "advisory_off", "warning_on", "warning_off", "warning_confirmation_s", "advisory_hold_s",
               "warning_hold_s", "recovery_s")
FORECAST_SIGNALS = ("road_parallel_force_mps2", "roll_rate_radps", "roll_angle_rad", "yaw_rate_radps", "speed_mps",
                    "steering_wheel_angle_rad")
BAND_COUNT = 4
LEVEL_BAND = 2  # from 0.8 on: in which the studies make alarms as frequent as the firmware's
DOUBLES, BYTES, INTEGERS = (ctypes.POINTER(kind) for kind in (ctypes.c_double, ctypes.c_uint8, ctypes.c_int32))
LIBRARY = "librsi_judge.so"
CTYPES = {"d": ctypes.c_double, "B": ctypes.c_uint8, "i": ctypes.c_int32, "I": ctypes.c_uint32, "Q": ctypes.c_size_t}
Numbers = Iterable[float]
SomeNumbers = Iterable[typing.Optional[float]]
Series = typing.Any  # a sequence of numbers, or an array of numpy without gaps
_folder = pathlib.Path(__file__).resolve().parent
if not (_folder / LIBRARY).exists():
    _folder = _folder.parents[1] / "build/release/sil"


class JudgeError(Exception):
    pass


class _Calibration(ctypes.Structure):
    _fields_ = [(name, ctypes.c_float) for name in CALIBRATION]


class _Course(ctypes.Structure):
    _fields_ = [("cycles", ctypes.c_size_t), ("times_s", DOUBLES), ("right", DOUBLES), ("left", DOUBLES)]


class _Share(ctypes.Structure):
    _fields_ = [("count", ctypes.c_size_t), ("total", ctypes.c_size_t), ("lowest", ctypes.c_double), ("highest", ctypes.c_double)]


class _Detection(ctypes.Structure):
    _fields_ = [("warned", _Share), ("warned_100ms", _Share), ("warned_200ms", _Share), ("false_alarms", _Share),
                ("alarms", _Share * BAND_COUNT), ("median_lead_s", ctypes.c_double)]


class _Runs(ctypes.Structure):
    _fields_ = [("count", ctypes.c_size_t), ("vehicles", ctypes.POINTER(ctypes.c_uint32)), ("lift_off_times_s", DOUBLES),
                ("largest_ltrs", DOUBLES), ("leads_s", DOUBLES), ("alarms", BYTES)]


class _Drive(ctypes.Structure):
    _fields_ = [("cycles", ctypes.c_size_t), ("times_s", DOUBLES), ("states", INTEGERS), ("sides", INTEGERS),
                ("load_transfer_ratios", DOUBLES), ("lift_off_time_s", ctypes.c_double), ("falling_side", ctypes.c_uint8)]


class _Judgement(ctypes.Structure):
    _fields_ = [("lifted", ctypes.c_uint8), ("side_at_lift_off", ctypes.c_uint8), ("late", ctypes.c_uint8),
                *((name, ctypes.c_double) for name in ("lead_s", "wrong_side_s", "warning_s", "advisory_s", "unavailable_s")),
                ("warnings", ctypes.c_uint32), ("advisories", ctypes.c_uint32), ("largest_ltr", ctypes.c_double),
                ("band", ctypes.c_uint8)]


class _Signals(ctypes.Structure):
    _fields_ = [("cycles", ctypes.c_size_t), *((name, DOUBLES) for name in FORECAST_SIGNALS)]


def use(program: str | pathlib.Path) -> None:
    """Takes the library from beside this rsi-sil."""
    global _folder
    if pathlib.Path(program).resolve().parent != _folder:
        _folder = pathlib.Path(program).resolve().parent
        library.cache_clear()
        _constant.cache_clear()


@functools.cache
def library() -> typing.Any:
    """The shared library, with the types of the judge's functions."""
    try:
        loaded = ctypes.CDLL(str(_folder / LIBRARY))
    except OSError as error:
        raise JudgeError(f"{error}; make it with cmake/environment/build release rsi-sil") from None
    number, size, byte = ctypes.c_double, ctypes.c_size_t, ctypes.c_uint8
    calibration, course = ctypes.POINTER(_Calibration), ctypes.POINTER(_Course)
    for name, result, arguments in (
            ("band_name", ctypes.c_char_p, [size]),
            ("each", None, [ctypes.POINTER(_Runs), *[BYTES] * 6]),
            ("detect", None, [ctypes.POINTER(_Runs), ctypes.POINTER(_Detection)]),
            ("lead_s", number, [size, DOUBLES, BYTES, number, byte]),
            ("index_lead_s", number, [calibration, course, number, number, byte]),
            ("alarms", ctypes.c_int, [calibration, course, number]),
            ("alarm_threshold", number, [calibration, course]),
            ("matched_threshold", number, [size, DOUBLES, number]),
            ("warnings", None, [ctypes.POINTER(_Drive), ctypes.POINTER(_Judgement)]),
            ("forecast_inputs", None, [size, ctypes.POINTER(ctypes.c_char_p), DOUBLES, ctypes.POINTER(_Signals), DOUBLES]),
            ("wilson_interval", None, [number, number, DOUBLES, DOUBLES]),
            ("share_by_vehicle", None, [size, ctypes.POINTER(size), ctypes.POINTER(size), ctypes.POINTER(_Share)])):
        function = getattr(loaded, f"judge_{name}")
        function.restype, function.argtypes = result, arguments
    return loaded


@functools.cache
def _constant(name: str, kind: typing.Any) -> typing.Any:
    return kind.in_dll(library(), f"judge_{name}").value


def early_s() -> float:
    return float(_constant("early_s", ctypes.c_double))


def very_early_s() -> float:
    return float(_constant("very_early_s", ctypes.c_double))


def rounding_s() -> float:
    return float(_constant("time_rounding_s", ctypes.c_double))


def lasts(begin_s: float, end_s: float) -> bool:
    """Whether both wheels of a side that are up between these times are a two-wheel lift-off."""
    return end_s - begin_s >= float(_constant("lasting_s", ctypes.c_double)) - rounding_s()


def fewest_vehicles() -> int:
    """From so many on, intervals count vehicles."""
    return int(_constant("fewest_clusters", ctypes.c_size_t))


def bands() -> list[str]:
    """Names of the bands of a run without two-wheel lift-off, by its largest |LTR|."""
    return [library().judge_band_name(band).decode() for band in range(BAND_COUNT)]


def _buffer(kind: str, values: typing.Any) -> typing.Any:
    """As a C array; what is one already, as an array of numpy, is not copied."""
    if not hasattr(values, "__array_interface__"):
        values = array.array(kind, values)
    ctype: typing.Any = CTYPES[kind]
    return (ctype * len(values)).from_buffer(values)


def _or_nan(values: typing.Any) -> typing.Any:
    return values if hasattr(values, "__array_interface__") else [math.nan if value is None else value for value in values]


def _or_none(value: float) -> float | None:
    return None if math.isnan(value) else value


class Share(typing.NamedTuple):
    """A count of runs, with its interval of 95 %."""

    count: int  # type: ignore[assignment]  # it hides tuple.count
    total: int
    interval: tuple[float, float]

    def value(self) -> float:
        return self.count / self.total if self.total else math.nan


def _share(found: typing.Any) -> Share:
    return Share(found.count, found.total, (found.lowest, found.highest))


def share_by_vehicle(vehicles: Iterable[tuple[int, int]]) -> Share:
    """`vehicles`: of each, how many runs count, and of how many."""
    found = _Share()
    columns: Sequence[tuple[int, ...]] = [*zip(*vehicles)] or [(), ()]
    library().judge_share_by_vehicle(len(columns[0]), *(_buffer("Q", column) for column in columns), found)
    return _share(found)


def wilson_interval(share: float, trials: float) -> tuple[float, float]:
    lowest, highest = ctypes.c_double(), ctypes.c_double()
    library().judge_wilson_interval(share * trials, trials, lowest, highest)
    return lowest.value, highest.value


class Detection(typing.NamedTuple):
    """Results of one warning over many runs."""

    warned: Share
    warned_100ms: Share
    warned_200ms: Share
    false_alarms: Share
    alarms: dict[str, Share]  # by band
    median_lead_s: float


def detection(vehicles: Sequence[str], lift_off_times_s: SomeNumbers, largest_ltrs: Numbers, leads_s: SomeNumbers,
              alarms: Iterable[bool]) -> Detection:
    """Outcomes of runs side by side; None without a lift-off or a lead."""
    numbers = {name: number for number, name in enumerate(sorted(set(vehicles)))}
    found = _Detection()
    library().judge_detect(
        _Runs(len(vehicles), _buffer("I", [numbers[name] for name in vehicles]), _buffer("d", _or_nan(lift_off_times_s)),
              _buffer("d", largest_ltrs), _buffer("d", _or_nan(leads_s)), _buffer("B", alarms)), found)
    return Detection(_share(found.warned), _share(found.warned_100ms), _share(found.warned_200ms), _share(found.false_alarms),
                     dict(zip(bands(), map(_share, found.alarms))), found.median_lead_s)


EACH = ("lifted", "calm", "warned", "warned_100ms", "warned_200ms", "band")


def each(lift_off_times_s: SomeNumbers, largest_ltrs: Numbers, leads_s: Sequence[float | None]) -> dict[str, array.array[int]]:
    """EACH of these runs side by side, as bytes; a band as its number. None or NaN: no lift-off, no lead."""
    count = len(leads_s)
    results = [array.array("B", bytes(count)) for _ in EACH]
    library().judge_each(
        _Runs(count, None, _buffer("d", _or_nan(lift_off_times_s)), _buffer("d", largest_ltrs), _buffer("d", _or_nan(leads_s)),
              None),
        *((ctypes.c_uint8 * count).from_buffer(result) for result in results))
    return dict(zip(EACH, results))


def lead_s(times_s: Sequence[float], sides: Iterable[str], lift_off_time_s: float, falling_side: str) -> float | None:
    """For how long, at lift-off, the falling side has been named; None if it is not. `sides`: named from these times on."""
    return _or_none(library().judge_lead_s(len(times_s), _buffer("d", times_s), _buffer("B", [SIDES[side] for side in sides]),
                                           lift_off_time_s, SIDES[falling_side]))


def forecast_inputs(calibration: Mapping[str, typing.Any], signals: Mapping[str, typing.Any]) -> tuple[array.array[float], int]:
    """Inputs of the firmware's linear forecast, one for each weight, for each cycle: the three lags of the first signal,
    of the second, and so on. `signals`: of each of FORECAST_SIGNALS, an array of doubles."""
    known = {name: value for name, value in calibration.items() if isinstance(value, (int, float))}
    names = (ctypes.c_char_p * len(known))(*(name.encode() for name in known))
    cycles, count = len(signals[FORECAST_SIGNALS[0]]), _constant("forecast_input_count", ctypes.c_size_t)
    inputs = array.array("d", bytes(8 * cycles * count))
    buffers = [_buffer("d", signals[name]) for name in FORECAST_SIGNALS]
    library().judge_forecast_inputs(len(known), names, _buffer("d", known.values()), _Signals(cycles, *buffers),
                                    (ctypes.c_double * len(inputs)).from_buffer(inputs))
    return inputs, count


class Index:
    """An index over one run, the risk of falling to either side in each cycle, behind the firmware's own warning states."""

    def __init__(self, calibration: Mapping[str, typing.Any], times_s: Series, right: Series, left: Series) -> None:
        self._calibration = _Calibration(*(calibration[name] for name in CALIBRATION))
        self._course = _Course(len(times_s), *(_buffer("d", values) for values in (times_s, right, left)))

    def lead_s(self, threshold: float, lift_off_time_s: float, falling_side: str) -> float | None:
        return _or_none(library().judge_index_lead_s(self._calibration, self._course, threshold, lift_off_time_s,
                                                     SIDES[falling_side]))

    def alarms(self, threshold: float) -> bool:
        return bool(library().judge_alarms(self._calibration, self._course, threshold))

    def alarm_threshold(self) -> float:
        """The largest threshold at which it raises an alarm; 0 when there is none."""
        return float(library().judge_alarm_threshold(self._calibration, self._course))


def matched_threshold(alarm_thresholds: Sequence[float], share: float) -> float:
    """The largest threshold with alarms in at least this share of the runs, of which alarm_threshold() is given."""
    return float(library().judge_matched_threshold(len(alarm_thresholds), _buffer("d", alarm_thresholds), share))


class Judgement(typing.NamedTuple):
    """Judgement of the warnings of one drive. Times in s; None: there is none."""

    lifted: bool  # two wheels of a side
    side_at_lift_off: str  # that the warning in force names; none: no warning
    late: bool  # the right warning came only after lift-off
    lead_s: float | None  # None unless the warning in force at lift-off names the falling side
    wrong_side_s: float  # a warning names the side that is loaded less
    warning_s: float
    advisory_s: float
    unavailable_s: float  # beyond the start-up
    warnings: int
    advisories: int
    largest_ltr: float  # |LTR| of the wheel loads; 0 if they are not known
    band: str  # one of bands() by it, or "lift"


def judgement(times_s: Series, states: Series, sides: Series, load_transfer_ratios: Series, lift_off_time_s: float | None,
              falling_side: str) -> Judgement:
    """States and sides are as the firmware numbers them, cycle by cycle; a load transfer ratio of NaN is not known."""
    found = _Judgement()
    library().judge_warnings(
        _Drive(len(times_s), _buffer("d", times_s), _buffer("i", states), _buffer("i", sides),
               _buffer("d", load_transfer_ratios), math.nan if lift_off_time_s is None else lift_off_time_s,
               SIDES[falling_side]), found)
    names = {number: name for name, number in SIDES.items()}
    return Judgement(bool(found.lifted), names[found.side_at_lift_off], bool(found.late), _or_none(found.lead_s),
                     found.wrong_side_s, found.warning_s, found.advisory_s, found.unavailable_s, found.warnings,
                     found.advisories, found.largest_ltr, "lift" if found.lifted else bands()[found.band])
