"""Measures on the runs what docs/reports/validation.md says of them: a dictionary of texts, and the claims they must bear."""

import csv
import math
import pathlib
import sys

import least_squares
import markdown
from results import G, Run, largest, mean, rms

sys.path.append(str(pathlib.Path(__file__).resolve().parents[3] / "cmake/environment"))

import file_io  # noqa: E402

HALF_TRACK_M = 0.8
NOMINAL_HEIGHT_M = 0.281  # of the roll centre; as the calibration's fixed_roll_centre_height_m
CG_HEIGHT_M = 0.988
START_S = {"j-turn-45": 1.0, "j-turn-110": 1.0, "j-turn-banked": 12.0, "fishhook-1a": 2.0}

# In the order of the document: the column, its title there, and whether it is one of the paper's own. Those come
# from the runs with the paper's estimator; the others, of which some use the estimate, from those with the default one.
# An index of the component that is not here follows the predicted ones, under its own name.
INDICES = [
    ("published", "RSI as published, (25)", True),
    ("bank_free", "RSI bank-free", True),
    ("extended", "extended RSI", False),
    ("static_stability_factor", "SSF", True),
    ("dynamic_stability", "DSI, physical sign (27)", True),
    ("dynamic_stability_late", "DSI, printed sign", True),
    ("energy", "energy `W`, (28)", True),
    ("rollover_index", "rollover index RI, (29)", True),
    ("time_to_rollover", "time to rollover", True),
    ("load_transfer", "load transfer from the roll state", False),
    ("predicted_load_transfer", "predicted load transfer", False),
    ("predicted_rsi", "predicted RSI", False),
    ("true_load_transfer", "true \\|LTR\\|, (26): no vehicle has it", False),
]
PAPERS = tuple(column for column, _, of_the_paper in INDICES if of_the_paper)


class Claims:
    """Words in the text. A claim that no longer holds must stop the renewal, not stand in the document."""

    def __init__(self):
        self.broken = []

    def hold(self, words, condition):
        if not condition:
            self.broken.append(words)


def seconds(time_s):
    return "never" if time_s is None else f"{time_s:.3f}"


def cycle(time_s):
    return "never" if time_s is None else f"{time_s:.2f}"


def ms(later_s, earlier_s):
    return f"{1000.0 * (later_s - earlier_s):.0f}"


def load(folder):
    names = ["j-turn-45", "j-turn-110", "j-turn-banked", "fishhook-1a", "roll-centre-moving", "roll-centre-fixed"]
    return {f"{name}-{kind}": Run(folder / f"{name}-{kind}") for name in names for kind in ("published", "default")}


def levels_of(runs):
    return [name.removeprefix("level_") for name in runs["fishhook-1a-default"].names("level_")]


def indices(runs):
    """Column and title of every index that the runs have; last the true load transfer."""
    named = [index[:2] for index in INDICES]
    known = dict(named)
    return [*named[:-1], *((column, column.replace("_", " ")) for column in levels_of(runs) if column not in known), named[-1]]


def signed(value_s):
    return f"{round(value_s, 2) + 0.0:+.2f}"


def level(runs, case, column):
    """The run that an index is taken from, and its level."""
    run = runs[f"{case}-{'published' if column in PAPERS else 'default'}"]
    return run, run[f"level_{column}"]


