// Frame delay: detects frames of roll angle or IMU that arrive in order, but with a constant delay.
#pragma once

#include <cstdint>

#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "rsi/ecu/monitoring/roll_lag.hpp"

namespace rsi::application {

// A constant delay leaves counters and receive times in order; it shows only when it begins, as a silence. If
// frames were lost in the silence, the counter has moved on meanwhile; if they were held back, it resumes
// where it stopped and so falls behind the counter of the other sender. The reference is the other counter
// and not the clock, because a pause of all senders is no delay. Without good frames of the other sender the
// decision waits, until the silence is so long that a sender may have restarted. A sender that paused and
// kept its counter looks like a delay: it is accepted again when roll angle and roll rate match in time
// (RollLag).
class FrameDelay {
 public:
    // One cycle: counters and values of the latest good frames, whether or not they arrived in this cycle.
    void update(std::uint32_t imu_counter, std::uint32_t roll_counter, float roll_angle_rad,
                float roll_rate_radps) noexcept {
        const bool as_before = (lead(imu_counter, roll_counter) == ahead_in_time_);
        if (calm_ && as_before && (imu_counter != imu_.counter)) {
            imu_.counter = imu_counter;  // as in nearly every cycle
            roll_.counter = roll_counter;
        } else {
            follow(imu_counter, roll_counter, roll_angle_rad, roll_rate_radps);
        }
    }

    // Cycles were missed, so silences were not counted.
    void miss_cycles() noexcept {
        may_be_anew_ = true;
        calm_ = false;
    }

    bool roll_angle_is_late() const noexcept { return roll_.late; }
    bool imu_is_late() const noexcept { return imu_.late; }

 private:
    static constexpr std::uint32_t counters = can_dbc::e2e::profile_11_largest_counter + 1U;
    // Cycles of 10 ms, one frame each. Shorter silences are ordinary losses. Longer ones may be a restart of
    // the sender, and a counter that is further behind (of 15) is rather ahead.
    static constexpr std::uint32_t shortest_silence = 4U;
    static constexpr std::uint32_t longest_silence = 11U;

    struct Sender {
        void follow(std::uint32_t newest) noexcept {
            if (newest == counter) {
                silence += may_start_anew() ? 0U : 1U;
                return;
            }
            counter = newest;
            paused = paused || !is_heard();
            silence = 0U;
        }

        bool is_new() const noexcept { return silence == 0U; }
        bool is_heard() const noexcept { return silence < shortest_silence; }
        bool may_start_anew() const noexcept { return silence > longest_silence; }

        void judge(std::uint32_t behind) noexcept {
            const bool held_back = (behind >= shortest_silence) && (behind <= longest_silence);
            late = held_back && (late || paused);
            paused = false;
        }

        std::uint32_t counter{0U};                    // of the newest frame
        std::uint32_t silence{longest_silence + 1U};  // cycles without another one
        bool paused{false};                           // was silent, and not judged since
        bool late{false};
    };

    // Lead of one counter over another, both from 0 to 14.
    static constexpr std::uint32_t lead(std::uint32_t first, std::uint32_t second) noexcept {
        return first - second + ((first < second) ? counters : 0U);
    }

    void follow(std::uint32_t imu_counter, std::uint32_t roll_counter, float roll_angle_rad,
                float roll_rate_radps) noexcept {
        calm_ = false;
        may_be_anew_ = may_be_anew_ || imu_.may_start_anew() || roll_.may_start_anew();
        imu_.follow(imu_counter);
        roll_.follow(roll_counter);
        if (roll_.is_new() && imu_.is_heard()) {
            judge(roll_angle_rad, roll_rate_radps);
        }
    }

    void judge(float roll_angle_rad, float roll_rate_radps) noexcept {
        const std::uint32_t ahead = lead(imu_.counter, roll_.counter);
        const bool were_in_time = !is_any_late();
        imu_.paused = imu_.paused && !may_be_anew_;
        roll_.paused = roll_.paused && !may_be_anew_;
        roll_.judge(lead(ahead, ahead_in_time_));
        imu_.judge(lead(ahead_in_time_, ahead));
        if (is_any_late()) {
            lag_ = were_in_time ? monitoring::RollLag{} : lag_;
            lag_.update(roll_angle_rad, roll_rate_radps);
            roll_.late = roll_.late && !lag_.angle_is_in_time();
            imu_.late = imu_.late && !lag_.rate_is_in_time();
            return;
        }
        // An IMU that has just begun to pause must not become the reference. One cycle without a frame is
        // ordinary.
        if (imu_.silence < 2U) {
            ahead_in_time_ = ahead;
            may_be_anew_ = false;
            calm_ = imu_.is_new();
        }
    }

    bool is_any_late() const noexcept { return roll_.late || imu_.late; }

    Sender imu_{};
    Sender roll_{};
    bool calm_{false};                 // both arrived in the last cycle, neither late
    bool may_be_anew_{false};          // a sender may have restarted since the last decision
    std::uint32_t ahead_in_time_{0U};  // lead of the IMU's counter while neither is late
    monitoring::RollLag lag_{};
};

}  // namespace rsi::application
