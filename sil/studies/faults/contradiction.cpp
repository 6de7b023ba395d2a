#include "sil/studies/faults/contradiction.hpp"

#include <algorithm>
#include <stdexcept>

namespace sil {
namespace {

using Kind = FaultKind;
using Place = FaultPlace;

constexpr int h = hidden;
constexpr std::array all_hidden{h, h, h, h, h, h, h};
constexpr std::array in_50_ms{50, 50, 50, 50, 50, 50, 50};
constexpr std::array in_100_ms{100, 100, 100, 100, 100, 100, 100};

constexpr const char* bank_alone = "nothing else in the vehicle says what the road's bank is";
constexpr const char* a_bank_to_everybody =
    "2 m/s^2 is a road's bank of 12 deg to everybody: only 3 m/s^2 are more than a bank";
constexpr const char* shaken = "the change of the change over 0.1 s, then 3 cycles";

}  // namespace

// Rest, straight, turn; in the J-turn 0.5 s before the driver steers and as he does, 0.3 s and 0.1 s before
// the warning.
const std::vector<Contradiction>& contradictions() {
    static const std::vector<Contradiction> all{
        {Kind::frozen,
         Place::lateral_acceleration,
         {h, h, 450, 50, 100, 100, 100},
         "21 equal values while yaw rate times speed spans 1 m/s^2; in the turn the road's roughness does "
         "that"},
        {Kind::frozen,
         Place::vertical_acceleration,
         {h, h, 100, 50, 50, 50, 50},
         "21 equal values while the lateral acceleration spans 1.5 m/s^2"},
        {Kind::frozen,
         Place::roll_rate,
         {450, 450, 50, 100, 100, 150, 150},
         "21 equal values while the roll angle less the integrated roll rate spans 0.02 rad"},
        {Kind::frozen,
         Place::roll_angle,
         {h, h, 550, 50, 50, 100, 50},
         "21 equal values while the integrated roll rate spans 0.015 rad"},
        {Kind::frozen, Place::bank_angle, all_hidden, bank_alone},
        {Kind::frozen,
         Place::speed,
         {h, h, h, 50, 50, 650, 650},
         "21 equal values while the yaw rate times this speed spans 4.5 m/s^2"},
        {Kind::frozen,
         Place::yaw_rate,
         {h, h, 250, 50, 50, 150, 50},
         "21 equal values while the lateral acceleration spans 1.5 m/s^2"},
        {Kind::frozen,
         Place::steering_wheel_angle,
         {h, h, h, 100, h, h, h},
         "straight for 0.2 s with it, then a turn of 3 m/s^2; in a turn a driver may hold it still"},

        {Kind::offset, Place::lateral_acceleration, all_hidden, a_bank_to_everybody, 0, 500},
        {Kind::offset,
         Place::vertical_acceleration,
         {600, 600, 600, 600, 600, 600, 600},
         "lag of 0.4 s against a threshold of 1.5 m/s^2, 3 cycles",
         0,
         100,
         1},
        {Kind::offset,
         Place::vertical_acceleration,
         {600, 600, 600, 600, h, h, h},
         "the same; it makes the warning early, and in a warning the threshold is 3.5 m/s^2",
         0,
         250,
         -1},
        {Kind::offset,
         Place::roll_rate,
         {950, 950, 950, 950, 950, 1000, 950},
         "10 deg/s make the 9 deg within 1 s in 0.9 s, 3 cycles"},
        {Kind::offset, Place::roll_angle, in_50_ms,
         "the step is a jump, then the observer contradicts, but not a vehicle that tips", 1050},
        {Kind::offset, Place::bank_angle, all_hidden, bank_alone},
        {Kind::offset, Place::speed, in_50_ms,
         "the step is a jump, which heals after 0.5 s; nothing says that the speed is wrong by 30 km/h",
         any_time_ms},
        {Kind::offset, Place::yaw_rate, all_hidden, "5 m/s^2 at 100 km/h, below the 7 of a spin"},
        {Kind::offset, Place::steering_wheel_angle, all_hidden, "below the step of a driver's hand"},

        {Kind::drift, Place::lateral_acceleration, all_hidden, a_bank_to_everybody},
        {Kind::drift,
         Place::vertical_acceleration,
         {1450, 1450, 1150, h, h, h, h},
         "passes 1.5 m/s^2 1 s after the least visible error, lag of 0.4 s; before that the vehicle is over"},
        {Kind::drift,
         Place::roll_rate,
         {1900, 1900, 1900, h, h, h, h},
         "passes 9 deg within 1 s 1.7 s after the least visible error; before that the vehicle is over"},
        {Kind::drift,
         Place::roll_angle,
         {1500, 1500, 1850, h, h, h, h},
         "passes 2.9 deg against the observer 0.9 s after the least visible error, for 0.3 s; in the J-turn "
         "the "
         "vehicle has tipped before"},
        {Kind::drift, Place::bank_angle, all_hidden, bank_alone},
        {Kind::drift, Place::speed, all_hidden, "as an acceleration; the step back at its end is a jump"},
        {Kind::drift, Place::yaw_rate, all_hidden, "below 7 m/s^2 at its end; the step back is a jump"},
        {Kind::drift, Place::steering_wheel_angle, all_hidden, "as a driver's hand"},

        {Kind::noise, Place::lateral_acceleration, {200, 200, 100, 100, 100, 150, 150}, shaken},
        {Kind::noise, Place::vertical_acceleration, in_100_ms, shaken},
        {Kind::noise, Place::roll_rate, {100, 100, 100, 100, 100, 150, 100}, shaken},
        {Kind::noise, Place::roll_angle, {100, 100, 100, 100, 100, 50, 50}, shaken},
        {Kind::noise, Place::bank_angle, all_hidden, bank_alone},
        {Kind::noise,
         Place::speed,
         {200, 50, 50, 50, 50, 50, 50},
         "a jump, or shaken; at rest every second value is below zero and is sent as zero"},
        {Kind::noise, Place::yaw_rate, in_100_ms, shaken},
        {Kind::noise, Place::steering_wheel_angle, in_100_ms, shaken},

        {Kind::sign_flip,
         Place::lateral_acceleration,
         {h, h, 200, 400, 400, 200, 50},
         "alone of its sign for 0.2 s, both beyond 2 m/s^2; in the moment of warning a jump",
         200},
        {Kind::sign_flip, Place::vertical_acceleration, in_50_ms, "a jump, then the offset", 100},
        {Kind::sign_flip,
         Place::roll_rate,
         {h, h, h, 200, 200, 50, 850},
         "3.5 deg within 0.2 s against the roll angle: once the body rolls; before that a jump, which heals",
         500},
        {Kind::sign_flip,
         Place::roll_angle,
         {h, h, 50, 100, 100, 50, 50},
         "a jump, then the observer contradicts",
         300},
        {Kind::sign_flip, Place::bank_angle, all_hidden, bank_alone},
        {Kind::sign_flip,
         Place::yaw_rate,
         {h, h, 50, 1300, 1300, 50, 50},
         "a jump in a turn; else alone of its sign for 1.2 s, because a spinning vehicle is for 0.7 s",
         1250},
        {Kind::sign_flip,
         Place::steering_wheel_angle,
         {h, h, h, h, h, 50, 50},
         "a jump in a turn; nothing else says where the driver steers",
         any_time_ms},
    };
    return all;
}

int limit_of(const Contradiction& stated, SceneKind scene) {
    const auto limit = [&stated](SceneKind kind) { return stated.limits_ms[static_cast<std::size_t>(kind)]; };
    if (scene != SceneKind::over) {
        return limit(scene);
    }
    const int before = limit(SceneKind::before_turn);
    const int steering = limit(SceneKind::steering);
    return before == hidden || steering == hidden ? hidden : std::max(before, steering);
}

const Contradiction& contradiction_of(const Fault& fault) {
    const std::vector<Contradiction>& all = contradictions();
    const auto found = std::find_if(all.begin(), all.end(), [&fault](const Contradiction& each) {
        return each.kind == fault.kind && each.place == fault.place && each.sign * fault.magnitude >= 0.0;
    });
    if (found == all.end()) {
        throw std::logic_error("no contradiction is stated for: " + describe(fault));
    }
    return *found;
}

}  // namespace sil
