#include "sil/studies/identification/lift_cut.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sil/studies/identification/roll_fit.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double lifted_load_share = 0.02;  // of the wheel's load at the start

template <typename Earlier>
void cut_by_loads(const Cycles& cycles, const Earlier& earlier) {
    for (const DriveCycle& cycle : cycles) {
        for (std::size_t wheel = 0U; wheel < wheel_count; ++wheel) {
            const double at_start = cycles.front().sample.wheel_load_n[wheel];
            if (cycle.sample.wheel_load_n[wheel] < lifted_load_share * at_start) {
                earlier(cycle.sample.time_s, "a wheel lifts, as the wheel loads show", true);
                return;
            }
        }
    }
}

template <typename Earlier>
void cut_by_acceleration(const Cycles& cycles, const VehicleData& vehicle, const PreparationOptions& options,
                         const SensorOffsets& offsets, const Earlier& earlier) {
    const Signal lateral = smooth(cycles, &DriveSample::lateral_acceleration_mps2, options.filter_lag_s);
    const Signal vertical = smooth(cycles, &DriveSample::vertical_acceleration_mps2, options.filter_lag_s);
    const Signal roll = smooth(cycles, &DriveSample::roll_angle_rad, options.filter_lag_s);
    const double limit = options.lift_share * static_stability_factor(vehicle);
    for (std::size_t k = 0U; k < lateral.size(); ++k) {
        const auto [parallel, normal] =
            road_forces(lateral[k] - offsets.lateral_mps2, vertical[k], roll[k] - offsets.roll_angle_rad);
        if (std::abs(parallel) > limit * normal) {
            earlier(cycles[k].sample.time_s,
                    fmt::format("{:.2f} g is reached, {:.0f} % of the track's half over the CG's height; "
                                "without wheel loads a first wheel may have lifted before: "
                                "if so, cut with --until",
                                limit, 100.0 * options.lift_share),
                    true);
            return;
        }
    }
}

}  // namespace

double load_transfer_by_heights(const VehicleData& vehicle, const RollSample& sample) {
    const double inertia_kgm2 = vehicle.roll_inertia_kgm2.value_or(usual_roll_inertia_kgm2(vehicle));
    const double moment_nm =
        height_moment_kgm(vehicle) * sample.overturning_mps2 - inertia_kgm2 * sample.roll_acceleration_radps2;
    return std::abs(moment_nm) / (0.5 * vehicle.total_mass_kg * sample.normal_mps2 * vehicle.track_width_m);
}

Cut find_cut(const Drive& drive, const Cycles& cycles, const VehicleData& vehicle,
             const PreparationOptions& options, const SensorOffsets& offsets) {
    Cut cut;
    const auto earlier = [&cut](double time_s, const std::string& reason, bool by_load_transfer) {
        if (!cut.time_s || time_s < *cut.time_s) {
            cut = Cut{time_s, reason, by_load_transfer};
        }
    };
    if (cycles.back().sample.time_s > options.until_s) {
        earlier(options.until_s, "as asked for", false);
    }
    if (drive.one_wheel_lift_s) {
        earlier(*drive.one_wheel_lift_s, "a wheel lifts, as the file says", true);
    }
    const bool loads = std::all_of(cycles.begin(), cycles.end(),
                                   [](const DriveCycle& cycle) { return has_loads(cycle.sample); });
    if (loads) {
        cut_by_loads(cycles, earlier);
    } else {
        cut_by_acceleration(cycles, vehicle, options, offsets, earlier);
    }
    return cut;
}

}  // namespace sil
