#include "rsi/component.hpp"

#include "rsi/model/roll_centre.hpp"

namespace rsi {
namespace {

constexpr Outputs no_outputs{RSI_STATE_UNAVAILABLE, RSI_SIDE_NONE, not_available, not_available,
                             not_available,         not_available, not_available, not_available,
                             not_available,         not_available, not_available, not_available,
                             not_available,         not_available, not_available, not_available};

void write_measurement(const Measurement& measured, Outputs& outputs) {
    outputs.lateral_acceleration_mps2 = measured.lateral_acceleration_mps2;
    outputs.road_parallel_force_mps2 = measured.road_parallel_force_mps2;
    outputs.road_normal_force_mps2 = measured.road_normal_force_mps2;
}

void write_estimate(const RollCentreEstimate& estimate, Outputs& outputs) {
    outputs.roll_centre_vertical_m = estimate.vertical_movement_m;
    outputs.roll_stiffness_deviation_nmprad = estimate.stiffness_deviation_nmprad;
    outputs.roll_damping_deviation_nmsprad = estimate.damping_deviation_nmsprad;
    outputs.disturbance_nm = estimate.disturbance_nm;
}

}  // namespace

Validation Component::init(const Parameters& parameters) {
    const Validation answer = validate(parameters);
    *this = Component{};
    initialised_ = (answer.accepted != 0);
    if (initialised_) {
        parameters_ = parameters;
        measurement_.init(parameters);
        model_.init(parameters);
        estimator_.init(parameters);
        threshold_.init(parameters);
        warning_.init(parameters);
    }
    return answer;
}

// The paper's Fig. 3 from left to right.
void Component::step(const Inputs& inputs, Outputs& outputs) {
    Measurement measured;
    if (!initialised_ || !measurement_.update(inputs, measured)) {
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
        overturned ? RollCentreEstimate{} : estimator_.update(model_, measured, fixed_);
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

    const float falling_side = (measured.roll_angle_rad < 0.0F) ? -1.0F : 1.0F;
    warning_.update(overturned ? RiskLevel{parameters_.warning_on, falling_side}
                               : risk_level(threshold, outputs));
    outputs.state = warning_.state();
    outputs.side = warning_.side();

    compensated_.advance(model_, measured, fixed_, M_add);
    fixed_.advance(model_, measured);
}

void Component::step_unavailable(Outputs& outputs) {
    running_ = false;
    warning_.update_unavailable();
    outputs = no_outputs;
}

// After a gap the models start where the vehicle is; what the estimator has learnt stays.
void Component::resume(const Measurement& measured) {
    fixed_.reset(measured.roll_angle_rad);
    compensated_.reset(measured.roll_angle_rad);
    running_ = true;
}

RiskLevel Component::risk_level(const StabilityThreshold& threshold, const Outputs& outputs) const {
    const bool bank_free = (parameters_.warning_indicator == RSI_INDICATOR_BANK_FREE);
    return RiskLevel{bank_free ? outputs.rsi_bank_free : outputs.rsi, threshold.side};
}

}  // namespace rsi
