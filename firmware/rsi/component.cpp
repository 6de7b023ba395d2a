#include "rsi/component.hpp"

#include <new>

#include "rsi/estimation/roll_centre.hpp"
#include "rsi/indicator/extended_indicator.hpp"
#include "rsi/indicator/roll_stability_indicator.hpp"
#include "rsi/indicator/stability_threshold.hpp"
#include "rsi/model/critical_roll_angle.hpp"
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

// In place: a copy would need the object's size again on the stack.
Validation Component::init(const Parameters& parameters) {
    const Validation answer = validate(parameters);
    if (answer.accepted != 0) {
        ::new (static_cast<void*>(this)) Component{parameters, iterate(parameters)};
    } else {
        ::new (static_cast<void*>(this)) Component{};
    }
    return answer;
}

void Component::reset(const Parameters& parameters) {
    if (is_initialised()) {
        ::new (static_cast<void*>(this)) Component{parameters, derived_.iterated()};
    }
}

Component::Component(const Parameters& parameters, const Iterated& iterated)
    : mark_(mark_of_init), derived_(parameters, iterated) {
    state_.estimator.reset(derived_.estimator);
}

void Component::change(const ParameterChange& change) {
    const Parameters& parameters = change.parameters();
    if (!is_initialised()) {
        if (change.has_gains()) {
            ::new (static_cast<void*>(this))
                Component{parameters, Iterated{change.gains(), critical_roll_angle_rad(parameters)}};
        }
        return;
    }
    const bool had_horizon = derived_.measurement.against_horizon;
    const Iterated iterated{change.has_gains() ? change.gains() : derived_.measurement.observer.gains,
                            critical_roll_angle_rad(parameters)};
    ::new (static_cast<void*>(&derived_)) Derived{parameters, iterated};
    if (derived_.measurement.against_horizon != had_horizon) {
        state_.measurement.reset_bank();
    }
    if (change.is_another_vehicle()) {
        state_.estimator.reset(derived_.estimator);
        state_.moment_arm_error.reset();
        state_.load_adaptation = LoadAdaptation{};
    } else if (change.has_other_units()) {
        state_.estimator.reset_published();
    } else {
        // All that has been learnt is of this vehicle and these units.
    }
    take_load();
}

bool Component::restore_load(const LearntLoad& learnt, bool doubted) {
    const bool restored = is_initialised() && state_.load_adaptation.restore(learnt, doubted);
    if (restored) {
        take_load();
    }
    return restored;
}

// All stages use the body as loaded, with two exceptions: the observer, against which the roll sensor is
// checked, must not follow what the roll sensor has taught (its check admits more roll under a load, within a
// bound), and the indices for comparison stay as published.
void Component::take_load() {
    derived_.vehicle.loaded =
        loaded_body(derived_.vehicle.suspension, state_.load_adaptation.body(derived_.load_adaptation));
}

