"""Quantities of a foreign vehicle that the population's page has, too, to set both beside each other."""

import math
import pathlib
import statistics

import manoeuvres
import ways
from conventions import GRAVITY_MPS2, load_transfer_ratio

POPULATION = pathlib.Path(__file__).resolve().parents[3] / "docs/reports/population.md"
TRUE_OVER_COMPUTED = "true over computed LTR"
# Name and unit as on the population's page, but for the last.
NAMES = (("static stability factor", ""), ("rollover threshold", "g"), ("grip over threshold", ""), ("roll gradient", "deg/g"),
         ("roll frequency", "Hz"), ("roll damping ratio", ""), ("understeer gradient", "1e-3 s2/m"),
         ("lateral response", "rad/s"), ("its lag", "s"), ("tyre limit over threshold", ""), (TRUE_OVER_COMPUTED, ""))
COMPARED_LTR = (0.3, 0.8)  # of the ramp, where true and computed LTR are compared


def of_vehicle(vehicle, ramp, replayed_ramp, calibration):
    """By name. Roll, steering and response are those that `identify` found; the threshold is the lateral acceleration at the
    end of the ramp over its LTR."""
    found = calibration
    threshold_g = manoeuvres.on_the_road_mps2(ramp[-1]) / GRAVITY_MPS2 / load_transfer_ratio(ramp[-1][-4:])
    arm_m = found["sprung_cg_height_m"] - found["fixed_roll_centre_height_m"]
    tipping = found["sprung_mass_kg"] * GRAVITY_MPS2 * arm_m
    net = found["roll_stiffness_nmprad"] - tipping
    inertia = found["roll_inertia_kgm2"] + found["sprung_mass_kg"] * arm_m**2
    result = {"static stability factor": vehicle.static_stability_factor(), "rollover threshold": threshold_g,
              "grip over threshold": vehicle.grip() / threshold_g, "roll gradient": math.degrees(tipping / net),
              "roll frequency": math.sqrt(net / inertia) / (2.0 * math.pi),
              "roll damping ratio": 0.5 * found["roll_damping_nmsprad"] / math.sqrt(net * inertia),
              "understeer gradient": 1e3 * found["understeer_gradient_s2pm"],
              "tyre limit over threshold": found[ways.TYRE_LIMIT] / GRAVITY_MPS2 / threshold_g,
              TRUE_OVER_COMPUTED: _true_over_computed(replayed_ramp)}
    frequency = found["lateral_response_frequency_radps"]
    if frequency > 0.0:
        result |= {"lateral response": frequency, "its lag": 2.0 * found["lateral_response_damping"] / frequency}
    return result


def _true_over_computed(replayed_ramp):
    low, high = COMPARED_LTR
    pairs = [(float(row["measured_load_transfer_ratio"]), float(row["load_transfer_ratio"])) for row in replayed_ramp]
    return statistics.median(abs(true / computed) for true, computed in pairs if low < abs(true) < high and computed)


def of_population(page=POPULATION):
    """Least and largest of each quantity, by name, from the table of the population's vehicles."""
    ranges = {}
    for line in page.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 7 and tuple(cells[:2]) in NAMES:
            ranges[cells[0]] = (float(cells[2]), float(cells[6]))
    missing = [name for name, _ in NAMES if name not in ranges and name != TRUE_OVER_COMPUTED]
    if missing:
        raise LookupError(f"{page}: no row of vehicles named {', '.join(missing)}; name it in quantities.py as it is there")
    return ranges
