// Derived: all numbers that follow from the parameters, the body with its load and what is found by
// iterating.
#pragma once

#include "rsi/adaptation/load_adaptation.hpp"
#include "rsi/comparison/classic_indices.hpp"
#include "rsi/estimation/roll_centre_estimator.hpp"
#include "rsi/measurement/measurement.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/model/vehicle.hpp"
#include "rsi/prediction/lateral_response.hpp"
#include "rsi/prediction/moment_arm_error.hpp"
#include "rsi/prediction/roll_predictor.hpp"
#include "rsi/prediction/steering_demand.hpp"
#include "rsi/types.hpp"
#include "rsi/warning/indicator_level.hpp"
#include "rsi/warning/warning_state_machine.hpp"

namespace rsi {

// Values that follow from the parameters alone, but take about a cycle or longer to find.
struct Iterated {
    ObserverGains gains{};
    float critical_roll_angle_rad{};
};

[[gnu::cold]] Iterated iterate(const Parameters& parameters);

// Read-only in a step, but for the loaded body, which follows the load that has been learnt. A stage without
// a state is its own set of numbers; of the others the Constants are here.
struct Derived {
    Derived() = default;
    // With the calibrated body.
    [[gnu::cold]] Derived(const Parameters& parameters, const Iterated& iterated);

    Iterated iterated() const { return {measurement.observer.gains, comparison.critical_roll_angle_rad()}; }

    float static_stability_factor{};
    float observer_weight{};  // of the level, while the observer stands in for the roll sensor
    float load_transfer_inertial_weight{};
    Vehicle vehicle;
    MeasurementStage::Constants measurement;
    RollMotionFilter::Constants motion_filter;
    RollCentreEstimator::Constants estimator;
    SteeringDemand steering_demand;
    LateralResponse lateral_response;
    MomentArmError::Constants moment_arm_error;
    RollPredictor predictor;
    LoadAdaptation::Constants load_adaptation;
    ClassicIndices comparison;
    WarningIndicator warning_indicator;
    WarningStateMachine::Constants warning;
};

}  // namespace rsi
