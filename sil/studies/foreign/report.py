"""The page of the study: both families side by side."""

import statistics

import families
import judge
import manoeuvres
import markdown
import quantities
import ways
from conventions import GRAVITY_MPS2

HEAD = """<!-- Written by sil/studies/foreign/run --document; do not edit. -->
# Vehicles of others' equations, and of another engine

The [population](population.md) is one model with other numbers, and that model is this project's own. Two other families
are here, drawn with seed {seed}. No constant of the firmware was chosen on them. They showed
where `identify` failed, and the population's ranges were widened towards them; [what is outside](#beside-the-population) is
counted.

- **commonroad** ({commonroad} vehicles): other equations, which this project did not write: the multi-body model of the
  package commonroad-vehicle-models (29 states; tyres, springs and compliant joints after the vehicle dynamics of the US
  Department of Transportation), its parameter set 3, a van, varied as high vans, SUVs and pick-ups. Two changes: a tyre
  without load gives no force, while that of the package holds a lifted wheel down; and a drive begins in equilibrium. The
  rest is as its authors wrote it, the tyre's jump with the sign of the camber included, which lets the body roll a little
  on the straight.
- **jointed** ({jointed} vehicles): another structure, in the physics engine MuJoCo: bodies, joints, springs, dry friction,
  stops and the contact of ellipsoidal wheels with the road are the engine's, which alone decides what a wheel carries. Cars
  on *swing arms* that jack the body up; trucks on rigid axles with *leaf springs* and their dry friction; with a frame that
  *twists*; *tankers* whose load swings; coaches on soft, progressive *air springs*. This project describes them and gives
  the force along the road, a brush tyre with relaxation, since the engine's own friction resists a speed and not a slip angle.

How they are calibrated and driven:

- **Calibration**: by `rsi-sil identify` alone, from the data sheet, a slowly increasing steer at {ramp_speed:.0f} km/h that
  the driver stops at |LTR| {ramp_stop}, and a calm lane change, with ideal sensors.{inertia_assumed}
- **Drives**: {kinds}, open loop, {slowest:.0f} to {fastest:.0f} km/h, with {least} to {most} times
  the handwheel angle of 0.3 g; every fourth round {gentle_least} to {gentle_most} times. A drive ends soon after a lift-off.
- **Errors**: sensor noise ({noise}), and for each vehicle
  a CG height up to {height_error:.0f} % and a roll stiffness up to {stiffness_error:.0f} % off, either way.
- **Open tyre limit**: only `largest_lateral_acceleration_mps2` of the calibration is changed, times {open_limit}.
- **Judge**: that of `rsi-sil replay` and of the campaigns ([what counts](../drives.md#what-counts)); lift-off is that of
  the wheels' loads in the model.

## Results
{results}

In brackets: 95 % confidence, counting {counted}. Alarms are those of drives without two-wheel lift-off, by their largest
|LTR|: how many of how many.{refused}

## By manoeuvre
Lift-offs that were warned of at least 0.1 s before, of how many.

{by_manoeuvre}

## By class, with errors
{by_class}

True over computed LTR: median of the vehicles, measured as [below](#beside-the-population). Above 1 the inner wheels carry
less than the component computes from roll and acceleration of the body, so that it warns later.

## The limit of the tyres
{limits}

The limit is `largest_lateral_acceleration_mps2`, as identified from the ramp. A vehicle exceeds it in its drives when its
largest lateral acceleration is greater; by how much: median and largest of the class.

## Beside the population
{beside}

Least to largest; of the foreign vehicles the median in brackets and how many lie outside the population's
[range](population.md#the-vehicles). Roll, understeer and response are those that `identify` found; of the population roll and
understeer follow from its parameters. The threshold is the lateral acceleration at the end of the ramp over its LTR. True
over computed LTR: median of the ramp between {compared_least} and {compared_most}, with ideal sensors.

## Ranges
Each quantity is drawn uniformly and independently. Factors are those on the package's parameter set.

{ends}
"""


