"""The one table of budgets, and what in it breaks a limit."""

import binary_tools
import limits
from measurement import ACCESS_LIBRARIES, DEFAULT, EVENTS, FAULTY_LOG, MANOEUVRES, Figures, stages

HEAD_1 = ["", "R5F least", "mean", "most", "worst case", "M4F least", "mean", "most", "worst case"]
HEAD_2 = ["goal", "limit", ""]
TARGETS = ("cortex-r5f", "cortex-m4f")


def _number(value):
    if value is None:
        return ""
    return f"{value:.2f}" if isinstance(value, float) and value < 10 else f"{value:,.0f}"


class Table:
    """Rows of four figures a target: least, mean, most over whole manoeuvres, most of the worst case."""

    def __init__(self, held_to):
        self._limits = held_to
        self.rows = []
        self.broken = []
        self.slack = []

    def heading(self, text):
        self.rows.append([f"**{text}**"] + [""] * (len(HEAD_1) + len(HEAD_2) - 1))

    def row(self, name, figures, key=None):
        """`figures`: by target, a list of up to four numbers; the last of them is what `key` holds to a limit."""
        cells = [name]
        for target in TARGETS:
            values = figures.get(target) or []
            cells += [_number(value) for value in ([None] * (4 - len(values)) + list(values))]
        self.rows.append(cells + self._judgement(name, figures, key))

    def _judgement(self, name, figures, key):
        if key is None:
            return ["", "", ""]
        verdicts, shown = [], []
        for target in TARGETS:
            if not figures.get(target):
                continue
            value = figures[target][-1]
            limit = self._limits.limit(key, target)
            verdict = self._limits.verdict(key, target, value)
            verdicts.append(verdict)
            shown.append(_number(limit))
            if verdict == limits.OVER:
                self.broken.append(
                    f"{name} on {target}: {_number(value)}, the limit is {_number(limit)} ({key} in limits.toml)"
                )
            if self._limits.is_slack(key, target, value):
                self.slack.append(f"{name} on {target} is {_number(value)}: its limit can be lowered ({key})")
        worst = next(v for v in (limits.OVER, limits.MISSED, limits.MET) if v in verdicts)
        return [_number(self._limits.goal(key)), ", ".join(dict.fromkeys(shown)), worst]

    def markdown(self):
        lines = [HEAD_1 + HEAD_2, *self.rows]
        numbers = range(1, len(lines[0]) - 1)
        widths = [max(3, *(len(line[i]) for line in lines)) for i in range(len(lines[0]))]
        marks = ["-" * (w - 1) + ":" if i in numbers else "-" * w for i, w in enumerate(widths)]
        lines = [
            [cell.rjust(w) if i in numbers else cell.ljust(w) for i, (cell, w) in enumerate(zip(line, widths))]
            for line in lines
        ]
        return "\n".join("| " + " | ".join(line) + " |" for line in [lines[0], marks, *lines[1:]]) + "\n"


def _of_steps(measured, estimator, values):
    """Least, mean, most over the manoeuvres and most over the worst case of `values(steps)`."""
    whole = Figures(v for name in MANOEUVRES for v in values(measured.steps[estimator, name]))
    worst = max(values(measured.steps[estimator, "worst-case"]))
    return [whole.least, whole.mean, whole.most, max(whole.most, worst)]


def _step(measured, estimator):
    figures = _of_steps(measured, estimator, lambda steps: steps.counts)
    figures[3] = max(figures[3], *measured.search[estimator, "search"].counts)
    return figures


def _instructions(table, measurements, operations):
    def rows(estimator, function):
        return {m.target: function(m, estimator) for m in measurements}

    table.heading("Instructions of rsi_step()")
    default = rows(DEFAULT, _step)
    table.row("step, default estimator", default, "step_most")
    table.row(
        "most expensive step over the manoeuvres' mean",
        {target: [figures[3] / figures[1]] for target, figures in default.items()},
        "step_most_over_mean",
    )
    _bounds_of_step(table, measurements, default)
    table.row("Component::reset(), in place of init within a cycle", {m.target: [m.reset] for m in measurements})
    table.row("· upper bound", {m.target: [m.reset_bound] for m in measurements}, "reset_bound")
    table.row(
        "the reset over the most expensive step",
        {m.target: [m.reset / default[m.target][3]] for m in measurements},
        "reset_over_step",
    )
    _stages(table, measurements, DEFAULT)
    floats = {m.target: _of_steps(m, DEFAULT, lambda steps: [c.operations for c in steps.calls]) for m in measurements}
    table.row("floating-point operations in a step", floats)
    table.row("instructions an operation", {t: [default[t][1] / floats[t][1]] for t in floats})
    published = rows("published", _step)
    table.row("step, published estimator", published)
    _stages(table, measurements, "published")
    _update(table, measurements, operations, published)


