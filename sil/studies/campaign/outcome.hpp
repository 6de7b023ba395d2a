// Outcome: what really became of a run, from the true wheel loads.
#pragma once

#include <optional>

#include "sil/judge/two_wheel_lift.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

struct Outcome {
    std::optional<double> one_wheel_lift_time_s;        // the first time that any wheel carries no load
    std::optional<double> two_wheel_lift_time_s;        // the lasting one (sil/judge/two_wheel_lift.hpp)
    std::optional<double> brief_two_wheel_lift_time_s;  // the first brief one before it
    double largest_ltr{0.0};                            // |LTR| over the whole run
    double largest_ltr_before_lift{0.0};                // |LTR| before any wheel has lifted
    double largest_lateral_acceleration_mps2{0.0};
    double largest_roll_angle_rad{0.0};  // relative to the road
    bool rolled_over{false};             // the roll angle went beyond any way back
    double distance_m{0.0};
    double end_time_s{0.0};
};

class OutcomeObserver {
 public:
    // No vehicle here has its balance point, about atan(SSF), beyond it.
    static constexpr double rolled_over_rad = 1.0;
    // After so long on two wheels it is of no more interest whether the vehicle falls or comes back.
    static constexpr double settled_after_lift_s = 1.0;

    // At every step of the vehicle, in the order of time.
    void observe(const Truth& truth);

    // No more can come that a campaign wants to know: the vehicle has rolled over, or two-wheel lift-off is
    // long past.
    bool settled() const;

    const Outcome& outcome() const { return outcome_; }
    const std::optional<TwoWheelLiftOff>& lift_off() const { return lift_.lift_off(); }

 private:
    Outcome outcome_{};
    TwoWheelLiftObserver lift_{};
};

}  // namespace sil