def detection(outcomes):
    rows = [(each.vehicle, each.lift_s, each.largest_ltr, each.lead_s, each.alarm) for each in outcomes]
    return judge.detection(*(zip(*rows) if rows else [()] * 5))


def outcomes_of(results, way):
    return [each for result in results for each in result.outcomes[way] or ()]


def _of_families(results):
    """Each family that was driven and its results."""
    for family in families.FAMILIES:
        of_family = [result for result in results if result.family == family]
        if of_family:
            yield family, of_family


def _cells(family, results, way):
    outcomes = outcomes_of(results, way)
    found = detection(outcomes)
    shares = (found.warned, found.warned_100ms, found.warned_200ms)
    return [family, way, str(found.warned.total), *map(markdown.percent, shares), f"{found.median_lead_s:.2f}",
            *(f"{share.count} of {share.total}" for share in found.alarms.values())]


def results_table(results):
    head = ["family", "", "lift-offs", "warned, right side, %", "0.1 s before, %", "0.2 s before, %", "median lead, s",
            *(f"alarms {band}" for band in judge.bands())]
    rows = [_cells(family, of_family, way) for family, of_family in (*_of_families(results), ("both", results))
            for way in ways.ALL]
    return markdown.table(head, rows, range(2, len(head)))


def _by_manoeuvre(results):
    rows = []
    for family, of_family in _of_families(results):
        for kind in manoeuvres.KINDS:
            cells = [family, kind]
            for way in ways.ALL:
                of_kind = [each for each in outcomes_of(of_family, way) if each.manoeuvre == kind]
                share = detection(of_kind).warned_100ms
                cells.append(f"{share.count} of {share.total}" if share.total else "-")
            rows.append(cells)
    return markdown.table(["family", "", *ways.ALL], rows, range(2, 2 + len(ways.ALL)))


def _range(values, digits):
    return f"{min(values):.{digits}f} to {max(values):.{digits}f}"


def _classes(results):
    """Family, class and results of each class that was driven."""
    for family, of_family in _of_families(results):
        for kind in dict.fromkeys(result.kind for result in of_family):
            yield family, kind, [result for result in of_family if result.kind == kind]


def _by_class(results):
    rows = []
    for family, kind, of_class in _classes(results):
        found = detection(outcomes_of(of_class, ways.ERRORS))
        alarms = list(found.alarms.values())[:-1]
        true_over_computed = statistics.median(result.quantities[quantities.TRUE_OVER_COMPUTED] for result in of_class)
        factors = [result.quantities["static stability factor"] for result in of_class]
        rows.append([family, kind, str(len(of_class)), _range(factors, 2), f"{true_over_computed:.2f}", str(found.warned.total),
                     *(str(share.count) for share in (found.warned, found.warned_100ms, found.warned_200ms)),
                     f"{found.median_lead_s:.2f}" if found.warned.count else "-",
                     f"{sum(share.count for share in alarms)} of {sum(share.total for share in alarms)}"])
    head = ["family", "class", "vehicles", "static stability factor", quantities.TRUE_OVER_COMPUTED, "lift-offs",
            "warned, right side", "0.1 s before", "0.2 s before", "median lead, s", "alarms below 0.9"]
    return markdown.table(head, rows, range(2, len(head)))


def _limits(results):
    rows = []
    for family, kind, of_class in _classes(results):
        limits = [result.tyre_limit_mps2 / GRAVITY_MPS2 for result in of_class]
        excess = [result.largest_lateral_acceleration_mps2 / result.tyre_limit_mps2 - 1.0 for result in of_class]
        over = [each for each in excess if each > 0.0]
        rows.append([family, kind, _range(limits, 2), f"{len(over)} of {len(of_class)}",
                     f"{100 * statistics.median(over):.0f} %, {100 * max(over):.0f} %" if over else "-"])
    return markdown.table(["family", "class", "limit, g", "exceed it", "by"], rows, range(2, 5))


