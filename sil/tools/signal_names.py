"""Which signal may be which quantity, by its name, unit and comment."""

import collections
import re

from drive_quantities import QUANTITIES, factor_of, is_known, is_other

# One signal that a log may have. `key` is what a mapping calls it.
Candidate = collections.namedtuple("Candidate", "key name unit comment")

# Names of signals in lower case, their words apart: English, German and the abbreviations of both. Ford writes a for an
# acceleration, w for a rate, an for an angle and v for a speed.
ACCELERATION = r"(accel\w*|acc|acl|beschl\w*|force)"
RATE = r"(rate|rte|rt|vel\w*|speed|spd|geschw\w*|gyro\w*)"
ANGLE = r"(angle|angl|ang|winkel|wnkl|pos\w*)"
LOAD = r"(load|force|weight|last|kraft|radlast|aufstandskraft|fz)"
TYRE = r"(wheel|whl|tire|tyre|rad|corner|vertical|normal)"
CORNERS = {"front_left": r"(fl|lf|vl|front left|left front)", "front_right": r"(fr|rf|vr|front right|right front)",
           "rear_left": r"(rl|lr|hl|rear left|left rear)", "rear_right": r"(rr|hr|rear right|right rear)"}
NAMES = {
    "lateral_acceleration": rf"\b(lat\w*|quer|y) ?{ACCELERATION}\b|\b{ACCELERATION} ?(y|lat\w*|quer)\b|\ba ?y\b|querbeschl|"
                            r"\bveh lat( comp)? a\b",
    "roll_rate": rf"\b(roll|wank)\w* ?{RATE}\b|\b(rate|omega|gyro|w) ?(x|roll)\b|wankgeschw|wankrate|rollrate|rollgeschw|"
                 r"\bveh roll?( comp)? w\b",
    "roll_angle": rf"\b(roll|wank)\w* ?{ANGLE}\b|\b(body|veh\w*|chassis) ?roll\b|^roll$|wankwinkel|rollwinkel|"
                  r"\bveh rol( comp)? an\b",
    "speed": rf"\b(veh\w*|car|ego|fzg|fahrzeug\w*|wheel based|ground|gps|reference|ref)( veh\w*)? ?{RATE}\b|"
             r"\bv ?(veh|ego|x|fzg)\b|fahrzeuggeschw|fahrgeschw|\bgeschw\w*|\bveh v\b|^(speed|velocity|v)$",
    "yaw_rate": rf"\b(yaw|gier)\w* ?{RATE}\b|\b(rate|omega|gyro|w) ?(z|yaw)\b|giergeschw|gierrate|yawrate|\bveh yaw( comp)? w\b",
    "vertical_acceleration": rf"\b(vert\w*|hoch|z) ?{ACCELERATION}\b|\b{ACCELERATION} ?(z|vert\w*)\b|\ba ?z\b|"
                             r"vertikalbeschl|hochbeschl|\bveh vert( comp)? a\b",
    "steering_wheel_angle": rf"\b(steer\w*|lenk\w*|str|sw|sas|hand) ?(wheel|whl|rad)? ?{ANGLE}\b|lenkrad ?winkel|lenkwinkel|"
                            r"steering ?wheel ?angle|\bste(er)? ?(pin|whl)\w*( rot)?( comp)? an\b",
    "bank_angle": r"\broad ?bank\b|\bbank ?(angle|ang)\b|^bank$|\bsuperelev\w*|\bcross ?(slope|fall)\b|querneig\w*",
    "vehicle_mass": r"\b(gross|total|veh\w*|fzg|gesamt|powered)[\w ]*(mass|weight|masse|gewicht)|\bmass\b|fahrzeugmasse|"
                    r"gesamt(masse|gewicht)",
}
NAMES.update({f"wheel_load_{corner}": rf"\b({TYRE} ?)?{LOAD} ?{text}\b|\b{text} ?({TYRE} ?)?{LOAD}\b"
              for corner, text in CORNERS.items()})
# Enough where the unit says the rest.
WITH_UNIT = {"lateral_acceleration": r"\b(lat|lateral|quer)\b", "vertical_acceleration": r"\b(vert|vertical|vertikal)\b",
             "roll_rate": r"\b(roll|wank)\b", "roll_angle": r"\b(roll|wank)\b", "yaw_rate": r"\b(yaw|gier)\b",
             "speed": r"^vx?( (mps|kmh|kph|mph))?$|\bv ?(signal|sig|ist|act|actual|ref\w*)\b",
             "steering_wheel_angle": r"\b(lenkrad|steering wheel|steering|(steer|delta) ?(hw|sw)|hand ?wheel|swa|lwi)\b"}
