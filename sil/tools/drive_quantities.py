"""The quantities of a drive (docs/drives.md), and the units in which others record them."""

import collections
import math
import re

# `columns` are those of sil/studies/drives/drive_columns.cpp; a test reads each of them with `rsi-sil`.
Quantity = collections.namedtuple("Quantity", "name column dimension need")

REQUIRED = "required"
OPTIONAL = "optional"

QUANTITIES = {quantity.name: quantity for quantity in (
    Quantity("lateral_acceleration", "lateral_acceleration_mps2", "acceleration", REQUIRED),
    Quantity("roll_rate", "roll_rate_degps", "rate", REQUIRED),
    Quantity("roll_angle", "roll_angle_deg", "angle", OPTIONAL),
    Quantity("speed", "speed_kmh", "speed", OPTIONAL),
    Quantity("yaw_rate", "yaw_rate_degps", "rate", OPTIONAL),
    Quantity("vertical_acceleration", "vertical_acceleration_mps2", "acceleration", OPTIONAL),
    Quantity("steering_wheel_angle", "steering_wheel_angle_deg", "angle", OPTIONAL),
    Quantity("bank_angle", "bank_angle_deg", "angle", OPTIONAL),
    Quantity("vehicle_mass", "vehicle_mass_kg", "mass", OPTIONAL),
    Quantity("wheel_load_front_left", "wheel_load_front_left_n", "force", OPTIONAL),
    Quantity("wheel_load_front_right", "wheel_load_front_right_n", "force", OPTIONAL),
    Quantity("wheel_load_rear_left", "wheel_load_rear_left_n", "force", OPTIONAL),
    Quantity("wheel_load_rear_right", "wheel_load_rear_right_n", "force", OPTIONAL),
)}
WHEEL_LOADS = [name for name in QUANTITIES if name.startswith("wheel_load_")]

G_MPS2 = 9.80665
POUND_KG = 0.45359237

# From each unit to that of the drive's column.
UNITS = {
    "acceleration": {"m/s^2": 1.0, "g": G_MPS2, "mg": 1.0e-3 * G_MPS2, "ft/s^2": 0.3048},
    "rate": {"deg/s": 1.0, "rad/s": math.degrees(1.0), "mrad/s": math.degrees(1.0e-3)},
    "angle": {"deg": 1.0, "rad": math.degrees(1.0), "mrad": math.degrees(1.0e-3)},
    "speed": {"km/h": 1.0, "m/s": 3.6, "mph": 1.609344, "knot": 1.852},
    "mass": {"kg": 1.0, "t": 1000.0, "lb": POUND_KG},
    "force": {"N": 1.0, "kN": 1000.0, "kgf": G_MPS2, "lbf": POUND_KG * G_MPS2},
    "length": {"m": 1.0, "cm": 1.0e-2, "mm": 1.0e-3, "inch": 0.0254, "ft": 0.3048},
    "time": {"s": 1.0, "ms": 1.0e-3, "us": 1.0e-6, "ns": 1.0e-9},
}

