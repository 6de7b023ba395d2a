#include "rsi/warning/warning_state_machine.hpp"

#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/saturating_count.hpp"

namespace rsi {
namespace {

// Times are validated to 0 .. 60 s, so the conversion is within range.
std::uint32_t to_samples(float time_s) {
    return static_cast<std::uint32_t>(time_s * (1.0F / sample_time_s) + 0.5F);
}

rsi_side falling_side(float side) {
    return (side < 0.0F) ? RSI_SIDE_LEFT : RSI_SIDE_RIGHT;
}

}  // namespace

WarningStateMachine::Constants::Constants(const Parameters& parameters)
    : advisory_on(parameters.advisory_on),
      advisory_off(parameters.advisory_off),
      warning_on(parameters.warning_on),
      warning_off(parameters.warning_off),
      confirmation_samples(to_samples(parameters.warning_confirmation_s)),
      advisory_hold_samples(to_samples(parameters.advisory_hold_s)),
      warning_hold_samples(to_samples(parameters.warning_hold_s)),
      recovery_samples(to_samples(parameters.recovery_s)) {}

void WarningStateMachine::update_unavailable() {
    state_ = RSI_STATE_UNAVAILABLE;
    side_ = RSI_SIDE_NONE;
    held_samples_ = 0U;
    samples_at_warning_level_ = 0U;
    good_samples_ = 0U;
}

void WarningStateMachine::enter(rsi_state state) {
    if (state != state_) {
        state_ = state;
        held_samples_ = 0U;
    }
}

void WarningStateMachine::count_confirmation(const Constants& constants, const RiskLevel& risk) {
    if (risk.indicator >= constants.warning_on) {
        count_up(samples_at_warning_level_);
    } else {
        samples_at_warning_level_ = 0U;
    }
}

void WarningStateMachine::update(const Constants& constants, const RiskLevel& risk) {
    if (!is_finite(risk.indicator)) {
        update_unavailable();
        return;
    }
    if (state_ == RSI_STATE_UNAVAILABLE) {
        count_up(good_samples_);
        if (good_samples_ < constants.recovery_samples) {
            return;
        }
        enter(RSI_STATE_READY);
    }
    count_confirmation(constants, risk);
    enter(next_state(constants, risk));
    const float level = level_of_state(constants);
    count_hold(level, risk);
    update_side(constants, level, risk);
}

// The hold time starts anew at each sample at the level of the state.
void WarningStateMachine::count_hold(float level, const RiskLevel& risk) {
    if (risk.indicator >= level) {
        held_samples_ = 1U;
    } else {
        count_up(held_samples_);
    }
}

float WarningStateMachine::level_of_state(const Constants& constants) const {
    return (state_ == RSI_STATE_WARNING) ? constants.warning_on : constants.advisory_on;
}

// Up at once (after confirmation), down only after the hold time and below the "off" level.
rsi_state WarningStateMachine::next_state(const Constants& constants, const RiskLevel& risk) const {
    if ((samples_at_warning_level_ > 0U) && (samples_at_warning_level_ >= constants.confirmation_samples)) {
        return RSI_STATE_WARNING;
    }
    switch (state_) {
        case RSI_STATE_WARNING:
            if ((risk.indicator >= constants.warning_off) ||
                (held_samples_ < constants.warning_hold_samples)) {
                return RSI_STATE_WARNING;
            }
            return (risk.indicator >= constants.advisory_off) ? RSI_STATE_ADVISORY : RSI_STATE_READY;
        case RSI_STATE_ADVISORY:
            if ((risk.indicator >= constants.advisory_off) ||
                (held_samples_ < constants.advisory_hold_samples)) {
                return RSI_STATE_ADVISORY;
            }
            return RSI_STATE_READY;
        default:
            return (risk.indicator >= constants.advisory_on) ? RSI_STATE_ADVISORY : RSI_STATE_READY;
    }
}

void WarningStateMachine::update_side(const Constants& constants, float level, const RiskLevel& risk) {
    side_ = (state_ == RSI_STATE_READY) ? RSI_SIDE_NONE : next_side(constants, level, risk);
}

// A side stays named while its own risk lasts and the other's does not reach the level of the state; below
// the advisory level it gives way to the other above it. Once neither is at risk, a held state keeps its side
// as long as the indicator points there.
rsi_side WarningStateMachine::next_side(const Constants& constants, float level,
                                        const RiskLevel& risk) const {
    const rsi_side riskier = falling_side(risk.side);
    if (risk.indicator < constants.advisory_off) {
        return (side_ == riskier) ? side_ : RSI_SIDE_NONE;
    }
    if ((side_ == RSI_SIDE_NONE) || (risk.opposite < constants.advisory_off)) {
        return riskier;
    }
    const bool takes_over = (risk.indicator >= level) || ((risk.indicator >= constants.advisory_on) &&
                                                          (risk.opposite < constants.advisory_on));
    return takes_over ? riskier : side_;
}

}  // namespace rsi