def _spread(values):
    low, middle, high = min(values), statistics.median(values), max(values)
    return f"{low:.3g} to {high:.3g} ({middle:.3g})"


def _beside(results):
    population, rows, of_families = quantities.of_population(), [], list(_of_families(results))
    for name, unit in quantities.NAMES:
        low, high = population.get(name, (float("-inf"), float("inf")))
        cells = [name, unit, f"{low:.3g} to {high:.3g}" if name in population else "-"]
        for _, of_family in of_families:
            values = [result.quantities[name] for result in of_family if name in result.quantities]
            cells += [_spread(values), str(sum(not low <= value <= high for value in values)) if name in population else "-"]
        rows.append(cells)
    head = ["", "unit", "population", *(cell for family, _ in of_families for cell in (family, "outside"))]
    return markdown.table(head, rows, range(2, len(head)))


def _ends():
    tables = []
    for module in families.FAMILIES.values():
        classes, rows = module.ends(), []
        for name in dict.fromkeys(name for drawn in classes.values() for name in drawn):
            rows.append([name.replace("_", " "), *(f"{drawn[name][0]:g} to {drawn[name][1]:g}" if name in drawn else "-"
                                                   for drawn in classes.values())])
        tables.append(markdown.table(["", *classes], rows, range(1, 1 + len(classes))))
    return "\n\n".join(tables)


def _refused(results):
    counts = {way: sum(result.outcomes[way] is None for result in results) for way in ways.ALL}
    named = [f"{count} with {way}" for way, count in counts.items() if count]
    return f" Vehicles left out, because the component does not admit their calibration: {', '.join(named)}." if named else ""


def _inertia_assumed(results):
    classes = [result.kind for result in results if result.inertia_assumed]
    named = ", ".join(f"{classes.count(kind)} of {kind}" for kind in dict.fromkeys(classes))
    return f"\n  With the rule of thumb's roll inertia, since the drives give none that a body can have: {named}." if named else ""


def page(results, seed):
    noise = manoeuvres.NOISE
    compared_least, compared_most = quantities.COMPARED_LTR
    counts = {family: sum(result.family == family for result in results) for family in families.FAMILIES}
    counted = "vehicles" if min(counts.values()) >= judge.fewest_vehicles() else "runs"
    return HEAD.format(
        **counts, inertia_assumed=_inertia_assumed(results), seed=seed, ramp_speed=manoeuvres.RAMP_SPEED_KMH,
        ramp_stop=manoeuvres.RAMP_STOP, kinds=", ".join(manoeuvres.KINDS), slowest=manoeuvres.SPEEDS_KMH[0],
        fastest=manoeuvres.SPEEDS_KMH[1], least=manoeuvres.AMPLITUDES[0], most=manoeuvres.AMPLITUDES[1],
        gentle_least=manoeuvres.GENTLE_AMPLITUDES[0], gentle_most=manoeuvres.GENTLE_AMPLITUDES[1],
        noise=f"{noise['lateral_acceleration_mps2'] / GRAVITY_MPS2:g} g, {noise['roll_rate_degps']:g} deg/s, "
              f"{noise['roll_angle_deg']:g} deg roll, {noise['speed_mps'] * 3.6:g} km/h, "
              f"{noise['steering_wheel_angle_deg']:g} deg at the handwheel; rms",
        height_error=100 * ways.CG_HEIGHT_ERROR, stiffness_error=100 * ways.STIFFNESS_ERROR, open_limit=ways.OPEN_LIMIT,
        results=results_table(results), counted=counted, refused=_refused(results), by_manoeuvre=_by_manoeuvre(results),
        by_class=_by_class(results), limits=_limits(results), beside=_beside(results), compared_least=compared_least,
        compared_most=compared_most, ends=_ends())
