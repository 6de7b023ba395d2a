"""Tables of the study: runs without and with a reaction, side by side."""

import collections
import typing

import goals
import judge
import markdown

REACTIONS = {"brake": "stability function", "driver": "driver"}


def at_alarms(limit):
    return f", {100 * limit:g} % alarms"


CHOSEN = ("default warning", "published RSI" + at_alarms(max(goals.EQUAL_ALARMS)))  # of the more detailed tables
TRUTH = "true_load_transfer"
TRUE_AT_OWN = "true load transfer, level of the default"
FEWEST_ALARMS = at_alarms(min(goals.EQUAL_ALARMS))


class Run(typing.NamedTuple):
    vehicle: str
    in_class: str
    manoeuvre: str
    lifted: bool  # two wheels, as the judge defines it
    largest_ltr: float
    end_s: float
    distance_m: float
    interventions: int


class Compared(typing.NamedTuple):
    """Pairs of a run without and with a reaction."""

    pairs: list

    def of(self, field, value):
        return Compared([pair for pair in self.pairs if getattr(pair[0], field) == value])

    def prevented(self):
        """Runs that lift no two wheels with a reaction, as a share of those that do without."""
        return _share([(one.vehicle, not other.lifted) for one, other in self.pairs if one.lifted])

    def caused(self):
        """Runs that lift two wheels with a reaction, as a share of those that do not without."""
        return _share([(one.vehicle, other.lifted) for one, other in self.pairs if not one.lifted])

    def calm(self):
        """The pairs whose run without a reaction is calm."""
        found = judge.each([0.0 if one.lifted else None for one, _ in self.pairs], [one.largest_ltr for one, _ in self.pairs],
                           [None] * len(self.pairs))["calm"]
        return Compared([pair for pair, calm in zip(self.pairs, found) if calm])

    def reacted(self):
        return _share([(one.vehicle, other.interventions > 0) for one, other in self.pairs])

    def interventions_per_hour(self):
        hours = sum(other.end_s for _, other in self.pairs) / 3600.0
        return sum(other.interventions for _, other in self.pairs) / hours if hours else 0.0

    def lost_m(self):
        """Mean way that a run with a reaction has lost at its end."""
        lost = [one.distance_m - other.distance_m for one, other in self.pairs if other.interventions and one.end_s == other.end_s]
        return sum(lost) / len(lost) if lost else None

    def lost_kmh(self):
        """By how much all of them are slower on the whole."""
        both = [(one, other) for one, other in self.pairs if one.end_s == other.end_s]
        time_s = sum(one.end_s for one, _ in both)
        return 3.6 * sum(one.distance_m - other.distance_m for one, other in both) / time_s if time_s else 0.0


def compare(without, having):
    """Both by number of the run. Raises ValueError unless they are of the same runs."""
    if without.keys() != having.keys():
        raise ValueError("the campaigns with and without a reaction have other runs")
    return Compared([(without[number], having[number]) for number in sorted(without)])


def _share(outcomes):
    """`outcomes`: vehicle, and whether the run counts. The interval counts vehicles."""
    vehicles = collections.defaultdict(lambda: [0, 0])
    for vehicle, counts in outcomes:
        vehicles[vehicle][0] += counts
        vehicles[vehicle][1] += 1
    return judge.share_by_vehicle([tuple(found) for found in vehicles.values()])


def cells(found, level):
    """Level, prevented and caused; without a result, such as of an index without such a level, dashes."""
    if found is None:
        return ["-", "-", "-"]
    return ["" if level is None else f"{level:.3f}", markdown.percent(found.prevented()), markdown.percent(found.caused(), 2)]


def prevention(lines):
    """`lines`: name, then cells() with and without errors."""
    head = ["reaction: to", "with errors: level", "prevented, %", "caused, %", "without errors: level", "prevented, %", "caused, %"]
    return markdown.table(head, [[name, *errors, *clean] for name, errors, clean in lines], range(1, len(head)))


def groups(compared, field):
    """`compared`: names of warnings with their results; `field` of a run makes the groups."""
    values = sorted({getattr(one, field) for one, _ in compared[0][1].pairs if one.lifted})
    lines = []
    for value in values:
        parts = [found.of(field, value) for _, found in compared]
        lines.append([value, str(parts[0].prevented().total), *(markdown.percent(part.prevented()) for part in parts)])
    return markdown.table(["", "lift-offs", *(f"{name}, %" for name, _ in compared)], lines, range(1, 2 + len(compared)))


def delays(lines):
    """`lines`: warning, reaction, result."""
    found = [[name, f"{reaction.delay_s:g}", f"{reaction.size:g}", markdown.percent(result.prevented()), markdown.percent(result.caused(), 2)]
             for name, reaction, result in lines]
    return markdown.table(["reacts to", "delay, s", "deceleration, m/s2", "prevented, %", "caused, %"], found, range(1, 5))


def costs(lines):
    """`lines`: warning, results of the campaign with errors and of ordinary driving."""
    found = []
    for name, errors, ordinary in lines:
        calm = errors.calm()
        lost_m = calm.lost_m()
        found.append([name, markdown.percent(calm.reacted(), 2), "-" if lost_m is None else f"{lost_m:.1f}",
                      f"{ordinary.interventions_per_hour():.2f}", f"{ordinary.lost_kmh():.3f}"])
    head = ["brakes at", "calm runs that are braked, %", "way lost in one of them, m", "braked in an hour of ordinary driving",
            "speed lost over it, km/h"]
    return markdown.table(head, found, range(1, 5))
