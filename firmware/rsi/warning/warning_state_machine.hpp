// Warning state machine: unavailable, ready, advisory, warning; hysteresis, confirmation, minimum hold times,
// side.
#pragma once

#include <cstdint>

#include "rsi/types.hpp"

namespace rsi {

// Risk of one sample.
struct RiskLevel {
    float indicator{0.0F};  // towards the side of the larger risk; 1 at the threshold
    float side{1.0F};       // < 0 in a right turn
    float opposite{0.0F};   // towards the other side, for an indicator that knows both; else 0
};

class WarningStateMachine {
 public:
    struct Constants {
        Constants() = default;
        [[gnu::cold]] explicit Constants(const Parameters& parameters);

        float advisory_on{};
        float advisory_off{};
        float warning_on{};
        float warning_off{};
        std::uint32_t confirmation_samples{};
        std::uint32_t advisory_hold_samples{};
        std::uint32_t warning_hold_samples{};
        std::uint32_t recovery_samples{};
    };

    // A sample without a statement: "unavailable" at once.
    void update_unavailable();

    // A sample with a statement; an indicator without a number is none. "Unavailable" is left once the inputs
    // have been good for recovery_s.
    void update(const Constants& constants, const RiskLevel& risk);

    rsi_state state() const { return state_; }
    rsi_side side() const { return side_; }

 private:
    void enter(rsi_state state);
    // `level`: the "on" level of the state.
    float level_of_state(const Constants& constants) const;
    void count_hold(float level, const RiskLevel& risk);
    void count_confirmation(const Constants& constants, const RiskLevel& risk);
    rsi_state next_state(const Constants& constants, const RiskLevel& risk) const;
    void update_side(const Constants& constants, float level, const RiskLevel& risk);
    rsi_side next_side(const Constants& constants, float level, const RiskLevel& risk) const;

    rsi_state state_{RSI_STATE_UNAVAILABLE};
    rsi_side side_{RSI_SIDE_NONE};
    std::uint32_t held_samples_{};  // since the last at the level of the state, that one included
    std::uint32_t samples_at_warning_level_{};
    std::uint32_t good_samples_{};
};

}  // namespace rsi
