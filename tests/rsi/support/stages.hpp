// The component's stages one by one, each with the numbers that follow from its parameters: for tests of one
// stage. rsi::Component has those numbers together in rsi::Derived.
#pragma once

#include "rsi/derived.hpp"

namespace rsi_test {

struct RollBankObserver : rsi::RollBankObserver {
    void init(const rsi::Parameters& parameters) {
        *this = {};
        constants = {parameters, rsi::iterate(parameters).gains};
    }
    void update(float lateral_force_mps2, float roll_rate_radps, float yaw_rate_radps, float speed_mps) {
        rsi::RollBankObserver::update(
            constants, {lateral_force_mps2, roll_rate_radps, yaw_rate_radps, speed_mps}, vertical_movement_m);
    }

    Constants constants{};
    float vertical_movement_m{0.0F};
};

struct RollSensorCheck : rsi::RollSensorCheck {
    explicit RollSensorCheck(const rsi::Parameters& parameters) : constants{parameters} {}
    void update(float difference_rad) { rsi::RollSensorCheck::update(constants, difference_rad); }

    Constants constants;
};

struct MeasurementStage : rsi::MeasurementStage {
    void init(const rsi::Parameters& parameters) {
        *this = {};
        constants = {parameters, rsi::iterate(parameters).gains};
    }
    bool update(const rsi::Inputs& inputs, rsi::Measurement& measurement) {
        return rsi::MeasurementStage::update(constants, inputs, learnt, measurement);
    }

    Constants constants{};
    rsi::Learnt learnt{};
};

struct FilteredRollEquation : rsi::FilteredRollEquation {
    explicit FilteredRollEquation(const rsi::Parameters& parameters)
        : constants{parameters}, vehicle{parameters} {}
    rsi::RollEquation update(const rsi::Measurement& measured) {
        return rsi::FilteredRollEquation::update(constants, vehicle, measured);
    }

    Constants constants;
    rsi::Vehicle vehicle;
};

struct ConsiderKalman : rsi::ConsiderKalman {
    void init(const rsi::Parameters& parameters) {
        constants = Constants{parameters};
        vehicle = rsi::Vehicle{parameters};
        reset();
    }
    void reset() { rsi::ConsiderKalman::reset(constants); }
    rsi::RollCentreEstimate update(const rsi::Measurement& measured, float extended_rsi, float speed_mps) {
        return rsi::ConsiderKalman::update(constants, vehicle, measured, extended_rsi, speed_mps);
    }

    Constants constants{};
    rsi::Vehicle vehicle{};
};

struct RobustLeastSquares : rsi::RobustLeastSquares {
    void init(const rsi::Parameters& parameters) {
        constants = Constants{parameters};
        reset();
    }
    void update(const rsi::Regression& regression) { rsi::RobustLeastSquares::update(constants, regression); }
    rsi::RollCentreEstimate estimate() const { return rsi::RobustLeastSquares::estimate(constants); }

    Constants constants{};
};

struct RollCentreEstimator : rsi::RollCentreEstimator {
    void init(const rsi::Parameters& parameters) {
        constants = Constants{parameters};
        vehicle = rsi::Vehicle{parameters};
        reset(constants);
    }
    rsi::RollCentreEstimate update(const rsi::Measurement& measured, const rsi::FixedModelRoll& fixed,
                                   float extended_rsi, float speed_mps) {
        return rsi::RollCentreEstimator::update(constants, vehicle, measured, fixed, extended_rsi, speed_mps);
    }
    float movement_for_observer_m() const {
        return rsi::RollCentreEstimator::movement_for_observer_m(constants);
    }

    Constants constants{};
    rsi::Vehicle vehicle{};
};

struct LoadRegression : rsi::LoadRegression {
    explicit LoadRegression(const rsi::Parameters& parameters) : constants{parameters} {}
    bool update(const rsi::RollMotion& motion, const rsi::TransferredLoad& load) {
        return rsi::LoadRegression::update(constants, motion, load);
    }

    Constants constants;
};

struct LoadAdaptation : rsi::LoadAdaptation {
    explicit LoadAdaptation(const rsi::Parameters& parameters) : constants{parameters} {}
    void update(const rsi::Inputs& inputs, const rsi::RollMotion& motion, const rsi::TransferredLoad& load,
                bool measured_angle) {
        rsi::LoadAdaptation::update(constants, inputs, motion, load, measured_angle);
    }
    rsi::SprungBody body() const { return rsi::LoadAdaptation::body(constants); }
    float known_mass_factor() const { return rsi::LoadAdaptation::known_mass_factor(constants); }
    float roll_factor() const { return rsi::LoadAdaptation::roll_factor(constants, body().moment_arm_kgm()); }
    float level_weight() const { return rsi::LoadAdaptation::level_weight(constants); }

    Constants constants;
};

struct MomentArmError : rsi::MomentArmError {
    explicit MomentArmError(const rsi::Parameters& parameters) : constants{parameters}, vehicle{parameters} {
        reset();
    }
    float update(const rsi::RollMotion& motion, const rsi::TransferredLoad& load, bool measured_angle) {
        return rsi::MomentArmError::update(constants, vehicle.loaded, motion, load, measured_angle);
    }

    Constants constants;
    rsi::Vehicle vehicle;
};

// The response with the limit of the tyres that it has learnt.
struct LateralResponse {
    void init(const rsi::Parameters& parameters) {
        response = rsi::LateralResponse{parameters};
        reset();
    }
    void reset() { limit.reset(response); }
    bool update(const rsi::RollMotion& motion, const rsi::DemandedForce& demand) {
        return limit.update(response, motion, demand, target);
    }
    rsi::ForceCourse after_step(const rsi::ForceCourse& from) const {
        return response.after_step(from, target);
    }

    rsi::LateralResponse response{};
    rsi::TyreLimit limit{};
    rsi::ForceTarget target{};
};

struct WarningStateMachine : rsi::WarningStateMachine {
    void init(const rsi::Parameters& parameters) {
        *this = {};
        constants = Constants{parameters};
    }
    void update(const rsi::RiskLevel& risk) { rsi::WarningStateMachine::update(constants, risk); }

    Constants constants{};
};

}  // namespace rsi_test
