// Step drive: one step of a procedure, driven with the ECU beside it and in process.
#pragma once

#include <string>

#include "sil/studies/procedures/procedure.hpp"
#include "sil/world/manoeuvres/manoeuvre.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

// Measurements of a procedure during a step. It sees a world in which the first turn is to the left, mirrored
// or not.
class StepMeasurement {
 public:
    StepMeasurement() = default;
    StepMeasurement(const StepMeasurement&) = delete;
    StepMeasurement& operator=(const StepMeasurement&) = delete;
    virtual ~StepMeasurement() = default;

    virtual void step(const Truth& truth) = 0;

    // Asked after each cycle: true ends the step.
    virtual bool finished() const { return false; }
};

struct StepDrive {
    WarningBeside warning{};
    double largest_roll_rad{0.0};    // relative to the road, a magnitude
    double two_wheel_height_m{0.0};  // the largest height of the lower of a side's two wheels
    bool completed{false};           // to the end of the manoeuvre, or to where the measurement ends it
};

// Height over the road of the lower of the two wheels of a side, of the side where it is higher.
double two_wheel_height_m(const Truth& truth);

// `name`: of the folder for the step's signals. Throws std::invalid_argument with the field's name when the
// calibration is refused.
StepDrive drive_step(const ProcedureWorld& world, const std::string& name, const Manoeuvre& manoeuvre,
                     bool mirrored, StepMeasurement& measurement);

// Results of the vehicle in every step.
std::vector<Figure> motion_figures(const StepDrive& drive);

}  // namespace sil
