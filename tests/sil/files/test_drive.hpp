// Test drive: a simulated vehicle steered by the clock, and what docs/calibration.md computes from its
// signals.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "rsi/types.hpp"

namespace calibration_test {

// One sample of 10 ms. `parallel` and `normal` are A and N of docs/theory.md.
struct Sample {
    double time_s;
    double parallel_mps2;
    double normal_mps2;
    double roll_angle_rad;
    double roll_rate_radps;
};

rsi::Parameters calibration_of(const std::string& vehicle);

// At 60 km/h on a level road; `handwheel_deg` is a function of the time in seconds.
std::vector<Sample> drive(const std::string& vehicle, double duration_s,
                          const std::function<double(double)>& handwheel_deg);

double moment_arm_m(const rsi::Parameters& parameters);  // H

// K_f as the least-squares slope of m_s H (A + N tan phi) over phi, for 0.1 g < |A| < 0.5 g.
double roll_stiffness_nmprad(const rsi::Parameters& parameters, const std::vector<Sample>& samples);

// c_f as the least-squares slope of m_s H (A + N tan phi) - K_f phi over the roll rate.
double roll_damping_nmsprad(const rsi::Parameters& parameters, double stiffness_nmprad,
                            const std::vector<Sample>& samples);

}  // namespace calibration_test
