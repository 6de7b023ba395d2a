#include "rsi/parameter_change.hpp"

#include <cstddef>
#include <cstring>

#include "rsi/parameters.hpp"

namespace rsi {
namespace {

// Of 2,000, so that a change of the vehicle is ready within two seconds.
constexpr std::uint32_t iterations_a_cycle = 10U;

// What stands before the wheelbase is the vehicle's body and how it rolls.
constexpr std::size_t vehicle_length = offsetof(Parameters, wheelbase_m);

// From there to the end are the sensors, and with them two selections that nobody changes often.
constexpr std::size_t sensors_at = offsetof(Parameters, accelerometer_noise_mps2);

bool are_same_from(std::size_t place, const Parameters& one, const Parameters& other) {
    const auto* const a = static_cast<const unsigned char*>(static_cast<const void*>(&one));
    const auto* const b = static_cast<const unsigned char*>(static_cast<const void*>(&other));
    return std::memcmp(a + place, b + place, sizeof(Parameters) - place) == 0;
}

bool are_same(float one, float other) {
    return std::memcmp(&one, &other, sizeof one) == 0;
}

}  // namespace

Validation ParameterChange::begin(const Parameters& from, const Parameters& to) {
    const Validation answer = validate(to);
    if (answer.accepted != 0) {
        to_ = to;
        is_another_vehicle_ = std::memcmp(&from, &to, vehicle_length) != 0;
        has_other_sensors_ = !are_same_from(sensors_at, from, to);
        has_gains_ =
            is_another_vehicle_ || !are_same(from.observer_bank_drift_radps, to.observer_bank_drift_radps);
        const ObserverModel model = observer_model_of(to);
        search_.begin(model.roll, model.noise);
    }
    return answer;
}

bool ParameterChange::prepare() {
    return !has_gains_ || search_.iterate(iterations_a_cycle);
}

}  // namespace rsi
