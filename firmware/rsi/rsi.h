/* Rollover-warning component: the C interface, and the one definition of its parameters, inputs and outputs.
 *
 * The component takes body-fixed sensor values at 100 Hz, estimates how the suspension's roll centre moves,
 * computes the roll stability indicator (RSI: the lateral acceleration at which the inner wheels lift) and
 * decides on a warning. It allocates nothing, keeps all state in the object that the caller owns, knows no
 * clock, no CAN and no file, and gives the same bits on every target that has IEEE 754 floats, provided that
 * the compiler neither fuses a*b+c nor reorders (-ffp-contract=off, no -ffast-math). One object is not for
 * two threads at once.
 *
 * Source: Jung, Shim, Gertsch, "A Vehicle Roll-Stability Indicator Incorporating Roll-Center Movements",
 * IEEE Transactions on Vehicular Technology 58(8), 2009; numbers in brackets are its equations.
 * Signs: ISO 8855 (x forward, y left, z up); a left turn has positive lateral acceleration, yaw rate and
 * roll.
 *
 * Use:
 *     rsi_component component;
 *     rsi_validation answer = rsi_init(&component, &parameters);
 *     if (!answer.accepted) { report(answer.field, answer.reason); }
 *     every 10 ms: rsi_step(&component, &inputs, &outputs);
 * Rate: always 100 Hz. Sensors at 50 Hz: step at 100 Hz with the held value. A missed cycle is not made up
 * for by calling twice; after more than two, step once with every input NaN. With an RTOS one task steps one
 * component, and no writer of its inputs may preempt the step.
 * selftest/selftest.c shows whether compiler, flags and FPU of a build are right.
 *
 * No field has the type of an enumeration, so that a caller and a library that were compiled with other sizes
 * of enumerations (-fshort-enums) agree on every structure. The enumeration that names the values of an
 * int32_t is given beside it.
 */
#ifndef RSI_RSI_H
#define RSI_RSI_H

#include <stdint.h>

#include "rsi/float_rules.h"
#include "rsi/version.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The fixed step, seconds. */
#define RSI_SAMPLE_TIME_S 0.01F

/* Which estimator moves the roll centre. */
typedef enum {
    RSI_ESTIMATOR_PUBLISHED = 0,      /* robust least squares with disturbance observer, (5), (8) to (11) */
    RSI_ESTIMATOR_CONSIDER_KALMAN = 1 /* one unknown; roll stiffness as a curve, and the roll inertia */
} rsi_estimator;

/* The reference of the roll sensor's angle. */
typedef enum {
    RSI_ROLL_AGAINST_ROAD = 0,   /* of a suspension: how far the body leans on its wheels */
    RSI_ROLL_AGAINST_HORIZON = 1 /* of an attitude sensor: the same and the road's bank */
} rsi_roll_angle_reference;

/* Whether the vehicle has a roll sensor. A sensor that is not fitted is neither missed nor read. */
typedef enum { RSI_ROLL_SENSOR_FITTED = 0, RSI_ROLL_SENSOR_NOT_FITTED = 1 } rsi_roll_angle_sensor;

/* The signals of its motion that the vehicle sends. */
typedef enum {
    RSI_MOTION_WITH_STEERING = 0, /* speed, yaw rate and steering wheel angle */
    RSI_MOTION_WITHOUT_STEERING = 1,
    RSI_MOTION_NOT_FITTED = 2 /* nothing */
} rsi_vehicle_motion_sensors;

/* The source of the roll angle in use. */
typedef enum { RSI_ROLL_NONE = 0, RSI_ROLL_SENSOR = 1, RSI_ROLL_OBSERVER = 2 } rsi_roll_source;

typedef enum {
    RSI_STATE_UNAVAILABLE = 0, /* no statement on the risk is possible */
    RSI_STATE_READY = 1,       /* no risk seen */
    RSI_STATE_ADVISORY = 2,    /* close to the threshold */
    RSI_STATE_WARNING = 3      /* the inner wheels lift or are about to */
} rsi_state;

/* The side towards which the vehicle would fall: the right one in a left turn. */
typedef enum { RSI_SIDE_NONE = 0, RSI_SIDE_LEFT = 1, RSI_SIDE_RIGHT = 2 } rsi_side;

