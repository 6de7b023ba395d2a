"""How often a rare event is, from a plain campaign and from campaigns that are drawn nearer to it: importance sampling.

All runs are one sample of the mixture of the campaigns' distributions; a run weighs its density under the plain settings over
that under the mixture (the balance heuristic; E. Veach and L. Guibas, SIGGRAPH 1995). Both are known, because what is drawn is
uniform between ends that the settings tell. As the plain campaign is a part of the mixture, nothing that can happen has density
0, and no weight is above the number of all runs over that of the plain ones.
"""

import json
import math
import pathlib
import tomllib
import typing

import judge
import query
import file_io
from campaign_error import CampaignError

INDEX = "predicted_load_transfer"
# Name: what it is, and for runs that may become one how far from it they are, smaller is nearer.
EVENTS = {"missed": ("lifted AND NOT warned", f"CASE WHEN lifted THEN {INDEX}_threshold END"),
          "late": ("lifted AND NOT warned_100ms", f"CASE WHEN lifted THEN {INDEX}_threshold_100ms END"),
          "alarm_below_0_7": ("band = 'below 0.7' AND warnings > 0",
                              f"CASE WHEN band = 'below 0.7' THEN -{INDEX}_threshold END"),
          "alarm_0_7_to_0_8": ("band = '0.7 to 0.8' AND warnings > 0",
                               f"CASE WHEN band = '0.7 to 0.8' THEN -{INDEX}_threshold END")}
PAIRS = ("friction_factor", "load_share", "load_height_factor")
EITHER_WAY = {"cg_height_error": ["cg_height_error"], "stiffness_error": ["stiffness_error"], "mass_error": ["mass_error"],
              "accelerometer_bias_g": ["lateral_bias_g", "vertical_bias_g"]}
DRAWN = (*PAIRS, *(column for columns in EITHER_WAY.values() for column in columns))
DIGITS = 1e-8  # to which a row tells what was drawn
NEAREST = 0.05  # share of the runs that may become an event, to which a proposal is drawn
FEWEST_NEAR = 30
AGAIN = 2  # how often a vehicle is in the proposal for each of its runs that come near, beside once as all are
HARDLY = 1e-6  # weight of a manoeuvre that does not come near
SEED_STEP = 1_000_003  # from a pilot's seed to that of the settings it proposes


def settings_of(folder):
    try:
        return tomllib.loads((folder / "campaign.toml").read_text(encoding="utf-8"))
    except OSError as error:
        raise CampaignError(f"{folder}/campaign.toml: {error.strerror}; wants the folder of a campaign") from None


def within(value, interval):
    """The density of what is uniform in it; of what is not drawn, 1."""
    lowest, highest = interval
    slack = DIGITS * max(1.0, abs(value))
    if not lowest - slack <= value <= highest + slack:
        return 0.0
    return 1.0 / (highest - lowest) if highest > lowest else 1.0


class Distribution:
    """Distributions that a campaign draws a run from."""

    def __init__(self, settings):
        self._spread = {key: settings["spread"][key] for key in PAIRS}
        for key, columns in EITHER_WAY.items():
            self._spread.update(dict.fromkeys(columns, [-settings["spread"][key], settings["spread"][key]]))
        self._manoeuvres, self._vehicles = {}, {}
        weights = sum(manoeuvre["weight"] for manoeuvre in settings["manoeuvre"])
        for place, manoeuvre in enumerate(settings["manoeuvre"]):
            self._manoeuvres.setdefault(manoeuvre["name"], []).append((place, manoeuvre["weight"] / weights, manoeuvre))
        for vehicle in settings["vehicle"]:
            self._vehicles.setdefault(pathlib.Path(vehicle["parameters"]).stem, []).append(vehicle)
        self._count = len(settings["vehicle"])

    def density(self, row):
        """Weight of a row, a dict of columns."""
        spread = math.prod(within(row[name], interval) for name, interval in self._spread.items())
        driven = 0.0
        for vehicle in self._vehicles.get(row["vehicle"], ()) if spread else ():
            for place, share, manoeuvre in self._manoeuvres.get(row["manoeuvre"], ()):
                factors = [vehicle.get(f"{name}_factors", {place: 1.0})[place] for name in ("speed", "steering")]
                driven += share / self._count * math.prod(
                    within(row[f"{name}_factor"] / factor, manoeuvre[f"{name}_factor"]) / factor
                    for name, factor in zip(("speed", "steering"), factors))
        return spread * driven

    def fixed(self):
        """Quantities with a single value: they must be the same in all campaigns."""
        return {name: tuple(ends) for name, ends in self._spread.items() if ends[0] == ends[1]}


