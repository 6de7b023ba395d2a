// Calibration identity: by what a workshop knows the calibration that the ECU runs on.
#pragma once

#include <array>
#include <cstdint>

#include "rsi/ecu/application/parameter_section.hpp"

namespace rsi::application {

struct CalibrationIdentity {
    // That of the section with which the ECU has started; zeros after a start without one.
    std::array<std::uint8_t, section::name_length> name{};
    // CRC-32 of the values in use, in the form in which a section has them; changes over XCP change it. The
    // same as that of XCP over the whole calibration.
    std::uint32_t checksum{0U};
};

}  // namespace rsi::application