/* The calibration. Every field has a range; rsi_init refuses a value outside it by the field's name. */
typedef struct {
    /* Vehicle */
    float sprung_mass_kg;       /* mass on the springs, m_s */
    float sprung_cg_height_m;   /* its centre of gravity above the road, h_cg,s */
    float track_width_m;        /* track width, c_w */
    float roll_inertia_kgm2;    /* of the sprung mass about its centre of gravity, Ixx */
    float unsprung_mass_kg;     /* axles, wheels and brakes, m_u */
    float unsprung_cg_height_m; /* their centre of gravity above the road, h_u */

    /* Roll-plane model with a fixed roll centre, (1) */
    float fixed_roll_centre_height_m; /* roll centre above the road, h_frc */
    float roll_stiffness_nmprad;      /* roll stiffness, K_f */
    float roll_damping_nmsprad;       /* roll damping, c_f */

    /* The suspension's roll moment as a curve: M(phi) = K_f phi + K_2 phi^3 + K_4 phi^5. The
     * published algorithm does not use it. */
    float roll_stiffness_cubic_nmprad3;   /* cubic part of the roll moment, K_2 */
    float roll_stiffness_quintic_nmprad5; /* part with the fifth power, K_4 */

    /* The lateral acceleration that the steering demands: a_d = V^2 delta / (L + K_us V^2) */
    float wheelbase_m;                       /* wheelbase, L */
    float steering_ratio;                    /* angle of the steering wheel over that of the front wheels */
    float understeer_gradient_s2pm;          /* understeer gradient, K_us, > 0 for an understeering vehicle */
    float largest_lateral_acceleration_mps2; /* the tyres give no more */
    /* How A follows a_d in the prediction, A'' = w^2 (a_d - A) - 2 zeta w A'. */
    float lateral_response_frequency_radps; /* natural frequency, w; 0 if not known */
    float lateral_response_damping;         /* damping ratio, zeta; without meaning where w is not known */

    /* Position of the IMU, from the sprung mass's centre of gravity in body axes */
    float imu_x_m;                    /* forward */
    float imu_y_m;                    /* to the left */
    float imu_z_m;                    /* upwards */
    float angular_acceleration_lag_s; /* of the derivatives that carry f_y and f_z to the CG, first order */

    /* Robust least squares with disturbance observer, (9) to (11) */
    float forgetting_factor;               /* weight of the sample before, lambda */
    float disturbance_cutoff_hz;           /* cut-off of Q(z), f_c; 0 switches the disturbance observer off */
    float regression_scale_nm;             /* Y is divided by this before normalisation */
    float initial_roll_centre_deviation_m; /* of dh at the start; with the next two the diagonal of P(0) */
    float initial_stiffness_deviation_nmprad; /* of the roll stiffness at the start */
    float initial_damping_deviation_nmsprad;  /* of the roll damping at the start */
    float covariance_limit; /* no forgetting while trace(P), in units of P(0), exceeds this */

    /* Consider-Kalman filter */
    float roll_centre_prior_deviation_m; /* standard deviation of dh before anything is known */
    float roll_centre_limit_m;           /* largest magnitude of dh */
    float roll_centre_reversion_s;       /* without excitation dh returns to the nominal within this time */
    float estimator_filter_lag_s;        /* two such lags on both sides of the roll equation */
    float excitation_threshold_mps2;     /* no update while |A + N tan phi| is smaller */
    float freeze_level;                  /* no update while the extended RSI is above */

    /* Load transfer from the roll state: 0 as the suspension's moments say, 1 as the forces and the roll
     * acceleration say, between them a mean of both. The former trusts K, the latter the height of the CG. */
    float load_transfer_inertial_weight;

    /* Looking ahead */
    float prediction_horizon_s;  /* how far ahead */
    float acceleration_trend_s;  /* time constant with which the trend of A dies away */
    float response_horizon_s;    /* how far with the lateral response, where it is known; 0: not at all */
    float response_margin_per_s; /* by how much a load transfer counts less for each second beyond 0.1 s */
    float forecast_share;        /* of the learnt linear forecast in the predicted load transfer; 0: none */
    float forecast_limit; /* by which share of itself, at most, the forecast raises the prediction; a quarter
                             of it downwards */
    float prediction_filter_lag_s; /* two such lags on the signals, a third on the trend */

    /* Load beyond the calibrated one */
    float load_adaptation; /* how much of the learnt load is used: 0 none (it is only published), 1 all */
    float load_margin;     /* times load_adaptation; the warning sees the level larger by this share of
                              load_excess_deviation, 0.1 at most */

    /* The paper's other indices */
    float rollover_index_angle_weight;        /* weight of the roll angle, C_1 of (29) */
    float rollover_index_acceleration_weight; /* weight of the acceleration, C_2 of (29) */
    float rollover_index_slope_radps;       /* slope of the line, k_1 of (29): phi' (rad/s) per rad of phi */
    float rollover_index_roll_angle_rad;    /* critical roll angle, phi_th of (29) */
    float rollover_index_roll_rate_radps;   /* critical roll rate, phi'_th of (29) */
    float rollover_index_acceleration_mps2; /* critical acceleration, a_yc of (29) */
    float time_to_rollover_limit_s;         /* a shorter time is a risk of 1 */

    /* Observer of roll angle and bank, and the check of the roll sensor against it */
    float observer_bank_drift_radps; /* how fast the bank changes: random walk, rad per square root of s */
    float observer_disagreement_rad; /* the sensor disagrees when further from the observer ... */
    float observer_disagreement_s;   /* ... for longer than this */
    float observer_margin; /* while the observer stands in, the warning sees the level larger by this share */

    /* Warning */
    float advisory_on;            /* indicator at which the advisory state is entered */
    float advisory_off;           /* indicator below which it may be left */
    float warning_on;             /* indicator at which the warning state is entered */
    float warning_off;            /* indicator below which it may be left */
    float warning_confirmation_s; /* so many samples of 10 ms in a row at warning_on; 0: one */
    float advisory_hold_s;        /* least time in the advisory state after the last sample at advisory_on */
    float warning_hold_s;         /* least time in the warning state after the last sample at warning_on */
    float recovery_s;             /* inputs must be good this long before "unavailable" is left */

    /* Sensors: what the monitoring of the inputs has to admit */
    float accelerometer_noise_mps2; /* rms at the rate of the frames; 0: filtered, as most are */
    float speed_resolution_mps;     /* one step of the speed's value */

    /* Selections */
    int32_t estimator;              /* roll-centre estimator in use: rsi_estimator */
    int32_t warning_indicator;      /* index that drives the warning: rsi_indicator */
    int32_t roll_angle_reference;   /* reference of the roll sensor: rsi_roll_angle_reference */
    int32_t roll_angle_sensor;      /* whether a roll sensor is fitted: rsi_roll_angle_sensor */
    int32_t vehicle_motion_sensors; /* motion signals that the vehicle sends: rsi_vehicle_motion_sensors */
} rsi_parameters;

