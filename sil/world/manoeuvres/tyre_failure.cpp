// Tyre failure: in a turn one tyre loses its air within a moment; the driver, frightened, takes the foot off,
// steers against it too far, and back.
#include <algorithm>

#include "sil/random.hpp"
#include "sil/world/manoeuvres/turn.hpp"

namespace sil {
namespace {

constexpr double start_s = 1.0;
constexpr double failure_s = 3.0;
constexpr double fastest_leak_s = 0.1;
constexpr double slowest_leak_s = 0.5;
constexpr double acceleration_mps2 = 4.0;
constexpr double reaction_s = failure_s + 0.7;
constexpr double against =
    2.5;  // times the handwheel angle of the turn, so that 1.5 to the other side are left
constexpr double against_held_s = 1.2;
constexpr double hands_ps = 5.0;  // of that angle

DisturbanceCourse failures(const VehicleParameters&, std::uint64_t seed) {
    RandomStream chance{seed};
    const std::size_t wheel = chance.below(wheel_count);
    const double duration_s = chance.between(fastest_leak_s, slowest_leak_s);
    return [wheel, duration_s](const Truth& truth) {
        Disturbance disturbance;
        disturbance.lost_air[wheel] = std::clamp((truth.time_s - failure_s) / duration_s, 0.0, 1.0);
        return disturbance;
    };
}

DriverCommand command(double time_s) {
    DriverCommand command{ramp_and_hold(time_s, start_s, 1.0, 1.0) -
                          ramp_and_hold(time_s, reaction_s, hands_ps, against) +
                          ramp_and_hold(time_s, reaction_s + against_held_s, hands_ps, against - 1.0)};
    command.speed_policy = time_s < reaction_s ? SpeedPolicy::held : SpeedPolicy::off_throttle;
    return command;
}

}  // namespace

Manoeuvre tyre_failure() {
    Manoeuvre manoeuvre = turn(acceleration_mps2, command);
    manoeuvre.name = "tyre-failure";
    manoeuvre.description =
        "turn of about 0.4 g at 50 mph in which one tyre goes flat within 0.1 to 0.5 s; the driver "
        "overcorrects";
    manoeuvre.duration_s = 8.0;
    manoeuvre.draw_disturbances = failures;
    manoeuvre.is_disturbed = true;
    return manoeuvre;
}

}  // namespace sil
