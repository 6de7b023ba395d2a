#include "rsi/component.hpp"

#include <new>

#include "rsi/estimation/roll_centre.hpp"
#include "rsi/indicator/extended_indicator.hpp"
#include "rsi/indicator/roll_stability_indicator.hpp"
#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/output_table.hpp"

#ifndef EIGEN_DONT_VECTORIZE
#error "compile with -DEIGEN_DONT_VECTORIZE: vector units may fuse and reorder, which changes the last bit"
#endif

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

void write_load(const LearntLoad& learnt, Outputs& outputs) {
    outputs.load_excess = learnt.excess;
    outputs.load_excess_deviation = learnt.excess_deviation;
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
        measurement_.init(parameters);
        comparison_.init(parameters);
        start(parameters);
    }
    return answer;
}

void Component::reset(const Parameters& parameters) {
    if (initialised_) {
        running_ = false;
        overturned_ = false;
        measurement_.reinitialise(parameters);
        comparison_.reinitialise(parameters);
        start(parameters);
    }
}

// What resume() resets, before the first sample as after any gap, is left to it.
void Component::start(const Parameters& parameters) {
    tune(parameters);
    estimator_.reset();
    load_adaptation_.init(parameters);
    warning_.update_unavailable();
}

// All that follows from the parameters alone, with the calibrated body. What has no state has an init() only.
void Component::tune(const Parameters& parameters) {
    static_stability_factor_ = static_stability_factor(parameters);
    observer_weight_ = 1.0F + parameters.observer_margin;
    motion_filter_.init(parameters);
    model_.init(parameters);
    estimator_.tune(parameters);
    threshold_.init(parameters);
    load_transfer_.init(parameters);
    steering_demand_.init(parameters);
    lateral_response_.tune(parameters);
    moment_arm_error_.tune(parameters);
    predictor_.init(parameters);
    load_adaptation_.tune(parameters);
    warning_indicator_.init(parameters);
    warning_.tune(parameters);
}

void Component::change(const ParameterChange& change) {
    if (!initialised_) {
        return;
    }
    const Parameters& parameters = change.parameters();
    measurement_.tune(parameters);
    if (change.has_gains()) {
        measurement_.assume_gains(change.gains());
    }
    comparison_.init(parameters);
    tune(parameters);
    if (change.is_another_vehicle()) {
        estimator_.reset();
        moment_arm_error_.reset();
        load_adaptation_.init(parameters);
    } else if (change.has_other_units()) {
        estimator_.forget_published();
    } else {
        // All that has been learnt is of this vehicle and these units.
    }
    measurement_.assume_movement(estimator_.movement_for_observer_m());
    measurement_.assume_mass(load_adaptation_.known_mass_factor());
    assume_body(load_adaptation_.body());
}

bool Component::restore_load(const LearntLoad& learnt, bool doubted) {
    const bool restored = initialised_ && load_adaptation_.restore(learnt, doubted);
    if (restored) {
        assume_body(load_adaptation_.body());
    }
    return restored;
}

// Whatever reckons with the sprung mass, but for two: the observer, against which the roll sensor is checked,
// must not follow what the roll sensor has taught (only the vehicle's mass excuses the sensor), and the
// indices for comparison stay as published.
void Component::assume_body(const SprungBody& body) {
    model_.assume_body(body);
    estimator_.assume_body(body);
    threshold_.assume_body(body);
    load_transfer_.assume_body(body);
    moment_arm_error_.assume_body(body);
    predictor_.assume_body(body);
}

