"""The firmware's warning states (firmware/rsi/warning), to let any prediction warn by the same rules."""

CYCLE_S = 0.01


class WarningStates:
    """Advisory and warning with hysteresis, confirmation, hold times and side; starts when the inputs are good."""

    def __init__(self, calibration):
        self._advisory_on = calibration["advisory_on"]
        self._advisory_off = calibration["advisory_off"]
        self._warning_on = calibration["warning_on"]
        self._warning_off = calibration["warning_off"]
        self._confirmation = _samples(calibration["warning_confirmation_s"])
        self._advisory_hold = _samples(calibration["advisory_hold_s"])
        self._warning_hold = _samples(calibration["warning_hold_s"])
        self.state = "ready"
        self.side = None
        self._in_state = 0
        self._at_warning_level = 0

    def update(self, right, left):
        """One cycle; the risk of falling to either side."""
        risk, opposite = (right, left) if right >= left else (left, right)
        self._at_warning_level = self._at_warning_level + 1 if risk >= self._warning_on else 0
        state = self._next_state(risk)
        if state != self.state:
            self.state, self._in_state = state, 0
        self._in_state += 1
        self.side = None if state == "ready" else self._next_side(risk, "right" if right >= left else "left", opposite)

    def _next_state(self, risk):
        if 0 < self._at_warning_level >= self._confirmation:
            return "warning"
        if self.state == "warning":
            if risk >= self._warning_off or self._in_state < self._warning_hold:
                return "warning"
            return "advisory" if risk >= self._advisory_off else "ready"
        if self.state == "advisory":
            return "advisory" if risk >= self._advisory_off or self._in_state < self._advisory_hold else "ready"
        return "advisory" if risk >= self._advisory_on else "ready"

    def _next_side(self, risk, larger, opposite):
        riskier = larger if risk >= self._advisory_off else None
        if self.side is None or opposite < self._advisory_off:
            return riskier
        level = self._warning_on if self.state == "warning" else self._advisory_on
        takes_over = risk >= level or (risk >= self._advisory_on and opposite < self._advisory_on)
        return riskier if takes_over else self.side


def _samples(time_s):
    return int(time_s / CYCLE_S + 0.5)


def largest_threshold(calibration, risks):
    """The largest threshold at which these risks, of the larger side and of every cycle, raise an alarm."""
    needed = max(1, _samples(calibration["warning_confirmation_s"]))
    return max((min(risks[end - needed:end]) for end in range(needed, len(risks) + 1)), default=0.0)
