// ExampleRun: steering ramp, first-order lateral acceleration, one roll degree of freedom, load transfer.
#include "tests/sil/results/example_run.hpp"

#include <algorithm>
#include <cmath>

#include "sil/results/event_marks.hpp"
#include "sil/results/signal_csv.hpp"
#include "sil/world/sensors/sensor_options.hpp"
#include "sil/world/sensors/sensor_suite.hpp"

namespace example_run {
namespace {

constexpr double g_mps2 = 9.80665;
constexpr double rad_per_deg = 3.14159265358979323846 / 180.0;
constexpr double mass_kg = 2374.0;
constexpr double sprung_mass_kg = 2060.0;
constexpr double roll_arm_m = 0.70;
constexpr double track_width_m = 1.60;
constexpr double height_m = track_width_m / (2.0 * static_stability_factor);
constexpr double roll_inertia_kgm2 = 1950.0;
constexpr double roll_stiffness_nmprad = 130.0e3;
constexpr double roll_damping_nmsprad = 8000.0;

void distribute_load(sil::Truth& truth, double transfer_share) {
    const double static_load_n = mass_kg * g_mps2 / 4.0;
    const double front = std::clamp(1.04 * transfer_share, -1.0, 1.0);
    const double rear = std::clamp(0.99 * transfer_share, -1.0, 1.0);
    truth.wheel_load_n = {static_load_n * (1.0 - front), static_load_n * (1.0 + front),
                          static_load_n * (1.0 - rear), static_load_n * (1.0 + rear)};
}

void step(sil::Truth& truth, const Options& options, double step_s) {
    constexpr double steer_start_s = 1.0;
    const double ramp_deg = std::clamp(250.0 * (truth.time_s - steer_start_s), 0.0, 360.0);
    truth.steering_wheel_angle_rad = options.direction * ramp_deg * rad_per_deg;
    const double demanded =
        options.steady_acceleration_g * g_mps2 * truth.steering_wheel_angle_rad / (360.0 * rad_per_deg);
    truth.lateral_acceleration_mps2 +=
        (1.3 * std::clamp(demanded, -g_mps2, g_mps2) - 0.3 * demanded - truth.lateral_acceleration_mps2) *
        step_s / 0.15;

    double& roll_rad = truth.roll_angle_rad;
    double& roll_rate_radps = truth.angular_velocity_radps[0];
    const double f_mps2 = truth.lateral_acceleration_mps2 + g_mps2 * std::tan(roll_rad);
    const double limit_nm = mass_kg * g_mps2 * track_width_m / 2.0 * 0.70;
    const double spring_nm = std::clamp(roll_stiffness_nmprad * roll_rad, -limit_nm, limit_nm);
    const double moment_nm =
        sprung_mass_kg * roll_arm_m * f_mps2 - spring_nm - roll_damping_nmsprad * roll_rate_radps;
    truth.angular_acceleration_radps2[0] = moment_nm / roll_inertia_kgm2;
    roll_rate_radps += truth.angular_acceleration_radps2[0] * step_s;
    roll_rad += roll_rate_radps * step_s;
    truth.specific_force_mps2 = {
        0.0, truth.lateral_acceleration_mps2 * std::cos(roll_rad) + g_mps2 * std::sin(roll_rad),
        g_mps2 * std::cos(roll_rad) - truth.lateral_acceleration_mps2 * std::sin(roll_rad)};
    truth.speed_mps = 110.0 / 3.6;
    distribute_load(truth, truth.lateral_acceleration_mps2 / (0.995 * static_stability_factor * g_mps2));
}

sil::EcuOutput respond(const sil::Truth& truth) {
    sil::EcuOutput output;
    const double side = truth.lateral_acceleration_mps2 >= 0.0 ? 1.0 : -1.0;
    const double t = (track_width_m / 2.0 - side * roll_arm_m * std::tan(truth.roll_angle_rad)) / height_m;
    const double level =
        std::min(std::fabs(truth.lateral_acceleration_mps2) / std::max(t * g_mps2, 0.05), 1.0);
    rsi::can_dbc::RolloverWarning& warning = output.warning();
    warning.lateral_acceleration_mps2 = static_cast<float>(truth.lateral_acceleration_mps2);
    warning.lateral_acceleration_threshold_mps2 = static_cast<float>(side * t * g_mps2);
    warning.warning_level = static_cast<float>(level);
    output.of<rsi::can_dbc::RollIndicesClassic>().rsi = static_cast<float>(level);
    warning.state = level >= 1.0   ? sil::WarningState::warning
                    : level >= 0.8 ? sil::WarningState::advisory
                                   : sil::WarningState::ready;
    if (output.warning().state == sil::WarningState::warning) {
        output.warning().side = side > 0.0 ? sil::WarningSide::right : sil::WarningSide::left;
    }
    return output;
}

sil::SensorOptions scaled_sensors(double share) {
    sil::SensorOptions sensors = share > 0.0 ? sil::noisy_sensors(7U) : sil::SensorOptions{};
    sensors.imu.lateral_acceleration_mps2.noise_rms *= share;
    sensors.roll.roll_angle_rad.noise_rms *= share;
    return sensors;
}

}  // namespace

sil::RunEvents write(const Options& options, const std::filesystem::path& folder) {
    constexpr double step_s = 0.001;
    constexpr int steps_per_cycle = 10;
    const int steps = static_cast<int>(std::lround(options.duration_s / step_s));

    sil::Truth truth;
    sil::EcuOutput output;
    sil::SensorSuite sensors(scaled_sensors(options.noise_share));
    sil::EventObserver observer(static_stability_factor);
    sil::SignalCsvWriter csv(folder / "signals.csv");
    distribute_load(truth, 0.0);
    for (int count = 0; count < steps; ++count) {
        truth.time_s = count * step_s;
        observer.observe(truth);
        sensors.observe(truth);
        if (count % steps_per_cycle == 0) {
            const sil::SensorSample sample = sensors.report(truth);
            output = count < 5 * steps_per_cycle ? sil::EcuOutput{} : respond(truth);
            observer.observe(output, truth.time_s);
            csv.write(sil::signal_csv_row(truth, sample, output));
        }
        step(truth, options, step_s);
    }
    csv.close();
    sil::write_event_marks(observer.events(), static_stability_factor, "Example run (invented data)",
                           folder / "events.gp");
    return observer.events();
}

}  // namespace example_run