def fig_2(runs, folder, claims):
    moving, fixed = runs["roll-centre-moving-published"], runs["roll-centre-fixed-published"]
    with open(folder / "ablation.csv", newline="", encoding="utf-8") as file:
        ablation = {
            (row["speed_kmh"], row["roll_centre"], row["suspension"]): float(row["largest_roll_deg"])
            for row in csv.DictReader(file)
        }
    over = {key: roll > 60.0 for key, roll in ablation.items()}
    speeds = sorted({key[0] for key in ablation}, key=float)
    springs = ("as it is", "without stops", "linear")
    kinds = [(centre, each) for centre in ("moving", "fixed") for each in springs]
    words = {True: "rolls over", False: "{:.1f} deg"}
    rows = [[speed, *(words[over[(speed, *kind)]].format(ablation[(speed, *kind)]) for kind in kinds)] for speed in speeds]
    claims.hold("Fig. 2: the fixed one rolls over, the moving one stays up", fixed.two_wheels() and not moving.two_wheels())
    fast = [speed for speed in speeds if float(speed) >= 64]
    claims.hold("Fig. 2: from 64 km/h on every vehicle without stops rolls over",
                all(over[(speed, centre, "without stops")] for speed in fast for centre in ("moving", "fixed")))
    claims.hold("Fig. 2: no vehicle with stops and a fixed roll centre rolls over",
                not any(over[(speed, "fixed", "as it is")] for speed in speeds))
    claims.hold(
        "Fig. 2: at 76 km/h the moving roll centre rolls over and the fixed one does not",
        over[("76", "moving", "as it is")] and not over[("76", "fixed", "as it is")],
    )
    claims.hold("Fig. 2: the published RSI reaches 1 on the vehicle that stays up", moving.first(moving["level_published"]))
    return {
        "fig2_moving_largest_roll": f"{largest(moving['true_roll_angle_deg']):.1f}",
        "fig2_fixed_two_wheels": seconds(fixed.two_wheels()),
        "fig2_moving_ltr": f"{largest(moving.within(moving['true_load_transfer_ratio'])):.3f}",
        "fig2_moving_one_wheel": "no wheel lifts" if moving.one_wheel() is None else f"one wheel lifts at {seconds(moving.one_wheel())} s",
        "fig2_moving_rsi": cycle(moving.first(moving["level_published"])),
        "fig2_table": markdown.table(["", "moving roll centre", "", "", "fixed roll centre", "", ""], [["km/h", *springs, *springs], *rows]),
    }


