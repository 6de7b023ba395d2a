#include "tests/application/regression/bus_faults.hpp"

#include <cstdint>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/hal/clock.hpp"

namespace rsi_test {
namespace {

// Within [begin_ms, end_ms) of the recording's time.
bool is_received_within(const rsi::hal::CanFrame& frame, std::int64_t begin_ms, std::int64_t end_ms) {
    return !(frame.receive_time < rsi::hal::Time::from_milliseconds(begin_ms)) &&
           frame.receive_time < rsi::hal::Time::from_milliseconds(end_ms);
}

constexpr std::int64_t end_of_recording_ms = INT32_MAX;

// Times and faults are listed in bus_faults.hpp.
bool is_dropped(const rsi::hal::CanFrame& frame) {
    switch (frame.identifier) {
        case rsi::can_dbc::Imu::identifier:
            return is_received_within(frame, 1000, 1010) || is_received_within(frame, 1500, 1600) ||
                   is_received_within(frame, 3000, 3300);
        case rsi::can_dbc::RollAngle::identifier:
            return is_received_within(frame, 3000, 3300) ||
                   is_received_within(frame, 4000, end_of_recording_ms);
        default:
            return false;
    }
}

}  // namespace

std::vector<sil::LoggedFrame> with_bus_faults(const std::vector<sil::LoggedFrame>& frames) {
    std::vector<sil::LoggedFrame> faulty;
    rsi::hal::CanFrame last_motion;
    for (sil::LoggedFrame logged : frames) {
        rsi::hal::CanFrame& frame = logged.frame;
        if (is_dropped(frame)) {
            continue;
        }
        if (frame.identifier == rsi::can_dbc::RollAngle::identifier &&
            is_received_within(frame, 2000, 2100)) {
            frame.data[3] ^= 0x10U;  // of the roll angle, behind the CRC: the end-to-end check must detect it
        }
        if (frame.identifier == rsi::can_dbc::VehicleMotion::identifier) {
            if (is_received_within(frame, 2500, 2600)) {
                frame.data = last_motion.data;
            }
            last_motion = frame;
        }
        faulty.push_back(logged);
    }
    return faulty;
}

}  // namespace rsi_test
