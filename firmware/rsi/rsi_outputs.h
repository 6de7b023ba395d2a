/* The outputs of the component: the one table of them. */
/* clang-format off */
/* write_outputs copies it into rsi.h, as rsi_outputs and rsi_indicator; rsi/output_table.hpp makes the values at
 * reset, the checks and the levels of it. A row is one of
 *
 *   CODE(name, reset, largest, risk, meaning)
 *       int32_t; 0 to `largest`.
 *   NUMBER(name, unit, mirror, presence, risk, meaning)
 *       float; NaN at reset and wherever it could not be computed.
 *   INDEX(name, unit, mirror, CHOICE, number, choice, scale, side, meaning)
 *       float, always present: a measure of the risk that can drive the warning. RSI_INDICATOR_CHOICE = number
 *       and the name `choice` select it. The numbers count from 0; a number that was once given keeps its index,
 *       for it stands in calibrations that are flashed.
 *
 * mirror, when left and right are exchanged:
 *   turns       the sign changes (ISO 8855: positive to the left)
 *   stays       it does not
 * presence:
 *   always      a number whenever there is a roll angle
 *   estimate    the same, and held to a range as well
 *   sometimes   not of every calibration, or not in every sample
 * risk:
 *   statement   part of what is said of the risk, and back at reset when that is taken back
 *   detail      not
 * scale, how the level (0 without risk, 1 warns) comes from the index:
 *   same, magnitude
 *   per_ssf     magnitude over c_w / (2 h), the static stability factor
 *   complement  1 less the index
 *   limit_over  time_to_rollover_limit_s over the index
 * side, what has the sign of the turn, so that the vehicle would fall to the other side:
 *   own (the index), force (A), acceleration (a_y), predicted (the predicted load transfer), roll (the roll angle)
 *
 * A new row adds a field to rsi_outputs and, for an index, a choice to warning_indicator. The layout of the
 * parameters stays.
 */
#ifndef RSI_RSI_OUTPUTS_H
#define RSI_RSI_OUTPUTS_H

