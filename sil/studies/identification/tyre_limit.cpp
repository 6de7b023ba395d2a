#include "sil/studies/identification/tyre_limit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sil/straight_line.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double dry_road_mps2 = 1.1 * g_mps2;
// Times the ramp's largest: a vehicle that lifts a wheel in a slow turn, or whose driver turned back, has not
// used all that its tyres give.
constexpr double open_share = 1.4;
constexpr double reserve = 1.05;
// The force has stopped growing if, while what is asked for grows by a quarter, it grows less than a quarter
// as fast as in the ramp's lower half. A brush tyre then gives nine tenths of its largest force, and more.
constexpr double last_part = 0.8;
constexpr double lower_half = 0.5;
constexpr double stopped_slope_share = 0.25;
constexpr double fewest_answers = 20.0;
// Share of the ramp's largest: a driver who drifts to the other side before he turns shows no limit there.
constexpr double least_reached_share = 0.9;

double largest(const std::vector<PreparedDrive>& drives) {
    double result = 0.0;
    for (const PreparedDrive& drive : drives) {
        result = std::max(result, drive.largest_parallel_mps2);
    }
    return result;
}

// The driver asks for something, and a lateral acceleration comes of it.
struct Answer {
    double asked;
    double came_mps2;
};

using Demand = double (*)(const RollSample& sample);

// Linear tyres give V^2 delta / (L + K_us V^2): at one speed in proportion to either demand. It falls behind
// the first one if speed is lost, behind the second if speed is gained and the vehicle understeers.
double by_steering(const RollSample& sample) {
    return sample.steering_wheel_angle_rad;
}

double by_steering_and_speed(const RollSample& sample) {
    return sample.speed_mps * sample.speed_mps * sample.steering_wheel_angle_rad;
}

// A turn to one side (1: left, -1: right) from the straight to the largest demand.
std::vector<Answer> way_out(const PreparedDrive& ramp, double side, Demand demand) {
    std::vector<Answer> all;
    std::size_t start = 0U, first = 0U, end = 0U;
    double most = 0.0;
    for (const RollSample& sample : ramp.samples) {
        const double asked = side * demand(sample);
        all.push_back({asked, side * sample.parallel_mps2});
        if (asked <= 0.0) {
            start = all.size();
        } else if (asked > most) {
            most = asked;
            first = start;
            end = all.size();
        }
    }
    const auto at = [&all](std::size_t place) { return all.begin() + static_cast<std::ptrdiff_t>(place); };
    return {at(first), at(end)};
}

bool stops_growing(const std::vector<Answer>& answers, double ramp_largest_mps2) {
    double most = 0.0, most_mps2 = 0.0;
    for (const Answer& answer : answers) {
        most = std::max(most, answer.asked);
        most_mps2 = std::max(most_mps2, answer.came_mps2);
    }
    if (most_mps2 < least_reached_share * ramp_largest_mps2) {
        return false;
    }
    const auto half = std::find_if(answers.begin(), answers.end(), [&](const Answer& answer) {
        return answer.came_mps2 > lower_half * most_mps2;
    });
    StraightLine first, last;
    std::for_each(answers.begin(), half,
                  [&first](const Answer& answer) { first.add(answer.asked, answer.came_mps2); });
    for (const Answer& answer : answers) {
        if (answer.asked > last_part * most) {
            last.add(answer.asked, answer.came_mps2);
        }
    }
    return std::min(first.count(), last.count()) >= fewest_answers && first.slope() > 0.0 &&
           last.slope() < stopped_slope_share * first.slope();
}

bool shows_the_limit_on(const PreparedDrive& ramp, double side) {
    return stops_growing(way_out(ramp, side, by_steering_and_speed), ramp.largest_parallel_mps2) &&
           stops_growing(way_out(ramp, side, by_steering), ramp.largest_parallel_mps2);
}

bool shows_the_limit(const PreparedDrive& ramp) {
    return ramp.has_steering && (shows_the_limit_on(ramp, 1.0) || shows_the_limit_on(ramp, -1.0));
}

// The tyres carry the whole vehicle sideways, (m_s h + m_u h_u) A against m g c_w/2. A body that leans lifts
// its wheels below this.
double lift_without_lean_mps2(const VehicleData& vehicle) {
    return g_mps2 * 0.5 * vehicle.track_width_m * vehicle.total_mass_kg / height_moment_kgm(vehicle);
}

}  // namespace

TyreLimit tyre_limit(const VehicleData& vehicle, const std::vector<PreparedDrive>& ramps,
                     const std::vector<PreparedDrive>& dynamics) {
    const double seen = reserve * std::max(largest(ramps), largest(dynamics));
    const bool lifted = std::any_of(ramps.begin(), ramps.end(),
                                    [](const PreparedDrive& ramp) { return ramp.cut_by_load_transfer; });
    if (!lifted && std::any_of(ramps.begin(), ramps.end(), shows_the_limit)) {
        return {seen, true, "5 % above the largest seen: the force grew no more while the steering did"};
    }
    const double of_ramps = open_share * largest(ramps);
    const double open = std::max(of_ramps, seen);
    const double lift_mps2 = lift_without_lean_mps2(vehicle);
    if (open > std::max(dry_road_mps2, lift_mps2)) {
        return {open, false,
                seen > of_ramps ? "open: 5 % above the largest seen; the ramp shows no limit"
                                : "open: 1.4 times the ramp's largest, which shows no limit"};
    }
    return {std::max(dry_road_mps2, lift_mps2), false,
            lift_mps2 > dry_road_mps2
                ? "open: the whole vehicle's static rollover threshold; the ramp shows no limit"
                : "open: 1.1 g, a dry road; the ramp shows no limit"};
}

}  // namespace sil
