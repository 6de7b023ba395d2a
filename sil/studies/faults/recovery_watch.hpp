// Recovery watch: the time from the end of each fault to the agreement of both ECUs, which must last a
// second: in hard driving each may reject the roll sensor at a moment of its own. Time at a standstill counts
// apart: where nothing moves, some values cannot prove themselves.
#pragma once

#include <cstdint>

#include "sil/studies/faults/endurance.hpp"

namespace sil {

class RecoveryWatch {
 public:
    void begin(std::uint64_t over) {
        *this = RecoveryWatch{};
        over_ = over;
        since_ = over;
    }
    void cycle(std::uint64_t number, bool agrees, bool stands) {
        if (recovered_ || number < over_) {
            return;
        }
        over_at_standstill_ = over_at_standstill_ || (number == over_ && stands);
        driven_ += stands ? 0U : 1U;
        if (!agrees) {
            since_ = number + 1U;
            driven_since_ = driven_;
        }
        recovered_ = number >= since_ + lasting_cycles;
        recovered_standing_ = recovered_ && stands && driven_ == 0U;
    }
    // Ten seconds of driving.
    bool is_past_limit() const { return driven_ >= recovery_limit_ms / 10; }
    bool has_recovered() const { return recovered_; }
    bool was_over_at_standstill() const { return over_at_standstill_; }
    bool has_recovered_at_standstill() const { return recovered_standing_; }
    int driven_ms() const { return static_cast<int>(driven_since_) * 10; }

 private:
    static constexpr std::uint64_t lasting_cycles = 100U;

    std::uint64_t over_{0U};
    std::uint64_t since_{0U};
    std::uint64_t driven_{0U};
    std::uint64_t driven_since_{0U};
    bool recovered_{false};
    bool over_at_standstill_{false};
    bool recovered_standing_{false};
};

}  // namespace sil
