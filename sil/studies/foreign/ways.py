"""The ways in which drives go through the component: with ideal or noisy sensors, with which calibration."""

import random

CLEAN, ERRORS = "clean", "errors"
CLEAN_OPEN, ERRORS_OPEN = "clean, open tyre limit", "errors, open tyre limit"
ALL = (CLEAN, ERRORS, CLEAN_OPEN, ERRORS_OPEN)
DRIVES = {CLEAN: "clean", ERRORS: "noisy", CLEAN_OPEN: "clean", ERRORS_OPEN: "noisy"}  # folder of each
CG_HEIGHT_ERROR, STIFFNESS_ERROR = 0.05, 0.1  # largest, either way
STIFFNESSES = ("roll_stiffness_nmprad", "roll_stiffness_cubic_nmprad3", "roll_stiffness_quintic_nmprad5")
TYRE_LIMIT = "largest_lateral_acceleration_mps2"
OPEN_LIMIT = 1.3  # factor on the identified one


def drawn_errors(calibration, seed, name):
    """The calibration's values that the errors change, for the vehicle of this name."""
    source = random.Random(f"errors {seed} {name}")
    height = 1.0 + source.uniform(-CG_HEIGHT_ERROR, CG_HEIGHT_ERROR)
    stiffness = 1.0 + source.uniform(-STIFFNESS_ERROR, STIFFNESS_ERROR)
    return {"sprung_cg_height_m": calibration["sprung_cg_height_m"] * height,
            **{key: calibration[key] * stiffness for key in STIFFNESSES}}


def changes(calibration, seed, name):
    """Changes of the calibration for each way."""
    errors = drawn_errors(calibration, seed, name)
    limit = {TYRE_LIMIT: OPEN_LIMIT * calibration[TYRE_LIMIT]}
    return {CLEAN: {}, ERRORS: errors, CLEAN_OPEN: limit, ERRORS_OPEN: errors | limit}