/* One sample of the sensors, all body-fixed. A value that is not finite or outside its range is "not
 * available". Without the first or third the component is unavailable; so it is without the fourth while the
 * observer, which needs yaw rate and speed, does not know the roll angle. The others are optional. An angle
 * against the horizon needs the bank that is in it: the sixth, or a fifth of a second of the observer. */
typedef struct {
    float lateral_specific_force_mps2;  /* specific force to the left at the IMU, f_y, -60 to 60 */
    float vertical_specific_force_mps2; /* up at the IMU, f_z, near +9.81 at rest, -60 to 60 (optional) */
    float roll_rate_radps; /* roll rate of the gyro, p, -10 to 10; taken for the rate of the roll angle */
    float roll_angle_rad;  /* against roll_angle_reference, -2.2 to 2.2 (the observer's if absent) */
    float yaw_rate_radps;  /* yaw rate, -10 to 10 (optional: lever-arm correction, observer) */
    float bank_angle_rad;  /* of the road, left side up is positive, -0.8 to 0.8 (optional) */
    float speed_mps;       /* -150 to 150 (optional: observer) */
    float steering_wheel_angle_rad; /* > 0 to the left, -30 to 30 (optional: prediction) */
    float vehicle_mass_kg;          /* of the whole vehicle with its load, axle loads added up (optional: load
                                       adaptation) */
} rsi_inputs;

/* The answer to one sample. NaN: not computed. [unit], [-] without one; in rsi_outputs.h stand the other
 * properties of each. This structure and the next enumeration are written from there: do not edit them here,
 * run write_outputs. */
