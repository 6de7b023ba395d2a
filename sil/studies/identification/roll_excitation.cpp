#include "sil/studies/identification/roll_excitation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sil/studies/identification/zero_phase_filter.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

// A body leans out of the turn: with roll angle and lateral acceleration in ISO 8855 signs both grow
// together.
void refuse_wrong_roll_sign(const PreparedDrive& drive) {
    double common = 0.0;
    for (const RollSample& sample : drive.samples) {
        common += sample.roll_angle_rad * sample.overturning_mps2;
    }
    if (common <= 0.0) {
        throw IdentificationError(
            fmt::format("{}: the body leans into the turn. Check the signs: in a left turn lateral "
                        "acceleration, yaw rate and roll angle are positive",
                        drive.name));
    }
}

// The roll rate must be the roll angle's derivative: not so with a wrong sign or a wrong unit.
void refuse_wrong_roll_rate(const PreparedDrive& drive) {
    std::vector<double> angle;
    for (const RollSample& sample : drive.samples) {
        angle.push_back(sample.roll_angle_rad);
    }
    const std::vector<double> slope = differentiate(angle, sample_time_s);
    double common = 0.0, squares = 0.0;
    for (std::size_t k = 0U; k < slope.size(); ++k) {
        common += slope[k] * drive.samples[k].roll_rate_radps;
        squares += drive.samples[k].roll_rate_radps * drive.samples[k].roll_rate_radps;
    }
    const double ratio = common / squares;
    if (ratio < 0.5 || ratio > 2.0) {
        throw IdentificationError(
            fmt::format("{}: the roll angle changes {:.2g} times as fast as the roll rate says. Check "
                        "sign and unit of both columns, that they are of one clock, and that the road is "
                        "level: a bank that changes turns the body and leaves an angle against the road",
                        drive.name, ratio));
    }
}

}  // namespace

void refuse_without_excitation(const std::vector<PreparedDrive>& ramps,
                               const std::vector<PreparedDrive>& dynamics) {
    for (const PreparedDrive& drive : ramps) {
        if (drive.largest_parallel_mps2 < 0.1 * g_mps2 || drive.largest_roll_angle_rad < 0.002) {
            throw IdentificationError(
                fmt::format("{}: the ramp reaches only {:.2f} g and {:.2f} deg of roll before it ends or "
                            "is cut; nothing can be fitted below 0.1 g. Steer slowly on, to 0.5 g at least",
                            drive.name, drive.largest_parallel_mps2 / g_mps2,
                            drive.largest_roll_angle_rad * degrees_per_radian));
        }
    }
    for (const PreparedDrive& drive : ramps) {
        refuse_wrong_roll_sign(drive);
    }
    for (const PreparedDrive& drive : dynamics) {
        double largest_rate = 0.0;
        for (const RollSample& sample : drive.samples) {
            largest_rate = std::max(largest_rate, std::abs(sample.roll_rate_radps));
        }
        if (largest_rate * degrees_per_radian < 2.0) {
            throw IdentificationError(
                fmt::format("{}: the body rolls with {:.1f} deg/s at most; damping and inertia do not "
                            "show below 2 deg/s. Drive a step steer or a lane change that reaches 0.3 g; "
                            "if it was one, check the units",
                            drive.name, largest_rate * degrees_per_radian));
        }
        refuse_wrong_roll_sign(drive);
        refuse_wrong_roll_rate(drive);
    }
}

}  // namespace sil