WITH_UNIT.update({f"wheel_load_{corner}": rf"\b({TYRE} ?{text}|{text} ?{TYRE})\b" for corner, text in CORNERS.items()})
NOT_MEANT = (r"\b(qual\w*|q ?bit|qf|qly|valid\w*|vld|sta|stat\w*|offset|ofs|offs|bias|crc|cs|cks|cksum|chk\w*|check ?sum\w*|"
             r"pruef\w*|pr\u00fcf\w*|cnt\w*|cntr|ctr|count\w*|counter|zaehler|z\u00e4hler|alive|bz|err\w*|fault\w*|flt|fail\w*|"
             r"fehler|target|req\w*|cmd|command\w*|ack|set|setpoint|soll|wunsch\w*|desired|max\w*|min\w*|limit\w*|cruise|sign|dir|"
             r"direction|confid\w*|conf|plaus\w*|deviation|std|var\w*|press\w*|prs|druck|rpm|drehzahl\w*|obj\w*|rel|relative|"
             r"radar|lrr|srr|trk|track\w*|temp\w*|torque|trq|tq|moment\w*|pulse\w*|impuls\w*|dist\w*|accum\w*|factor|group|grp|"
             r"src|source|reserv\w*|id|jerk|pitch|nick\w*|brake|brems\w*|trailer|trlr|traffic|curv\w*|lane|misalign\w*|ziel\w*|"
             r"begrenz\w*|lim|mx|rq|trg|lead)\b")
DOUBTFUL = r"\b(angez\w*|anz\w*|disp\w*|dsply|clu\w*|kombi|calc\w*)\b"  # as shown to the driver, or worked out from others
SIGN = r"\b(vz|vorz\w*|sign|sgn|dir\w*|richtung|neg\w*|polarity)\b"
FILLERS = r"\b(der|des|of|the)\b"
OTHERS_MESSAGES = r"\b(radar|lrr|srr|obj\w*|trk|track\w*|target\w*)\b"
WHEEL_SPEEDS = (r"\b(wheel|whl|rad|engine|eng|motor|fan|shaft|turbine|axle|wind|gear\w*|yaw|gier\w*|roll|wank\w*|steer\w*|lenk\w*|"
                r"lat|lateral|vert\w*)\b")


def words(text):
    """A name's words in lower case, apart: LatAcc_Raw is "lat acc raw"."""
    apart = re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])|(?<=[A-Za-z])(?=\d)|(?<=\d)(?=[A-Za-z])|[_\W]+", " ", text)
    return " ".join(apart.lower().split())


def likeness(quantity, candidate):
    """How much speaks for it, 0: nothing, and whether its own name does."""
    dimension = QUANTITIES[quantity].dimension
    name = words(candidate.name)
    fits = bool(candidate.unit) and factor_of(candidate.unit, dimension) is not None
    if candidate.unit and not fits and (is_known(candidate.unit) or is_other(candidate.unit)):
        return 0, False
    message = words(candidate.key.removesuffix(candidate.name))
    if re.search(NOT_MEANT, name) or re.search(OTHERS_MESSAGES, message):
        return 0, False
    if quantity == "speed" and re.search(WHEEL_SPEEDS, name) and "wheel based" not in name:
        return 0, False
    if quantity in ("roll_angle", "steering_wheel_angle", "bank_angle") and re.search(rf"\b{RATE}\b", name):
        return 0, False
    if re.search(NAMES[quantity], name):
        score = 4
    elif fits and re.search(WITH_UNIT.get(quantity, "(?!)"), name):
        score = 3
    elif (fits or not candidate.unit) and re.search(NAMES[quantity], f"{message} {name}"):
        score = 2
    elif fits and re.search(NAMES[quantity], words(candidate.comment or "")):
        score = 1
    else:
        return 0, False
    is_doubtful = bool(re.search(DOUBTFUL, name))
    return score * 2 + (3 if fits else 0) - is_doubtful, score > 2 and not is_doubtful


def candidates(quantity, signals):
    """The likeliest first, and whether the first is clearly the likeliest."""
    scored = sorted(((*likeness(quantity, signal), -number) for number, signal in enumerate(signals)), reverse=True)
    scored = [(score, by_name, signals[-number]) for score, by_name, number in scored if score > 0][:5]
    is_clear = bool(scored) and scored[0][1] and (len(scored) == 1 or scored[0][0] > scored[1][0])
    return [signal for _, _, signal in scored], is_clear


def sign_of(magnitude, flags):
    """The flag that is the sign of this magnitude: the one of the most words, all of which the magnitude's name has, too."""
    own = words(magnitude).split()

    def fits(flag):
        rest = re.sub(FILLERS, "", re.sub(SIGN, "", words(flag))).split()
        return all(any(word.startswith(part) for word in own) for part in rest)

    return max((flag for flag in flags if re.search(SIGN, words(flag)) and fits(flag)), key=len, default=None)