/* clang-format off */
typedef struct {
    int32_t state;                             /* rsi_state: what is said of the risk */
    int32_t side;                              /* rsi_side: towards which the vehicle would fall; none
                                                  while neither side has the risk of an advisory */
    int32_t roll_source;                       /* rsi_roll_source: where the roll angle in use comes from */
    int32_t roll_sensor_disagrees;             /* 1: the roll sensor and the observer contradict each other */
    int32_t estimate_frozen;                   /* 1: the estimator in use learns nothing at present */
    float warning_level;                       /* [-] level of the index that drives the warning, 0 to 20;
                                                  without observer_margin and load_margin */
    float lateral_acceleration_mps2;           /* [m/s^2] a_y: horizontal, of the sprung CG */
    float lateral_acceleration_threshold_mps2; /* [m/s^2] its threshold a_y*, (23), signed like the side it
                                                  is for */
    float road_parallel_force_mps2;            /* [m/s^2] A: specific force along the road, left */
    float road_normal_force_mps2;              /* [m/s^2] N: specific force normal to the road, up */
    float fixed_model_roll_angle_rad;          /* [rad] roll angle of the model with a fixed roll centre,
                                                  phi_f, (1) */
    float compensated_roll_angle_rad;          /* [rad] roll angle of that model with the additional roll
                                                  moment (7) */
    float additional_roll_moment_nm;           /* [N m] additional roll moment, M_add, (7) */
    float roll_centre_vertical_m;              /* [m] dh: movement of the roll centre from its nominal
                                                  height, up */
    float roll_centre_lateral_m;               /* [m] c_rc, (6): lateral movement of the roll centre */
    float roll_stiffness_deviation_nmprad;     /* [N m/rad] dK: deviation of the roll stiffness from its
                                                  nominal value */
    float roll_damping_deviation_nmsprad;      /* [N m s/rad] dc: deviation of the roll damping from its
                                                  nominal value */
    float disturbance_nm;                      /* [N m] estimated disturbance, d of (11), in units of Y */
    float roll_centre_deviation_m;             /* [m] standard deviation of dh; not of every estimator */
    float opposite_load_transfer_ratio;        /* [-] the largest towards the other side than
                                                  predicted_load_transfer_ratio, 0 to 20 */
    float load_excess;                         /* [-] by which share m_s H is larger than calibrated, as
                                                  driving has shown, -0.6 to 1; used or not */
    float load_excess_deviation;               /* [-] standard deviation of it, 0.01 to 0.25 */
    float observed_roll_angle_rad;             /* [rad] roll angle relative to the road, without the roll
                                                  sensor */
    float observed_bank_angle_rad;             /* [rad] bank angle of the road as the observer has it */
    float rsi;                                 /* [-] RSI, (25): lateral acceleration over its threshold
                                                  (23), 0 to 1 */
    float rsi_bank_free;                       /* [-] |A/N| / T, over the modified half-track ratio, 0 to
                                                  20 */
    float rsi_extended;                        /* [-] |A/N| / T_dyn: the same with unsprung mass and roll
                                                  inertia, 0 to 20 */
    float load_transfer_ratio;                 /* [-] (26) from the roll state instead of wheel loads, > 0
                                                  in a left turn, -20 to 20 */
    float predicted_load_transfer_ratio;       /* [-] the same, of largest magnitude now or within the
                                                  prediction horizon */
    float predicted_rsi;                       /* [-] rsi_extended at that load transfer, or now if larger */
    float static_stability_level;              /* [-] level by the static stability factor: |a_y| / (g
                                                  SSF), 0 to 20 */
    float dynamic_stability_index;             /* [g] dynamic stability index, (27) with minus, the
                                                  physical sign, > 0 in a left turn, -20 to 20 */
    float dynamic_stability_index_late;        /* [g] the same, (27) with plus, as printed, -20 to 20 */
    float energy_margin;                       /* [-] W of (28): 1 at rest, 0 at the critical energy */
    float rollover_index;                      /* [-] rollover index (29), 0 to 20 */
    float time_to_rollover_s;                  /* [s] time until the CG leaves the track, 0 to 10; 10 while
                                                  it does not roll outwards */
} rsi_outputs;

/* The indices that can drive the warning. Each has a level, 0 without risk, at which 1 means "warn", and a
 * side of its own. All are available whenever the component is; one that had no number would make the state
 * "unavailable". */
typedef enum {
    RSI_INDICATOR_PUBLISHED = 0,               /* rsi */
    RSI_INDICATOR_BANK_FREE = 1,               /* rsi_bank_free */
    RSI_INDICATOR_EXTENDED = 2,                /* rsi_extended */
    RSI_INDICATOR_LOAD_TRANSFER = 3,           /* load_transfer_ratio */
    RSI_INDICATOR_PREDICTED_LOAD_TRANSFER = 4, /* predicted_load_transfer_ratio */
    RSI_INDICATOR_PREDICTED_RSI = 5,           /* predicted_rsi */
    RSI_INDICATOR_STATIC_STABILITY_FACTOR = 6, /* static_stability_level */
    RSI_INDICATOR_DYNAMIC_STABILITY = 7,       /* dynamic_stability_index */
    RSI_INDICATOR_DYNAMIC_STABILITY_LATE = 8,  /* dynamic_stability_index_late */
    RSI_INDICATOR_ENERGY = 9,                  /* energy_margin */
    RSI_INDICATOR_ROLLOVER_INDEX = 10,         /* rollover_index */
    RSI_INDICATOR_TIME_TO_ROLLOVER = 11        /* time_to_rollover_s */
} rsi_indicator;
/* clang-format on */

