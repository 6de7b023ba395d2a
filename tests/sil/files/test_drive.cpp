#include "tests/sil/files/test_drive.hpp"

#include <cmath>

#include "sil/files/calibration_file.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace calibration_test {
namespace {

constexpr double gravity_mps2 = 9.80665;

Sample sample_of(const sil::Truth& truth) {
    const double f_y = truth.specific_force_mps2[1];
    const double f_z = truth.specific_force_mps2[2];
    const double sine = std::sin(truth.roll_angle_rad);
    const double cosine = std::cos(truth.roll_angle_rad);
    return Sample{truth.time_s, f_y * cosine - f_z * sine, f_y * sine + f_z * cosine, truth.roll_angle_rad,
                  truth.angular_velocity_radps[0]};
}

double overturning_moment_nm(const rsi::Parameters& parameters, const Sample& sample) {
    return static_cast<double>(parameters.sprung_mass_kg) * moment_arm_m(parameters) *
           (sample.parallel_mps2 + sample.normal_mps2 * std::tan(sample.roll_angle_rad));
}

}  // namespace

rsi::Parameters calibration_of(const std::string& vehicle) {
    return sil::load_calibration(RSI_SOURCE_DIR "/firmware/calibrations/" + vehicle + ".toml");
}

std::vector<Sample> drive(const std::string& vehicle, double duration_s,
                          const std::function<double(double)>& handwheel_deg) {
    sil::Manoeuvre manoeuvre;
    manoeuvre.duration_s = duration_s;
    manoeuvre.initial_speed_mps = sil::from_kmh(60.0);
    manoeuvre.make_road = sil::flat_road();
    manoeuvre.make_driver = sil::open_loop([handwheel_deg](double time_s) {
        return sil::DriverCommand{sil::from_degrees(handwheel_deg(time_s))};
    });
    sil::ManoeuvreRun run{sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/" + vehicle + ".toml"), manoeuvre};
    std::vector<Sample> samples;
    for (int step = 1; !run.finished(); ++step) {
        run.step();
        if (step % 10 == 0) {
            samples.push_back(sample_of(run.truth()));
        }
    }
    return samples;
}

double moment_arm_m(const rsi::Parameters& parameters) {
    return static_cast<double>(parameters.sprung_cg_height_m) -
           static_cast<double>(parameters.fixed_roll_centre_height_m);
}

double roll_stiffness_nmprad(const rsi::Parameters& parameters, const std::vector<Sample>& samples) {
    double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const Sample& sample : samples) {
        const double level_g = std::abs(sample.parallel_mps2) / gravity_mps2;
        if ((level_g < 0.1) || (level_g > 0.5)) {
            continue;
        }
        const double moment_nm = overturning_moment_nm(parameters, sample);
        count += 1.0;
        x += sample.roll_angle_rad;
        y += moment_nm;
        xx += sample.roll_angle_rad * sample.roll_angle_rad;
        xy += sample.roll_angle_rad * moment_nm;
    }
    return (xy - x * y / count) / (xx - x * x / count);
}

double roll_damping_nmsprad(const rsi::Parameters& parameters, double stiffness_nmprad,
                            const std::vector<Sample>& samples) {
    double xx = 0.0, xy = 0.0;
    for (const Sample& sample : samples) {
        const double moment_nm =
            overturning_moment_nm(parameters, sample) - stiffness_nmprad * sample.roll_angle_rad;
        xx += sample.roll_rate_radps * sample.roll_rate_radps;
        xy += sample.roll_rate_radps * moment_nm;
    }
    return xy / xx;
}

}  // namespace calibration_test
