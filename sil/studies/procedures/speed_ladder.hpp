// Speed ladder: NHTSA's rollover tests, driven faster and faster until two wheels lift.
#pragma once

#include <functional>
#include <vector>

#include "sil/studies/procedures/step_drive.hpp"

namespace sil {

// Two-wheel lift: both wheels of a side are two inches up at the same time.
inline constexpr double two_wheel_lift_m = 2.0 * 0.0254;

// Ends a step soon after two-wheel lift: from there on the outriggers of the real test hold the vehicle.
class TwoWheelLiftMeasurement final : public StepMeasurement {
 public:
    // `start_s`: when the steering begins.
    explicit TwoWheelLiftMeasurement(double start_s) : start_s_{start_s} {}

    void step(const Truth& truth) override;
    bool finished() const override;

    std::optional<double> entry_speed_mps() const { return entry_speed_mps_; }
    double height_m() const { return height_m_; }  // the largest

 private:
    double start_s_;
    double time_s_{0.0};
    double height_m_{0.0};
    std::optional<double> reached_s_{};
    std::optional<double> entry_speed_mps_{};
};

Criterion two_wheel_lift_criterion(double height_m, const std::string& source);

struct SpeedLadder {
    std::vector<double> speeds_mph{};
    double factor{0.0};  // of the handwheel angle of 0.3 g
    double start_s{2.0};
    std::string source{};  // of the limit
    std::function<Manoeuvre(double speed_mps, double handwheel_rad)> manoeuvre{};
};

// A series to either side; each ends with the first two-wheel lift or the last speed.
ProcedureResult run_speed_ladder(const ProcedureWorld& world, const SpeedLadder& ladder);

}  // namespace sil
