#include "tests/application/regression/bus_faults.hpp"

#include <cstdint>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/hal/clock.hpp"

namespace rsi_test {
namespace {

// The frame is due from `begin_ms` on, and before `end_ms`.
bool is_due(const rsi::hal::CanFrame& frame, std::int64_t begin_ms, std::int64_t end_ms) {
    return !(frame.receive_time < rsi::hal::Time::from_milliseconds(begin_ms)) &&
           frame.receive_time < rsi::hal::Time::from_milliseconds(end_ms);
}

bool is_missing(const rsi::hal::CanFrame& frame) {
    switch (frame.identifier) {
        case rsi::can_dbc::Imu::identifier:
            return is_due(frame, 1000, 1010) || is_due(frame, 1500, 1600) || is_due(frame, 3000, 3300);
        case rsi::can_dbc::RollAngle::identifier:
            return is_due(frame, 3000, 3300) || is_due(frame, 4000, INT32_MAX);
        default:
            return false;
    }
}

}  // namespace

std::vector<sil::LoggedFrame> with_bus_faults(const std::vector<sil::LoggedFrame>& frames) {
    std::vector<sil::LoggedFrame> faulty;
    rsi::hal::CanFrame motion;
    for (sil::LoggedFrame logged : frames) {
        rsi::hal::CanFrame& frame = logged.frame;
        if (is_missing(frame)) {
            continue;
        }
        if (frame.identifier == rsi::can_dbc::RollAngle::identifier && is_due(frame, 2000, 2100)) {
            frame.data[3] ^= 0x10U;
        }
        if (frame.identifier == rsi::can_dbc::VehicleMotion::identifier) {
            if (is_due(frame, 2500, 2600)) {
                frame.data = motion.data;
            }
            motion = frame;
        }
        faulty.push_back(logged);
    }
    return faulty;
}

}  // namespace rsi_test
