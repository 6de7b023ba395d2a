#include "sil/studies/faults/signal_fault.hpp"

#include <cmath>

#include "sil/simulation/pace.hpp"

namespace sil {
namespace {

constexpr double beyond_every_range = 1.0e6;

}  // namespace

SignalFault::SignalFault(const Fault& fault, std::uint64_t seed)
    : fault_{fault},
      signal_{is_signal_fault(fault.kind) ? find_signal(fault.place) : nullptr},
      noise_{seed, static_cast<std::uint64_t>(fault.place)} {}

SensorSample SignalFault::apply(const SensorSample& sample, bool active) {
    visible_ = false;
    if (signal_ == nullptr || !active) {
        frozen_.reset();
        drifted_ = 0.0;
        return sample;
    }
    SensorSample changed = sample;
    double& value = changed.*(signal_->value);
    const double right = value;
    value = faulty(right);
    if (fault_.place == FaultPlace::speed && value < 0.0) {
        value = 0.0;  // a wheel's sensor counts pulses: without a sign
    }
    const double error = std::abs(value - right);
    visible_ = fault_.kind == FaultKind::out_of_range ||
               !(error < signal_->smallest_error * signal_->unit_si);  // also true of "not available"
    return changed;
}

double SignalFault::faulty(double value) {
    switch (fault_.kind) {
        case FaultKind::frozen:
            frozen_ = frozen_.value_or(value);
            return *frozen_;
        case FaultKind::offset:
            return value + fault_.magnitude;
        case FaultKind::drift:
            drifted_ += fault_.magnitude * cycle_time_s;
            return value + drifted_;
        case FaultKind::noise:
            return value + fault_.magnitude * noise_.next();
        case FaultKind::gain:
            return fault_.magnitude * value;
        case FaultKind::noise_alone:
            return fault_.magnitude * noise_.next();
        case FaultKind::sign_flip:
            return -value;
        case FaultKind::saturated:
            return std::copysign(beyond_every_range, fault_.magnitude);
        case FaultKind::not_available:
            return SensorSample::not_available;
        default:
            return value;
    }
}

}  // namespace sil
