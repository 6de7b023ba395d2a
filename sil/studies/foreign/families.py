"""The families of foreign vehicles: a module each.

`draw(seed, number)` gives a vehicle: `name` and `kind`; `data()` for `rsi-sil identify`; `roll_inertia_kgm2()`;
`static_stability_factor()`; `grip()`, the friction with all the load on two wheels; and `motion(speed_mps)`. A
motion has `STEP_S`, `advance(handwheel_rad, acceleration_mps2)`, `signals()`, `wheel_loads_n()`, `speed_mps()`,
`load_transfer_ratio()` and `is_still_a_drive()`. `ends()` has both ends of what is drawn.
"""

import commonroad
import jointed

FAMILIES = {"commonroad": commonroad, "jointed": jointed}
