#include "rsi/parameter_change.hpp"

#include <array>
#include <cstddef>

#include "rsi/parameters.hpp"

namespace rsi {
namespace {

// Part of 2,000, so that a change of the vehicle is ready within two seconds.
constexpr std::uint32_t iterations_a_cycle = 10U;

using Field = float Parameters::*;

// The vehicle's body and how it rolls.
constexpr std::array<Field, 11> vehicle_fields{&Parameters::sprung_mass_kg,
                                               &Parameters::sprung_cg_height_m,
                                               &Parameters::track_width_m,
                                               &Parameters::roll_inertia_kgm2,
                                               &Parameters::unsprung_mass_kg,
                                               &Parameters::unsprung_cg_height_m,
                                               &Parameters::fixed_roll_centre_height_m,
                                               &Parameters::roll_stiffness_nmprad,
                                               &Parameters::roll_damping_nmsprad,
                                               &Parameters::roll_stiffness_cubic_nmprad3,
                                               &Parameters::roll_stiffness_quintic_nmprad5};

constexpr std::array<Field, 4> unit_fields{
    &Parameters::regression_scale_nm, &Parameters::initial_roll_centre_deviation_m,
    &Parameters::initial_stiffness_deviation_nmprad, &Parameters::initial_damping_deviation_nmsprad};

constexpr std::array<Field, 1> bank_drift_field{&Parameters::observer_bank_drift_radps};

constexpr std::array<Field, 2> sensor_fields{&Parameters::accelerometer_noise_mps2,
                                             &Parameters::speed_resolution_mps};

template <std::size_t count>
bool differ(const Parameters& one, const Parameters& other, const std::array<Field, count>& fields) {
    bool found = false;
    for (const Field field : fields) {
        found = found || (one.*field < other.*field) || (one.*field > other.*field);
    }
    return found;
}

bool have_other_sensors(const Parameters& one, const Parameters& other) {
    return (one.roll_angle_reference != other.roll_angle_reference) ||
           (one.roll_angle_sensor != other.roll_angle_sensor) ||
           (one.vehicle_motion_sensors != other.vehicle_motion_sensors) || differ(one, other, sensor_fields);
}

}  // namespace

Validation ParameterChange::begin(const Parameters& from, const Parameters& to) {
    const Validation answer = validate(to);
    if (answer.accepted != 0) {
        to_ = to;
        is_another_vehicle_ = differ(from, to, vehicle_fields);
        has_other_sensors_ = have_other_sensors(from, to);
        has_other_units_ = differ(from, to, unit_fields);
        has_gains_ = is_another_vehicle_ || differ(from, to, bank_drift_field);
        search_.begin(upright_roll(to), observer_noise(to));
    }
    return answer;
}

bool ParameterChange::prepare() {
    return !has_gains_ || search_.iterate(iterations_a_cycle);
}

}  // namespace rsi