def figs_5_to_8(runs, claims):
    run, second = runs["j-turn-45-published"], runs["j-turn-45-default"]
    end = run.time[-1]
    steady = lambda values: mean(run.within(values, end - 2.0))
    height = [h - NOMINAL_HEIGHT_M for h in run["true_roll_centre_height_m"]]
    estimate, better = run["roll_centre_vertical_m"], second["roll_centre_vertical_m"]
    turn = lambda values: run.within(values, 1.5)
    error = lambda estimated: rms(turn([a - b for a, b in zip(estimated, height)]))
    tan = lambda degrees: math.tan(math.radians(degrees))
    lever = CG_HEIGHT_M - NOMINAL_HEIGHT_M
    true_lateral = [
        lever * tan(f) - (lever - dh) * tan(m)
        for f, m, dh in zip(run["fixed_model_roll_angle_deg"], run["true_roll_angle_deg"], height)
    ]
    roll = run["true_roll_angle_deg"]
    off = lambda of, column: rms(of.within([a - b for a, b in zip(of[column], roll)]))
    kinematic_height = run["true_kinematic_roll_centre_height_m"]
    values = {
        "j45_peak_ay": f"{largest(run.ay):.3f}",
        "j45_steady_ay": f"{steady(run.ay):.3f}",
        "j45_steady_roll": f"{steady(roll):.2f}",
        "j45_late_roll_rate": f"{largest(run.within(run['true_roll_rate_degps'], end - 2.0)):.2f}",
        "j45_rsi": f"{max(run['level_published']):.3f}",
        "j45_true_dh_mm": f"{1000 * steady(height):.0f}",
        "j45_published_dh_mm": f"{1000 * steady(estimate):.0f}",
        "j45_second_dh_mm": f"{1000 * steady(better):.0f}",
        "j45_published_dh_rms_mm": f"{1000 * error(estimate):.0f}",
        "j45_second_dh_rms_mm": f"{1000 * error(better):.0f}",
        "j45_constant_dh_rms_mm": f"{1000 * rms(turn(height)):.0f}",
        "j45_published_lateral_mm": f"{1000 * steady(run['roll_centre_lateral_m']):.1f}",
        "j45_second_lateral_mm": f"{1000 * steady(second['roll_centre_lateral_m']):.1f}",
        "j45_true_lateral_mm": f"{1000 * steady(true_lateral):.1f}",
        "j45_kinematic_steady_mm": f"{1000 * steady(run['true_roll_centre_lateral_m']):.0f}",
        "j45_kinematic_largest_mm": f"{1000 * largest(run.within(run['true_roll_centre_lateral_m'])):.0f}",
        "j45_kinematic_vertical_mm": f"{1000 * (max(kinematic_height) - min(kinematic_height)):.0f}",
        "j45_published_roll_rms": f"{off(run, 'compensated_roll_angle_deg'):.2f}",
    }
    start = START_S["j-turn-45"]
    spans = [(-math.inf, end), (start, start + 2.0), (end - 2.0, end)]
    errors = {}
    for name, of, column in (("simple model", run, "fixed_model_roll_angle_deg"),
                             ("compensated, published estimates", run, "compensated_roll_angle_deg"),
                             ("compensated, second estimator's estimates", second, "compensated_roll_angle_deg")):
        difference = [a - b for a, b in zip(of[column], roll)]
        errors[name] = [rms(of.within(difference, *span)) for span in spans]
    values["fig7_table"] = markdown.table(["", "whole run", "transient", "steady"],
                                          [[name, *(f"{error:.2f}" for error in row)] for name, row in errors.items()])
    simple, *compensated = errors.values()
    claims.hold("Fig. 7: both compensated models are better than the simple one, in transient and steady state",
                all(row[k] < simple[k] for row in compensated for k in (1, 2)))
    claims.hold("Fig. 5: below 0.8 g, near 6 degrees, no wheel lifts", largest(run.ay) < 0.8 and abs(steady(roll) - 6.0) < 1.0 and not run.one_wheel())
    claims.hold("Fig. 6: the published height is far off, the second near", error(estimate) > 5 * rms(turn(height)) and error(better) < 0.5 * rms(turn(height)))
    claims.hold("Fig. 7: both compensated models are within 0.2 degrees", off(run, "compensated_roll_angle_deg") < 0.2 and off(second, "compensated_roll_angle_deg") < 0.2)
    claims.hold("Fig. 8: the RSI is not crossed", max(run["level_published"]) < 1.0)
    return values


def rollover(name, runs, claims):
    """The J-turns that roll over."""
    run, default = runs[f"{name}-published"], runs[f"{name}-default"]
    key = {"j-turn-110": "j110", "j-turn-banked": "banked"}[name]
    start = START_S[name]
    two, one = run.two_wheels(), run.one_wheel()
    crossing = run.first(run["level_published"])
    ssf = run.summary["ssf_crossing_time_s"]
    claims.hold(f"{name}: RSI, one wheel, two wheels", start < crossing < one < two)
    claims.hold(f"{name}: the default warning is in force with the right side as two wheels lift",
                default.summary["lead_time_s"] is not None)
    values = {
        f"{key}_rsi_s": cycle(crossing),
        f"{key}_rsi_ay": f"{run.at(run.ay, crossing):.3f}",
        f"{key}_one_s": seconds(one),
        f"{key}_two_s": seconds(two),
        f"{key}_two_ay": f"{run.at(run.ay, two):.3f}",
        f"{key}_ssf_s": seconds(ssf),
        f"{key}_ssf_ay": f"{run.at(run.ay, ssf):.3f}",
        f"{key}_rsi_lead": f"{two - crossing:.2f}",
    }
    if key == "banked":
        claims.hold("banked: the SSF is crossed before the RSI", ssf < crossing)
        values["banked_two_roll"] = f"{run.at(run['true_roll_angle_deg'], two):.2f}"
        values["banked_two_horizon"] = f"{run.at(run['true_roll_to_horizon_deg'], two):.2f}"
    else:
        claims.hold("J-turn 110: the SSF comes last", ssf > two)
        values["j110_ssf_after"] = ms(ssf, two)
    values.update(on_its_side(run, key, claims))
    return values


