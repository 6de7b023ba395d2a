#include "sil/studies/identification/simulated_drive.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "sil/units.hpp"
#include "sil/world/sensors/sensor_suite.hpp"

namespace sil {
namespace {

constexpr int steps_a_cycle = 10;

DriveSample recorded(const SensorSample& sensors, const Truth& truth) {
    return {sensors, truth.wheel_load_n};
}

}  // namespace

Drive simulate_drive(const VehicleParameters& vehicle, const Manoeuvre& manoeuvre, const SensorFlaws& flaws,
                     const RunOptions& options) {
    ManoeuvreRun run{vehicle, manoeuvre, options};
    SensorSuite sensors{mounted_sensors(vehicle, flaws)};
    Drive drive;
    drive.name = manoeuvre.name;
    for (int step = 1; !run.finished(); ++step) {
        run.step();
        sensors.observe(run.truth());
        if (step % steps_a_cycle == 0) {
            drive.samples.push_back(recorded(sensors.report(run.truth()), run.truth()));
        }
    }
    return drive;
}

std::string drive_csv(const Drive& drive) {
    std::string text =
        "time_s,speed_mps,lateral_acceleration_mps2,vertical_acceleration_mps2,roll_rate_degps,yaw_rate_"
        "degps,roll_angle_deg,steering_wheel_angle_deg,wheel_load_front_left_n,wheel_load_front_right_n,"
        "wheel_load_rear_left_n,wheel_load_rear_right_n\n";
    for (const DriveSample& sample : drive.samples) {
        fmt::format_to(std::back_inserter(text), "{:.4f}", sample.time_s);
        for (const double value :
             {sample.speed_mps, sample.lateral_acceleration_mps2, sample.vertical_acceleration_mps2,
              sample.roll_rate_radps * degrees_per_radian, sample.yaw_rate_radps * degrees_per_radian,
              sample.roll_angle_rad * degrees_per_radian,
              sample.steering_wheel_angle_rad * degrees_per_radian, sample.wheel_load_n[front_left],
              sample.wheel_load_n[front_right], sample.wheel_load_n[rear_left],
              sample.wheel_load_n[rear_right]}) {
            text += std::isfinite(value) ? fmt::format(",{:.8g}", value) : ",";
        }
        text += '\n';
    }
    return text;
}

}  // namespace sil
