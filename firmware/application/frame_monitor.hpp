// Frame monitor: end-to-end check, decoding and freshness of one received frame.
#pragma once

#include <cstdint>

#include "can_dbc/codec/message.hpp"
#include "can_dbc/e2e/profile_11.hpp"
#include "hal/interface/can_bus.hpp"
#include "hal/interface/saturating_count.hpp"

namespace application {

// A value older than this is not used. With frames and cycles of 10 ms a silent sender is noticed 35 to 45 ms
// after its last frame, depending on the phase between the two.
inline constexpr hal::Time frame_time_limit = hal::Time::from_milliseconds(35);

// Two lost frames in a row are tolerated: the fourth one would be older than the time limit anyway.
inline constexpr std::uint8_t largest_counter_step = 3U;

// What went wrong with a frame in one cycle.
struct FrameFaults {
    bool received{false};        // a usable frame has come since the start
    bool timeout{false};         // no usable frame within the time limit
    bool checksum_error{false};  // CRC, data identifier or length
    bool counter_error{false};   // repeated, or more frames lost than tolerated
    bool signal_invalid{false};  // the latest usable frame carries a signal that is not valid
};

// Message is one of the structures that can_dbc generates.
template <typename Message>
class FrameMonitor {
 public:
    void begin_cycle() noexcept {
        checksum_error_ = false;
        counter_error_ = false;
    }

    // Judges one frame with this message's identifier; keeps its values only when the end-to-end check
    // accepts it.
    void take(const hal::CanFrame& frame) noexcept {
        const can_dbc::e2e::CheckResult check = receiver_.check(frame.data, frame.length);
        count(check);
        if (can_dbc::e2e::is_usable(check.status)) {
            latest_ = can_dbc::decode<Message>(frame.data);
            latest_time_ = frame.receive_time;
            received_ = true;
        }
    }

    bool received() const noexcept { return received_; }

    bool is_fresh(hal::Time now) const noexcept {
        return received_ && !(frame_time_limit < (now - latest_time_));
    }

    // The last usable values; only meaningful while is_fresh().
    const can_dbc::Decoded<Message>& latest() const noexcept { return latest_; }

    bool checksum_error() const noexcept { return checksum_error_; }
    bool counter_error() const noexcept { return counter_error_; }
    std::uint32_t frames_rejected() const noexcept { return frames_rejected_; }
    std::uint32_t frames_lost() const noexcept { return frames_lost_; }

 private:
    void count(const can_dbc::e2e::CheckResult& check) noexcept {
        using can_dbc::e2e::CheckStatus;
        checksum_error_ = checksum_error_ || (check.status == CheckStatus::error);
        counter_error_ = counter_error_ || (check.status == CheckStatus::repeated) ||
                         (check.status == CheckStatus::wrong_sequence);
        if (!can_dbc::e2e::is_usable(check.status)) {
            hal::count_up(frames_rejected_);
        }
        hal::count_up(frames_lost_, check.lost_frames);
    }

    can_dbc::e2e::Profile11Receiver receiver_{Message::e2e_data_id, Message::length, largest_counter_step};
    can_dbc::Decoded<Message> latest_{};
    hal::Time latest_time_{};
    bool received_{false};
    bool checksum_error_{false};
    bool counter_error_{false};
    std::uint32_t frames_rejected_{0U};
    std::uint32_t frames_lost_{0U};
};

}  // namespace application