def _bounds_of_step(table, measurements, default):
    """Upper bounds by path analysis, of either estimator."""
    bounds = {m.target: [m.step_bound] for m in measurements}
    table.row("upper bound, either estimator", bounds, "step_bound")
    table.row(
        "· over the most expensive step that was found",
        {m.target: [m.step_bound / default[m.target][3]] for m in measurements},
        "step_bound_over_most",
    )
    as_turned = {m.target: [m.step_bound_as_turned] for m in measurements}
    table.row("· each loop as often as traced", as_turned)


def _init(table, measurements):
    table.heading("Instructions of rsi_init()")
    table.row("init", {m.target: [m.init_most] for m in measurements}, "init_most")
    table.row("upper bound", {m.target: [m.init_bound] for m in measurements}, "init_bound")
    ratios = {m.target: [m.init_bound / m.init_most] for m in measurements}
    table.row("· over the most expensive init that was found", ratios)


def _stages(table, measurements, estimator):
    _parts(table, "step", lambda values: {m.target: _of_steps(m, estimator, values) for m in measurements}, "order, outputs")


def _parts(table, root, figures_of, rest):
    """A row a stage of `root` and one for the rest; `figures_of(values)`: by target, of `values(steps)`."""
    for stage in stages(root):
        name = ("· · of it: " if stage.get("part") else "· ") + stage["name"]
        table.row(name, figures_of(lambda s: s.within(stage["functions"])), stage.get("key"))
    named = [name for stage in stages(root) if not stage.get("part") for name in stage["functions"]]
    remain = lambda s: [call.instructions - sum(call.within[name] for name in named) for call in s.calls]
    table.row(f"· the rest: {rest}", figures_of(remain))


def _of_cycles(measured, values):
    """Least, mean, most over the manoeuvres and most with the faulty recording."""
    whole = Figures(v for name in MANOEUVRES for v in values(measured.cycles[name]))
    return [whole.least, whole.mean, whole.most, max(whole.most, *values(measured.cycles[FAULTY_LOG]))]


def _cycles(table, measurements):
    table.heading("Instructions of a cycle of the ECU, frames to frames")

    def figures_of(values):
        return {m.target: _of_cycles(m, values) for m in measurements}

    table.row("cycle: RolloverEcu::step()", figures_of(lambda s: s.counts), "cycle_most")
    bounds = {m.target: [m.cycle_bound] for m in measurements}
    table.row("upper bound, most frames received", bounds, "cycle_bound")
    most = figures_of(lambda s: s.counts)
    ratios = {m.target: [m.cycle_bound / most[m.target][3]] for m in measurements}
    table.row("· over the most expensive cycle that was found", ratios)
    as_turned = {m.target: [m.cycle_bound_as_turned] for m in measurements}
    table.row("· each loop as often as traced", as_turned)
    _parts(table, "cycle", figures_of, "order")
    table.row(
        "more with XCP and diagnosis, not connected",
        {m.target: _of_access_cycles(m, is_event=False) for m in measurements},
        "access_cycle_most",
    )
    table.row(
        "· the same in a cycle in which a trouble code changes or is stored",
        {m.target: _of_access_cycles(m, is_event=True) for m in measurements},
        "access_event_most",
    )


def _of_access_cycles(measured, is_event):
    """Instructions more than without XCP and diagnosis, of the cycles with an event or of all others: least, mean and most
    over the manoeuvres, and most with the faulty recording."""

    def more(log):
        pairs = zip(measured.cycles[log].calls, measured.access_cycles[log].calls, strict=True)
        return [
            with_them.instructions - without.instructions
            for without, with_them in pairs
            if any(with_them.within[name] for name in EVENTS) == is_event
        ]

    whole = Figures(value for log in MANOEUVRES for value in more(log))
    return [whole.least, whole.mean, whole.most, max(whole.most, *more(FAULTY_LOG))]


