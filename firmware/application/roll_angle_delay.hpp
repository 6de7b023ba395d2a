// Roll angle delay: frames that arrive in order, but late all the time.
#pragma once

#include <cstdint>

#include "can_dbc/e2e/profile_11.hpp"
#include "monitoring/roll_lag.hpp"

namespace application {

// A constant delay leaves counters and receive times in order; only its beginning shows, as a silence. After
// a silence in which frames were lost, the counter goes on with the one that is due; after one that held them
// back, where it had stopped, while the IMU's counter has gone on. Compared with the IMU's counter instead of
// the clock, because when all senders pause together nothing is late. A sender that itself has paused looks
// the same: it is believed again when the roll rate shows that its angle is in time.
class RollAngleDelay {
 public:
    // One cycle: counter and value of the newest good frames, new or not.
    void update(std::uint32_t imu_counter, std::uint32_t roll_counter, float roll_angle_rad,
                float roll_rate_radps) noexcept {
        if (roll_counter == roll_counter_) {
            silent_cycles_ += (silent_cycles_ <= longest_silence) ? 1U : 0U;
            return;
        }
        const bool paused = (silent_cycles_ >= shortest_silence) && (silent_cycles_ <= longest_silence);
        const std::uint32_t ahead = (imu_counter + counters - roll_counter) % counters;
        const std::uint32_t behind = (ahead + counters - ahead_in_time_) % counters;
        const bool held_back = (behind >= shortest_silence) && (behind <= longest_silence);
        lag_.update(late_ ? roll_angle_rad : rsi::not_available, roll_rate_radps);
        late_ = held_back && (late_ || paused) && !lag_.is_in_time();
        ahead_in_time_ = late_ ? ahead_in_time_ : ahead;
        roll_counter_ = roll_counter;
        silent_cycles_ = 0U;
    }

    bool is_late() const noexcept { return late_; }

 private:
    static constexpr std::uint32_t counters = can_dbc::e2e::profile_11_largest_counter + 1U;
    // Frames and cycles of 10 ms. Two more than that are bridged; in a longer silence the sender may have
    // started anew, and three fewer than the counter's round are a lead and no delay.
    static constexpr std::uint32_t shortest_silence = 4U;
    static constexpr std::uint32_t longest_silence = 11U;

    std::uint32_t roll_counter_{0U};   // of the frame before
    std::uint32_t ahead_in_time_{0U};  // of the IMU's counter, while the roll angle is not late
    std::uint32_t silent_cycles_{longest_silence + 1U};
    bool late_{false};
    monitoring::RollLag lag_{};
};

}  // namespace application
