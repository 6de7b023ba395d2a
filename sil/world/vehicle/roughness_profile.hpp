// Roughness profile: the random heights of one track, with the spectrum of ISO 8608.
#pragma once

#include <cstdint>
#include <vector>

namespace sil {

struct ProfilePoint {
    double height_m{0.0};
    double slope{0.0};  // of the height along the track
};

// Power spectral density of the height G(n) = G(n0) (n / n0)^-2 with n0 = 0.1 cycles/m, from 0.05 cycles/m
// (below it even: longer waves lift both sides of a real road together) up to what a tyre's contact patch
// still feels. The geometric mean of class C is G(n0) =
// 256e-6 m^3. The same seed gives the same profile on every machine. Repeats after `length_m`.
class RoughnessProfile {
 public:
    static constexpr double class_c_m3 = 256.0e-6;
    static constexpr double spacing_m = 0.1;
    static constexpr double length_m = 819.2;

    RoughnessProfile(double density_m3, std::uint64_t seed);

    ProfilePoint at(double distance_m) const noexcept;

 private:
    std::vector<double> heights_m_;
};

}  // namespace sil
