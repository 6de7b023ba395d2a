// Degradation: the function that is left in the current fault state.
#pragma once

#include <cstdint>

#include "rsi/ecu/monitoring/signatures.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

enum class Degradation : std::uint8_t {
    unavailable,       // no warning function
    full,              // no restriction
    roll_sensor_lost,  // the observer replaces the roll sensor
    motion_lost,       // no speed or yaw rate: nothing would replace a failing roll sensor
    internal_fault,    // a self-check has failed; no warning function
    mass_lost,         // the received vehicle mass is not used; the last one as far as the load admits
};

// Degradation of a cycle with these inputs and outputs.
inline Degradation degradation_of(const rsi::Inputs& inputs, const rsi::Outputs& outputs, bool internal_fault,
                                  CodeSet confirmed) noexcept {
    if (internal_fault) {
        return Degradation::internal_fault;
    }
    if (outputs.state == RSI_STATE_UNAVAILABLE) {
        return Degradation::unavailable;
    }
    if (outputs.roll_source != RSI_ROLL_SENSOR) {
        return Degradation::roll_sensor_lost;
    }
    const bool moving_known = rsi::is_finite(inputs.speed_mps) && rsi::is_finite(inputs.yaw_rate_radps);
    if (!moving_known) {
        return Degradation::motion_lost;
    }
    return ((confirmed & mass_codes) == 0U) ? Degradation::full : Degradation::mass_lost;
}

}  // namespace rsi::monitoring