def _update(table, measurements, operations, published):
    table.heading("Instructions of one least-squares update, three parameters")
    name = ["rsi::RobustLeastSquares::update"]
    update = {m.target: _of_steps(m, "published", lambda steps: steps.within(name)) for m in measurements}
    for figures in update.values():
        figures[0] = min(x for x in figures if x)  # a step without a measurement has no update
    table.row("the firmware's", update, "least_squares_most")
    book = {m.target: m.textbook_update for m in measurements}
    table.row("the same with dynamic-size Eigen matrices", {t: [f.least, f.mean, f.most, f.most] for t, f in book.items()})
    table.row(
        "step, published estimator, if it had those (sum)",
        {t: [published[t][1] - update[t][1] + book[t].mean] for t in book},
    )
    table.row("floor: operations on floats that the equations need", {m.target: [operations] for m in measurements})
    table.row("the firmware's over the floor", {t: [f[3] / operations] for t, f in update.items()})
    table.row("dynamic-size Eigen over the floor", {t: [f.mean / operations] for t, f in book.items()})


def _memory(table, measurements):
    table.heading("Bytes")

    def row(name, value, key=None):
        table.row(name, {m.target: [value(m)] for m in measurements if value(m) is not None}, key)

    row("code of the library", lambda m: m.library_size["code"], "library_code_bytes")
    row("constants of the library", lambda m: m.library_size["constants"], "library_constant_bytes")
    row("static RAM", lambda m: m.library_size["data"] + m.library_size["zeroed data"], "library_ram_bytes")
    row("rsi::Component, all state", lambda m: m.component_bytes, "component_bytes")
    row("whole image, flash", lambda m: m.image_size and m.image_size["flash"], "image_flash_bytes")
    row("whole image, static RAM", lambda m: m.image_size and m.image_size["ram"])
    row("stack of rsi_step(): bound by the call graph", lambda m: m.step_stack, "step_stack_bytes")
    row("· as painted on the target", lambda m: m.step_painted)
    row("stack of rsi_init(): bound by the call graph", lambda m: m.init_stack, "init_stack_bytes")
    row("· as painted on the target", lambda m: m.init_painted)


def _access_memory(table, measurements):
    table.heading("Bytes of XCP and diagnosis")

    def row(name, value, key=None):
        table.row(name, {m.target: [value(m)] for m in measurements}, key)

    for part, key in zip(ACCESS_LIBRARIES, ("xcp_code_bytes", "diagnosis_code_bytes", "seed_and_key_code_bytes"), strict=True):
        row(f"code of {part}", lambda m, part=part: m.access_code[part], key)
    row("constants beyond those of the ECU", lambda m: m.access_constants)
    row("static RAM", lambda m: m.access_static, "library_ram_bytes")
    row("all state of XCP, its seed and key among it", lambda m: m.xcp_bytes + m.seed_and_key_bytes)
    row("all state of diagnosis, the same", lambda m: m.diagnosis_bytes + m.seed_and_key_bytes)
    row("all state of both", lambda m: m.xcp_bytes + m.diagnosis_bytes + 2 * m.seed_and_key_bytes, "access_state_bytes")


def indirect_calls(measurements):
    """A sentence on calls through pointers: none in the library (that is checked), the application its platform."""
    names = sorted({name for m in measurements for name in m.application_indirect_callers})
    callers = ", ".join(f"`{name}`" for name in binary_tools.demangled(names) if name)
    return f"\nThe library makes no indirect call. The application makes its virtual calls, of hal/interface, in {callers}.\n"


def loops(measurements):
    """All loops of the traced calls with their bounds: how often a loop's first instruction is executed each time the
    loop is entered."""
    lines = [
        "\nLoops of `rsi_step`, `rsi_init`, `RolloverEcu::step` and what they call, each with the most executions of its "
        "first instruction each time it is entered: as bounded, and as traced.\n",
        "| function | loop | R5F bound | traced | M4F bound | traced | bound by |",
        "| -------- | ---- | --------: | -----: | --------: | -----: | -------- |",
    ]
    for function, code in sorted({key for m in measurements for key in m.loops}):
        found = {m.target: m.loops.get((function, code), []) for m in measurements}
        cells = [f"`{function}`", f"`{code}`".replace("|", "\\|")]
        for target in TARGETS:
            cells += [_number(max((loop[i] for loop in found[target]), default=None)) for i in (0, 1)]
        reasons = {reason: None for target in TARGETS for _, _, reason in found[target]}
        lines.append("| " + " | ".join([*cells, "; ".join(reasons)]) + " |")
    return "\n".join(lines) + "\n"


def make(measurements, operations, held_to):
    """The table of both targets."""
    table = Table(held_to)
    _instructions(table, measurements, operations)
    _init(table, measurements)
    _cycles(table, measurements)
    _memory(table, measurements)
    _access_memory(table, measurements)
    return table
