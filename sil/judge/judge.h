/* C interface of the judge, for Python (judge.py): every rule is that of the C++ beside it.
 * Sides: 0 none, 1 left, 2 right. Times in s; NaN: there is none. No function keeps what it is given. */
#ifndef SIL_JUDGE_H
#define SIL_JUDGE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The parameters of the same names, of the firmware's warning states. */
typedef struct {
    float advisory_on;
    float advisory_off;
    float warning_on;
    float warning_off;
    float warning_confirmation_s;
    float advisory_hold_s;
    float warning_hold_s;
    float recovery_s;
} judge_calibration;

/* An index, cycle by cycle: the risk of falling to either side, 1 where it says "warn". */
typedef struct {
    size_t cycles;
    const double* times_s;
    const double* right;
    const double* left;
} judge_course;

typedef struct {
    size_t count;
    size_t total;
    double lowest; /* of the 95 % interval; from 0 to 1 when the total is 0 */
    double highest;
} judge_share;

enum { JUDGE_BANDS = 4 };

typedef struct {
    judge_share warned;
    judge_share warned_100ms;
    judge_share warned_200ms;
    judge_share false_alarms;
    judge_share alarms[JUDGE_BANDS];
    double median_lead_s;
} judge_detection;

/* Runs side by side: what really became of them, and what one warning did in them. */
typedef struct {
    size_t count;
    const uint32_t* vehicles; /* numbered from 0; only the detection reads them */
    const double* lift_off_times_s;
    const double* largest_load_transfer_ratios;
    const double* leads_s;
    const uint8_t* alarms; /* only the detection reads them */
} judge_runs;

extern const double judge_early_s;
extern const double judge_very_early_s;
extern const double judge_time_rounding_s;
extern const double judge_lasting_s; /* of a two-wheel lift-off, at least */
extern const size_t judge_fewest_clusters;

const char* judge_band_name(size_t band);

/* For each run: lifted, calm, warned, warned 0.1 s and 0.2 s before, and the number of its band. */
void judge_each(const judge_runs* runs, uint8_t* lifted, uint8_t* calm, uint8_t* warned,
                uint8_t* warned_100ms, uint8_t* warned_200ms, uint8_t* band);

void judge_detect(const judge_runs* runs, judge_detection* detection);

/* The lead of a warning that names these sides from these times on; ascending. */
double judge_lead_s(size_t count, const double* times_s, const uint8_t* sides, double lift_off_time_s,
                    uint8_t falling_side);

/* An index behind the firmware's warning states, with its threshold there. */
double judge_index_lead_s(const judge_calibration* calibration, const judge_course* course, double threshold,
                          double lift_off_time_s, uint8_t falling_side);

/* Whether it raises an alarm: 1 or 0. */
int judge_alarms(const judge_calibration* calibration, const judge_course* course, double threshold);

/* The largest threshold at which it does. */
double judge_alarm_threshold(const judge_calibration* calibration, const judge_course* course);

/* The largest threshold with alarms in at least this share of the runs, given the largest of each. */
double judge_matched_threshold(size_t runs, const double* alarm_thresholds, double share);

/* A drive, cycle by cycle: state (0 unavailable, 1 ready, 2 advisory, 3 warning) and side that were
 * published, and the load transfer ratio of the wheel loads, NaN where it is not known. Two wheels lift at
 * lift_off_time_s, and the vehicle falls to falling_side. */
typedef struct {
    size_t cycles;
    const double* times_s;
    const int32_t* states;
    const int32_t* sides;
    const double* load_transfer_ratios;
    double lift_off_time_s;
    uint8_t falling_side;
} judge_drive;

typedef struct {
    uint8_t lifted;
    uint8_t side_at_lift_off; /* that the warning in force names */
    uint8_t late;             /* the right warning came only after lift-off */
    double lead_s;
    double wrong_side_s;
    double warning_s;
    double advisory_s;
    double unavailable_s; /* beyond the start-up */
    uint32_t warnings;
    uint32_t advisories;
    double largest_load_transfer_ratio;
    uint8_t band; /* of a drive without lift-off */
} judge_judgement;

void judge_warnings(const judge_drive* drive, judge_judgement* judgement);

/* Signals of a drive, cycle by cycle, in the firmware's units; NaN: none. */
typedef struct {
    size_t cycles;
    const double* road_parallel_force_mps2;
    const double* roll_rate_radps;
    const double* roll_angle_rad;
    const double* yaw_rate_radps;
    const double* speed_mps;
    const double* steering_wheel_angle_rad;
} judge_signals;

extern const size_t judge_forecast_input_count;

/* Inputs of the firmware's linear forecast, one for each weight, judge_forecast_input_count numbers a cycle;
 * zero while there is no measurement. `names`, `values`: the calibration; names that are no number of it are
 * passed over. */
void judge_forecast_inputs(size_t parameters, const char* const* names, const double* values,
                           const judge_signals* signals, double* inputs);

void judge_wilson_interval(double count, double total, double* lowest, double* highest);

/* For all runs, by vehicle: how many of each count, and of how many. */
void judge_share_by_vehicle(size_t vehicles, const size_t* counts, const size_t* totals, judge_share* share);

#ifdef __cplusplus
}
#endif
#endif
