#include "rsi/component.hpp"

#include <new>

#include "rsi/indicator/indicator_level.hpp"
#include "rsi/model/roll_centre.hpp"

namespace rsi {
namespace {

Outputs no_outputs() {
    Outputs outputs{};
    outputs.state = RSI_STATE_UNAVAILABLE;
    outputs.side = RSI_SIDE_NONE;
    outputs.roll_source = RSI_ROLL_NONE;
    outputs.warning_level = not_available;
    outputs.rsi = not_available;
    outputs.rsi_bank_free = not_available;
    outputs.lateral_acceleration_mps2 = not_available;
    outputs.lateral_acceleration_threshold_mps2 = not_available;
    outputs.road_parallel_force_mps2 = not_available;
    outputs.road_normal_force_mps2 = not_available;
    outputs.fixed_model_roll_angle_rad = not_available;
    outputs.compensated_roll_angle_rad = not_available;
    outputs.additional_roll_moment_nm = not_available;
    outputs.roll_centre_vertical_m = not_available;
    outputs.roll_centre_lateral_m = not_available;
    outputs.roll_stiffness_deviation_nmprad = not_available;
    outputs.roll_damping_deviation_nmsprad = not_available;
    outputs.disturbance_nm = not_available;
    outputs.roll_centre_deviation_m = not_available;
    outputs.observed_roll_angle_rad = not_available;
    outputs.observed_bank_angle_rad = not_available;
    outputs.rsi_extended = not_available;
    outputs.load_transfer_ratio = not_available;
    outputs.predicted_load_transfer_ratio = not_available;
    outputs.predicted_rsi = not_available;
    outputs.static_stability_level = not_available;
    outputs.dynamic_stability_index = not_available;
    outputs.dynamic_stability_index_late = not_available;
    outputs.energy_margin = not_available;
    outputs.rollover_index = not_available;
    outputs.time_to_rollover_s = not_available;
    return outputs;
}

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
        parameters_ = parameters;
        measurement_.init(parameters);
        model_.init(parameters);
        estimator_.init(parameters);
        threshold_.init(parameters);
        further_.init(parameters);
        warning_.init(parameters);
    }
    return answer;
}

// The paper's Fig. 3 from left to right. Flattened: the library is compiled as one unit, and a third of the
// cost of the small functions below would be calling them.
[[gnu::flatten]] void Component::step(const Inputs& inputs, Outputs& outputs) {
    Measurement measured;
    if (!initialised_ || !measurement_.update(inputs, measured, movement_m_)) {
        step_unavailable(outputs);
        return;
    }
    if (!running_) {
        resume(measured);
    }
    // A vehicle that lies on its side teaches nothing; once it stands again, all starts anew.
    const bool overturned = has_overturned(measured, parameters_);
    if (overturned) {
        estimator_.reset();
        running_ = false;
    }

    fixed_.evaluate(model_, measured);
    const RollCentreEstimate estimate =
        overturned ? RollCentreEstimate{}
                   : estimator_.update(model_, measured, fixed_, extended_rsi_, inputs.speed_mps);
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

    // The published estimate drifts to where it fits anything; it must not move the observer.
    const bool sound = (parameters_.estimator == RSI_ESTIMATOR_CONSIDER_KALMAN);
    movement_m_ = sound ? estimate.vertical_movement_m : 0.0F;
    further_.update(inputs, measured, outputs);
    warn(measured, overturned, outputs);

    compensated_.advance(model_, measured, fixed_, M_add);
    fixed_.advance(model_);
    extended_rsi_ = outputs.rsi_extended;
}

// An overturned vehicle is warned of whatever the indicator says, an indicator without a number of nothing.
void Component::warn(const Measurement& measured, bool overturned, Outputs& outputs) {
    outputs.warning_level = indicator_level(outputs, parameters_);
    RiskLevel risk{outputs.warning_level, indicator_side(outputs, parameters_, measured.roll_angle_rad)};
    if (overturned) {
        risk = RiskLevel{parameters_.warning_on, measured.roll_angle_rad};
    }
    if (is_finite(risk.indicator)) {
        warning_.update(risk);
    } else {
        warning_.update_unavailable();
    }
    outputs.state = warning_.state();
    outputs.side = warning_.side();
}

void Component::step_unavailable(Outputs& outputs) {
    running_ = false;
    warning_.update_unavailable();
    outputs = no_outputs();
}

void Component::forget() {
    running_ = false;
    movement_m_ = 0.0F;
    measurement_.reset();
    estimator_.reset();
    warning_.update_unavailable();
}

// After a gap the models start where the vehicle is; what the estimator has learnt stays.
void Component::resume(const Measurement& measured) {
    fixed_.reset(measured.roll_angle_rad);
    compensated_.reset(measured.roll_angle_rad);
    further_.reset(measured);
    estimator_.restart();
    extended_rsi_ = not_available;
    running_ = true;
}

}  // namespace rsi
