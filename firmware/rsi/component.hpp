// Rollover-warning component: the C++ interface. rsi.h documents parameters, inputs and outputs.
#pragma once

#include "rsi/adaptation/load_adaptation.hpp"
#include "rsi/comparison/classic_indices.hpp"
#include "rsi/estimation/roll_centre_estimator.hpp"
#include "rsi/estimation/roll_plane_model.hpp"
#include "rsi/indicator/load_transfer.hpp"
#include "rsi/indicator/stability_threshold.hpp"
#include "rsi/measurement/measurement.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/parameter_change.hpp"
#include "rsi/parameters.hpp"
#include "rsi/prediction/moment_arm_error.hpp"
#include "rsi/prediction/roll_predictor.hpp"
#include "rsi/prediction/steering_demand.hpp"
#include "rsi/warning/indicator_level.hpp"
#include "rsi/warning/warning_state_machine.hpp"

namespace rsi {

// All state is in here; no heap, no globals, no exceptions. Not for use from two threads at once.
class Component {
 public:
    // Starts anew with these parameters (copied). When they are refused, the answer names the field, and
    // every step says "unavailable" until an init succeeds.
    [[gnu::cold]] Validation init(const Parameters& parameters);

    // Reinitialises from `parameters`, which must be those that init has accepted, and keeps what init
    // computes by iteration (the observer's settled gains, the critical roll angle). Costs no more than a
    // step, so it fits into a cycle; init does not. Without an accepted init it does nothing.
    [[gnu::cold]] void reset(const Parameters& parameters);

    // Goes on with the parameters of a change that is ready, and that began from those in use. Signals,
    // states and what has been learnt stay; only of another vehicle what was learnt of this one is forgotten.
    // Costs no more than a step. Without an accepted init it does nothing.
    [[gnu::cold]] void change(const ParameterChange& change);

    // What has been learnt of the load so far, to be kept without power.
    LearntLoad learnt_load() const { return load_adaptation_.learnt(); }

    // Takes it up in another run with the same parameters, between init and the first step. `doubted`: in
    // between the load may have changed. False, and without an effect, where it cannot have been learnt.
    [[gnu::cold]] bool restore_load(const LearntLoad& learnt, bool doubted);

    // One step of 10 ms. Never fails; what cannot be computed is NaN and the state says "unavailable".
    void step(const Inputs& inputs, Outputs& outputs);

 private:
    void start(const Parameters& parameters);
    void tune(const Parameters& parameters);
    // Rare, so not to be made part of step() as all the rest is.
    [[gnu::cold, gnu::noinline]] void step_unavailable(Outputs& outputs);
    void resume(const Measurement& measured);
    void warn(const Measurement& measured, Outputs& outputs);
    [[gnu::noinline]] void assume_body(const SprungBody& body);

    bool initialised_{false};
    bool running_{false};       // false until the first good sample after init, a gap or an overturn
    bool overturned_{false};    // and not resumed since
    float extended_rsi_{0.0F};  // of the cycle before
    float static_stability_factor_{1.0F};
    float observer_weight_{1.0F};  // of the level, while the observer stands in for the roll sensor
    MeasurementStage measurement_{};
    RollMotionFilter motion_filter_{};
    RollPlaneModel model_{};
    FixedModelRoll fixed_{};
    CompensatedModelRoll compensated_{};
    RollCentreEstimator estimator_{};
    StabilityThresholdStage threshold_{};
    LoadTransfer load_transfer_{};
    SteeringDemand steering_demand_{};
    LateralResponse lateral_response_{};
    MomentArmError moment_arm_error_{};
    RollPredictor predictor_{};
    LoadAdaptation load_adaptation_{};
    ClassicIndices comparison_{};
    WarningIndicator warning_indicator_{};
    WarningStateMachine warning_{};
};

}  // namespace rsi