def on_its_side(run, key, claims):
    """Lateral acceleration of a vehicle that rolls over: its largest, and at 60 degrees."""
    end = next(t for t, roll in zip(run.time, run["true_roll_angle_deg"]) if abs(roll) >= 60.0)
    highest, last = largest(run.within(run.ay, end_s=end)), abs(run.at(run.ay, end))
    claims.hold(f"{key}: the lateral acceleration falls to a fifth at most", last < 0.2 * highest)
    return {f"{key}_largest_ay": f"{highest:.2f}", f"{key}_last_ay": f"{last:.2f}"}


def second_turn_s(run):
    """When the lateral acceleration of the fishhook's first turn has passed zero."""
    return next(t for t, a in zip(run.time, run.ay) if t > 2.4 and a < 0.0)


def fishhook(runs, claims):
    run = runs["fishhook-1a-published"]
    turn = second_turn_s(run)
    two, one = run.two_wheels(turn), run.one_wheel(turn)
    moments = [(one, "one wheel", seconds(one)), (two, "two wheels", seconds(two))]
    rows = []
    second = {}
    for column, name in indices(runs):
        source, levels = level(runs, "fishhook-1a", column)
        first = source.first(levels, end_s=turn)
        second[column] = source.first(levels, begin_s=turn)
        rows.append([name, cycle(first), f"{max(source.within(levels, end_s=turn)):.2f}", cycle(second[column])])
    claims.hold("the runs have each index of INDICES", {column for column, *_ in INDICES} <= set(levels_of(runs)))
    named = {"published": "RSI", "energy": "energy", "rollover_index": "RI", "dynamic_stability": "DSI with the physical sign",
             "dynamic_stability_late": "DSI with the printed one", "static_stability_factor": "SSF"}
    moments += [(second[column], name, cycle(second[column])) for column, name in named.items()]
    claims.hold("fishhook: energy and RI come between one wheel and two", one < second["energy"] < two and one < second["rollover_index"] < two)
    claims.hold("fishhook: both DSI come after two wheels, the physical one first",
                two < second["dynamic_stability"] < second["dynamic_stability_late"])
    first_lift = [(what, begin, end) for what, begin, end in run.lifts if begin < turn and "side" not in what]
    moments = sorted((m for m in moments if m[0] is not None), key=lambda m: m[0])
    rsi = run.first(run["level_published"], begin_s=turn)
    claims.hold("fishhook: one wheel before two in the counter-steer, one wheel lifts in the first turn", one < two and len(first_lift) == 1)
    threshold = [abs(v) / G for v in run["ecu_lateral_acceleration_threshold_mps2"]]
    exact = run.crossing([abs(a) - t for a, t in zip(run.ay, threshold)], turn)
    claims.hold("fishhook: RSI between one wheel and the cycle of two", one < rsi <= two + 0.01)
    claims.hold("fishhook: with the true acceleration the RSI lies between one wheel and two", one < exact < two)
    claims.hold("fishhook: the published RSI is crossed in the first turn", run.first(run["level_published"], end_s=turn))
    ltr = [abs(v) for v in run["true_load_transfer_ratio"]]
    differences = run.within([a - b for a, b in zip(run["level_published"], ltr)], START_S["fishhook-1a"], two)
    counter = run.within([a - b for a, b in zip(run["level_published"], ltr)], turn, two)
    wheel, begin, end = first_lift[0]
    return {
        "fish_handwheel": f"{largest(run['true_steering_wheel_angle_deg']):.1f}",
        "fish_turn_s": cycle(turn),
        "fish_one_s": seconds(one),
        "fish_two_s": seconds(two),
        "fish_rsi_s": cycle(rsi),
        "fish_rsi_first_s": cycle(run.first(run["level_published"], end_s=turn)),
        "fish_first_wheel": wheel.replace("_", " "),
        "fish_first_begin": seconds(begin),
        "fish_first_ms": ms(end, begin),
        "fish_first_ltr": f"{max(run.within(ltr, end_s=turn)):.2f}",
        "fish_table": markdown.table(["index", "first turn", "largest there", "counter-steer"], rows),
        "fish_order": ", ".join(f"{name} {time}" for _, name, time in moments),
        "fish_rsi_ltr": f"{mean([abs(d) for d in differences]):.2f}",
        "fish_rsi_ltr_counter": f"{mean([abs(d) for d in counter]):.2f}",
        "fish_rsi_true_s": seconds(exact),
        "fish_rsi_one_after": ms(rsi, one),
    }