// The algorithm from the sensors to the warning. Flattened: the library is compiled as one unit, and a third
// of the cost of the small functions below would be calling them.
[[gnu::flatten]] void Component::step(const Inputs& inputs, Outputs& outputs) {
    const Derived& derived = derived_;
    const Vehicle& vehicle = derived.vehicle;
    State& state = state_;
    if (!is_initialised()) {
        step_unavailable(outputs);
        return;
    }

    // Measure, and observe roll and bank.
    const Learnt learnt{
        state.estimator.movement_for_observer_m(derived.estimator),
        state.load_adaptation.roll_factor(derived.load_adaptation, derived.vehicle.loaded.moment_arm_kgm)};
    Measurement measured;
    if (!state.measurement.update(derived.measurement, inputs, learnt, measured)) {
        step_unavailable(outputs);
        return;
    }
    if (!state.running) {
        resume(measured);
    }
    const RollMotion motion = state.motion_filter.update(derived.motion_filter, measured);
    write_measurement(measured, outputs);

    // Model: how a vehicle with a fixed roll centre would roll, (1).
    FixedModelRoll& fixed = state.fixed;
    fixed.update(vehicle, measured);
    outputs.fixed_model_roll_angle_rad = fixed.angle_rad();

    // Estimate the roll centre's vertical movement.
    const RollCentreEstimate estimate = state.estimator.update(derived.estimator, vehicle, measured, fixed,
                                                               state.extended_rsi, inputs.speed_mps);
    write_estimate(estimate, outputs);

    // Roll centre, (6), the moment that its movement adds, (7), and the model that it compensates.
    const float c_rc = lateral_roll_centre_m(vehicle, measured, fixed, estimate.vertical_movement_m);
    const float M_add = additional_roll_moment_nm(vehicle, measured, estimate, c_rc);
    outputs.roll_centre_lateral_m = c_rc;
    outputs.additional_roll_moment_nm = M_add;
    state.compensated.update(vehicle, measured, fixed, M_add);
    outputs.compensated_roll_angle_rad = state.compensated.angle_rad();

    // Threshold, (23), and RSI, (25).
    const StabilityThreshold threshold =
        stability_threshold(vehicle, measured, estimate.vertical_movement_m, c_rc);
    outputs.lateral_acceleration_threshold_mps2 = threshold.lateral_acceleration_mps2;
    outputs.rsi = normalised_indicator(measured, threshold);
    outputs.rsi_bank_free = bank_free_indicator(measured, threshold);

    // Load transfer, (26), and the extended RSI.
    const TransferredLoad load = transferred_load(vehicle, derived.load_transfer_inertial_weight, motion);
    outputs.load_transfer_ratio = load.ratio;
    outputs.rsi_extended = extended_level(motion, vehicle.loaded);

    // Predict both.
    const DemandedForce demand = derived.steering_demand.evaluate(inputs, measured);
    const float moment_arm_error = state.moment_arm_error.update(
        derived.moment_arm_error, vehicle.loaded, motion, load, measured.roll_source == RSI_ROLL_SENSOR);
    ForceTarget target{};
    const bool is_course_known = state.tyre_limit.update(derived.lateral_response, motion, demand, target);
    const float forecast = state.forecast.update(vehicle, inputs, measured, demand);
    const Prediction predicted =
        derived.predictor.evaluate(vehicle, motion, load, demand, derived.lateral_response,
                                   is_course_known ? &target : nullptr, moment_arm_error, forecast);
    outputs.predicted_load_transfer_ratio = predicted.load_transfer_ratio;
    outputs.opposite_load_transfer_ratio = predicted.opposite_ratio;
    outputs.predicted_rsi = larger(outputs.rsi_extended, predicted.rsi_extended);

    // Learn the load.
    state.load_adaptation.update(derived.load_adaptation, inputs, motion, load,
                                 measured.roll_angle_is_measured);
    write_load(state.load_adaptation.learnt(), outputs);

    // For comparison: the paper's other indices.
    derived.comparison.evaluate(measured, motion, outputs);

    // Warn.
    warn(measured, outputs);

    // To the next sample.
    state.extended_rsi = outputs.rsi_extended;
    take_load();
}

// An overturned vehicle sets the warning, whatever the indicator. Without a level there is no statement.
// Nothing is learnt while the vehicle lies on its side: every sample starts the component anew until it
// stands again.
void Component::warn(const Measurement& measured, Outputs& outputs) {
    const IndicatedRisk indicated = derived_.warning_indicator.evaluate(outputs, measured.roll_angle_rad);
    outputs.warning_level = indicated.level;
    const float source_weight = (measured.roll_source == RSI_ROLL_OBSERVER) ? derived_.observer_weight : 1.0F;
    const float weight = source_weight * state_.load_adaptation.level_weight(derived_.load_adaptation);
    RiskLevel risk{weight * indicated.level, indicated.direction, weight * indicated.opposite};
    if (has_overturned(measured, derived_.static_stability_factor)) {
        state_.overturned = true;
        state_.running = false;
        risk = RiskLevel{derived_.warning.warning_on, measured.roll_angle_rad, 0.0F};
    }
    state_.warning.update(derived_.warning, risk);
    outputs.state = state_.warning.state();
    outputs.side = state_.warning.side();
}

void Component::step_unavailable(Outputs& outputs) {
    state_.running = false;
    state_.warning.update_unavailable();
    outputs = no_outputs();
}

// After a gap the models start where the vehicle is; what the estimator has learnt stays, but not past an
// overturn.
void Component::resume(const Measurement& measured) {
    if (state_.overturned) {
        state_.estimator.reset(derived_.estimator);
        state_.load_adaptation.reset_learnt();
        state_.overturned = false;
    }
    state_.fixed.reset(measured.roll_angle_rad);
    state_.compensated.reset(measured.roll_angle_rad);
    state_.motion_filter.reset(measured);
    state_.tyre_limit.reset(derived_.lateral_response);
    state_.moment_arm_error.reset();
    state_.forecast.reset();
    state_.estimator.reset_signals();
    state_.extended_rsi = not_available;
    state_.running = true;
}

}  // namespace rsi
