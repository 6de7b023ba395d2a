#include "sil/studies/faults/signal_fault.hpp"

#include <cmath>

#include "sil/simulation/pace.hpp"

namespace sil {
namespace {

constexpr double beyond_every_range = 1.0e6;

}  // namespace

SignalFault::SignalFault(const Fault& fault, std::uint64_t seed)
    : fault_{fault}, noise_{seed, static_cast<std::uint64_t>(fault.place)} {
    if (is_signal_fault(fault.kind)) {
        for (const SensorSignal* const signal : signals_at(fault.place)) {
            failing_.push_back({signal});
        }
    }
}

SensorSample SignalFault::apply(const SensorSample& sample, bool active) {
    visible_ = false;
    SensorSample changed = sample;
    for (Failing& failing : failing_) {
        if (active) {
            change(failing, changed);
        } else {
            failing = {failing.signal};
        }
    }
    return changed;
}

void SignalFault::change(Failing& failing, SensorSample& sample) {
    const SensorSignal& signal = *failing.signal;
    double& value = sample.*(signal.value);
    const double right = value;
    value = faulty(failing, right);
    if (signal.place == FaultPlace::speed && value < 0.0) {
        value = 0.0;  // a wheel's sensor counts pulses: without a sign
    }
    const double error = std::abs(value - right);
    visible_ = visible_ || fault_.kind == FaultKind::out_of_range ||
               !(error < signal.smallest_error * signal.unit_si);  // also true of "not available"
}

double SignalFault::faulty(Failing& failing, double value) {
    switch (fault_.kind) {
        case FaultKind::frozen:
            failing.frozen = failing.frozen.value_or(value);
            return *failing.frozen;
        case FaultKind::offset:
            return value + fault_.magnitude;
        case FaultKind::drift:
            failing.drifted += fault_.magnitude * cycle_time_s;
            return value + failing.drifted;
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