SPELLINGS = {
    "mps2": "m/s^2", "m/s2": "m/s^2", "m/s/s": "m/s^2", "m/ss": "m/s^2", "meters/s2": "m/s^2", "meterspersecond2": "m/s^2",
    "ft/s2": "ft/s^2",
    "degps": "deg/s", "degs/s": "deg/s", "degpersec": "deg/s", "degpers": "deg/s", "dps": "deg/s", "deg/second": "deg/s",
    "radps": "rad/s", "radpers": "rad/s", "radpersec": "rad/s", "radians/s": "rad/s", "radiant/s": "rad/s",
    "mpers": "m/s", "mpers2": "m/s^2", "meter/s": "m/s", "meters/s": "m/s", "meter/s2": "m/s^2", "gforce": "g", "g-force": "g",
    "km/std": "km/h", "km/stunde": "km/h", "km/hour": "km/h", "kmph": "km/h", "kilometer/h": "km/h",
    "millimeter": "mm", "meter": "m", "meters": "m", "centimeter": "cm", "kilogram": "kg", "kilograms": "kg",
    # As VW's files abbreviate them.
    "forceofgravi": "g", "meterperseconsquar": "m/s^2", "meterpersquaresecond": "m/s^2", "degreofarcpersecon": "deg/s",
    "radianpersecon": "rad/s", "degreofarc": "deg", "kilometerperhour": "km/h", "meterpersecon": "m/s",
    "meterpersecond": "m/s", "newto": "n", "kilonewto": "kn",
    "degrees": "deg", "degree": "deg", "degs": "deg", "radians": "rad", "radian": "rad", "radiant": "rad",
    "kmh": "km/h", "kph": "km/h", "km/hr": "km/h",
    "mps": "m/s", "mi/h": "mph", "miles/h": "mph", "kn": "knot", "kt": "knot", "kts": "knot", "knots": "knot",
    "to": "t", "ton": "t", "tons": "t", "tonne": "t", "tonnes": "t", "lbs": "lb", "pound": "lb", "pounds": "lb",
    "newton": "n", "kilonewton": "kn", "unitless": "", "-": "",
    "sec": "s", "second": "s", "seconds": "s", "msec": "ms", "milliseconds": "ms", "microseconds": "us",
    "nanoseconds": "ns", "\u00b5s": "us", "\u03bcs": "us",
}

# Units of what no drive has.
OTHER_UNITS = frozenset((
    "pa", "kpa", "kpag", "hpa", "mpa", "bar", "mbar", "millibar", "psi", "kilopascal", "mmhg",
    "rpm", "1/min", "u/min", "r/min", "min-1", "minutinver", "rev/min", "hz", "hertz",
    "%", "percent", "prozent", "c", "f", "k", "degc", "degf", "degk", "celsius", "degrec", "degrecelsi", "gradc",
    "a", "ma", "amp", "amps", "amper", "ampere", "ah", "ohm", "w", "kw", "watt", "watts", "kwh", "wh",
    "nm", "newtonmeter", "newtometer", "nm/s", "deg/s2", "rad/s2", "m/s3", "1/m", "1/meter", "m/m",
    "km", "kilometer", "mile", "miles", "yd/s", "l", "ml", "ul", "liter", "liters", "litre", "l/h", "l/100km",
    "min", "minute", "minutes", "minut", "h", "hr", "hour", "hours", "day", "days", "month", "year", "years",
    "db", "dbm", "dbsm", "lux", "yes/no", "pulse", "pulses", "pulsecount", "impulse", "bit", "bits"))


def plain(unit):
    """A unit's spelling without what differs from file to file: case, blanks, brackets, signs of degree and power."""
    text = (unit or "").strip().lower().removeprefix("unit_")
    text = re.sub(r"[\s\[\](){}_^*\u00b7]", "", text)
    text = re.sub("[\u00b0\u00ba\u02da]", "deg", text).replace("\u00b2", "2").replace("degrees", "deg").replace("degree", "deg")
    text = re.sub(r"^grad(?=$|[/.])|^winkelgrad$", "deg", text)
    text = re.sub(r"(?:/|per|pro)(sec|second|seconds|sek|sekunde)\.?(?=2?$)", "/s", text)
    return text.replace("/sec2", "/s2").replace("s-1", "/s").replace("s-2", "/s2").replace("//", "/")


def factor_of(unit, dimension):
    """Factor from this unit to that of the drive's column; None for a unit of another dimension."""
    text = plain(unit)
    for known, factor in UNITS[dimension].items():
        if plain(known) == text or (text in SPELLINGS and plain(SPELLINGS[text]) == plain(known)):
            return factor
    return None


def is_known(unit):
    """Whether it is a unit of any dimension."""
    return any(factor_of(unit, dimension) is not None for dimension in UNITS)


def is_other(unit):
    """Whether it is a unit of nothing that a drive has."""
    return plain(unit) in OTHER_UNITS


def admitted(dimension):
    return ", ".join(UNITS[dimension])
