"""Quantities of a foreign vehicle that the population's page has, too, to set both beside each other."""

import math
import pathlib
import statistics
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "population"))

import manoeuvres
import vehicle_quantities
import ways
from conventions import GRAVITY_MPS2, load_transfer_ratio

POPULATION = pathlib.Path(__file__).resolve().parents[3] / "docs/reports/population.md"
TRUE_OVER_COMPUTED = "true over computed LTR"
# As on the population's page, but for the last.
NAMES = tuple((name, vehicle_quantities.UNITS.get(name, "")) for name in (
    "static stability factor", "rollover threshold", "grip over threshold", "roll gradient", "roll frequency", "roll damping ratio",
    "understeer gradient", "lateral response", "its lag", "tyre limit over threshold", TRUE_OVER_COMPUTED))
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


def of_data_sheet(vehicle, calibration):
    """By name, what the report on distributions sets beside the population besides; None: not a quantity of this vehicle."""
    sheet, drawn = vehicle.data(), vehicle.drawn
    track = sheet.get("track_width_m") or 0.5 * (sheet["track_width_front_m"] + sheet["track_width_rear_m"])
    sprung = sheet["sprung_mass_kg"]
    return {"mass": sheet["total_mass_kg"], "CG height": 0.5 * track / vehicle.static_stability_factor(),
            "roll radius of gyration over track": vehicle_quantities.roll_gyration_over_track(
                sprung, sheet["total_mass_kg"] - sprung, sheet["sprung_cg_height_m"], sheet["wheel_radius_m"], track,
                vehicle.roll_inertia_kgm2()),
            "characteristic speed": vehicle_quantities.characteristic_speed_kmh(
                sheet["wheelbase_m"], calibration["understeer_gradient_s2pm"]),
            "relaxation length": drawn.get("relaxation_m"), "steering lag": drawn.get("steering_lag_s")}


def data(results):
    """A line a vehicle with family, class and quantities, for sil/studies/population/distributions."""
    names = {"vehicle": [result.vehicle for result in results], "family": [result.family for result in results],
             "class": [result.kind for result in results]}
    every = [result.quantities | result.data_sheet for result in results]
    return vehicle_quantities.csv_text(names, {name: [each.get(name) for each in every]
                                               for name in vehicle_quantities.UNITS if any(name in each for each in every)})


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
