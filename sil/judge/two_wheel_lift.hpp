// Two-wheel lift-off: which lifts of both wheels of a side count, and towards which side the vehicle then
// falls. The only definition; only a recorded drive's own statement takes its place.
#pragma once

#include <optional>

#include "sil/judge/warning.hpp"

namespace sil {

// Times are sums of steps of 1 ms, and whole milliseconds in files.
inline constexpr double time_rounding_s = 1.0e-6;

// The vehicle's true state at the moment of an event.
struct EventMoment {
    double time_s{0.0};
    double lateral_acceleration_mps2{0.0};  // horizontal, at the CG, > 0 in a left turn
    double roll_angle_rad{0.0};             // relative to the road
};

struct TwoWheelLiftOff {
    EventMoment moment{};
    WarningSide side{WarningSide::none};  // towards which the vehicle falls
};

// The side whose wheels carry more: right where the load transfer, or the lateral acceleration, is positive.
// None of zero and of what is no number.
WarningSide loaded_side(double load_transfer_or_acceleration);

// Two-wheel lift-off is the beginning of the first time that both wheels of one side carry nothing for at
// least `lasting_s`. A shorter one is brief: a bump threw them up.
class TwoWheelLiftObserver {
 public:
    static constexpr double lasting_s = 0.050;

    // At every step, in the order of time; whether both wheels of a side are up.
    void observe(const EventMoment& now, bool left_up, bool right_up);

    // Known `lasting_s` after its moment. A vehicle that left the ground with all wheels at once falls to the
    // outside of its turn.
    const std::optional<TwoWheelLiftOff>& lift_off() const { return lift_off_; }

    // The first brief one before it. One that has begun but not yet lasted counts.
    std::optional<double> brief_time_s() const;

 private:
    void follow(std::optional<EventMoment>& began, const EventMoment& now, bool up);
    bool lasts(const std::optional<EventMoment>& began, const EventMoment& now) const;

    std::optional<EventMoment> left_began_{};
    std::optional<EventMoment> right_began_{};
    std::optional<double> brief_time_s_{};
    std::optional<TwoWheelLiftOff> lift_off_{};
};

}  // namespace sil
