"""Which signal may be which quantity, by its name, unit and comment."""

import collections
import re

from drive_quantities import QUANTITIES, factor_of, is_known

# One signal that a log may have. `key` is what a mapping calls it.
Candidate = collections.namedtuple("Candidate", "key name unit comment")

# Names of signals in lower case, their words apart: English, German and the abbreviations of both.
ACCELERATION = r"(acc\w*|beschl\w*|force)"
RATE = r"(rate|vel\w*|speed|spd|geschw\w*|gyro\w*)"
ANGLE = r"(angle|ang|winkel|wnkl|pos\w*)"
CORNERS = {"front_left": r"(fl|lf|vl|front left|left front)", "front_right": r"(fr|rf|vr|front right|right front)",
           "rear_left": r"(rl|lr|hl|rear left|left rear)", "rear_right": r"(rr|hr|rear right|right rear)"}
NAMES = {
    "lateral_acceleration": rf"\b(lat\w*|quer|y) ?{ACCELERATION}|\b{ACCELERATION} ?(y|lat\w*|quer)\b|\ba ?y\b|querbeschl",
    "roll_rate": rf"\b(roll|wank)\w* ?{RATE}|\b(rate|omega|gyro|w) ?(x|roll)\b|wankgeschw|rollrate",
    "roll_angle": rf"\b(roll|wank)\w* ?{ANGLE}|\b(body|veh\w*|chassis) ?roll\b|^roll$|wankwinkel|rollwinkel",
    "speed": rf"\b(veh\w*|car|ego|fzg|fahrzeug\w*|wheel based|ground|gps|reference|ref)( veh\w*)? ?{RATE}|\bv ?(veh|ego|x|fzg)\b|"
             r"fahrzeuggeschw|^(speed|velocity|v)$",
    "yaw_rate": rf"\b(yaw|gier)\w* ?{RATE}|\b(rate|omega|gyro|w) ?(z|yaw)\b|giergeschw|gierrate|yawrate",
    "vertical_acceleration": rf"\b(vert\w*|hoch|z) ?{ACCELERATION}|\b{ACCELERATION} ?(z|vert\w*)\b|\ba ?z\b|vertikalbeschl",
    "steering_wheel_angle": rf"\b(steer\w*|lenk\w*|str|sw|sas|hand) ?(wheel|whl|rad)? ?{ANGLE}|lenkrad ?winkel|"
                            r"steering ?wheel ?angle",
    "bank_angle": r"\b(road )?(bank|superelev\w*|cross ?slope|cross ?fall|querneig\w*)",
    "vehicle_mass": r"\b(gross|total|veh\w*|fzg|gesamt|powered)[\w ]*(mass|weight|masse|gewicht)|\bmass\b|fahrzeugmasse",
}
NAMES.update({f"wheel_load_{corner}": rf"\b(wheel|tire|tyre|rad|vertical|fz) ?(load|force|last|weight)?\w* ?{text}\b|"
                                      rf"\b{text} ?(wheel|tire|tyre|rad) ?(load|force|last)" for corner, text in CORNERS.items()})
NOT_MEANT = (r"\b(qual\w*|qf|qly|valid\w*|vld|stat\w*|offset|ofs|offs|crc|chk\w*|checksum|cnt\w*|count\w*|alive|bz|err\w*|"
             r"fault\w*|target|req\w*|set|setpoint|soll|desired|max\w*|min\w*|limit\w*|cruise|sign|dir|direction|confid\w*|"
             r"plaus\w*|deviation|std|var\w*)\b")
WHEEL_SPEEDS = r"\b(wheel|whl|engine|eng|motor|fan|shaft|turbine|axle|wind|gear\w*)\b"


def words(text):
    """A name's words in lower case, apart: LatAcc_Raw is "lat acc raw"."""
    apart = re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])|(?<=[A-Za-z])(?=\d)|(?<=\d)(?=[A-Za-z])|[_\W]+", " ", text)
    return " ".join(apart.lower().split())


def likeness(quantity, candidate):
    """How much speaks for it; 0: nothing."""
    dimension = QUANTITIES[quantity].dimension
    name = words(candidate.name)
    fits = candidate.unit and factor_of(candidate.unit, dimension) is not None
    if candidate.unit and not fits and is_known(candidate.unit):
        return 0
    if re.search(NOT_MEANT, name):
        return 0
    if quantity == "speed" and re.search(WHEEL_SPEEDS, name) and "wheel based" not in name:
        return 0
    if re.search(NAMES[quantity], name):
        score = 4
    elif re.search(NAMES[quantity], words(candidate.key)):
        score = 3
    elif re.search(NAMES[quantity], words(candidate.comment or "")):
        score = 2
    else:
        return 0
    if quantity in ("roll_angle", "steering_wheel_angle", "bank_angle") and re.search(rf"\b{RATE}\b", name):
        return 0
    return score * 2 + (3 if fits else 0)


def candidates(quantity, signals):
    """The likeliest first, and whether the first is clearly the likeliest."""
    scored = sorted(((likeness(quantity, signal), -number) for number, signal in enumerate(signals)), reverse=True)
    scored = [(score, signals[-number]) for score, number in scored if score > 0][:5]
    is_clear = bool(scored) and (len(scored) == 1 or scored[0][0] > scored[1][0])
    return [signal for _, signal in scored], is_clear
