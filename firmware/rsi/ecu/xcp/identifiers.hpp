// Identifiers of XCP on CAN: settings of the integration, like the A2L's. These are free in the DBC file, and
// lower in priority than every frame of it.
#pragma once

#include <cstdint>

namespace rsi::xcp {

// Both of 11 bits.
struct Identifiers {
    std::uint32_t command;  // master to slave (CRO)
    std::uint32_t answer;   // slave to master (DTO): answers, events and samples
};

inline constexpr Identifiers default_identifiers{0x6F0U, 0x6F1U};

}  // namespace rsi::xcp