def rest_of(settings):
    """Settings that must agree in campaigns that are weighed together."""
    spread = {key: value for key, value in settings["spread"].items() if key not in (*PAIRS, *EITHER_WAY)}
    vehicles = {pathlib.Path(vehicle["parameters"]).stem: vehicle for vehicle in settings["vehicle"]}
    program = settings.get("made_with", {}).get("program")
    return spread, vehicles, settings.get("changes"), settings.get("learning_s"), program


def check_alike(folders, all_settings):
    plain, seeds = all_settings[0], set()
    for folder, settings in zip(folders, all_settings):
        rest, wanted = rest_of(settings), rest_of(plain)
        known = all(wanted[1].get(name) == vehicle for name, vehicle in rest[1].items())
        places = {m["name"]: m["duration_s"] for m in plain["manoeuvre"]}
        driven = all(places.get(m["name"]) == m["duration_s"] for m in settings["manoeuvre"])
        if rest[0] != wanted[0] or rest[2:] != wanted[2:] or not known or not driven or (
                Distribution(settings).fixed() != Distribution(plain).fixed()):
            raise CampaignError(f"{folder}: is of another kind than {folders[0]}: only weights, ends, seed, and which vehicles how "
                                "often may differ; the same program drives both")
        if settings["seed"] in seeds:
            raise CampaignError(f"{folder}: has the seed of another; the runs would not be independent")
        seeds.add(settings["seed"])
    if any(seed + SEED_STEP in seeds for seed in seeds):
        raise CampaignError("one of the campaigns is the pilot from whose runs another was proposed; weighed together they would "
                            "be biased: take a plain campaign of another seed in its place")


class Estimate(typing.NamedTuple):
    events: int
    runs: int
    share: float  # of runs of the plain mixture
    interval: tuple
    trials: float  # plain runs that would tell as much


def estimate(samples, runs_plain):
    """`samples`: for each campaign, of each run its weight where the event is in it, else 0."""
    runs = sum(map(len, samples))
    events = sum(weight > 0 for sample in samples for weight in sample)
    share = math.fsum(map(math.fsum, samples)) / runs
    if events == 0:  # nothing to see a variance of: what the plain runs alone say
        return Estimate(0, runs, 0.0, judge.wilson_interval(0.0, runs_plain), runs_plain)
    variance = 0.0
    for sample in samples:
        mean = math.fsum(sample) / len(sample)
        variance += math.fsum((weight - mean) ** 2 for weight in sample) / max(len(sample) - 1, 1) * len(sample) / runs**2
    trials = share * (1 - share) / variance if variance > 0 and share < 1 else runs
    return Estimate(events, runs, share, judge.wilson_interval(min(share, 1.0), trials), trials)


def plainly(sample):
    """Estimate from a plain campaign's runs alone."""
    return estimate([[float(weight > 0) for weight in sample]], len(sample))


def weighed(folders, program, what):
    """The samples of estimate(), and the weights of all runs."""
    all_settings = [settings_of(folder) for folder in folders]
    check_alike(folders, all_settings)
    distributions = [Distribution(settings) for settings in all_settings]
    columns = ("vehicle", "manoeuvre", "speed_factor", "steering_factor", *DRAWN)
    rows = [query.open_rows(folder.resolve(), program.resolve()).execute(
        f"SELECT coalesce({what}, false), {', '.join(columns)} FROM drawn ORDER BY run").fetchall() for folder in folders]
    shares = [len(of_folder) / sum(map(len, rows)) for of_folder in rows]
    weights = []
    for folder, of_folder in zip(folders, rows):
        weights.append([])
        for _, *cells in of_folder:
            densities = [distribution.density(dict(zip(columns, cells))) for distribution in distributions]
            mixture = sum(share * density for share, density in zip(shares, densities))
            if not mixture:
                raise CampaignError(f"{folder}: has a run that its campaign.toml does not draw")
            weights[-1].append(densities[0] / mixture)
    samples = [[weight if row[0] else 0.0 for weight, row in zip(*both)] for both in zip(weights, rows)]
    return samples, weights


