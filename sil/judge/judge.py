"""Judgement of warnings by the rules of a campaign (docs/drives.md, What counts): the C++ beside, called through judge.h.

The library rsi_judge lies beside rsi-sil; a command that takes another program names it with use().
"""

import array
import ctypes
import functools
import math
import pathlib
import typing

SIDES = {"none": 0, "left": 1, "right": 2}
CALIBRATION = ("advisory_on", "advisory_off", "warning_on", "warning_off", "warning_confirmation_s", "advisory_hold_s",
               "warning_hold_s", "recovery_s")
FORECAST_SIGNALS = ("road_parallel_force_mps2", "roll_rate_radps", "roll_angle_rad", "yaw_rate_radps", "speed_mps",
                    "steering_wheel_angle_rad")
BAND_COUNT = 4
LEVEL_BAND = 2  # from 0.8 on: in which the studies make alarms as frequent as the firmware's
DOUBLES, BYTES = ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_uint8)
_folder = pathlib.Path(__file__).resolve().parents[2] / "build/release/sil"


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


class _Signals(ctypes.Structure):
    _fields_ = [("cycles", ctypes.c_size_t), *((name, DOUBLES) for name in FORECAST_SIGNALS)]


def use(program):
    """Takes the library from beside this rsi-sil."""
    global _folder
    if pathlib.Path(program).resolve().parent != _folder:
        _folder = pathlib.Path(program).resolve().parent
        _library.cache_clear()
        _constant.cache_clear()


@functools.cache
def _library():
    try:
        library = ctypes.CDLL(str(_folder / "librsi_judge.so"))
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
            ("forecast_inputs", None, [size, ctypes.POINTER(ctypes.c_char_p), DOUBLES, ctypes.POINTER(_Signals), DOUBLES]),
            ("wilson_interval", None, [number, number, DOUBLES, DOUBLES]),
            ("share_by_vehicle", None, [size, ctypes.POINTER(size), ctypes.POINTER(size), ctypes.POINTER(_Share)])):
        function = getattr(library, f"judge_{name}")
        function.restype, function.argtypes = result, arguments
    return library


@functools.cache
def _constant(name, kind):
    return kind.in_dll(_library(), f"judge_{name}").value


def early_s():
    return _constant("early_s", ctypes.c_double)


def very_early_s():
    return _constant("very_early_s", ctypes.c_double)


def rounding_s():
    return _constant("time_rounding_s", ctypes.c_double)


def lasts(begin_s, end_s):
    """Whether both wheels of a side that are up between these times are a two-wheel lift-off."""
    return end_s - begin_s >= _constant("lasting_s", ctypes.c_double) - rounding_s()


def fewest_vehicles():
    """From so many on, intervals count vehicles."""
    return _constant("fewest_clusters", ctypes.c_size_t)


def bands():
    """Names of the bands of a run without two-wheel lift-off, by its largest |LTR|."""
    return [_library().judge_band_name(band).decode() for band in range(BAND_COUNT)]


def _buffer(kind, values):
    """As a C array; what is one already, as an array of numpy, is not copied."""
    if not hasattr(values, "__array_interface__"):
        values = array.array(kind, values)
    ctype = {"d": ctypes.c_double, "B": ctypes.c_uint8, "I": ctypes.c_uint32, "Q": ctypes.c_size_t}[kind]
    return (ctype * len(values)).from_buffer(values)


def _or_nan(values):
    return values if hasattr(values, "__array_interface__") else [math.nan if value is None else value for value in values]


def _or_none(value):
    return None if math.isnan(value) else value


class Share(typing.NamedTuple):
    """A count of runs, with its interval of 95 %."""

    count: int
    total: int
    interval: tuple

    def value(self):
        return self.count / self.total if self.total else math.nan


def _share(found):
    return Share(found.count, found.total, (found.lowest, found.highest))


def share_by_vehicle(vehicles):
    """`vehicles`: of each, how many runs count, and of how many."""
    found, columns = _Share(), [*zip(*vehicles)] or [(), ()]
    _library().judge_share_by_vehicle(len(columns[0]), *(_buffer("Q", column) for column in columns), found)
    return _share(found)


