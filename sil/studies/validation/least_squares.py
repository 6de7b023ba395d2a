"""The paper's least squares on the signals of a run, with and without what it adds: observed disturbance, normalising.

Written from docs/theory.md, in double precision. It shares nothing with the firmware but the measured signals and the
roll of the fixed model.
"""

import math

# Additions: observing the disturbance, normalising. With both it is the paper's.
VARIANTS = [
    ("none", False, False),
    ("normalisation", False, True),
    ("disturbance observer", True, False),
    ("both", True, True),
]
SCALES = ["initial_roll_centre_deviation_m", "initial_stiffness_deviation_nmprad", "initial_damping_deviation_nmsprad"]


def regression(run, calibration):
    """Y and psi of (5) in every cycle."""
    m_s, K_f, c_f = (calibration[k] for k in ("sprung_mass_kg", "roll_stiffness_nmprad", "roll_damping_nmsprad"))
    H = calibration["sprung_cg_height_m"] - calibration["fixed_roll_centre_height_m"]
    columns = ("road_parallel_force_mps2", "road_normal_force_mps2", "fixed_model_roll_angle_deg",
               "sensor_roll_angle_deg", "sensor_roll_rate_degps")
    rows = []
    for A, N, *degrees in zip(*(run[column] for column in columns)):
        phi_f, phi_m, rate_m = map(math.radians, degrees)
        rate_f = (m_s * H * (A + N * math.tan(phi_f)) - K_f * phi_f) / c_f
        Y = c_f * (rate_f - rate_m) + (K_f - m_s * N * H) * (phi_f - phi_m)
        rows.append((Y, (m_s * (A + N * math.tan(phi_m)), phi_m, rate_m)))
    return rows


def movements(rows, calibration, observes, normalises, added_nm=0.0):
    """dh in every cycle, m. `added_nm` is a constant moment that the model does not know: a load off the middle."""
    scale = [calibration[key] for key in SCALES]
    alpha = 1.0 - math.exp(-2.0 * math.pi * calibration["disturbance_cutoff_hz"] * 0.01)
    size, three = calibration["regression_scale_nm"], range(3)
    P = [[1.0 if i == j else 0.0 for j in three] for i in three]
    theta, d, found = [0.0] * 3, 0.0, []
    for Y, psi in rows:
        x = [value * width / size for value, width in zip(psi, scale)]
        g = [sum(P[i][j] * x[j] for j in three) for i in three]
        s = sum(a * b for a, b in zip(x, g))
        forgets = sum(P[i][i] for i in three) <= calibration["covariance_limit"]
        forgetting = calibration["forgetting_factor"] if forgets else 1.0
        divisor = forgetting * (1.0 + s if normalises else 1.0) + s
        e = (Y + added_nm) / size - sum(a * b for a, b in zip(x, theta)) - d
        d += alpha * e if observes else 0.0
        theta = [t + a * e / divisor for t, a in zip(theta, g)]
        P = [[(P[i][j] - g[i] * g[j] / divisor) / forgetting for j in three] for i in three]
        found.append(theta[0] * scale[0])
    return found
