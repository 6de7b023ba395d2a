// Roll angle delay: frames that arrive in order, but late all the time.
#pragma once

#include <cstdint>

#include "can_dbc/e2e/profile_11.hpp"
#include "monitoring/roll_lag.hpp"

namespace application {

// A constant delay leaves counters and receive times in order; only its beginning shows, as a silence. After
// a silence in which frames were lost, the counter goes on with the one that is due; after one that held them
// back, where it had stopped, while the IMU's counter has gone on. Compared with the IMU's counter instead of
// the clock, because when all senders pause together nothing is late. While the IMU itself is silent or its
// frames are damaged there is nothing to compare with: the judgement waits for it, unless it takes so long
// that its sender may have started anew. A roll angle's sender that itself has paused looks as a delay does:
// it is used again when the roll rate shows that its angle is in time.
class RollAngleDelay {
 public:
    // One cycle: counter and value of the newest good frames, new or not.
    void update(std::uint32_t imu_counter, std::uint32_t roll_counter, float roll_angle_rad,
                float roll_rate_radps) noexcept {
        imu_silence_ = (imu_counter == imu_counter_) ? grown(imu_silence_) : 0U;
        imu_counter_ = imu_counter;
        if (roll_counter == roll_counter_) {
            roll_silence_ = grown(roll_silence_);
            return;
        }
        roll_counter_ = roll_counter;
        if (roll_silence_ >= shortest_silence) {
            paused_ = roll_silence_ <= longest_silence;
        }
        roll_silence_ = 0U;
        if (imu_silence_ < shortest_silence) {
            judge(roll_angle_rad, roll_rate_radps);
        } else {
            paused_ = paused_ && (imu_silence_ <= longest_silence);
        }
    }

    bool is_late() const noexcept { return late_; }

 private:
    static constexpr std::uint32_t counters = can_dbc::e2e::profile_11_largest_counter + 1U;
    // Frames and cycles of 10 ms. Two more than that are bridged; in a longer silence the sender may have
    // started anew, and three fewer than the counter's round are a lead and no delay.
    static constexpr std::uint32_t shortest_silence = 4U;
    static constexpr std::uint32_t longest_silence = 11U;

    // Of one counter over another, both from 0 to 14.
    static constexpr std::uint32_t lead(std::uint32_t first, std::uint32_t second) noexcept {
        return first - second + ((first < second) ? counters : 0U);
    }

    static constexpr std::uint32_t grown(std::uint32_t silence) noexcept {
        return silence + ((silence <= longest_silence) ? 1U : 0U);
    }

    void judge(float roll_angle_rad, float roll_rate_radps) noexcept {
        const std::uint32_t ahead = lead(imu_counter_, roll_counter_);
        const std::uint32_t behind = lead(ahead, ahead_in_time_);
        const bool held_back = (behind >= shortest_silence) && (behind <= longest_silence);
        lag_.update(late_ ? roll_angle_rad : rsi::not_available, roll_rate_radps);
        late_ = held_back && (late_ || paused_) && !lag_.is_in_time();
        paused_ = false;
        ahead_in_time_ = late_ ? ahead_in_time_ : ahead;
    }

    std::uint32_t imu_counter_{0U};  // of the newest frames
    std::uint32_t roll_counter_{0U};
    std::uint32_t ahead_in_time_{0U};  // of the IMU's counter, while the roll angle is not late
    std::uint32_t imu_silence_{longest_silence + 1U};  // cycles without another counter
    std::uint32_t roll_silence_{longest_silence + 1U};
    bool paused_{false};  // silent for as long as a delay begins with, and not judged yet
    bool late_{false};
    monitoring::RollLag lag_{};
};

}  // namespace application