def lead_table(runs, calibration):
    """How long before two-wheel lift-off each index first said "warn" in the turn that rolls over."""
    rows = []
    names = ["j-turn-110", "j-turn-banked", "fishhook-1a"]
    calm = ["j-turn-45", "roll-centre-moving"]
    warning_on = calibration["warning_on"]
    chosen = (calibration["warning_indicator"], f"**the default warning's: `{calibration['warning_indicator']}` at {warning_on:g}**")
    for column, name in [*indices(runs), chosen]:
        wanted = warning_on if name is chosen[1] else 1.0
        cells = [name]
        for case in names:
            run, levels = level(runs, case, column)
            begin = second_turn_s(run) if case == "fishhook-1a" else START_S[case]
            two = run.two_wheels(begin)
            first = run.first(levels, wanted, begin_s=begin)
            cells.append("never" if first is None else signed(two - first))
        for case in calm:
            run, levels = level(runs, case, column)
            cells.append(f"{max(run.within(levels)):.2f}")
        rows.append(cells)
    return markdown.table(["index", "J-turn 110", "banked J-turn", "fishhook 1a, counter-steer", "J-turn 45, largest",
                           "Fig. 2 moving, largest"], rows)


# The indices of the paper's Fig. 15, in the order that it finds in the counter-steer.
OF_FIG_15 = {"energy": "energy", "rollover_index": "RI", "published": "RSI", "dynamic_stability": "DSI, physical sign",
             "dynamic_stability_late": "DSI, printed sign"}


def nearest(runs, claims):
    """Fig. 15 (a): which index says "warn" nearest to two-wheel lift-off, before or after it."""
    rows, closest = [], {}
    names = {"fishhook-1a": "fishhook 1a, counter-steer", "j-turn-110": "J-turn 110", "j-turn-banked": "banked J-turn"}
    for case, name in names.items():
        distances = {}
        for column, index in OF_FIG_15.items():
            run, levels = level(runs, case, column)
            begin = second_turn_s(run) if case == "fishhook-1a" else START_S[case]
            first = run.first(levels, begin_s=begin)
            distances[index] = math.inf if first is None else abs(run.two_wheels(begin) - first)
        closest[case] = min(distances, key=distances.get)
        rows.append([name, *("never" if math.isinf(d) else f"{d:.2f}" for d in distances.values()), closest[case]])
    claims.hold("Fig. 15 (a): the RSI is nearest in the fishhook, the energy in both J-turns",
                closest == {"fishhook-1a": "RSI", "j-turn-110": "energy", "j-turn-banked": "energy"})
    return {"fig15_nearest": markdown.table(["apart from two-wheel lift-off, s", *OF_FIG_15.values(), "nearest"], rows)}


