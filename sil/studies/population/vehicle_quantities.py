"""Quantities in which drawn, foreign and published vehicles are compared, and their spread."""

import csv
import io
import math

# In the order of the pages; the names are those of population and foreign vehicles alike.
UNITS = {
    "mass": "kg",
    "CG height": "m",
    "static stability factor": "",
    "rollover threshold": "g",
    "grip over threshold": "",
    "roll radius of gyration over track": "",
    "roll-centre height over that of the CG": "",
    "roll gradient": "deg/g",
    "roll frequency": "Hz",
    "roll damping ratio": "",
    "understeer gradient": "1e-3 s2/m",
    "characteristic speed": "km/h",
    "relaxation length": "m",
    "steering lag": "s",
    "growth of the springs' stiffness": "1/m2",
    "dry friction of leaf springs over static load": "",
    "stiffness of a twisting frame over that in roll": "",
    "lateral response": "rad/s",
    "its lag": "s",
    "tyre limit over threshold": "",
}


def at_share(values, share):
    """The value below which this share of all lies; 0: the least, 1: the largest."""
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def roll_gyration_over_track(sprung_kg, unsprung_kg, sprung_height_m, wheel_radius_m, track_m, sprung_inertia_kgm2):
    """That of the whole vehicle about its CG, as inertia rigs measure it. The unsprung masses are taken to be at the wheels."""
    total = sprung_kg + unsprung_kg
    height = (sprung_kg * sprung_height_m + unsprung_kg * wheel_radius_m) / total
    inertia = (sprung_inertia_kgm2 + sprung_kg * (sprung_height_m - height)**2
               + unsprung_kg * (0.25 * track_m**2 + (wheel_radius_m - height)**2))
    return math.sqrt(inertia / total) / track_m


def characteristic_speed_kmh(wheelbase_m, understeer_s2pm):
    """The speed at which an understeering vehicle takes twice the angle of a slow turn; None for the others."""
    return 3.6 * math.sqrt(wheelbase_m / understeer_s2pm) if understeer_s2pm > 0.0 else None


def csv_text(names, quantities):
    """A line a vehicle: first its names, then its quantities, empty where nothing is known. Both are columns by name."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*names, *quantities])
    for line in zip(*names.values(), *([None if value is None else f"{value:.6g}" for value in column] for column in quantities.values())):
        writer.writerow(line)
    return text.getvalue()
