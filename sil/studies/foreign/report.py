"""The page of the study."""

import collections
import statistics

import judge
import manoeuvres
import markdown
import vehicle as vehicles
import ways

HEAD = """<!-- Written by sil/studies/foreign/run --document; do not edit. -->
# Vehicles of others' equations

The [population](population.md) is one model with other numbers, and that model is this project's own. The vehicles here
have other equations: the multi-body model of the package commonroad-vehicle-models (29 states; tyres, springs and
compliant joints after the vehicle dynamics of the US Department of Transportation), {count} variations of its parameter
set 3, a van, drawn with seed {seed} as high vans, SUVs and pick-ups. Nothing in firmware, identification or population
was chosen on them; the firmware is measured as it is.

- **Two changes**: a tyre without load gives no force, while that of the package holds a lifted wheel down; and a drive
  begins in equilibrium. The rest is as its authors wrote it, the tyre's jump with the sign of the camber included, which
  lets the body roll a little on the straight.
- **Calibration**: by `rsi-sil identify` alone, from the data sheet, a slowly increasing steer at {ramp_speed:.0f} km/h that
  the driver stops at |LTR| {ramp_stop}, and a calm lane change, with ideal sensors.
- **Drives**: {kinds}, open loop, {slowest:.0f} to {fastest:.0f} km/h, with {least} to {most} times
  the handwheel angle of 0.3 g; every fourth round {gentle_least} to {gentle_most} times. A drive ends soon after a lift-off.
- **Errors**: sensor noise ({noise}), and for each vehicle
  a CG height up to {height_error:.0f} % and a roll stiffness up to {stiffness_error:.0f} % off, either way.
- **Open tyre limit**: only `largest_lateral_acceleration_mps2` of the calibration is changed, times {open_limit}.
- **Judge**: that of `rsi-sil replay` and of the campaigns ([what counts](../drives.md#what-counts)); lift-off is that of
  the model's tyre forces.

## Results
{results}

In brackets: 95 % confidence, counting {counted}. Alarms are those of drives without two-wheel lift-off, by their largest
|LTR|: how many of how many.{refused}

## By manoeuvre
Lift-offs that were warned of at least 0.1 s before, of how many.

{by_manoeuvre}

## By class
{by_class}

The limit is `largest_lateral_acceleration_mps2`, as identified from the ramp. A vehicle exceeds it in its drives when its
largest lateral acceleration is greater; by how much: median and largest of the class.

## Ranges
Each quantity is drawn uniformly and independently. Factors are those on the package's parameter set.

{ends}
"""


def percent(share):
    low, high = share.interval
    return "-" if not share.total else f"{100 * share.value():.1f} ({100 * low:.1f} to {100 * high:.1f})"


def detection(outcomes):
    columns = zip(*((each.vehicle, each.lift_s, each.largest_ltr, each.lead_s, each.alarm) for each in outcomes))
    return judge.detection(*columns)


def outcomes_of(results, way):
    return [each for result in results for each in result.outcomes[way] or ()]


def _cells(results, way):
    outcomes = outcomes_of(results, way)
    found = detection(outcomes)
    shares = (found.warned, found.warned_100ms, found.warned_200ms)
    return [way, str(found.warned.total), *map(percent, shares), f"{found.median_lead_s:.2f}",
            *(f"{share.count} of {share.total}" for share in found.alarms.values())]


def results_table(results):
    head = ["", "lift-offs", "warned, right side, %", "0.1 s before, %", "0.2 s before, %", "median lead, s",
            *(f"alarms {band}" for band in judge.bands())]
    return markdown.table(head, [_cells(results, way) for way in ways.ALL], range(1, len(head)))


def _by_manoeuvre(results):
    rows = []
    for kind in manoeuvres.KINDS:
        cells = [kind]
        for way in ways.ALL:
            of_kind = [each for each in outcomes_of(results, way) if each.manoeuvre == kind]
            share = detection(of_kind).warned_100ms if of_kind else None
            cells.append(f"{share.count} of {share.total}" if share else "-")
        rows.append(cells)
    return markdown.table(["", *ways.ALL], rows, range(1, 1 + len(ways.ALL)))


def _range(values, digits):
    return f"{min(values):.{digits}f} to {max(values):.{digits}f}"


def _by_class(results):
    classes = collections.defaultdict(list)
    for result in results:
        classes[result.kind].append(result)
    rows = []
    for kind, of_class in classes.items():
        limits = [result.tyre_limit_mps2 / vehicles.GRAVITY_MPS2 for result in of_class]
        excess = [result.largest_lateral_acceleration_mps2 / result.tyre_limit_mps2 - 1.0 for result in of_class]
        over = [each for each in excess if each > 0.0]
        rows.append([kind, str(len(of_class)), _range([result.static_stability_factor for result in of_class], 2),
                     _range([result.friction for result in of_class], 2), _range(limits, 2), str(len(over)),
                     f"{100 * statistics.median(over):.0f} %, {100 * max(over):.0f} %" if over else "-"])
    return markdown.table(["class", "vehicles", "static stability factor", "friction", "limit, g", "exceed it", "by"], rows,
                          range(1, 7))


def _ends():
    rows = []
    for name in (*vehicles.FACTORS, *vehicles.DRAWN, *next(iter(vehicles.CLASSES.values()))):
        ends = [(vehicles.FACTORS | vehicles.DRAWN | kind)[name] for kind in vehicles.CLASSES.values()]
        factor = ", factor" if name in vehicles.FACTORS or name == "mass" else ""
        rows.append([name.replace("_", " ") + factor, *(f"{low:g} to {high:g}" for low, high in ends)])
    return markdown.table(["", *vehicles.CLASSES], rows, range(1, 1 + len(vehicles.CLASSES)))


def _refused(results):
    counts = {way: sum(result.outcomes[way] is None for result in results) for way in ways.ALL}
    named = [f"{count} with {way}" for way, count in counts.items() if count]
    return f" Vehicles left out, because the component does not admit their calibration: {', '.join(named)}." if named else ""


def page(results, seed):
    noise = manoeuvres.NOISE
    counted = "vehicles" if len(results) >= judge.fewest_vehicles() else "runs"
    return HEAD.format(
        count=len(results), seed=seed, ramp_speed=manoeuvres.RAMP_SPEED_KMH, ramp_stop=manoeuvres.RAMP_STOP,
        kinds=", ".join(manoeuvres.KINDS), slowest=manoeuvres.SPEEDS_KMH[0], fastest=manoeuvres.SPEEDS_KMH[1],
        least=manoeuvres.AMPLITUDES[0], most=manoeuvres.AMPLITUDES[1], gentle_least=manoeuvres.GENTLE_AMPLITUDES[0],
        gentle_most=manoeuvres.GENTLE_AMPLITUDES[1],
        noise=f"{noise['lateral_acceleration_mps2'] / vehicles.GRAVITY_MPS2:g} g, {noise['roll_rate_degps']:g} deg/s, "
              f"{noise['roll_angle_deg']:g} deg roll, {noise['speed_mps'] * 3.6:g} km/h, "
              f"{noise['steering_wheel_angle_deg']:g} deg at the handwheel; rms",
        height_error=100 * ways.CG_HEIGHT_ERROR, stiffness_error=100 * ways.STIFFNESS_ERROR, open_limit=ways.OPEN_LIMIT,
        results=results_table(results), counted=counted, refused=_refused(results), by_manoeuvre=_by_manoeuvre(results),
        by_class=_by_class(results), ends=_ends())
