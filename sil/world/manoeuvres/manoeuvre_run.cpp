// Manoeuvre run: the driver sees a world in which the first turn is to the left, mirrored or not.
#include "sil/world/manoeuvres/manoeuvre_run.hpp"

#include <utility>

#include "sil/world/vehicle/mirror.hpp"

namespace sil {
namespace {

std::unique_ptr<const Road> make_road(const Manoeuvre& manoeuvre, const RunOptions& options) {
    std::unique_ptr<const Road> road = manoeuvre.make_road(options.road_seed);
    if (options.mirrored) {
        return std::make_unique<MirroredRoad>(std::move(road));
    }
    return road;
}

VehicleParameters adapted(const VehicleParameters& parameters, const Manoeuvre& manoeuvre) {
    return manoeuvre.adapt_vehicle ? manoeuvre.adapt_vehicle(parameters) : parameters;
}

}  // namespace

ManoeuvreRun::ManoeuvreRun(const VehicleParameters& parameters, const Manoeuvre& manoeuvre,
                           RunOptions options)
    : ManoeuvreRun{adapted(parameters, manoeuvre), manoeuvre, options, Adapted{}} {}

ManoeuvreRun::ManoeuvreRun(const VehicleParameters& parameters, const Manoeuvre& manoeuvre,
                           RunOptions options, Adapted)
    : options_{options},
      duration_s_{options.duration_s > 0.0 ? options.duration_s : manoeuvre.duration_s},
      wanted_speed_mps_{manoeuvre.initial_speed_mps * options.speed_factor},
      road_{make_road(manoeuvre, options)},
      driver_{manoeuvre.make_driver(parameters)},
      speed_control_{parameters},
      disturbance_{manoeuvre.draw_disturbances ? manoeuvre.draw_disturbances(parameters, options.road_seed)
                                               : DisturbanceCourse{}},
      vehicle_{parameters, *road_} {
    InitialState initial;
    initial.speed_mps = wanted_speed_mps_ * manoeuvre.start_speed_share;
    initial.sideways_mps =
        initial.speed_mps * manoeuvre.start_sideways_share * (options.mirrored ? -1.0 : 1.0);
    vehicle_.reset(initial);
}

ManoeuvreRun::ManoeuvreRun(const ManoeuvreRun& other)
    : options_{other.options_},
      duration_s_{other.duration_s_},
      wanted_speed_mps_{other.wanted_speed_mps_},
      road_{other.road_},
      driver_{other.driver_->copy()},
      speed_control_{other.speed_control_},
      disturbance_{other.disturbance_},
      intervention_{other.intervention_},
      vehicle_{other.vehicle_} {}

void ManoeuvreRun::step() {
    vehicle_.step(next_input(), options_.step_s);
}

void ManoeuvreRun::demand_intervention(bool wanted) {
    if (intervention_) {
        intervention_->demand(wanted, vehicle_.truth().time_s);
    }
}

DriverInput ManoeuvreRun::next_input() {
    const Truth& truth = vehicle_.truth();
    const Truth seen = options_.mirrored ? mirrored(truth) : truth;
    DriverCommand command = driver_->command(seen);
    command.steering_wheel_angle_rad *=
        options_.mirrored ? -options_.steering_factor : options_.steering_factor;
    if (intervention_) {
        command = intervention_->changed(command, truth.time_s);
    }
    const SpeedPolicy policy = command.brake > 0.0 ? SpeedPolicy::off_throttle : command.speed_policy;
    DriverInput input;
    input.steering_wheel_angle_rad = command.steering_wheel_angle_rad;
    input.drive_force_n = speed_control_.drive_force_n(policy, wanted_speed_mps_ * command.speed_share,
                                                       truth.speed_mps, options_.step_s);
    input.brake = command.brake;
    if (disturbance_) {
        const Disturbance disturbance = disturbance_(seen);
        input.disturbance = options_.mirrored ? mirrored(disturbance) : disturbance;
    }
    return input;
}

}  // namespace sil
