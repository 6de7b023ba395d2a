// Gust: in a steady turn a gust of wind from one side, as behind the end of a wall.
#include <cmath>

#include "sil/random.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/turn.hpp"

namespace sil {
namespace {

constexpr double start_s = 1.0;
constexpr double acceleration_mps2 = 5.0;
constexpr double earliest_s = 2.5;
constexpr double latest_s = 4.0;
constexpr double slowest_mps = 10.0;
constexpr double fastest_mps = 30.0;
constexpr double shortest_s = 0.6;
constexpr double longest_s = 2.0;

// Side force coefficient of the flat side of the bodywork, and place of the force ahead of its middle, over
// its length.
constexpr double side_coefficient = 1.0;
constexpr double force_ahead = 0.1;

// One minus cosine, as gusts are idealised: from nothing to `speed_mps` and back.
struct Gust {
    double begin_s;
    double duration_s;
    double speed_mps;  // > 0: to the left

    double speed_at(double time_s) const {
        const double phase = (time_s - begin_s) / duration_s;
        return phase <= 0.0 || phase >= 1.0 ? 0.0 : 0.5 * speed_mps * (1.0 - std::cos(2.0 * pi * phase));
    }
};

DisturbanceCourse gusts(const VehicleParameters& vehicle, std::uint64_t seed) {
    RandomStream chance{seed};
    const double side = chance.below(2U) == 0U ? 1.0 : -1.0;
    const Gust gust{chance.between(earliest_s, latest_s), chance.between(shortest_s, longest_s),
                    side * chance.between(slowest_mps, fastest_mps)};
    const HullParameters& hull = vehicle.hull;
    const double area_m2 = 2.0 * hull.half_length_m * (hull.top_above_cg_m + hull.bottom_below_cg_m);
    const double ahead_m = force_ahead * 2.0 * hull.half_length_m;
    const double above_m = 0.5 * (hull.top_above_cg_m - hull.bottom_below_cg_m);
    return [gust, area_m2, ahead_m, above_m](const Truth& truth) {
        const double wind = gust.speed_at(truth.time_s);
        Disturbance disturbance;
        disturbance.side_force_n =
            0.5 * air_density_kgpm3 * side_coefficient * area_m2 * wind * std::hypot(wind, truth.speed_mps);
        disturbance.side_force_ahead_m = ahead_m;
        disturbance.side_force_above_m = above_m;
        return disturbance;
    };
}

}  // namespace

Manoeuvre gust() {
    Manoeuvre manoeuvre = held_turn(acceleration_mps2, start_s, 1.0);
    manoeuvre.name = "gust";
    manoeuvre.description =
        "turn of about 0.5 g at 50 mph, held, and a gust of 10 to 30 m/s from one side or the other";
    manoeuvre.duration_s = 8.0;
    manoeuvre.draw_disturbances = gusts;
    manoeuvre.is_disturbed = true;
    return manoeuvre;
}

}  // namespace sil
