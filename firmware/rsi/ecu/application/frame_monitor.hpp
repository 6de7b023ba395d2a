// Frame monitor: end-to-end check, state of the channel, decoding and freshness of one received frame.
#pragma once

#include <cstdint>

#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "rsi/can_dbc/e2e/state_machine.hpp"
#include "rsi/ecu/application/sender_rate.hpp"
#include "rsi/hal/can_bus.hpp"
#include "rsi/hal/saturating_count.hpp"

namespace rsi::application {

// A value older than this is not used. With frames and cycles of 10 ms a silent sender is noticed 35 to 45 ms
// after its last frame, depending on the phase between the two.
inline constexpr hal::Time frame_time_limit = hal::Time::from_milliseconds(35);

// A receive time further in the future than this means that the clock has jumped back, so the age is unknown
// and the frame is not used. One cycle of tolerance covers receive times from a clock of lower resolution.
inline constexpr hal::Time youngest_frame_age = hal::Time::from_milliseconds(-10);

// MaxDeltaCounter. Two lost frames in a row are tolerated; with three, the time limit has expired anyway.
inline constexpr std::uint8_t largest_counter_step = 3U;

// E2E state machine: a channel with more than four errors in the last eight frames is invalid until there are
// two or fewer, because a CRC-8 misses one damaged frame in 256. One good frame is enough to start, because
// the component itself waits before it reports "ready". The time limit detects silence, and sooner than the
// window would.
inline constexpr can_dbc::e2e::StateMachineSettings channel_settings{8U, {1U, 4U}, {1U, 4U}, {1U, 2U}, true};

// Faults of a frame in one cycle.
struct FrameFaults {
    bool received{false};        // a usable frame was received since the start
    bool timeout{false};         // no usable frame within the time limit
    bool checksum_error{false};  // CRC, data identifier or length
    bool counter_error{false};   // repeated, or more frames lost than tolerated
    bool signal_invalid{false};  // the latest usable frame carries a signal that is not valid
    bool two_senders{false};     // more frames come than one sender sends

    // False for a sensor that the vehicle does not have: `received` stays false, and `timeout` too.
    bool is_fresh() const noexcept { return received && !timeout; }
};

// Message is one of the structures that can_dbc generates.
template <typename Message>
class FrameMonitor {
 public:
    void begin_cycle() noexcept {
        if (!heard_) {  // in the cycle that has ended
            follow(receiver_.no_frame());
        }
        if (sender_rate_.end_cycle()) {
            withdrawn_ = withdrawn_ || has_two_senders();
        }
        heard_ = false;
        checksum_error_ = false;
        counter_error_ = false;
    }

    // Number of cycles left out before this one.
    void miss_cycles(std::uint32_t cycles) noexcept { sender_rate_.miss(cycles); }

    // Judges one frame with this message's identifier; keeps its values only when the end-to-end check
    // accepts it and the channel is valid.
    void take(const hal::CanFrame& frame) noexcept {
        const can_dbc::e2e::CheckResult check = receiver_.check(frame.data, frame.length);
        heard_ = true;
        count(check, frame.data[0]);
        follow(check);
        if (channel_.is_valid() && can_dbc::e2e::is_usable(check.status)) {
            latest_ = can_dbc::decode<Message>(frame.data);
            latest_time_ = frame.receive_time;
            latest_counter_ = can_dbc::e2e::profile_11_counter(frame.data.data());
            received_ = true;
            withdrawn_ = has_two_senders();
        }
    }

    bool received() const noexcept { return received_; }

    bool is_fresh(hal::Time now) const noexcept {
        return received_ && !withdrawn_ && !(frame_time_limit < age(now)) && !(age(now) < youngest_frame_age);
    }

    // Time since the last usable frame; only meaningful once one was received.
    hal::Time age(hal::Time now) const noexcept { return now - latest_time_; }

    // The last usable values; only meaningful while is_fresh().
    const can_dbc::Decoded<Message>& latest() const noexcept { return latest_; }
    // Their frame's counter, 0 to 14.
    std::uint8_t latest_counter() const noexcept { return latest_counter_; }

    can_dbc::e2e::ChannelState channel_state() const noexcept { return channel_.state(); }
    bool checksum_error() const noexcept { return checksum_error_; }
    bool counter_error() const noexcept { return counter_error_; }
    // No value is used then, because the genuine sender cannot be identified.
    bool has_two_senders() const noexcept { return sender_rate_.is_doubled(); }
    std::uint32_t frames_rejected() const noexcept { return frames_rejected_; }
    std::uint32_t frames_lost() const noexcept { return frames_lost_; }

 private:
    // An invalid channel withdraws its latest values for good: when it is valid again, only a new frame
    // counts.
    void follow(const can_dbc::e2e::CheckResult& check) noexcept {
        channel_.update(check.status);
        withdrawn_ = withdrawn_ || !channel_.is_valid();
    }

    void count(const can_dbc::e2e::CheckResult& check, std::uint8_t checksum) noexcept {
        using can_dbc::e2e::CheckStatus;
        checksum_error_ = checksum_error_ || (check.status == CheckStatus::error);
        counter_error_ = counter_error_ || (check.status == CheckStatus::repeated) ||
                         (check.status == CheckStatus::wrong_sequence);
        if (can_dbc::e2e::is_usable(check.status)) {
            sender_rate_.count();
        } else {
            hal::count_up(frames_rejected_);
            count_in_disorder(check.status, checksum);
        }
        checksum_ = checksum;
        hal::count_up(frames_lost_, check.lost_frames);
    }

    // A frame out of sequence may come from a second sender and counts towards the rate. A duplicate (same
    // counter and checksum) does not.
    void count_in_disorder(can_dbc::e2e::CheckStatus status, std::uint8_t checksum) noexcept {
        using can_dbc::e2e::CheckStatus;
        const bool is_copy = (status == CheckStatus::repeated) && (checksum == checksum_);
        if ((status != CheckStatus::error) && !is_copy) {
            sender_rate_.count();
        }
    }

    static_assert(Message::e2e_profile == 11U, "this monitor checks end-to-end profile 11");

    can_dbc::e2e::Profile11Receiver receiver_{Message::e2e_data_id, Message::length, largest_counter_step};
    can_dbc::e2e::StateMachine<channel_settings> channel_{};
    can_dbc::Decoded<Message> latest_{};
    hal::Time latest_time_{};
    std::uint8_t latest_counter_{0U};
    std::uint8_t checksum_{0U};  // of the newest frame
    bool received_{false};
    bool withdrawn_{false};  // the channel was not valid since the latest usable frame, or has two senders
    bool heard_{true};       // a frame came in this cycle, good or not; true before the first cycle
    bool checksum_error_{false};
    bool counter_error_{false};
    SenderRate sender_rate_{};
    std::uint32_t frames_rejected_{0U};
    std::uint32_t frames_lost_{0U};
};

}  // namespace rsi::application