def acceleration_alone(runs, claims):
    """Fig. 15 (b): a warning from the lateral acceleration alone, at the least level that spares the run of Fig. 2."""
    calm, run = runs["roll-centre-moving-published"], runs["fishhook-1a-published"]
    spared, turn = largest(calm.ay), second_turn_s(run)
    two, crossed = run.two_wheels(turn), run.crossing([abs(a) - spared for a in run.ay], turn)
    claims.hold("Fig. 15 (b): a lateral acceleration that spares Fig. 2 is less than 50 ms ahead in the fishhook",
                calm.two_wheels() is None and 0.0 < two - crossed < 0.05)
    claims.hold("Fig. 15 (b): the SSF is crossed after two-wheel lift-off on flat ground",
                all(of.first(of["level_static_stability_factor"], begin_s=begin) > of.two_wheels(begin)
                    for of, begin in ((run, turn), (runs["j-turn-110-published"], START_S["j-turn-110"]))))
    return {"alone_spared_ay": f"{spared:.3f}", "alone_lead_ms": ms(two, crossed),
            "fish_two_ay": f"{abs(run.at(run.ay, two)):.3f}"}


ADDED_NM = 500.0  # 50 kg a metre off the middle


def least_squares_errors(run, case, calibration, claims):
    """For each added moment: RMS error of the vertical movement of each variant, and last of the constant, m."""
    end = run.two_wheels() or run.time[-1]
    height = [h - NOMINAL_HEIGHT_M for h in run["true_roll_centre_height_m"]]
    rows = least_squares.regression(run, calibration)

    def error(found):
        return rms(run.within([a - b for a, b in zip(found, height)], START_S.get(case, 1.0) + 0.5, end))

    errors = {}
    for added_nm in (0.0, ADDED_NM):
        found = {name: least_squares.movements(rows, calibration, *how, added_nm)
                 for name, *how in least_squares.VARIANTS}
        if added_nm == 0.0:
            off = [a - b for a, b in zip(found["both"], run["roll_centre_vertical_m"])]
            claims.hold(f"least squares, {case}: with both it is the firmware's estimate",
                        largest(run.within(off, end_s=end)) < 0.002)
        errors[added_nm] = {name: error(movement) for name, movement in found.items()}
        errors[added_nm]["constant"] = error([0.0] * len(height))
    return errors


def least_squares_table(runs, calibration, claims):
    """The paper's least squares, without and with its additions."""
    rows = []
    names = {"j-turn-45": "J-turn 45", "roll-centre-moving": "Fig. 2 moving", "j-turn-110": "J-turn 110",
             "fishhook-1a": "fishhook 1a"}
    gains = [("normalisation", "none"), ("disturbance observer", "none"), ("both", "normalisation"),
             ("both", "disturbance observer")]
    for case, name in names.items():
        errors = least_squares_errors(runs[f"{case}-published"], case, calibration, claims)
        for added_nm, row in errors.items():
            claims.hold(f"least squares, {case}: each addition makes the error smaller",
                        all(row[with_it] < row[without] for with_it, without in gains))
            claims.hold(f"least squares, {case}: all are worse than the constant", min(row, key=row.get) == "constant")
            rows.append([name, f"{added_nm:.0f}", *(f"{1000 * error:.0f}" for error in row.values())])
        left = [row["both"] / row["normalisation"] for row in errors.values()]
        claims.hold(f"least squares, {case}: the observer gains more where there is a disturbance", left[1] < left[0])
    return {"least_squares_table": markdown.table(["", "added moment, N m", "alone", "normalisation", "disturbance observer", "both",
                                                    "constant"], rows)}


def margins(runs):
    """How far below the lateral acceleration of two-wheel lift-off the published RSI is crossed, g."""
    values = {}
    for case, key in (("j-turn-110", "j110_margin"), ("j-turn-banked", "banked_margin"), ("fishhook-1a", "fish_margin")):
        run, levels = level(runs, case, "published")
        begin = second_turn_s(run) if case == "fishhook-1a" else START_S[case]
        ay = [abs(run.at(run.ay, time)) for time in (run.two_wheels(begin), run.first(levels, begin_s=begin))]
        values[key] = f"{ay[0] - ay[1]:.3f}"
    return values


