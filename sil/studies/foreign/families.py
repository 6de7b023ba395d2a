"""The families of foreign vehicles: a module each, with `draw`, `ends` and a sentence on what they are.

`draw(seed, number)` gives a vehicle: `name` and `kind`; `data()` for `rsi-sil identify`; `static_stability_factor()`; `grip()`,
the friction with all the load on two wheels; and `motion(speed_mps)`. A motion has `STEP_S`, `advance(handwheel_rad,
acceleration_mps2)`, `signals()`, `wheel_loads_n()`, `speed_mps()`, `load_transfer_ratio()` and `is_still_a_drive()`.
"""

import commonroad
import jointed

FAMILIES = {"commonroad": commonroad, "jointed": jointed}
