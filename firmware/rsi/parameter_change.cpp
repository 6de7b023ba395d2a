#include "rsi/parameter_change.hpp"

#include <cstddef>

#include "rsi/parameters.hpp"

namespace rsi {
namespace {

// Of 2,000, so that a change of the vehicle is ready within two seconds.
constexpr std::uint32_t iterations_a_cycle = 10U;

// Places in the table of fields.
constexpr std::size_t place_of(float Parameters::* member) {
    std::size_t place = 0U;
    while ((place < parameter_fields.size()) && (parameter_fields[place].member != member)) {
        ++place;
    }
    return place;
}

// Before the wheelbase stands the vehicle's body and how it rolls.
constexpr std::size_t vehicle_end = place_of(&Parameters::wheelbase_m);
constexpr std::size_t units_begin = place_of(&Parameters::regression_scale_nm);
constexpr std::size_t units_end = place_of(&Parameters::covariance_limit);
constexpr std::size_t bank_drift = place_of(&Parameters::observer_bank_drift_radps);
constexpr std::size_t sensors_begin = place_of(&Parameters::accelerometer_noise_mps2);
constexpr std::size_t sensors_end = parameter_fields.size();
static_assert((vehicle_end < units_begin) && (units_begin < units_end) && (units_end < bank_drift) &&
              (bank_drift < sensors_begin) && (sensors_begin < sensors_end));

bool differ(const Parameters& one, const Parameters& other, std::size_t begin, std::size_t end) {
    bool found = false;
    for (std::size_t place = begin; place < end; ++place) {
        const float a = one.*parameter_fields[place].member;
        const float b = other.*parameter_fields[place].member;
        found = found || (a < b) || (a > b);
    }
    return found;
}

bool have_other_sensors(const Parameters& one, const Parameters& other) {
    return (one.roll_angle_reference != other.roll_angle_reference) ||
           (one.roll_angle_sensor != other.roll_angle_sensor) ||
           (one.vehicle_motion_sensors != other.vehicle_motion_sensors) ||
           differ(one, other, sensors_begin, sensors_end);
}

}  // namespace

Validation ParameterChange::begin(const Parameters& from, const Parameters& to) {
    const Validation answer = validate(to);
    if (answer.accepted != 0) {
        to_ = to;
        is_another_vehicle_ = differ(from, to, 0U, vehicle_end);
        has_other_sensors_ = have_other_sensors(from, to);
        has_other_units_ = differ(from, to, units_begin, units_end);
        has_gains_ = is_another_vehicle_ || differ(from, to, bank_drift, bank_drift + 1U);
        RollBankObserver observer;
        observer.tune(to);
        search_.begin(observer.upright_roll(), observer_noise(to));
    }
    return answer;
}

bool ParameterChange::prepare() {
    return !has_gains_ || search_.iterate(iterations_a_cycle);
}

}  // namespace rsi
