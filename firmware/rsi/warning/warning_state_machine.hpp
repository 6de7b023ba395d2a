// Warning state machine: unavailable, ready, advisory, warning; hysteresis, confirmation, minimum hold times,
// side.
#pragma once

#include <cstdint>

#include "rsi/types.hpp"

namespace rsi {

// What one sample says about the risk.
struct RiskLevel {
    float indicator{0.0F};  // towards the side of the larger risk; 1 at the threshold
    float side{1.0F};       // < 0 in a right turn
    float opposite{0.0F};   // towards the other side, for an indicator that knows both; else 0
};

class WarningStateMachine {
 public:
    [[gnu::cold]] void init(const Parameters& parameters) {
        tune(parameters);
        update_unavailable();
    }

    // The parameters from now on; the state stays until a sample changes it.
    [[gnu::cold]] void tune(const Parameters& parameters);

    // A sample without a statement: "unavailable" at once.
    void update_unavailable();

    // A sample with a statement; an indicator without a number is none. "Unavailable" is left once the inputs
    // have been good for recovery_s.
    void update(const RiskLevel& risk);

    rsi_state state() const { return state_; }
    rsi_side side() const { return side_; }
    float warning_on() const { return warning_on_; }

 private:
    void enter(rsi_state state);
    void count_confirmation(const RiskLevel& risk);
    rsi_state next_state(const RiskLevel& risk) const;
    void update_side(const RiskLevel& risk);
    rsi_side next_side(const RiskLevel& risk) const;

    float advisory_on_{1.0F};
    float advisory_off_{1.0F};
    float warning_on_{1.0F};
    float warning_off_{1.0F};
    std::uint32_t confirmation_samples_{1U};
    std::uint32_t advisory_hold_samples_{0U};
    std::uint32_t warning_hold_samples_{0U};
    std::uint32_t recovery_samples_{1U};

    rsi_state state_{RSI_STATE_UNAVAILABLE};
    rsi_side side_{RSI_SIDE_NONE};
    std::uint32_t samples_in_state_{0U};
    std::uint32_t samples_at_warning_level_{0U};
    std::uint32_t good_samples_{0U};
};

}  // namespace rsi