// The algorithm from the sensors to the warning. Flattened: the library is compiled as one unit, and a third
// of the cost of the small functions below would be calling them.
[[gnu::flatten]] void Component::step(const Inputs& inputs, Outputs& outputs) {
    // Measure, and observe roll and bank.
    Measurement measured;
    if (!initialised_ || !measurement_.update(inputs, measured)) {
        step_unavailable(outputs);
        return;
    }
    if (!running_) {
        resume(measured);
    }
    const RollMotion motion = motion_filter_.update(measured);
    write_measurement(measured, outputs);

    // Model: how a vehicle with a fixed roll centre would roll, (1).
    fixed_.update(model_, measured);
    outputs.fixed_model_roll_angle_rad = fixed_.angle_rad();

    // Estimate the roll centre's vertical movement.
    const RollCentreEstimate estimate =
        estimator_.update(model_, measured, fixed_, extended_rsi_, inputs.speed_mps);
    measurement_.assume_movement(estimator_.movement_for_observer_m());
    write_estimate(estimate, outputs);

    // Roll centre, (6), the moment that its movement adds, (7), and the model that it compensates.
    const float c_rc = lateral_roll_centre_m(model_, measured, fixed_, estimate.vertical_movement_m);
    const float M_add = additional_roll_moment_nm(model_, measured, estimate, c_rc);
    outputs.roll_centre_lateral_m = c_rc;
    outputs.additional_roll_moment_nm = M_add;
    compensated_.update(model_, measured, fixed_, M_add);
    outputs.compensated_roll_angle_rad = compensated_.angle_rad();

    // Threshold, (23), and RSI, (25).
    const StabilityThreshold threshold = threshold_.evaluate(measured, estimate.vertical_movement_m, c_rc);
    outputs.lateral_acceleration_threshold_mps2 = threshold.lateral_acceleration_mps2;
    outputs.rsi = normalised_indicator(measured, threshold);
    outputs.rsi_bank_free = bank_free_indicator(measured, threshold);

    // Load transfer, (26), and the extended RSI.
    const TransferredLoad load = load_transfer_.evaluate(motion);
    outputs.load_transfer_ratio = load.ratio;
    outputs.rsi_extended = extended_level(motion, load_transfer_.vehicle());

    // Predict both.
    const DemandedForce demand = steering_demand_.evaluate(inputs, measured);
    const float moment_arm_error =
        moment_arm_error_.update(motion, load, measured.roll_source == RSI_ROLL_SENSOR);
    const LateralResponse* const response =
        lateral_response_.update(motion, demand) ? &lateral_response_ : nullptr;
    const Prediction predicted =
        predictor_.evaluate(motion, load, demand, response, moment_arm_error, load_transfer_);
    outputs.predicted_load_transfer_ratio = predicted.load_transfer_ratio;
    outputs.opposite_load_transfer_ratio = predicted.opposite_ratio;
    outputs.predicted_rsi = larger(outputs.rsi_extended, predicted.rsi_extended);

    // Learn the load; the next sample reckons with it.
    load_adaptation_.update(inputs, motion, load, measured.roll_angle_is_measured);
    write_load(load_adaptation_.learnt(), outputs);

    // For comparison: the paper's other indices.
    comparison_.evaluate(measured, motion, outputs);

    // Warn.
    warn(measured, outputs);

    // To the next sample.
    extended_rsi_ = outputs.rsi_extended;
    measurement_.assume_mass(load_adaptation_.known_mass_factor());
    assume_body(load_adaptation_.body());
}

// An overturned vehicle sets the warning, whatever the indicator. Without a level there is no statement.
// Nothing is learnt while the vehicle lies on its side: every sample starts the component anew until it
// stands again.
void Component::warn(const Measurement& measured, Outputs& outputs) {
    const IndicatedRisk indicated = warning_indicator_.evaluate(outputs, measured.roll_angle_rad);
    outputs.warning_level = indicated.level;
    const float source_weight = (measured.roll_source == RSI_ROLL_OBSERVER) ? observer_weight_ : 1.0F;
    const float weight = source_weight * load_adaptation_.level_weight();
    RiskLevel risk{weight * indicated.level, indicated.direction, weight * indicated.opposite};
    if (has_overturned(measured, static_stability_factor_)) {
        overturned_ = true;
        running_ = false;
        risk = RiskLevel{warning_.warning_on(), measured.roll_angle_rad, 0.0F};
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
        load_adaptation_.forget();
        overturned_ = false;
    }
    fixed_.reset(measured.roll_angle_rad);
    compensated_.reset(measured.roll_angle_rad);
    motion_filter_.reset(measured);
    lateral_response_.reset();
    moment_arm_error_.reset();
    estimator_.restart();
    extended_rsi_ = not_available;
    running_ = true;
}

}  // namespace rsi
