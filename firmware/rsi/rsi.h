/* Rollover-warning component: the C face, and the one definition of its parameters, inputs and outputs.
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
 */
#ifndef RSI_RSI_H
#define RSI_RSI_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The fixed step, seconds. */
#define RSI_SAMPLE_TIME_S 0.01F

/* Which estimator moves the roll centre. */
typedef enum {
    RSI_ESTIMATOR_PUBLISHED = 0 /* robust least squares with disturbance observer, (5) and (8) to (11) */
} rsi_estimator;

/* Which indicator drives the warning. */
typedef enum {
    RSI_INDICATOR_PUBLISHED = 0, /* (25): lateral acceleration over its threshold (23) */
    RSI_INDICATOR_BANK_FREE = 1  /* |A/N| over the modified half-track ratio: needs no bank angle */
} rsi_indicator;

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
    float sprung_mass_kg;     /* m_s */
    float sprung_cg_height_m; /* h_cg,s above the road */
    float track_width_m;      /* c_w */

    /* Roll-plane model with a fixed roll centre, (1) */
    float fixed_roll_centre_height_m; /* h_frc above the road */
    float roll_stiffness_nmprad;      /* K_f */
    float roll_damping_nmsprad;       /* c_f */

    /* Where the IMU sits, from the sprung mass's centre of gravity in body axes */
    float imu_x_m;
    float imu_y_m;
    float imu_z_m;
    float
        angular_acceleration_lag_s; /* first-order lag of the derivatives that carry f_y and f_z to the CG */

    /* Robust least squares with disturbance observer, (9) to (11) */
    float forgetting_factor;               /* lambda */
    float disturbance_cutoff_hz;           /* f_c of Q(z); 0 switches the disturbance observer off */
    float regression_scale_nm;             /* Y is divided by this before normalisation */
    float initial_roll_centre_deviation_m; /* square roots of the diagonal of P(0) */
    float initial_stiffness_deviation_nmprad;
    float initial_damping_deviation_nmsprad;
    float covariance_limit; /* no forgetting while trace(P), in units of P(0), exceeds this */

    /* Warning */
    float advisory_on;            /* indicator at which the advisory state is entered */
    float advisory_off;           /* indicator below which it may be left */
    float warning_on;             /* indicator at which the warning state is entered */
    float warning_off;            /* indicator below which it may be left */
    float warning_confirmation_s; /* so many samples of 10 ms in a row at warning_on; 0: one */
    float advisory_hold_s;        /* least time in the advisory state */
    float warning_hold_s;         /* least time in the warning state */
    float recovery_s;             /* inputs must be good this long before "unavailable" is left */

    /* Selections */
    int32_t estimator;         /* rsi_estimator */
    int32_t warning_indicator; /* rsi_indicator */
} rsi_parameters;

/* One sample of the sensors, all body-fixed. A value that is not finite or outside its range is "not
 * available". Without the first, third or fourth the component is unavailable; the others are optional. */
typedef struct {
    float lateral_specific_force_mps2;  /* f_y at the IMU, -60 to 60 */
    float vertical_specific_force_mps2; /* f_z at the IMU, near +9.81 at rest, -60 to 60 (optional) */
    float roll_rate_radps; /* p, of the body's gyro, -10 to 10; taken for the rate of the roll angle */
    float roll_angle_rad;  /* of the body relative to the road, -2.2 to 2.2 */
    float yaw_rate_radps;  /* -10 to 10 (optional: lever-arm correction) */
    float bank_angle_rad;  /* of the road, left side up is positive, -0.8 to 0.8 (optional) */
    float speed_mps;       /* (optional; the published algorithm does not use it) */
} rsi_inputs;

/* The answer to one sample. A number that could not be computed is NaN. */
typedef struct {
    rsi_state state;
    rsi_side side; /* none while unavailable or ready */

    float rsi;                                 /* (25), 0 to 1 */
    float rsi_bank_free;                       /* |A/N| / T, 0 to 20 */
    float lateral_acceleration_mps2;           /* a_y: horizontal, of the sprung CG */
    float lateral_acceleration_threshold_mps2; /* a_y*, (23), signed like the side it is for */

    float road_parallel_force_mps2; /* A: specific force along the road, left */
    float road_normal_force_mps2;   /* N: specific force normal to the road, up */

    float fixed_model_roll_angle_rad;      /* phi_f, (1) */
    float compensated_roll_angle_rad;      /* (1) with the additional roll moment (7) */
    float additional_roll_moment_nm;       /* M_add, (7) */
    float roll_centre_vertical_m;          /* dh */
    float roll_centre_lateral_m;           /* c_rc, (6) */
    float roll_stiffness_deviation_nmprad; /* dK */
    float roll_damping_deviation_nmsprad;  /* dc */
    float disturbance_nm;                  /* d of (11), in units of Y */
} rsi_outputs;

/* Answer of rsi_init. `field` and `reason` point to constant text; both are empty when accepted. */
typedef struct {
    int32_t accepted; /* 1 or 0 */
    const char* field;
    const char* reason;
} rsi_validation;

/* Storage of one component; only the functions below look inside. */
#define RSI_COMPONENT_SIZE 512U
typedef union {
    unsigned char bytes[RSI_COMPONENT_SIZE];
    uint64_t alignment_integer;
    const void* alignment_pointer;
} rsi_component;

/* Starts `component` with `parameters` (copied). When refused, the component is safe to step and says
 * "unavailable". Neither pointer may be null. May be called again at any time: it forgets everything. */
rsi_validation rsi_init(rsi_component* component, const rsi_parameters* parameters);

/* One step of 10 ms. `component` must have been through rsi_init; no pointer may be null. Constant cost, no
 * errors. */
void rsi_step(rsi_component* component, const rsi_inputs* inputs, rsi_outputs* outputs);

#ifdef __cplusplus
}
#endif

#endif
