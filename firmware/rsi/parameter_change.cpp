#include "rsi/parameter_change.hpp"

#include <cstddef>
#include <cstring>

#include "rsi/parameters.hpp"

namespace rsi {
namespace {

// Of 2,000, so that a change of the vehicle is ready within two seconds.
constexpr std::uint32_t iterations_a_cycle = 10U;

// Places in the parameters. Before the wheelbase stands the vehicle's body and how it rolls; behind the
// sensors there are two selections more, which nobody changes often.
constexpr std::size_t vehicle_end = offsetof(Parameters, wheelbase_m);
constexpr std::size_t units_begin = offsetof(Parameters, regression_scale_nm);
constexpr std::size_t units_end = offsetof(Parameters, covariance_limit);
constexpr std::size_t bank_drift_begin = offsetof(Parameters, observer_bank_drift_radps);
constexpr std::size_t bank_drift_end = offsetof(Parameters, observer_disagreement_rad);
constexpr std::size_t sensors_begin = offsetof(Parameters, accelerometer_noise_mps2);

bool differ(const Parameters& one, const Parameters& other, std::size_t begin, std::size_t end) {
    const auto* const a = static_cast<const unsigned char*>(static_cast<const void*>(&one));
    const auto* const b = static_cast<const unsigned char*>(static_cast<const void*>(&other));
    return std::memcmp(a + begin, b + begin, end - begin) != 0;
}

}  // namespace

Validation ParameterChange::begin(const Parameters& from, const Parameters& to) {
    const Validation answer = validate(to);
    if (answer.accepted != 0) {
        to_ = to;
        is_another_vehicle_ = differ(from, to, 0U, vehicle_end);
        has_other_sensors_ = differ(from, to, sensors_begin, sizeof(Parameters));
        has_other_units_ = differ(from, to, units_begin, units_end);
        has_gains_ = is_another_vehicle_ || differ(from, to, bank_drift_begin, bank_drift_end);
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
