#include "sil/studies/identification/tyre_limit.hpp"

#include <algorithm>
#include <cmath>

#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double dry_road_mps2 = 1.1 * g_mps2;
// Share of the ramp's largest: a vehicle that lifts a wheel in a slow turn has not used all that its tyres
// give.
constexpr double reserve_after_lift = 1.4;
constexpr double reserve = 1.05;
// Asked for so many times what came, the tyres slide; below, a wrong understeer gradient would do.
constexpr double sliding_demand = 1.3;

double largest(const std::vector<PreparedDrive>& drives) {
    double result = 0.0;
    for (const PreparedDrive& drive : drives) {
        result = std::max(result, drive.largest_parallel_mps2);
    }
    return result;
}

bool slides(const VehicleData& vehicle, const SteeringFit& steering, const PreparedDrive& ramp) {
    const auto asks_for_more = [&](const RollSample& sample) {
        const double square = sample.speed_mps * sample.speed_mps;
        const double divisor_m = vehicle.wheelbase_m + steering.understeer_gradient_s2pm.value * square;
        // Near or past the critical speed of a negative gradient the demand is unbounded, whatever the tyres
        // give.
        if (divisor_m < 0.5 * vehicle.wheelbase_m) {
            return false;
        }
        const double asked = square * std::abs(sample.steering_wheel_angle_rad) / steering.ratio.value;
        return asked > sliding_demand * ramp.largest_parallel_mps2 * divisor_m;
    };
    return ramp.has_steering && std::any_of(ramp.samples.begin(), ramp.samples.end(), asks_for_more);
}

}  // namespace

TyreLimit tyre_limit(const VehicleData& vehicle, const SteeringFit* steering,
                     const std::vector<PreparedDrive>& ramps, const std::vector<PreparedDrive>& dynamics) {
    const double seen = reserve * std::max(largest(ramps), largest(dynamics));
    const bool lifted = std::any_of(ramps.begin(), ramps.end(),
                                    [](const PreparedDrive& ramp) { return ramp.cut_by_load_transfer; });
    if (lifted) {
        return {std::max(reserve_after_lift * largest(ramps), seen),
                "1.4 of the ramp's largest, which a wheel's lift ended"};
    }
    const bool all_given =
        steering != nullptr && std::any_of(ramps.begin(), ramps.end(), [&](const PreparedDrive& ramp) {
            return slides(vehicle, *steering, ramp);
        });
    if (all_given) {
        return {seen, "5 % above the largest seen: the tyres gave no more"};
    }
    return {std::max(dry_road_mps2, seen),
            seen > dry_road_mps2 ? "5 % above the largest seen" : "1.1 g: a dry road"};
}

}  // namespace sil
