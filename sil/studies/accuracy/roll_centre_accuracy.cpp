#include "sil/studies/accuracy/roll_centre_accuracy.hpp"

#include <cmath>

#include "sil/units.hpp"

namespace sil::accuracy {
namespace {

constexpr double rolling_over_rad = 0.2;

class MeanSquare {
 public:
    void add(double error) {
        sum_ += error * error;
        ++count_;
    }
    double mean() const { return count_ > 0 ? sum_ / count_ : 0.0; }
    double root() const { return std::sqrt(mean()); }
    int count() const { return count_; }

 private:
    double sum_{0.0};
    int count_{0};
};

}  // namespace

RollCentreAccuracy roll_centre_accuracy(const std::vector<Cycle>& cycles, const rsi::Parameters& parameters) {
    MeanSquare constant, estimate, normalised, roll;
    int within = 0;
    for (const Cycle& cycle : cycles) {
        const sil::Truth& truth = *cycle.truth;
        const rsi::Outputs& outputs = cycle.outputs;
        if (std::abs(truth.roll_angle_rad) > rolling_over_rad) {
            break;
        }
        const double roll_error =
            static_cast<double>(outputs.compensated_roll_angle_rad) - truth.roll_angle_rad;
        if (std::isfinite(roll_error)) {
            roll.add(roll_error * sil::degrees_per_radian);
        }
        const double movement_m =
            truth.roll_centre_height_m - static_cast<double>(parameters.fixed_roll_centre_height_m);
        const double error_m = static_cast<double>(outputs.roll_centre_vertical_m) - movement_m;
        if (!std::isfinite(error_m)) {
            continue;
        }
        constant.add(movement_m);
        estimate.add(error_m);
        const double deviation_m = static_cast<double>(outputs.roll_centre_deviation_m);
        if (std::isfinite(deviation_m)) {
            normalised.add(error_m / deviation_m);
            within += std::abs(error_m) <= 3.0 * deviation_m ? 1 : 0;
        }
    }
    RollCentreAccuracy accuracy;
    accuracy.cycles = constant.count();
    accuracy.constant_rms_m = constant.root();
    accuracy.estimate_rms_m = estimate.root();
    accuracy.within_three_deviations =
        normalised.count() > 0 ? static_cast<double>(within) / normalised.count() : 0.0;
    accuracy.normalised_square = normalised.mean();
    accuracy.compensated_roll_rms_deg = roll.root();
    return accuracy;
}

rsi::Parameters calibration_of(const RecordedDrive& drive, rsi_estimator estimator) {
    rsi::Parameters parameters = calibration(drive.vehicle);
    parameters.sprung_cg_height_m = static_cast<float>(drive.vehicle_parameters.geometry.cg_height_m);
    if (drive.vehicle_parameters.front_suspension.spring_damper.jounce_stop_npm2 == 0.0) {
        parameters.roll_stiffness_cubic_nmprad3 = 0.0F;
        parameters.roll_stiffness_quintic_nmprad5 = 0.0F;
    }
    parameters.estimator = estimator;
    return parameters;
}

}  // namespace sil::accuracy
