#include "sil/studies/identification/admitted_range.hpp"

#include <algorithm>

#include "sil/files/parameter_field.hpp"

namespace sil {

double within_admitted(float rsi::Parameters::* field, double value) {
    const rsi::ParameterField& range = parameter_field(field);
    constexpr double rounding = 0.001;  // of the written value
    constexpr double larger = 1.0 + correction_reserve + rounding;
    constexpr double smaller = 1.0 - correction_reserve - rounding;
    const auto lowest = static_cast<double>(range.minimum);
    const auto highest = static_cast<double>(range.maximum);
    return std::clamp(value, lowest > 0.0 ? lowest / smaller : lowest / larger, highest / larger);
}

}  // namespace sil