#define RSI_OUTPUTS(CODE, NUMBER, INDEX) \
    CODE(state, RSI_STATE_UNAVAILABLE, RSI_STATE_WARNING, statement, \
         "rsi_state: what is said of the risk") \
    CODE(side, RSI_SIDE_NONE, RSI_SIDE_RIGHT, statement, \
         "rsi_side: towards which the vehicle would fall; none while neither side has the risk of an advisory") \
    CODE(roll_source, RSI_ROLL_NONE, RSI_ROLL_OBSERVER, detail, \
         "rsi_roll_source: where the roll angle in use comes from") \
    CODE(roll_sensor_disagrees, 0, 1, detail, \
         "1: the roll sensor and the observer contradict each other") \
    CODE(estimate_frozen, 0, 1, detail, \
         "1: the estimator in use learns nothing at present") \
    \
    NUMBER(warning_level, "-", stays, always, statement, \
           "level of the index that drives the warning, 0 to 20; without observer_margin and load_margin") \
    NUMBER(lateral_acceleration_mps2, "m/s^2", turns, always, statement, \
           "a_y: horizontal, of the sprung CG") \
    NUMBER(lateral_acceleration_threshold_mps2, "m/s^2", turns, always, statement, \
           "its threshold a_y*, (23), signed like the side it is for") \
    \
    NUMBER(road_parallel_force_mps2, "m/s^2", turns, always, detail, \
           "A: specific force along the road, left") \
    NUMBER(road_normal_force_mps2, "m/s^2", stays, always, detail, \
           "N: specific force normal to the road, up") \
    \
    NUMBER(fixed_model_roll_angle_rad, "rad", turns, always, detail, \
           "roll angle of the model with a fixed roll centre, phi_f, (1)") \
    NUMBER(compensated_roll_angle_rad, "rad", turns, always, detail, \
           "roll angle of that model with the additional roll moment (7)") \
    NUMBER(additional_roll_moment_nm, "N m", turns, always, detail, \
           "additional roll moment, M_add, (7)") \
    NUMBER(roll_centre_vertical_m, "m", stays, estimate, detail, \
           "dh: movement of the roll centre from its nominal height, up") \
    NUMBER(roll_centre_lateral_m, "m", turns, always, detail, \
           "c_rc, (6): lateral movement of the roll centre") \
    NUMBER(roll_stiffness_deviation_nmprad, "N m/rad", stays, estimate, detail, \
           "dK: deviation of the roll stiffness from its nominal value") \
    NUMBER(roll_damping_deviation_nmsprad, "N m s/rad", stays, estimate, detail, \
           "dc: deviation of the roll damping from its nominal value") \
    NUMBER(disturbance_nm, "N m", turns, sometimes, detail, \
           "estimated disturbance, d of (11), in units of Y") \
    NUMBER(roll_centre_deviation_m, "m", stays, sometimes, detail, \
           "standard deviation of dh; not of every estimator") \
    \
    NUMBER(opposite_load_transfer_ratio, "-", stays, always, detail, \
           "the largest towards the other side than predicted_load_transfer_ratio, 0 to 20") \
    \
    NUMBER(load_excess, "-", stays, estimate, detail, \
           "by which share m_s H is larger than calibrated, as driving has shown, -0.6 to 1; used or not") \
    NUMBER(load_excess_deviation, "-", stays, estimate, detail, \
           "standard deviation of it, 0.01 to 0.25") \
    \
    NUMBER(observed_roll_angle_rad, "rad", turns, sometimes, detail, \
           "roll angle relative to the road, without the roll sensor") \
    NUMBER(observed_bank_angle_rad, "rad", turns, sometimes, detail, \
           "bank angle of the road as the observer has it") \
    \
    INDEX(rsi, "-", stays, PUBLISHED, 0, published, same, force, \
          "RSI, (25): lateral acceleration over its threshold (23), 0 to 1") \
    INDEX(rsi_bank_free, "-", stays, BANK_FREE, 1, bank_free, same, force, \
          "|A/N| / T, over the modified half-track ratio, 0 to 20") \
    INDEX(rsi_extended, "-", stays, EXTENDED, 2, extended, same, force, \
          "|A/N| / T_dyn: the same with unsprung mass and roll inertia, 0 to 20") \
    INDEX(load_transfer_ratio, "-", turns, LOAD_TRANSFER, 3, load_transfer, magnitude, own, \
          "(26) from the roll state instead of wheel loads, > 0 in a left turn, -20 to 20") \
    INDEX(predicted_load_transfer_ratio, "-", turns, PREDICTED_LOAD_TRANSFER, 4, predicted_load_transfer, magnitude, both, \
          "the same, of largest magnitude now or within the prediction horizon") \
    INDEX(predicted_rsi, "-", stays, PREDICTED_RSI, 5, predicted_rsi, same, predicted, \
          "rsi_extended at that load transfer, or now if larger") \
    INDEX(static_stability_level, "-", stays, STATIC_STABILITY_FACTOR, 6, static_stability_factor, same, acceleration, \
          "level by the static stability factor: |a_y| / (g SSF), 0 to 20") \
    INDEX(dynamic_stability_index, "g", turns, DYNAMIC_STABILITY, 7, dynamic_stability, per_ssf, own, \
          "dynamic stability index, (27) with minus, the physical sign, > 0 in a left turn, -20 to 20") \
    INDEX(dynamic_stability_index_late, "g", turns, DYNAMIC_STABILITY_LATE, 8, dynamic_stability_late, per_ssf, own, \
          "the same, (27) with plus, as printed, -20 to 20") \
    INDEX(energy_margin, "-", stays, ENERGY, 9, energy, complement, roll, \
          "W of (28): 1 at rest, 0 at the critical energy") \
    INDEX(rollover_index, "-", stays, ROLLOVER_INDEX, 10, rollover_index, same, roll, \
          "rollover index (29), 0 to 20") \
    INDEX(time_to_rollover_s, "s", stays, TIME_TO_ROLLOVER, 11, time_to_rollover, limit_over, roll, \
          "time until the CG leaves the track, 0 to 10; 10 while it does not roll outwards")
/* clang-format on */

#endif