/* Answer of rsi_init. `field` and `reason` point to constant text; both are empty when accepted. */
typedef struct {
    int32_t accepted; /* 1 or 0 */
    const char* field;
    const char* reason;
} rsi_validation;

/* The load as learnt from driving: plain numbers, to be stored without power. */
typedef struct {
    float excess;           /* by which share m_s H is larger than calibrated, -0.6 to 1 */
    float excess_deviation; /* standard deviation of it, 0.01 to 0.25 */
    float offset_mps2;      /* added to the force by sensor offsets and a load off the middle, -2 to 2 */
} rsi_learnt_load;

/* Storage of one component; only the functions below look inside. */
#define RSI_COMPONENT_SIZE 1088U
typedef union {
    unsigned char bytes[RSI_COMPONENT_SIZE];
    uint64_t alignment_integer;
    const void* alignment_pointer;
} rsi_component;

/* Storage of one change of parameters; only the functions below look inside. */
#define RSI_PARAMETER_CHANGE_SIZE 448U
typedef union {
    unsigned char bytes[RSI_PARAMETER_CHANGE_SIZE];
    uint64_t alignment_integer;
    const void* alignment_pointer;
} rsi_parameter_change;

/* Starts `component` with `parameters` (copied). When refused, the component is safe to step and says
 * "unavailable". Neither pointer may be null. May be called again at any time: it forgets everything. Takes
 * longer than a cycle, because it iterates to find the observer's gains. */
rsi_validation rsi_init(rsi_component* component, const rsi_parameters* parameters);

/* Starts `component` anew, as rsi_init does, but keeps what rsi_init has found by iterating; so it costs less
 * than a step and fits into a cycle. `parameters` must be those in use; they are not validated again. Without
 * an accepted rsi_init it does nothing. No pointer may be null. */
void rsi_reset(rsi_component* component, const rsi_parameters* parameters);

/* One step of 10 ms. `component` must have been through rsi_init; no pointer may be null. Constant cost, no
 * errors. */
void rsi_step(rsi_component* component, const rsi_inputs* inputs, rsi_outputs* outputs);

/* Other parameters for a component that is running, in three steps:
 *     rsi_validation answer = rsi_begin_change(&change, &parameters_in_use, &others);
 *     if (answer.accepted) in every cycle until it returns 1: rsi_prepare_change(&change);
 *     between two calls of rsi_step: rsi_change(&component, &change);
 * No pointer may be null.
 *
 * The first validates `to` and compares it with `from`, the parameters in use. When `to` is refused, the
 * answer names the field, and there is nothing to prepare. Neither is needed after the call. */
rsi_validation rsi_begin_change(rsi_parameter_change* change, const rsi_parameters* from,
                                const rsi_parameters* to);

/* One cycle's share of the work, less than a step. Returns 1 when the change is ready, else 0. Most changes
 * are ready at the first call, those of the vehicle or of observer_bank_drift_radps within two seconds. */
int32_t rsi_prepare_change(rsi_parameter_change* change);

/* The component goes on with the parameters of `change`, which must be ready and have begun from those in
 * use. Signals, states and what has been learnt stay; but what was learnt of the vehicle is forgotten where
 * its masses, heights, springs or dampers change. Costs less than a step. After rsi_init has refused the
 * parameters it starts the component, with a change that has begun from parameters that are all zero. */
void rsi_change(rsi_component* component, const rsi_parameter_change* change);

/* The load learnt so far. */
rsi_learnt_load rsi_get_learnt_load(const rsi_component* component);

/* Between rsi_init and the first step: takes up what another run with the same parameters has learnt.
 * `doubted`: 0 where the load cannot have changed in between, as after a reset while driving, else 1. Returns
 * 1; or 0, and without an effect, where it cannot have been learnt or the parameters were refused. */
int32_t rsi_restore_learnt_load(rsi_component* component, const rsi_learnt_load* learnt, int32_t doubted);

/* Whether the library was compiled with an optimiser (-O1, -O2, -O3, -Os): 1 or 0. Without one its answers
 * have the same bits, but a step takes many times the instructions, and more stack. */
int32_t rsi_is_optimised(void);

#ifdef __cplusplus
}
#endif

#endif
