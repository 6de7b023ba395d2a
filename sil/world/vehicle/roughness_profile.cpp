// Roughness profile: filtered noise in a table, read with a cubic interpolation.
#include "sil/world/vehicle/roughness_profile.hpp"

#include <cmath>
#include <cstddef>

#include "sil/random.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double reference_pm = 0.1;       // n0
constexpr double lowest_pm = 0.05;         // cycles per metre
constexpr std::size_t point_count = 8192;  // a power of two, so that a mask wraps
constexpr std::size_t mask = point_count - 1U;
static_assert(point_count * RoughnessProfile::spacing_m == RoughnessProfile::length_m);

class Random {
 public:
    explicit Random(std::uint64_t seed) : state_{seed} {}

    // Mean 0, variance 1; the sum of twelve uniform numbers is close enough to a normal one.
    double normal() {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i) {
            sum += unit_interval(next());
        }
        return sum;
    }

 private:
    std::uint64_t next() {
        const std::uint64_t bits = scrambled(state_);
        state_ += scrambled_step;
        return bits;
    }
    std::uint64_t state_;
};

// Weights 1/4, 1/2, 1/4: the contact patch does not feel what is shorter than itself.
std::vector<double> smoothed(const std::vector<double>& values) {
    std::vector<double> result(point_count);
    for (std::size_t i = 0; i < point_count; ++i) {
        result[i] = 0.5 * values[i] + 0.25 * (values[(i - 1U) & mask] + values[(i + 1U) & mask]);
    }
    return result;
}

}  // namespace

RoughnessProfile::RoughnessProfile(double density_m3, std::uint64_t seed) : heights_m_(point_count) {
    Random random{seed};
    std::vector<double> noise(point_count);
    for (double& value : noise) {
        value = random.normal();
    }
    // A slope of white noise has the density (2 pi n0)^2 G(n0) at every n; its samples' variance is that
    // times the bandwidth 1 / (2 spacing).
    const double slope = 2.0 * pi * reference_pm * std::sqrt(density_m3 / (2.0 * spacing_m));
    const double decay = std::exp(-2.0 * pi * lowest_pm * spacing_m);
    double height = 0.0;
    for (int lap = 0; lap < 2; ++lap) {  // the second begins as it will end: the profile repeats smoothly
        for (std::size_t i = 0; i < point_count; ++i) {
            height = decay * height + spacing_m * slope * noise[i];
            heights_m_[i] = height;
        }
    }
    heights_m_ = smoothed(heights_m_);
}

ProfilePoint RoughnessProfile::at(double distance_m) const noexcept {
    const double position = distance_m * (1.0 / spacing_m);
    const double whole = std::floor(position);
    const double t = position - whole;
    const auto index = static_cast<std::size_t>(static_cast<std::int64_t>(whole));
    const double before = heights_m_[(index - 1U) & mask];
    const double left = heights_m_[index & mask];
    const double right = heights_m_[(index + 1U) & mask];
    const double after = heights_m_[(index + 2U) & mask];
    const double a = 0.5 * (after - before) + 1.5 * (left - right);
    const double b = before - 2.5 * left + 2.0 * right - 0.5 * after;
    const double c = 0.5 * (right - before);
    return {left + t * (c + t * (b + t * a)), (c + t * (2.0 * b + t * 3.0 * a)) * (1.0 / spacing_m)};
}

}  // namespace sil
