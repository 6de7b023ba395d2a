"""The error that a user can set right."""


class Refused(ValueError):
    """A calibration, a time series or a name is not accepted: the message says which, why, and what to do."""