def kinematic_rest_m(folder):
    """Height of the kinematic roll centre before the J-turn begins."""
    run = Run(folder / "j-turn-45-published")
    return run.at(run["true_kinematic_roll_centre_height_m"], 0.5)


def marks(folder):
    """For the picture of Fig. 15: when each index says "warn" in the counter-steer, and where the vehicle is then."""
    run = Run(folder / "fishhook-1a-published")
    turn = second_turn_s(run)
    moments = [("OWLO", run.one_wheel(turn), "one_wheel"), ("TWLO", run.two_wheels(turn), "two_wheels")]
    names = {"energy": "W", "rollover_index": "RI", "published": "RSI", "dynamic_stability": "DSI -",
             "dynamic_stability_late": "DSI +", "static_stability_factor": "SSF"}
    moments += [(name, run.first(run[f"level_{column}"], begin_s=turn), column) for column, name in names.items()]
    lines = ["name,time_s,roll_deg,roll_rate_degps,ay_g,index"]
    for name, time, index in sorted((m for m in moments if m[1] is not None), key=lambda m: m[1]):
        place = (run.at(run[c], time) for c in ("true_roll_angle_deg", "true_roll_rate_degps"))
        lines.append(f"{name} {time:.3f} s,{time:.9g}," + ",".join(f"{v:.6f}" for v in place) + f",{run.at(run.ay, time):.6f},{index}")
    file_io.write(folder / "marks.csv", "\n".join(lines) + "\n")


def warning_table(runs):
    """The warnings themselves, with confirmation and frames: the published algorithm's, and the default one's."""
    rows = []
    for case, name in [("j-turn-45", "J-turn 45 km/h"), ("j-turn-110", "J-turn 110 km/h"), ("j-turn-banked", "banked J-turn"),
                       ("fishhook-1a", "fishhook 1a"), ("roll-centre-moving", "Fig. 2, moving"), ("roll-centre-fixed", "Fig. 2, fixed")]:
        run, default = runs[f"{case}-published"], runs[f"{case}-default"]
        cells = [name, seconds(run.one_wheel()), seconds(run.two_wheels())]
        for one in (run, default):
            warning, lead = one.summary["warning_time_s"], one.summary["lead_time_s"]
            cells.append("never" if warning is None else f"{cycle(warning)}, {one.summary['warning_side']}")
            lifted = one.summary["two_wheel_lift_time_s"] is not None
            cells.append(f"{lead:.3f}" if lead is not None else "none" if lifted else "-")
        rows.append(cells)
    return markdown.table(["case", "one wheel lifts", "two wheels lift", "published", "its lead", "default", "its lead"], rows)


def measure(folder, calibration):
    """All values of the paper's cases by name, and the claims of the text that they do not bear."""
    runs, claims = load(folder), Claims()
    claims.hold("the default estimator is the consider-Kalman filter", calibration["estimator"] == "consider_kalman")
    claims.hold("the vehicle's values of figures.py are the calibration's",
                (2 * HALF_TRACK_M, NOMINAL_HEIGHT_M, CG_HEIGHT_M)
                == tuple(calibration[k] for k in ("track_width_m", "fixed_roll_centre_height_m", "sprung_cg_height_m")))
    values = fig_2(runs, folder, claims)
    values.update(figs_5_to_8(runs, claims))
    for name in ("j-turn-110", "j-turn-banked"):
        values.update(rollover(name, runs, claims))
    values.update(fishhook(runs, claims))
    values.update(margins(runs))
    values.update(nearest(runs, claims))
    values.update(acceleration_alone(runs, claims))
    values.update(least_squares_table(runs, calibration, claims))
    values["lead_table"] = lead_table(runs, calibration)
    values["warning_indicator"] = calibration["warning_indicator"]
    values["warning_on"] = f"{calibration['warning_on']:g}"
    values["horizon_s"] = f"{calibration['prediction_horizon_s']:g}"
    values["warning_table"] = warning_table(runs)
    return values, claims.broken