def wilson_interval(share, trials):
    lowest, highest = ctypes.c_double(), ctypes.c_double()
    _library().judge_wilson_interval(share * trials, trials, lowest, highest)
    return lowest.value, highest.value


class Detection(typing.NamedTuple):
    """Results of one warning over many runs."""

    warned: Share
    warned_100ms: Share
    warned_200ms: Share
    false_alarms: Share
    alarms: dict  # Share of each band
    median_lead_s: float


def detection(vehicles, lift_off_times_s, largest_ltrs, leads_s, alarms):
    """Outcomes of runs side by side; None without a lift-off or a lead."""
    numbers = {name: number for number, name in enumerate(sorted(set(vehicles)))}
    found = _Detection()
    _library().judge_detect(
        _Runs(len(vehicles), _buffer("I", [numbers[name] for name in vehicles]), _buffer("d", _or_nan(lift_off_times_s)),
              _buffer("d", largest_ltrs), _buffer("d", _or_nan(leads_s)), _buffer("B", alarms)), found)
    return Detection(_share(found.warned), _share(found.warned_100ms), _share(found.warned_200ms), _share(found.false_alarms),
                     dict(zip(bands(), map(_share, found.alarms))), found.median_lead_s)


EACH = ("lifted", "calm", "warned", "warned_100ms", "warned_200ms", "band")


def each(lift_off_times_s, largest_ltrs, leads_s):
    """EACH of these runs side by side, as bytes; a band as its number. None or NaN: no lift-off, no lead."""
    count = len(leads_s)
    results = [array.array("B", bytes(count)) for _ in EACH]
    _library().judge_each(
        _Runs(count, None, _buffer("d", _or_nan(lift_off_times_s)), _buffer("d", largest_ltrs), _buffer("d", _or_nan(leads_s)),
              None),
        *((ctypes.c_uint8 * count).from_buffer(result) for result in results))
    return dict(zip(EACH, results))


def lead_s(times_s, sides, lift_off_time_s, falling_side):
    """For how long, at lift-off, the falling side has been named; None if it is not. `sides`: named from these times on."""
    return _or_none(_library().judge_lead_s(len(times_s), _buffer("d", times_s), _buffer("B", [SIDES[side] for side in sides]),
                                            lift_off_time_s, SIDES[falling_side]))


def forecast_inputs(calibration, signals):
    """Inputs of the firmware's linear forecast, one for each weight, for each cycle: the three lags of the first signal,
    of the second, and so on. `signals`: of each of FORECAST_SIGNALS, an array of doubles."""
    known = {name: value for name, value in calibration.items() if isinstance(value, (int, float))}
    names = (ctypes.c_char_p * len(known))(*(name.encode() for name in known))
    cycles, count = len(signals[FORECAST_SIGNALS[0]]), _constant("forecast_input_count", ctypes.c_size_t)
    inputs = array.array("d", bytes(8 * cycles * count))
    buffers = [_buffer("d", signals[name]) for name in FORECAST_SIGNALS]
    _library().judge_forecast_inputs(len(known), names, _buffer("d", known.values()), _Signals(cycles, *buffers),
                                     (ctypes.c_double * len(inputs)).from_buffer(inputs))
    return inputs, count


class Index:
    """An index over one run, the risk of falling to either side in each cycle, behind the firmware's own warning states."""

    def __init__(self, calibration, times_s, right, left):
        self._calibration = _Calibration(*(calibration[name] for name in CALIBRATION))
        self._course = _Course(len(times_s), *(_buffer("d", values) for values in (times_s, right, left)))

    def lead_s(self, threshold, lift_off_time_s, falling_side):
        return _or_none(_library().judge_index_lead_s(self._calibration, self._course, threshold, lift_off_time_s,
                                                      SIDES[falling_side]))

    def alarms(self, threshold):
        return bool(_library().judge_alarms(self._calibration, self._course, threshold))

    def alarm_threshold(self):
        """The largest threshold at which it raises an alarm; 0 when there is none."""
        return _library().judge_alarm_threshold(self._calibration, self._course)
