#include "sil/studies/identification/roll_prediction.hpp"

#include <cmath>

namespace sil {
namespace {

constexpr int steps_a_sample = 10;
constexpr double tipped_rad = 1.0;

double moment_nm(const RollModel& model, double phi) {
    const double square = phi * phi;
    return phi * (model.stiffness_nmprad + square * (model.cubic_nmprad3 + square * model.quintic_nmprad5));
}

}  // namespace

RollModel roll_model(const VehicleData& vehicle, const RollFit& fit) {
    return {vehicle.sprung_mass_kg * fit.arm_m, fit.inertia_kgm2.value,
            fit.damping_nmsprad.value,          fit.stiffness_nmprad.value,
            fit.stiffness_cubic_nmprad3.value,  fit.stiffness_quintic_nmprad5.value};
}

RollModel roll_model(const rsi::Parameters& parameters) {
    const double arm_m = static_cast<double>(parameters.sprung_cg_height_m) -
                         static_cast<double>(parameters.fixed_roll_centre_height_m);
    return {static_cast<double>(parameters.sprung_mass_kg) * arm_m,
            static_cast<double>(parameters.roll_inertia_kgm2),
            static_cast<double>(parameters.roll_damping_nmsprad),
            static_cast<double>(parameters.roll_stiffness_nmprad),
            static_cast<double>(parameters.roll_stiffness_cubic_nmprad3),
            static_cast<double>(parameters.roll_stiffness_quintic_nmprad5)};
}

std::vector<double> predicted_roll_angles_rad(const RollModel& model,
                                              const std::vector<RollSample>& samples) {
    std::vector<double> angles(samples.size(), DriveSample::not_available);
    if (samples.empty()) {
        return angles;
    }
    double angle = samples.front().roll_angle_rad;
    double rate = samples.front().roll_rate_radps;
    angles.front() = angle;
    for (std::size_t sample = 1U; sample < samples.size() && std::fabs(angle) < tipped_rad; ++sample) {
        const RollSample& from = samples[sample - 1U];
        const RollSample& to = samples[sample];
        const double step_s = (to.time_s - from.time_s) / steps_a_sample;
        for (int step = 0; step < steps_a_sample; ++step) {
            const double share = (step + 0.5) / steps_a_sample;
            const double parallel = from.parallel_mps2 + share * (to.parallel_mps2 - from.parallel_mps2);
            const double normal = from.normal_mps2 + share * (to.normal_mps2 - from.normal_mps2);
            const double tipping = model.mass_arm_kgm * (parallel + normal * std::tan(angle));
            rate += step_s * (tipping - moment_nm(model, angle) - model.damping_nmsprad * rate) /
                    model.inertia_kgm2;
            angle += step_s * rate;
        }
        angles[sample] = std::fabs(angle) < tipped_rad ? angle : DriveSample::not_available;
    }
    return angles;
}

double load_moment_nm(const rsi::Parameters& parameters, const RollSample& sample) {
    const double alpha_kgm = static_cast<double>(parameters.sprung_mass_kg) *
                                 static_cast<double>(parameters.fixed_roll_centre_height_m) +
                             static_cast<double>(parameters.unsprung_mass_kg) *
                                 static_cast<double>(parameters.unsprung_cg_height_m);
    const RollModel model = roll_model(parameters);
    return alpha_kgm * sample.parallel_mps2 + moment_nm(model, sample.roll_angle_rad) +
           model.damping_nmsprad * sample.roll_rate_radps;
}

std::vector<double> response_mps2(const SteeringModel& model, double frequency_radps, double damping,
                                  const std::vector<RollSample>& samples) {
    std::vector<double> response(samples.size(), DriveSample::not_available);
    double value = DriveSample::not_available;
    double rate = 0.0;
    for (std::size_t sample = 0U; sample < samples.size(); ++sample) {
        const double demand = steering_demand_mps2(model, samples[sample]);
        if (std::isnan(demand)) {
            value = DriveSample::not_available;
            continue;
        }
        if (std::isnan(value)) {
            value = samples[sample].parallel_mps2;
            rate = 0.0;
        } else {
            const double step_s = (samples[sample].time_s - samples[sample - 1U].time_s) / steps_a_sample;
            for (int step = 0; step < steps_a_sample; ++step) {
                rate += step_s * (frequency_radps * frequency_radps * (demand - value) -
                                  2.0 * damping * frequency_radps * rate);
                value += step_s * rate;
            }
        }
        response[sample] = value;
    }
    return response;
}

}  // namespace sil
