#include "sil/studies/faults/driven_world.hpp"

#include <algorithm>
#include <cmath>

#include "sil/simulation/mounted_sensors.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/mixed_driving.hpp"

namespace sil {
namespace {

constexpr double upset_rad = 1.2;
constexpr std::uint64_t cycles_without_vehicle = 100U;
constexpr int steps_a_cycle = 10;
constexpr double step_s = cycle_time_s / steps_a_cycle;

constexpr double braking_mps2 = 4.0;
constexpr double gathering_speed_mps2 = 3.0;
constexpr double straight_before_stop_s = 0.5;

}  // namespace

DrivenWorld::DrivenWorld(const VehicleParameters& vehicle, std::uint64_t seed, double duration_s)
    : vehicle_{vehicle}, seed_{seed}, duration_s_{duration_s}, chance_{seed + 1U} {
    SensorFlaws flaws;
    flaws.noise = true;
    flaws.seed = seed;
    flaws.bank_sensor = true;
    sensors_.emplace(mounted_sensors(vehicle, flaws));
    until_stop_s_ = chance_.between(30.0, 300.0);
    start();
}

void DrivenWorld::start() {
    plant_.emplace(vehicle_, mixed_driving(seed_ + 1000U * rollovers_, duration_s_));
    sensors_->observe(plant_->truth());
}

std::optional<SensorSample> DrivenWorld::next() {
    if (absent_ > 0U) {
        --absent_;
        return std::nullopt;
    }
    begin_stop_if_due();
    for (int count = 0; count < steps_a_cycle; ++count) {
        step();
        sensors_->observe(shown_);
    }
    if (std::abs(shown_.roll_angle_rad) > upset_rad) {
        ++rollovers_;
        start();
        absent_ = cycles_without_vehicle;
        return std::nullopt;
    }
    return sensors_->report(shown_);
}

void DrivenWorld::step() {
    if (stop_) {
        shown_ = stopping_truth();
        return;
    }
    plant_->step();
    shown_ = plant_->truth();
    shown_.time_s += stopped_s_;
}

// With no more roll and yaw than the sensors' noise hides, so that the change to what is written down is
// none.
bool DrivenWorld::goes_straight() const {
    const Truth& truth = plant_->truth();
    return std::abs(truth.specific_force_mps2[1]) < 0.05 && std::abs(truth.roll_angle_rad) < 0.002 &&
           std::abs(truth.angular_velocity_radps[0]) < 0.005 &&
           std::abs(truth.angular_velocity_radps[2]) < 0.005;
}

void DrivenWorld::begin_stop_if_due() {
    if (stop_) {
        return;
    }
    until_stop_s_ -= cycle_time_s;
    straight_s_ = goes_straight() ? straight_s_ + cycle_time_s : 0.0;
    if (until_stop_s_ <= 0.0 && straight_s_ >= straight_before_stop_s) {
        stop_ = Stop{plant_->truth().speed_mps, chance_.between(3.0, 40.0)};
        until_stop_s_ = chance_.between(30.0, 300.0);
        straight_s_ = 0.0;
        ++stops_;
    }
}

Truth DrivenWorld::stopping_truth() {
    stop_->time_s += step_s;
    stopped_s_ += step_s;
    const double stands_s = stop_->speed_mps / braking_mps2;
    const double goes_s = stands_s + stop_->standing_s;
    const double falling_mps = stop_->speed_mps - braking_mps2 * stop_->time_s;
    const double rising_mps = gathering_speed_mps2 * (stop_->time_s - goes_s);
    stop_speed_mps_ = std::max({falling_mps, rising_mps, 0.0});
    Truth truth;
    truth.time_s = plant_->truth().time_s + stopped_s_;
    truth.specific_force_mps2 = {0.0, 0.0, g_mps2};
    truth.speed_mps = stop_speed_mps_;
    if (stop_->time_s > goes_s && stop_speed_mps_ >= stop_->speed_mps) {
        truth.speed_mps = stop_->speed_mps;
        stop_.reset();
    }
    return truth;
}

}  // namespace sil
