// Steady circle: what is measured on it, and the lines through it.
#pragma once

#include <optional>
#include <vector>

#include "sil/studies/procedures/step_drive.hpp"

namespace sil {

struct SteadyTurn {
    double speed_mps{0.0};
    double lateral_acceleration_mps2{0.0};
    double curvature_pm{0.0};
    double handwheel_rad{0.0};
    double sideslip_rad{0.0};  // at the CG, > 0 when the vehicle moves to its left
    double roll_rad{0.0};
};

// Means over the last seconds of a step, from the truth of each step in a turn to the left.
class SteadyTurnMeasurement final : public StepMeasurement {
 public:
    static constexpr double averaged_s = 3.0;  // ISO 4138: the steady state is held for so long

    explicit SteadyTurnMeasurement(double end_s) : from_s_{end_s - averaged_s} {}

    void step(const Truth& truth) override;
    bool finished() const override { return lifted_; }  // two wheels: the drive ends

    // Empty: the step ended before.
    std::optional<SteadyTurn> mean() const;

 private:
    double from_s_;
    double count_{0.0};
    bool lifted_{false};
    SteadyTurn sum_{};
};

// Whether the turn is on the circle: its curvature is within two per cent of the wanted one.
bool is_on_circle(const std::optional<SteadyTurn>& turn, double circle_radius_m);

// Slope of the least-squares line of a quantity over the lateral acceleration, of the turns from 1 to 4
// m/s^2; empty with fewer than two.
std::optional<double> gradient(const std::vector<SteadyTurn>& turns, double SteadyTurn::* quantity);

}  // namespace sil
