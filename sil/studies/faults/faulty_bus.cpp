#include "sil/studies/faults/faulty_bus.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/hal/can_bus.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/simulation/sensor_frames.hpp"
#include "sil/studies/faults/fault.hpp"
#include "sil/studies/faults/sensor_signal.hpp"

namespace sil {
namespace {

template <typename Message>
rsi::hal::CanFrame protected_frame(const Message& message, std::uint8_t counter) {
    auto payload = rsi::can_dbc::encode(message);
    rsi::can_dbc::e2e::protect_profile_11(payload, Message::e2e_data_id, counter);
    return to_frame<Message>(payload);
}

rsi::can_dbc::Imu imu(bool calm) {
    rsi::can_dbc::Imu message;
    message.lateral_acceleration_mps2 = calm ? 0.0F : 8.0F;
    message.vertical_acceleration_mps2 = 9.81F;
    message.roll_rate_deg_per_s = calm ? 0.0F : 20.0F;
    return message;
}

rsi::can_dbc::RollAngle roll_angle(bool calm) {
    rsi::can_dbc::RollAngle message;
    message.roll_angle_deg = calm ? 0.0F : 9.0F;
    return message;
}

rsi::can_dbc::VehicleMotion motion(bool calm) {
    rsi::can_dbc::VehicleMotion message;
    message.speed_kmh = 100.0F;
    message.yaw_rate_deg_per_s = calm ? 0.0F : 20.0F;
    message.steering_wheel_angle_deg = calm ? 0.0F : 200.0F;
    return message;
}

rsi::can_dbc::RolloverWarning warning(bool calm) {
    rsi::can_dbc::RolloverWarning message;
    message.state =
        calm ? rsi::can_dbc::RolloverWarning::State::ready : rsi::can_dbc::RolloverWarning::State::warning;
    message.side =
        calm ? rsi::can_dbc::RolloverWarning::Side::none : rsi::can_dbc::RolloverWarning::Side::right;
    return message;
}

// Identifier of a sensor frame, or of the ECU's warning. Its content depends on the sign of `magnitude`.
// Negative: calm, a vehicle that goes straight ahead at 100 km/h, and `ready`. Else: alarming, one that is
// about to roll over to the right, and `warning`.
rsi::hal::CanFrame second_senders_frame(FaultPlace place, double magnitude, std::uint8_t counter) {
    const bool calm = magnitude < 0.0;
    switch (place) {
        case FaultPlace::imu_frame:
            return protected_frame(imu(calm), counter);
        case FaultPlace::roll_angle_frame:
            return protected_frame(roll_angle(calm), counter);
        case FaultPlace::vehicle_motion_frame:
            return protected_frame(motion(calm), counter);
        default:
            return protected_frame(warning(calm), counter);
    }
}

constexpr std::uint32_t foreign_identifier = 0x010U;  // of high priority
constexpr std::uint8_t counter_jump = 5U;             // beyond the step of one that every frame makes
constexpr int frames_of_tenfold_sender = 10;          // a cycle

struct SensorFrame {
    FaultPlace place;
    std::uint32_t identifier;
    std::uint16_t data_id;
};
constexpr std::array<SensorFrame, 3> protected_frames{
    {{FaultPlace::imu_frame, rsi::can_dbc::Imu::identifier, rsi::can_dbc::Imu::e2e_data_id},
     {FaultPlace::roll_angle_frame, rsi::can_dbc::RollAngle::identifier,
      rsi::can_dbc::RollAngle::e2e_data_id},
     {FaultPlace::vehicle_motion_frame, rsi::can_dbc::VehicleMotion::identifier,
      rsi::can_dbc::VehicleMotion::e2e_data_id}}};

// Faults of it are those of its signal alone.
constexpr SensorFrame mass_frame{FaultPlace::vehicle_mass, rsi::can_dbc::VehicleMass::identifier,
                                 rsi::can_dbc::VehicleMass::e2e_data_id};

const SensorFrame* find_frame(std::uint32_t identifier) {
    if (identifier == mass_frame.identifier) {
        return &mass_frame;
    }
    for (const SensorFrame& frame : protected_frames) {
        if (frame.identifier == identifier) {
            return &frame;
        }
    }
    return nullptr;
}

// The identifier that a frame has when those of `place` and of the frame after it are exchanged.
std::uint32_t exchanged(std::uint32_t identifier, FaultPlace place) {
    for (std::size_t i = 0U; i < protected_frames.size(); ++i) {
        if (protected_frames[i].place == place) {
            const std::uint32_t first = protected_frames[i].identifier;
            const std::uint32_t second = protected_frames[(i + 1U) % protected_frames.size()].identifier;
            return identifier == first ? second : (identifier == second ? first : identifier);
        }
    }
    return identifier;
}

void protect_again(rsi::hal::CanFrame& frame, std::uint8_t counter) {
    const SensorFrame* const known = find_frame(frame.identifier);
    if (known == nullptr) {
        return;
    }
    std::array<std::uint8_t, 8> payload{};
    std::copy_n(frame.data.begin(), payload.size(), payload.begin());
    rsi::can_dbc::e2e::protect_profile_11(payload, known->data_id, counter);
    std::copy_n(payload.begin(), payload.size(), frame.data.begin());
}

std::uint8_t counter_of(const rsi::hal::CanFrame& frame) {
    return rsi::can_dbc::e2e::profile_11_counter(frame.data.data());
}

std::uint8_t after(std::uint8_t counter, unsigned step = 1U) {
    return static_cast<std::uint8_t>((counter + step) % (rsi::can_dbc::e2e::profile_11_largest_counter + 1U));
}

// The signal's code replaced, and the frame protected as if its sender had sent that.
void write_code(rsi::hal::CanFrame& frame, const SensorSignal& signal) {
    const std::uint16_t code = signal.code_out_of_range;
    const auto low = static_cast<std::uint8_t>(code & 0xFFU);
    const auto high = static_cast<std::uint8_t>(code >> 8U);
    frame.data[signal.first_byte] = signal.little_endian ? low : high;
    frame.data[signal.first_byte + 1U] = signal.little_endian ? high : low;
    protect_again(frame, counter_of(frame));
}

}  // namespace

void FaultyBus::begin_cycle(bool active) {
    if (active_ && !active) {  // frames that were held back arrive now
        for (const rsi::hal::CanFrame& frame : held_) {
            bus_.send(frame);
        }
        held_.clear();
        counting_ = false;
    }
    active_ = active;
    visible_ = false;
    if (active) {
        send_flood();
        send_as_ecu();
    }
}

void FaultyBus::send_flood() {
    if (fault_.kind != FaultKind::flood_foreign && fault_.kind != FaultKind::flood_own) {
        return;
    }
    rsi::hal::CanFrame frame;
    frame.identifier =
        fault_.kind == FaultKind::flood_own ? rsi::can_dbc::Imu::identifier : foreign_identifier;
    frame.length = 8U;
    frame.data.fill(0x55U);
    for (int count = 0; count < static_cast<int>(fault_.magnitude); ++count) {
        bus_.send(frame);
    }
    visible_ = true;
}

// With the ECU's own identifier; the ECU's frames are not those that pass here.
void FaultyBus::send_as_ecu() {
    if (!is_second_sender(fault_.kind) || fault_.place != FaultPlace::warning_frame) {
        return;
    }
    const int frames = fault_.kind == FaultKind::sender_tenfold ? frames_of_tenfold_sender : 1;
    for (int count = 0; count < frames; ++count) {
        bus_.send(second_senders_frame(fault_.place, fault_.magnitude, next_counter()));
    }
    visible_ = true;
}

// The genuine frame, and those of the second sender.
rsi::hal::SendResult FaultyBus::send_beside(const rsi::hal::CanFrame& frame) {
    const auto send_another = [&](std::uint8_t counter) {
        bus_.send(second_senders_frame(fault_.place, fault_.magnitude, counter));
    };
    if (fault_.kind == FaultKind::sender_before) {
        send_another(counter_of(frame));
        return bus_.send(frame);
    }
    const rsi::hal::SendResult result = bus_.send(frame);
    if (fault_.kind == FaultKind::sender_after) {
        send_another(after(counter_of(frame)));
        return result;
    }
    for (int count = 0; count < frames_of_tenfold_sender; ++count) {
        send_another(next_counter());
    }
    return result;
}

std::uint8_t FaultyBus::next_counter() {
    counter_ = after(counter_);
    return counter_;
}

bool FaultyBus::is_concerned(const rsi::hal::CanFrame& frame) const {
    if (fault_.place == FaultPlace::all_sensor_frames) {
        return true;
    }
    if (fault_.kind == FaultKind::swapped) {
        return exchanged(frame.identifier, fault_.place) != frame.identifier;
    }
    if (fault_.kind == FaultKind::out_of_range) {
        const SensorSignal* const signal = find_signal(fault_.place);
        return signal != nullptr && signal->identifier == frame.identifier;
    }
    const SensorFrame* const known = find_frame(frame.identifier);
    return known != nullptr && known->place == fault_.place;
}

rsi::hal::SendResult FaultyBus::send(const rsi::hal::CanFrame& frame) noexcept {
    if (!active_ || !is_concerned(frame)) {
        return bus_.send(frame);
    }
    visible_ = true;
    switch (fault_.kind) {
        case FaultKind::lost:
            return rsi::hal::SendResult::sent;
        case FaultKind::delayed:
            return send_delayed(frame);
        case FaultKind::doubled:
            bus_.send(frame);
            return bus_.send(frame);
        case FaultKind::sender_before:
        case FaultKind::sender_after:
        case FaultKind::sender_tenfold:
            return send_beside(frame);
        default:
            return bus_.send(changed(frame));
    }
}

rsi::hal::SendResult FaultyBus::send_delayed(const rsi::hal::CanFrame& frame) {
    held_.push_back(frame);
    const auto cycles = static_cast<std::size_t>(std::lround(fault_.magnitude * 1.0e-3 / cycle_time_s));
    if (held_.size() <= cycles) {
        return rsi::hal::SendResult::sent;
    }
    const rsi::hal::CanFrame oldest = held_.front();
    held_.pop_front();
    return bus_.send(oldest);
}

rsi::hal::CanFrame FaultyBus::changed(const rsi::hal::CanFrame& frame) {
    rsi::hal::CanFrame faulty = frame;
    switch (fault_.kind) {
        case FaultKind::bad_crc:
            faulty.data[0] ^= 0xFFU;
            break;
        case FaultKind::counter_stands:
        case FaultKind::counter_jumps: {
            if (!counting_) {
                counter_ = counter_of(frame);
                counting_ = true;
            }
            protect_again(faulty, counter_);
            const unsigned step = fault_.kind == FaultKind::counter_jumps ? 1U + counter_jump : 0U;
            counter_ = after(counter_, step);
            break;
        }
        case FaultKind::swapped:
            faulty.identifier = exchanged(frame.identifier, fault_.place);
            break;
        case FaultKind::wrong_length:
            faulty.length = static_cast<std::uint8_t>(frame.length - 1U);
            break;
        case FaultKind::out_of_range:
            write_code(faulty, *find_signal(fault_.place));
            break;
        default:
            break;
    }
    return faulty;
}

}  // namespace sil
