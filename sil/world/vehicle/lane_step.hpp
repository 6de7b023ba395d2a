// Lane step: how the vehicles of a batch step, compiled for several kinds of processor. Only VehicleBatch and
// tests look here.
#pragma once

#include <cstddef>
#include <vector>

#include "sil/world/vehicle/driver_input.hpp"
#include "sil/world/vehicle/lane_count.hpp"
#include "sil/world/vehicle/road.hpp"
#include "sil/world/vehicle/truth.hpp"
#include "sil/world/vehicle/vehicle_model.hpp"

namespace sil {

// All that steps: nothing but numbers, in the same order for one vehicle as for several. A number of one lane
// thus lies where it does for one vehicle, times lane_count, plus the lane.
template <typename Real>
struct SteppedNumbers {
    VehicleModel<Real> model{BasicVehicleParameters<Real>{}};
    BasicDriverInput<Real> input{};
    BasicTruth<Real> truth{};
};
inline constexpr std::size_t stepped_number_count = sizeof(SteppedNumbers<double>) / sizeof(double);

struct LaneStep {
    const char* processor;  // for which it is compiled
    // Makes the numbers in memory of stepped_number_count * lane_count doubles, aligned as the largest
    // register.
    void (*make)(double* numbers);
    // Steps all lanes by their inputs; the truth of each is then whole, or its motion alone. `roads`: of each
    // lane, a null pointer for an empty one.
    void (*step)(double* numbers, const Road* const* roads, double step_s, bool whole_truth);

    // Functions that the step uses, of lane_count numbers, in place of which they put the result: for tests.
    void (*atan)(double* values);
    void (*sin)(double* values);
    void (*sin_and_cos)(double* values, double* cosines);
};
inline constexpr std::size_t lane_alignment = lane_count * sizeof(double);

// That for any processor, and those for some. The same numbers come from each.
LaneStep portable_lane_step();
#ifdef RSI_X86_LANE_STEPS
LaneStep avx2_lane_step();
LaneStep avx512_lane_step();
#endif

// Those that this machine can run, the best first.
std::vector<LaneStep> lane_steps();

}  // namespace sil
