// Roll angle delay: frames that arrive in order, but late all the time.
#pragma once

#include <cstdint>

#include "monitoring/roll_lag.hpp"

namespace application {

// A constant delay leaves counters and receive times in order; only its beginning shows, as a silence. After a
// silence in which frames were lost, the counter goes on with the one that is due; after one that held them
// back, where it had stopped, while the IMU's counter has gone on. Compared with the IMU's counter instead of
// the clock, because when all senders pause together nothing is late. A sender that itself has paused looks
// the same: it is believed again when the roll rate shows that its angle is in time.
class RollAngleDelay {
 public:
    // One cycle. How many frames either sender has made, by its counter; whether a usable RollAngle came.
    void update(std::uint32_t imu_frames, std::uint32_t roll_frames, bool heard, float roll_angle_rad,
                float roll_rate_radps) noexcept {
        if (!heard) {
            silent_cycles_ += (silent_cycles_ < silence) ? 1U : 0U;
            return;
        }
        const std::uint32_t ahead = imu_frames - roll_frames;
        const std::uint32_t behind = ahead - ahead_in_time_;
        const bool held_back = (behind >= fewest_frames) && (behind <= most_frames);
        if (late_) {
            lag_.update(roll_angle_rad, roll_rate_radps);
        } else {
            lag_ = monitoring::RollLag{};
        }
        late_ = held_back && (late_ || (silent_cycles_ >= silence)) && !lag_.is_in_time();
        ahead_in_time_ = late_ ? ahead_in_time_ : ahead;
        silent_cycles_ = 0U;
    }

    bool is_late() const noexcept { return late_; }

 private:
    static constexpr std::uint32_t silence = 4U;  // longer than the time limit of a frame
    // As many more than two, which are tolerated. A longer silence may be that of a sender that starts anew,
    // and beyond 14 the counter has gone round.
    static constexpr std::uint32_t fewest_frames = 4U;
    static constexpr std::uint32_t most_frames = 13U;

    std::uint32_t ahead_in_time_{0U};  // of the IMU's frames, while the roll angle's are not late
    std::uint32_t silent_cycles_{0U};
    bool late_{false};
    monitoring::RollLag lag_{};
};

}  // namespace application
