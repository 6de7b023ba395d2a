// SensorChannel: bias, noise, quantisation, delay and rate of one measured quantity.
#include "sil/world/sensors/sensor_channel.hpp"

#include <cmath>

namespace sil {

SensorChannel::SensorChannel(const ChannelOptions& options, std::uint64_t seed, NoiseStream stream)
    : options_(options), noise_(seed, static_cast<std::uint64_t>(stream)) {}

double SensorChannel::disturbed(double true_value) {
    const double disturbed = true_value + options_.bias + options_.noise_rms * noise_.next();
    if (options_.quantisation_step > 0.0) {
        return std::round(disturbed / options_.quantisation_step) * options_.quantisation_step;
    }
    return disturbed;
}

double SensorChannel::measure(double true_value) {
    under_way_.push_back(disturbed(true_value));
    const double arrived = under_way_.front();
    if (under_way_.size() > options_.reports_late) {
        under_way_.pop_front();
    }
    if (reports_of_held_ == 0U) {
        held_ = arrived;
    }
    reports_of_held_ = (reports_of_held_ + 1U) % options_.reports_a_value;
    return held_;
}

}  // namespace sil
