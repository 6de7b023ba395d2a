// Outcome: what really became of a run, from the true wheel loads.
#pragma once

#include <optional>

#include "sil/world/vehicle/truth.hpp"

namespace sil {

struct Outcome {
    std::optional<double> one_wheel_lift_time_s;  // the first time that any wheel carries no load
    // The beginning of the first time that both wheels of one side carry none for at least 50 ms.
    std::optional<double> two_wheel_lift_time_s;
    // The first time that they carry none for less: a bump threw them up. Only before two-wheel lift-off.
    std::optional<double> brief_two_wheel_lift_time_s;
    double largest_ltr{0.0};              // |LTR| over the whole run
    double largest_ltr_before_lift{0.0};  // |LTR| before any wheel has lifted
    double largest_lateral_acceleration_mps2{0.0};
    double largest_roll_angle_rad{0.0};  // relative to the road
    bool rolled_over{false};             // the roll angle went beyond any way back
    double end_time_s{0.0};
};

class OutcomeObserver {
 public:
    static constexpr double lasting_lift_s = 0.050;

    // At every step of the vehicle, in the order of time.
    void observe(const Truth& truth);

    // No more can come that a campaign wants to know: the vehicle has rolled over, or two-wheel lift-off is
    // long past.
    bool settled() const;

    // A two-wheel lift that has begun but not yet lasted counts as brief.
    Outcome outcome() const;

 private:
    void observe_sides(const Truth& truth);

    Outcome outcome_{};
    std::optional<double> lift_began_s_{};  // of the two-wheel lift under way
};

}  // namespace sil
