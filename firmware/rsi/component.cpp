#include "rsi/component.hpp"

#include <new>

#include "rsi/model/roll_centre.hpp"
#include "rsi/output_table.hpp"

namespace rsi {
namespace {

void write_measurement(const Measurement& measured, Outputs& outputs) {
    outputs.lateral_acceleration_mps2 = measured.lateral_acceleration_mps2;
    outputs.road_parallel_force_mps2 = measured.road_parallel_force_mps2;
    outputs.road_normal_force_mps2 = measured.road_normal_force_mps2;
    outputs.roll_source = measured.roll_source;
    outputs.observed_roll_angle_rad = measured.observed.roll_angle_rad;
    outputs.observed_bank_angle_rad = measured.observed.bank_angle_rad;
    outputs.roll_sensor_disagrees = measured.observed.sensor_disagrees ? 1 : 0;
}

void write_estimate(const RollCentreEstimate& estimate, Outputs& outputs) {
    outputs.roll_centre_vertical_m = estimate.vertical_movement_m;
    outputs.roll_stiffness_deviation_nmprad = estimate.stiffness_deviation_nmprad;
    outputs.roll_damping_deviation_nmsprad = estimate.damping_deviation_nmsprad;
    outputs.disturbance_nm = estimate.disturbance_nm;
    outputs.roll_centre_deviation_m = estimate.deviation_m;
    outputs.estimate_frozen = estimate.frozen ? 1 : 0;
}

}  // namespace

Validation Component::init(const Parameters& parameters) {
    const Validation answer = validate(parameters);
    ::new (static_cast<void*>(this)) Component{};  // in place: a copy would need its size again on the stack
    initialised_ = (answer.accepted != 0);
    if (initialised_) {
        static_stability_factor_ = parameters.track_width_m / (2.0F * parameters.sprung_cg_height_m);
        observer_weight_ = 1.0F + parameters.observer_margin;
        measurement_.init(parameters);
        model_.init(parameters);
        estimator_.init(parameters);
        threshold_.init(parameters);
        further_.init(parameters);
        warning_indicator_.init(parameters);
        warning_.init(parameters);
    }
    return answer;
}

// The paper's Fig. 3 from left to right. Flattened: the library is compiled as one unit, and a third of the
// cost of the small functions below would be calling them.
[[gnu::flatten]] void Component::step(const Inputs& inputs, Outputs& outputs) {
    Measurement measured;
    if (!initialised_ || !measurement_.update(inputs, measured)) {
        step_unavailable(outputs);
        return;
    }
    bool fresh = false;
    if (!running_) {
        resume(measured);
        fresh = true;
    }
    fixed_.evaluate(model_, measured);
    if (estimator_.update(model_, measured, fixed_, extended_rsi_, inputs.speed_mps,
                          measured.odd_sample || fresh)) {
        measurement_.assume_movement(estimator_.estimate().vertical_movement_m);
    }
    const RollCentreEstimate& estimate = estimator_.estimate();
    const float c_rc = lateral_roll_centre_m(model_, measured, fixed_, estimate.vertical_movement_m);
    const float M_add = additional_roll_moment_nm(model_, measured, estimate, c_rc);
    const StabilityThreshold threshold = threshold_.evaluate(measured, estimate.vertical_movement_m, c_rc);

    write_measurement(measured, outputs);
    write_estimate(estimate, outputs);
    outputs.rsi = normalised_indicator(measured, threshold);
    outputs.rsi_bank_free = bank_free_indicator(measured, threshold);
    outputs.lateral_acceleration_threshold_mps2 = threshold.lateral_acceleration_mps2;
    outputs.roll_centre_lateral_m = c_rc;
    outputs.additional_roll_moment_nm = M_add;
    outputs.fixed_model_roll_angle_rad = fixed_.angle_rad();
    outputs.compensated_roll_angle_rad = compensated_.angle_rad();

    // To the next sample at once: kept until the end, what this needs would crowd the registers.
    compensated_.advance(model_, measured, fixed_, M_add);
    fixed_.advance(model_);

    further_.update(inputs, measured, fresh, outputs);
    warn(measured, outputs);
    extended_rsi_ = outputs.rsi_extended;
}

// An overturned vehicle is warned of whatever the indicator says, an indicator without a number of nothing.
// What lies on its side teaches nothing either: all starts anew with every sample until it stands again.
void Component::warn(const Measurement& measured, Outputs& outputs) {
    const IndicatedRisk indicated = warning_indicator_.evaluate(outputs, measured.roll_angle_rad);
    outputs.warning_level = indicated.level;
    const float weight = (measured.roll_source == RSI_ROLL_OBSERVER) ? observer_weight_ : 1.0F;
    RiskLevel risk{weight * indicated.level, indicated.direction};
    if (has_overturned(measured, static_stability_factor_)) {
        overturned_ = true;
        running_ = false;
        risk = RiskLevel{warning_.warning_on(), measured.roll_angle_rad};
    }
    warning_.update(risk);
    outputs.state = warning_.state();
    outputs.side = warning_.side();
}

void Component::step_unavailable(Outputs& outputs) {
    running_ = false;
    warning_.update_unavailable();
    outputs = no_outputs();
}

// After a gap the models start where the vehicle is; what the estimator has learnt stays, but not past an
// overturn.
void Component::resume(const Measurement& measured) {
    if (overturned_) {
        estimator_.reset();
        measurement_.assume_movement(0.0F);
        overturned_ = false;
    }
    fixed_.reset(measured.roll_angle_rad);
    compensated_.reset(measured.roll_angle_rad);
    further_.reset(measured);
    estimator_.restart();
    extended_rsi_ = not_available;
    running_ = true;
}

}  // namespace rsi
