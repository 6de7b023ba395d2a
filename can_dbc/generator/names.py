"""How names and units of a DBC file become C++ names."""
import re

# The ending that a field's name takes from its unit. A unit that is not here is refused: add it.
UNIT_ENDINGS = {
    "": "",
    "-": "",  # dimensionless
    "m": "m",
    "mm": "mm",
    "s": "s",
    "ms": "ms",
    "m/s": "mps",
    "km/h": "kmh",
    "m/s^2": "mps2",
    "g": "g",
    "deg": "deg",
    "deg/s": "deg_per_s",
    "rad": "rad",
    "rad/s": "radps",
    "N": "n",
    "N m": "nm",
    "N m/rad": "nmprad",
    "N m s/rad": "nmsprad",
    "kg": "kg",
    "V": "v",
    "%": "percent",
    "degC": "deg_c",
}

# From the unit that the name of a source ends in to the unit of the signal that carries it: a factor.
CONVERSIONS = {
    ("rad", "deg"): "57.295780F",
    ("radps", "deg_per_s"): "57.295780F",
    ("mps", "kmh"): "3.6F",
}

RESERVED = set("""
alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t char8_t class co_await
co_return co_yield compl concept const const_cast consteval constexpr constinit continue decltype default delete do
double dynamic_cast else enum explicit export extern false float for friend goto if inline int long mutable namespace
new noexcept not not_eq nullptr operator or or_eq private protected public register reinterpret_cast requires return
short signed sizeof static static_assert static_cast struct switch template this thread_local throw true try typedef
typeid typename union unsigned using virtual void volatile wchar_t while xor xor_eq
""".split())

# Names that every generated message struct uses itself.
TAKEN = {"identifier", "extended", "flexible_data_rate", "length", "cycle_time_ms", "e2e_protected", "e2e_profile",
         "e2e_data_id", "name", "encode", "decode", "is_known", "name_of", "all_valid", "visit_signals", "take",
         "visit_sources", "has_sources", "source", "visitor", "not_available"}
TAKEN_TYPES = {"Status", "Signals"}


def snake_case(text):
    """LateralAcceleration, lateral acceleration and LATERAL_ACCELERATION all give lateral_acceleration."""
    text = re.sub(r"[^0-9A-Za-z]+", "_", text.strip())
    text = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", text)
    text = re.sub(r"([A-Z]+)([A-Z][a-z])", r"\1_\2", text)
    return re.sub(r"_+", "_", text).strip("_").lower()


def camel_case(text):
    return "".join(word.capitalize() for word in snake_case(text).split("_"))


def is_usable(name):
    return re.fullmatch(r"[A-Za-z][0-9A-Za-z_]*", name) is not None and name not in RESERVED
