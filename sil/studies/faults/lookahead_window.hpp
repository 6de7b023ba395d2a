// LookaheadWindow: the drive some seconds ahead of itself, so that faults can be drawn to where a warning
// will be due. The ECUs only warn, so the drive does not depend on them.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "sil/studies/faults/driven_world.hpp"
#include "sil/studies/faults/faulty_line.hpp"

namespace sil {

class LookaheadWindow {
 public:
    struct Cycle {
        std::optional<SensorSample> sample{};
        bool stands{false};
    };

    LookaheadWindow(const VehicleParameters& vehicle, const rsi::Parameters& calibration, std::uint64_t seed,
                    double duration_s);

    Cycle next();

    // Values of the cycle that was seen last.
    bool warning_begins() const { return warning_begins_; }
    const DrivenWorld& world() const { return world_; }

    static constexpr std::uint64_t cycles_ahead = 600U;

 private:
    void look();

    DrivenWorld world_;
    FaultyLine scout_;
    std::deque<Cycle> ahead_{};
    std::uint64_t number_{0U};
    bool warned_{false};
    bool warning_begins_{false};
};

}  // namespace sil
