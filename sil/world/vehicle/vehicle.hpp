// Vehicle: body, suspensions, tyres and wheels put together, and one step of time.
//
// 14 degrees of freedom: body 6 (quaternion, valid at any angle), front left and right jounce, rear axle
// heave and roll, four wheel spins; and, where the frame twists, the roll of the rear part of the body.
// Integration is semi-implicit Euler: velocities first, positions with the new velocities; meant for steps of
// 1 ms.
#pragma once

#include "sil/world/vehicle/driver_input.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/road.hpp"
#include "sil/world/vehicle/state.hpp"
#include "sil/world/vehicle/truth.hpp"
#include "sil/world/vehicle/vehicle_model.hpp"

namespace sil {

// Place and motion at the beginning of a run. Offsets are from static equilibrium on the road below.
struct InitialState {
    double speed_mps{0.0};
    double sideways_mps{0.0};  // to the left, of a vehicle that slides
    double position_x_m{0.0};
    double position_y_m{0.0};
    double yaw_angle_rad{0.0};
    double height_offset_m{0.0};
    double roll_offset_rad{0.0};
    double pitch_offset_rad{0.0};
    double roll_rate_radps{0.0};  // rates are body components
    double pitch_rate_radps{0.0};
    double yaw_rate_radps{0.0};
};

// Owns all its state; no heap use and no exception after construction. The road must outlive it.
class Vehicle {
 public:
    // Nominal step; the largest at which the model is accurate.
    static constexpr double nominal_step_s = 0.001;

    Vehicle(const VehicleParameters& parameters, const Road& road);

    // Time zero; body square to the plane on which the four wheels stand, wheels rolling, spring forces in
    // balance with the weights of a level road.
    void reset(const InitialState& initial = {});

    // Advances by `step_s` (above 0, at most 2 ms); `input` holds at the end of the step.
    void step(const DriverInput& input, double step_s = nominal_step_s);

    const Truth& truth() const { return truth_; }
    const State& state() const { return model_.state; }
    const VehicleParameters& parameters() const { return parameters_; }

    // Kinetic and potential energy of everything, zero height being that of the earth-fixed origin.
    double mechanical_energy_j() const;

 private:
    friend class VehicleBatch;  // steps the model in its place

    struct Ground {
        double height_m;  // below the CG
        Vector3 normal;
    };

    Ground ground_below(const InitialState& initial) const;

    VehicleParameters parameters_;
    const Road& road_;
    VehicleModel<double> model_;
    Truth truth_{};
};

}  // namespace sil
