// Any calibration, accepted or not.
#pragma once

#include <cstdint>

#include "rsi/parameters.hpp"
#include "tests/quality/fuzz/support/byte_reader.hpp"
#include "tests/support/large_suv.h"

namespace fuzz {

// Choices of a calibration; true if the warning is to be held and to recover for no time at all.
inline bool choose_any(rsi_parameters& parameters, ByteReader& bytes) {
    const unsigned choices = bytes.below(4U);  // one byte for both, as the committed inputs have it
    parameters.estimator = static_cast<std::int32_t>(choices % 2U);
    parameters.roll_angle_reference = static_cast<std::int32_t>(choices / 2U);
    parameters.warning_indicator = static_cast<std::int32_t>(bytes.below(13U));
    const bool without_times = bytes.one_in(2U);
    if (without_times) {
        parameters.recovery_s = parameters.advisory_hold_s = parameters.warning_hold_s = 0.0F;
    }
    return without_times;
}

// A large SUV with a few values anywhere between their limits; not all of it will be accepted.
inline rsi_parameters any_calibration(ByteReader& bytes) {
    rsi_parameters parameters = rsi_test_large_suv();
    parameters.imu_x_m = 1.0F;
    parameters.imu_y_m = -0.5F;
    parameters.imu_z_m = 0.5F;
    choose_any(parameters, bytes);
    for (unsigned changes = bytes.below(8U); changes > 0U; --changes) {
        const rsi::ParameterField& field = rsi::parameter_fields[bytes.below(rsi::parameter_fields.size())];
        const float share = static_cast<float>(bytes.take<std::uint16_t>()) / 65535.0F;
        parameters.*field.member = field.minimum + share * (field.maximum - field.minimum);
    }
    if (bytes.one_in(16U)) {
        parameters.*rsi::parameter_fields[bytes.below(rsi::parameter_fields.size())].member =
            bytes.take<float>();
    }
    return parameters;
}

}  // namespace fuzz
