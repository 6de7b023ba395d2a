// SensorChannel: bias, noise and quantisation of one measured quantity.
#include "sil/world/sensors/sensor_channel.hpp"

#include <cmath>

namespace sil {

SensorChannel::SensorChannel(const ChannelOptions& options, std::uint64_t seed, NoiseStream stream)
    : options_(options), noise_(seed, static_cast<std::uint64_t>(stream)) {}

double SensorChannel::measure(double true_value) {
    const double disturbed = true_value + options_.bias + options_.noise_rms * noise_.next();
    if (options_.quantisation_step > 0.0) {
        return std::round(disturbed / options_.quantisation_step) * options_.quantisation_step;
    }
    return disturbed;
}

}  // namespace sil
