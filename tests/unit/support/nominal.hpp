// A large SUV's calibration and ordinary sensor values, as the unit tests use them.
#pragma once

#include "rsi/rsi.h"
#include "tests/support/large_suv.h"

namespace rsi_test {

constexpr double gravity_mps2 = 9.80665;
constexpr double pi = 3.14159265358979323846;

inline rsi_parameters large_suv() {
    return rsi_test_large_suv();
}

// The vehicle stands on a flat road.
inline rsi_inputs at_rest() {
    rsi_inputs inputs{};
    inputs.vertical_specific_force_mps2 = static_cast<float>(gravity_mps2);
    return inputs;
}

}  // namespace rsi_test
