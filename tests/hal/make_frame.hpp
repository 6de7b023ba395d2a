// Short spellings for frames in tests.
#pragma once

#include <cstdint>
#include <initializer_list>

#include "rsi/hal/can_bus.hpp"

namespace rsi::hal::testing {

inline CanFrame make_frame(std::uint32_t identifier, std::initializer_list<std::uint8_t> payload = {}) {
    CanFrame frame;
    frame.identifier = identifier;
    for (const std::uint8_t byte : payload) {
        frame.data[frame.length++] = byte;
    }
    return frame;
}

inline CanFrame make_frame_at(Time time, std::uint32_t identifier) {
    CanFrame frame = make_frame(identifier);
    frame.receive_time = time;
    return frame;
}

}  // namespace rsi::hal::testing
