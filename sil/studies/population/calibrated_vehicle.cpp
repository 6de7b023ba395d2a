#include "sil/studies/population/calibrated_vehicle.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "sil/files/calibration_file.hpp"
#include "sil/files/file_io.hpp"
#include "sil/studies/identification/calibration_writer.hpp"
#include "sil/studies/identification/identification.hpp"
#include "sil/studies/identification/simulated_drive.hpp"
#include "sil/studies/population/properties.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/slow_ramp.hpp"

namespace sil {
namespace {

// The step steer goes to 0.4 g; who tests a truck stays this far below its threshold.
constexpr double step_steer_g = 0.4;
constexpr double step_steer_of_threshold = 0.6;

double largest_ltr(const Drive& drive) {
    double largest = 0.0;
    for (const DriveSample& sample : drive.samples) {
        const double left = sample.wheel_load_n[front_left] + sample.wheel_load_n[rear_left];
        const double right = sample.wheel_load_n[front_right] + sample.wheel_load_n[rear_right];
        largest = std::max(largest, std::abs(left - right) / std::max(1.0, left + right));
    }
    return largest;
}

}  // namespace

IdentificationDrives IdentificationDrives::without_loads() const {
    IdentificationDrives drives = *this;
    for (std::vector<Drive>* list : {&drives.ramps, &drives.dynamics}) {
        for (Drive& drive : *list) {
            for (DriveSample& sample : drive.samples) {
                sample.wheel_load_n.fill(DriveSample::not_available);
            }
        }
    }
    return drives;
}

IdentificationDrives identification_drives(const VehicleParameters& vehicle, double back_from_ltr,
                                           std::uint64_t sensor_seed) {
    SensorFlaws flaws;
    flaws.noise = true;
    flaws.seed = sensor_seed;
    IdentificationDrives drives;
    drives.ramps.push_back(simulate_drive(vehicle, slow_ramp(back_from_ltr), flaws));
    drives.largest_ramp_ltr = largest_ltr(drives.ramps.front());
    ++flaws.seed;
    RunOptions gentle;
    gentle.steering_factor =
        std::min(1.0, step_steer_of_threshold * properties(vehicle).threshold_g / step_steer_g);
    drives.dynamics.push_back(simulate_drive(vehicle, find_manoeuvre("step-steer"), flaws, gentle));
    return drives;
}

Calibrated calibrate(const std::filesystem::path& vehicle_data, const IdentificationDrives& drives,
                     const std::filesystem::path& calibration) {
    Calibrated calibrated;
    try {
        const Identification result =
            identify(load_vehicle_data(vehicle_data), drives.ramps, drives.dynamics);
        calibrated.warnings = result.warnings;
        write_file_atomically(calibration, calibration_text(result));
        try {
            load_calibration(calibration.string());
        } catch (const InputError&) {
            std::filesystem::path refused = calibration;
            std::filesystem::rename(calibration, refused.replace_extension(".refused.toml"));
            throw;
        }
    } catch (const std::exception& error) {
        calibrated.failure = error.what();
    }
    return calibrated;
}

}  // namespace sil
