// Drive signals: the columns of a resampled drive, as they are and smoothed.
#pragma once

#include <array>
#include <stdexcept>
#include <vector>

#include "sil/studies/drives/resample.hpp"

namespace sil {

// Reasons that a drive is of no use; ready to be shown.
class IdentificationError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

inline constexpr double sample_time_s = 0.01;

using Signal = std::vector<double>;
using Cycles = std::vector<DriveCycle>;

bool complete(const Signal& signal);
bool has_loads(const DriveSample& sample);
// c_w/2 (F_zR - F_zL)
double load_moment_nm(const DriveSample& sample, double track_width_m);

// The longest part in which everything that is necessary is there.
Cycles longest_whole_part(const Cycles& cycles);

// Without delay; all NaN where a value is missing.
Signal smooth(const Cycles& cycles, double DriveSample::* member, double lag_s);

// Along the road and normal to it, of the forces in body axes.
std::array<double, 2> road_forces(double lateral, double vertical, double roll);

}  // namespace sil
