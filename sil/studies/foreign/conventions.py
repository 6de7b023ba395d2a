"""Conventions of all foreign vehicles."""

GRAVITY_MPS2 = 9.81
WHEELS = ("front_left", "front_right", "rear_left", "rear_right")  # order of their loads


def load_transfer_ratio(loads_n):
    """From the wheel loads; positive in a left turn."""
    front_left, front_right, rear_left, rear_right = loads_n
    total = front_left + front_right + rear_left + rear_right
    return (front_right + rear_right - front_left - rear_left) / total if total else 0.0
