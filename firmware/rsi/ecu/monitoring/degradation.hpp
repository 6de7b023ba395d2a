// Degradation: what the component can still do.
#pragma once

#include <cstdint>

#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

enum class Degradation : std::uint8_t {
    unavailable,       // no statement on the risk
    full,              // all that matters is there
    roll_sensor_lost,  // the observer stands in for the roll sensor
    motion_lost,       // without speed or yaw rate: nothing stands in for the roll sensor if it fails too
    internal_fault,    // the control unit has found itself faulty; no statement on the risk
};

// Degradation of a cycle with these inputs and outputs.
inline Degradation degradation_of(const rsi::Inputs& inputs, const rsi::Outputs& outputs,
                                  bool internal_fault) noexcept {
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
    return moving_known ? Degradation::full : Degradation::motion_lost;
}

}  // namespace rsi::monitoring
