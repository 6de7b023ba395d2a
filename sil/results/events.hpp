// EventObserver: finds the moments that matter in a run, while it runs.
#pragma once

#include <optional>

#include "sil/judge/two_wheel_lift.hpp"
#include "sil/judge/warning_judgement.hpp"
#include "sil/results/ecu_output.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

struct RunEvents {
    std::optional<EventMoment> one_wheel_lift;   // the first time that any wheel carries no load
    std::optional<EventMoment> front_axle_lift;  // the same on the front axle: |LTR| of this axle is 1
    std::optional<EventMoment> rear_axle_lift;   // the same on the rear axle
    std::optional<EventMoment> two_wheel_lift;  // the beginning of the first lasting one (two_wheel_lift.hpp)
    std::optional<EventMoment> ssf_crossing;    // the first time that |a_y| >= SSF g, SSF = c_w/(2h)
    std::optional<EventMoment> warning;         // the first frame whose state is `warning`, for information
    WarningSide warning_side{WarningSide::none};  // that it named
    WarningJudgement judgement;                   // judgement of the warning

    double largest_lateral_acceleration_mps2{0.0};  // largest |a_y|
    double final_roll_angle_rad{0.0};               // relative to the road, of the last truth
    double end_time_s{0.0};                         // of the last truth
};

class EventObserver {
 public:
    // `static_stability_factor` = c_w/(2h), h the height of the CG of the whole vehicle. Lift-off before
    // `start_time_s` does not count: the vehicle is still being put on its wheels.
    explicit EventObserver(double static_stability_factor, double start_time_s = 0.0);

    // At every step of the simulation, in the order of time.
    void observe(const Truth& truth);

    // When a warning frame has arrived; its moment is `reception_time_s`, its state that of the latest truth.
    void observe(const EcuOutput& output, double reception_time_s);

    const RunEvents& events() const { return events_; }

 private:
    void observe_lift(const Truth& truth);

    double ssf_acceleration_mps2_;
    double start_time_s_;
    EventMoment latest_;
    TwoWheelLiftObserver two_wheel_lift_;
    WarningJudge judge_;
    RunEvents events_;
};

}  // namespace sil
