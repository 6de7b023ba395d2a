// Split friction: in a turn the left and the right wheels come onto a slick patch, each at its own time, and
// leave it again; the grip that returns throws the sliding vehicle into the turn.
#include "sil/random.hpp"
#include "sil/world/manoeuvres/turn.hpp"

namespace sil {
namespace {

constexpr double start_s = 2.0;
constexpr double acceleration_mps2 = 5.0;
constexpr double least_grip = 0.2;
constexpr double largest_grip = 0.6;

struct Patch {
    double begin_s;
    double end_s;
    double grip;

    double grip_at(double time_s) const { return time_s < begin_s || time_s >= end_s ? 1.0 : grip; }
};

DisturbanceCourse patches(const VehicleParameters&, std::uint64_t seed) {
    RandomStream chance{seed};
    const auto patch = [&chance] {
        const double begin_s = start_s + chance.between(0.0, 0.6);
        return Patch{begin_s, begin_s + chance.between(0.6, 1.8), chance.between(least_grip, largest_grip)};
    };
    const Patch left = patch();
    const Patch right = patch();
    return [left, right](const Truth& truth) {
        Disturbance disturbance;
        const double left_grip = left.grip_at(truth.time_s);
        const double right_grip = right.grip_at(truth.time_s);
        disturbance.grip = {left_grip, right_grip, left_grip, right_grip};
        return disturbance;
    };
}

}  // namespace

Manoeuvre split_friction() {
    Manoeuvre manoeuvre = held_turn(acceleration_mps2, start_s, 2.0);
    manoeuvre.name = "split-friction";
    manoeuvre.description =
        "turn of about 0.5 g at 50 mph, held, over slick patches that differ from left to right";
    manoeuvre.duration_s = 8.0;
    manoeuvre.draw_disturbances = patches;
    manoeuvre.is_disturbed = true;
    return manoeuvre;
}

}  // namespace sil