def toml_of(settings):
    """Settings of a campaign as TOML."""
    def lines(table):
        return "".join(f"{key} = {json.dumps(value)}\n" for key, value in table.items())

    top = {key: value for key, value in settings.items() if not isinstance(value, (dict, list)) or key == "changes"}
    text = lines(top) + "\n[spread]\n" + lines(settings["spread"])
    for kind in ("vehicle", "manoeuvre"):
        text += "".join(f"\n[[{kind}]]\n" + lines(table) for table in settings[kind])
    return text


def propose(folder, program, event):
    """Settings that draw from about the runs of a plain campaign that come nearest to the event."""
    settings = settings_of(folder)
    distance = EVENTS[event][1]
    connection = query.open_rows(folder.resolve(), program.resolve())
    rows = connection.execute(f"SELECT vehicle, manoeuvre, speed_factor, steering_factor, friction_factor FROM drawn WHERE "
                              f"{distance} IS NOT NULL ORDER BY {distance}, run").fetchall()
    near = rows[:max(FEWEST_NEAR, int(NEAREST * len(rows)))]
    if len(near) < FEWEST_NEAR:
        raise CampaignError(f"{folder}: only {len(near)} runs can become {event}; at least {FEWEST_NEAR} are wanted: more runs")
    vehicles = {pathlib.Path(vehicle["parameters"]).stem: vehicle for vehicle in settings["vehicle"]}
    manoeuvres = []
    for place, manoeuvre in enumerate(settings["manoeuvre"]):
        of_this = [row for row in near if row[1] == manoeuvre["name"]]
        narrowed = dict(manoeuvre, weight=len(of_this) or HARDLY)
        for column, key in ((2, "speed"), (3, "steering")):
            drawn = [row[column] / vehicles[row[0]].get(f"{key}_factors", {place: 1.0})[place] for row in of_this]
            narrowed[f"{key}_factor"] = narrower(drawn, manoeuvre[f"{key}_factor"])
        manoeuvres.append(narrowed)
    spread = dict(settings["spread"])
    spread["friction_factor"] = narrower([row[4] for row in near], spread["friction_factor"])
    left = {key: value for key, value in settings.items() if key != "made_with"}
    return toml_of({**left, "seed": settings["seed"] + SEED_STEP, "spread": spread, "manoeuvre": manoeuvres,
                    "vehicle": [*settings["vehicle"], *(vehicles[row[0]] for row in near for _ in range(AGAIN))]})


def narrower(values, interval):
    """About these values, and in the interval."""
    if len(values) < 5 or interval[0] == interval[1]:
        return list(interval)
    room = 2 * (max(values) - min(values)) / len(values) + 1e-6  # few say little of where the ends are
    return [max(interval[0], min(values) - room), min(interval[1], max(values) + room)]


def per_million(value):
    return f"{float(f'{1e6 * value:.3g}'):g}"


def answer(options):
    """The printed text."""
    if options.propose:
        if len(options.folders) != 1:
            raise CampaignError("--propose wants one folder, of a plain campaign")
        file_io.write(options.propose, propose(options.folders[0], options.program, options.event))
        return (f"{options.propose} draws nearer to {options.event}. Drive it, and the settings of {options.folders[0]} with "
                f"another --seed; then: sil/tools/campaign rare PLAIN NEARER --event {options.event}")
    samples, weights = weighed(options.folders, options.program, EVENTS[options.event][0])
    all_weights = [weight for of_folder in weights for weight in of_folder]
    lines = [f"{options.event}: {EVENTS[options.event][0]}; in 1,000,000 runs of {options.folders[0]}, 95 % in brackets"]
    plain = plainly(samples[0])
    for name, found in (("plain runs alone", plain), ("all, weighed", estimate(samples, len(samples[0])))):
        low, high = found.interval
        lines.append(f"{name + ':':<18}{per_million(found.share)} ({per_million(low)} to {per_million(high)}), {found.events} "
                     f"events in {found.runs} runs, worth {found.trials:.0f} plain ones")
    lines.append(f"mean weight {math.fsum(all_weights) / len(all_weights):.4f} (1 is expected), effective sample size "
                 f"{math.fsum(all_weights) ** 2 / math.fsum(w * w for w in all_weights):.0f} of {len(all_weights)}")
    return "\n".join(lines)
