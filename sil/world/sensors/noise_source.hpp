// NoiseSource: white, nearly Gaussian noise whose every bit is the same on every machine and compiler.
#pragma once

#include <cstdint>

#include "sil/random.hpp"

namespace sil {

// The sum of twelve uniform integers of 32 bits has mean 6 and variance 1 in units of 2^32 (Irwin-Hall). It
// is computed in integers and scaled by a power of two, so neither libm nor the library's own distributions
// (whose algorithms the C++ standard leaves open) can change a bit of it. Against a Gaussian its excess
// kurtosis is -0.1 and its values end at +-6 standard deviations.
class NoiseSource {
 public:
    // Sources with the same seed and different streams are unrelated: a sensor that draws more or fewer
    // values does not change what the others see.
    NoiseSource(std::uint64_t seed, std::uint64_t stream);

    // Zero mean, standard deviation 1.
    double next();

 private:
    RandomStream generator_;
};

}  // namespace sil
