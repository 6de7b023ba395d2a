// Rollover-warning component: the C++ interface. rsi.h documents parameters, inputs and outputs.
#pragma once

#include "rsi/language.hpp"

#include <cstdint>

#include "rsi/adaptation/load_adaptation.hpp"
#include "rsi/derived.hpp"
#include "rsi/estimation/roll_centre_estimator.hpp"
#include "rsi/estimation/roll_plane_model.hpp"
#include "rsi/measurement/measurement.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/parameter_change.hpp"
#include "rsi/parameters.hpp"
#include "rsi/prediction/lateral_response.hpp"
#include "rsi/prediction/linear_forecast.hpp"
#include "rsi/prediction/moment_arm_error.hpp"
#include "rsi/warning/warning_state_machine.hpp"

namespace rsi {

// State that lasts from one sample to the next.
struct State {
    bool running{false};     // false until the first good sample after init, a gap or an overturn
    bool overturned{false};  // and not resumed since
    float extended_rsi{};    // of the cycle before
    MeasurementStage measurement{};
    RollMotionFilter motion_filter{};
    FixedModelRoll fixed{};
    CompensatedModelRoll compensated{};
    RollCentreEstimator estimator{};
    TyreLimit tyre_limit{};
    MomentArmError moment_arm_error{};
    LinearForecast forecast{};
    LoadAdaptation load_adaptation{};
    WarningStateMachine warning{};
};

// All state is in here; no heap, no globals, no exceptions. Not for use from two threads at once.
class Component {
 public:
    Component() = default;

    // Starts anew with these parameters (copied). When they are refused, the answer names the field, and
    // every step says "unavailable" until an init succeeds.
    [[gnu::cold]] Validation init(const Parameters& parameters);

    // As init, with `parameters`, which must be those that init has accepted; keeps what init has found by
    // iterating. Costs no more than a step, so it fits into a cycle; init does not. Without an accepted init
    // it does nothing.
    [[gnu::cold]] void reset(const Parameters& parameters);

    // Goes on with the parameters of a change that is ready, and that began from those in use. Signals,
    // states and what has been learnt stay; only of another vehicle what was learnt of this one is forgotten.
    // Costs no more than a step. Without an accepted init it starts, as init does, with a change that has
    // begun from Parameters{}; with another it does nothing.
    [[gnu::cold]] void change(const ParameterChange& change);

    // The load learnt so far, to be kept without power.
    LearntLoad learnt_load() const { return state_.load_adaptation.learnt(); }

    // Takes it up in another run with the same parameters, between init and the first step. `doubted`: in
    // between the load may have changed. False, and without an effect, where it cannot have been learnt.
    [[gnu::cold]] bool restore_load(const LearntLoad& learnt, bool doubted);

    // One step of 10 ms. Never fails; what cannot be computed is NaN and the state says "unavailable".
    void step(const Inputs& inputs, Outputs& outputs);

 private:
    [[gnu::cold]] Component(const Parameters& parameters, const Iterated& iterated);

    // Rare, so not to be made part of step() as all the rest is.
    [[gnu::cold, gnu::noinline]] void step_unavailable(Outputs& outputs);
    void resume(const Measurement& measured);
    void warn(const Measurement& measured, Outputs& outputs);
    [[gnu::noinline]] void take_load();

    // A mark and no bool: memory before the first init may hold anything.
    static constexpr std::uint32_t mark_of_init = 0x5AC3'96E1U;
    bool is_initialised() const { return mark_ == mark_of_init; }

    std::uint32_t mark_{0U};  // mark_of_init after an init that accepts the parameters
    Derived derived_;
    State state_{};
};

}  // namespace rsi
