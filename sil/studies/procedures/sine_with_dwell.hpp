// Sine with dwell as FMVSS 126 and UN R140 judge it.
#pragma once

#include <optional>
#include <vector>

#include "sil/studies/procedures/step_drive.hpp"

namespace sil {

// Amplitudes of one series in degrees: from 1.5 A in steps of 0.5 A to the last one, which is 6.5 A or 270
// degrees, whichever is greater, but 300 degrees at most (FMVSS 126 S7.9.3, S7.9.4). `a_deg` must be
// positive.
std::vector<double> sine_with_dwell_amplitudes_deg(double a_deg);

// Quantities that the rule measures in a run, from the truth of each step with the first turn to the left.
class SineWithDwellMeasurement final : public StepMeasurement {
 public:
    void step(const Truth& truth) override;
    // When all is measured, unless two wheels are up: then it is to be seen whether the vehicle overturns.
    bool finished() const override;

    // The first peak of the yaw rate after the handwheel has changed sign. Steps in which it turns the other
    // way count, and a peak is one from which it falls by a fiftieth: what falls by less is no peak after the
    // low-pass filter of S7.11.
    std::optional<double> peak_yaw_rate_radps() const;

    // Shares of that peak in per cent, 1.00 s and 1.75 s after completion of steer; empty: not reached. A
    // yaw rate back to the other side is a negative share.
    std::optional<double> share_after_1_00_s() const { return share(yaw_rate_after_1_00_s_); }
    std::optional<double> share_after_1_75_s() const { return share(yaw_rate_after_1_75_s_); }

    // Sideways from the path before the manoeuvre, 1.07 s after beginning of steer.
    std::optional<double> displacement_m() const { return displacement_m_; }

    std::optional<double> entry_speed_mps() const { return entry_speed_mps_; }

 private:
    std::optional<double> share(const std::optional<double>& yaw_rate_radps) const;
    void follow_peak(double yaw_rate_radps);

    double largest_yaw_rate_radps_{0.0};  // after the change of sign, to the right
    bool peak_is_over_{false};
    bool wheels_are_up_{false};
    std::optional<double> begin_s_{};  // of steer
    double begin_y_m_{0.0};
    std::optional<double> entry_speed_mps_{};
    std::optional<double> displacement_m_{};
    std::optional<double> yaw_rate_after_1_00_s_{};
    std::optional<double> yaw_rate_after_1_75_s_{};
};

// The limits of the rule for a run with this amplitude.
std::vector<Criterion> sine_with_dwell_criteria(const SineWithDwellMeasurement& measurement, double mass_kg,
                                                bool from_5_a_on);

}  // namespace sil
