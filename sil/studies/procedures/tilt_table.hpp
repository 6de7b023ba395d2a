// Tilt table: what is measured on it, and the limit of UN R111.
#pragma once

#include <optional>

#include "sil/studies/procedures/step_drive.hpp"

namespace sil {

// From the truth of each step with the left side up.
class TiltMeasurement final : public StepMeasurement {
 public:
    void step(const Truth& truth) override;
    bool finished() const override;

    double angle_rad() const { return angle_rad_; }  // the latest
    std::optional<double> one_wheel_angle_rad() const { return one_wheel_angle_rad_; }
    std::optional<double> two_wheel_angle_rad() const { return two_wheel_angle_rad_; }
    double roll_rad() const { return roll_rad_; }  // on the table, as two wheels lift

 private:
    double time_s_{0.0};
    double angle_rad_{0.0};
    double roll_rad_{0.0};
    double lifted_s_{0.0};
    std::optional<double> one_wheel_angle_rad_{};
    std::optional<double> two_wheel_angle_rad_{};
};

Criterion tilt_criterion(double angle_rad);

}  // namespace sil
