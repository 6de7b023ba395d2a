// Manoeuvre run: a vehicle driven through a manoeuvre, step by step.
#pragma once

#include <memory>
#include <optional>

#include "sil/world/manoeuvres/intervention.hpp"
#include "sil/world/manoeuvres/manoeuvre.hpp"
#include "sil/world/vehicle/vehicle.hpp"

namespace sil {

struct RunOptions {
    bool mirrored{false};  // steering and road with left and right exchanged
    double step_s{Vehicle::nominal_step_s};
    double duration_s{0.0};          // 0: as the manoeuvre says
    double speed_factor{1.0};        // times the manoeuvre's speed
    double steering_factor{1.0};     // times the driver's handwheel angle
    std::uint64_t road_seed{8608U};  // of a rough road and of what disturbs the vehicle
};

// Has road, driver and vehicle; vehicle().parameters() are those that the manoeuvre has adapted. After the
// last step the vehicle may be driven on; nothing stops it.
class ManoeuvreRun {
 public:
    ManoeuvreRun(const VehicleParameters& parameters, const Manoeuvre& manoeuvre, RunOptions options = {});

    // The run as it is now; both go on apart from each other. The road, which nothing changes, is shared.
    ManoeuvreRun(const ManoeuvreRun& other);
    ManoeuvreRun& operator=(const ManoeuvreRun&) = delete;

    // One step of the vehicle under the driver's command.
    void step();

    // The two halves of it, for who steps the vehicle together with others: what the driver does in the next
    // step, to be asked once a step, and the vehicle.
    DriverInput next_input();
    Vehicle& vehicle_to_step() { return vehicle_; }
    double step_s() const { return options_.step_s; }

    // From now on there may be an intervention, which is not demanded yet.
    void add_intervention(const Intervention& intervention) {
        intervention_.emplace(intervention, vehicle_.parameters());
    }
    // Whether it is demanded, from now on; no effect where there is none.
    void demand_intervention(bool wanted);
    const std::optional<InterventionEffect>& intervention() const { return intervention_; }

    bool finished() const { return vehicle_.truth().time_s >= duration_s_ - 0.5 * options_.step_s; }
    double duration_s() const { return duration_s_; }
    const Truth& truth() const { return vehicle_.truth(); }
    const Vehicle& vehicle() const { return vehicle_; }

 private:
    struct Adapted {};
    ManoeuvreRun(const VehicleParameters& adapted, const Manoeuvre& manoeuvre, RunOptions options, Adapted);

    RunOptions options_;
    double duration_s_;
    double wanted_speed_mps_;
    std::shared_ptr<const Road> road_;
    std::unique_ptr<Driver> driver_;
    SpeedControl speed_control_;
    DisturbanceCourse disturbance_;  // may be empty
    std::optional<InterventionEffect> intervention_{};
    Vehicle vehicle_;
};

}  // namespace sil
