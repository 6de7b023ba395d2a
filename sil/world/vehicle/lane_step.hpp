// Lane step: how the vehicles of a batch step, compiled for several kinds of processor.
#pragma once

#include <cstddef>

#include "sil/world/vehicle/driver_input.hpp"
#include "sil/world/vehicle/lane_count.hpp"
#include "sil/world/vehicle/road.hpp"
#include "sil/world/vehicle/truth.hpp"
#include "sil/world/vehicle/vehicle_model.hpp"

namespace sil {

// All that steps: nothing but numbers, in the same order for one vehicle as for several. So a number of one lane lies
// where it does for one vehicle, times lane_count, plus the lane.
template <typename Real>
struct SteppedNumbers {
    VehicleModel<Real> model{BasicVehicleParameters<Real>{}};
    BasicDriverInput<Real> input{};
    BasicTruth<Real> truth{};
};
inline constexpr std::size_t stepped_number_count = sizeof(SteppedNumbers<double>) / sizeof(double);

struct LaneStep {
    // Makes the numbers in memory of stepped_number_count * lane_count doubles, aligned as the largest register.
    void (*make)(double* numbers);
    // Steps all lanes by their inputs; the truth of each is then whole, or its motion alone. `roads`: of each lane, a
    // null pointer for an empty one.
    void (*step)(double* numbers, const Road* const* roads, double step_s, bool whole_truth);
};
inline constexpr std::size_t lane_alignment = lane_count * sizeof(double);

// That for any processor; the same numbers come from each.
LaneStep portable_lane_step();
#ifdef RSI_X86_LANE_STEPS
LaneStep avx2_lane_step();
LaneStep avx512_lane_step();
#endif

// The one that suits this machine best.
LaneStep lane_step();

}  // namespace sil
