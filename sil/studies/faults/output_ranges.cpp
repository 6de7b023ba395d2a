#include "sil/studies/faults/output_ranges.hpp"

#include <algorithm>
#include <cmath>

#include "rsi/output_table.hpp"

namespace sil {
namespace {

bool is_within(float value, double low, double high) {
    const auto number = static_cast<double>(value);
    return number >= low && number <= high;
}

// A value that could not be computed is NaN.
bool is_within_if_known(float value, double low, double high) {
    return std::isnan(value) || is_within(value, low, high);
}

}  // namespace

bool are_in_range(const rsi::Outputs& outputs) {
    const bool finite = std::none_of(
        rsi::number_outputs.begin(), rsi::number_outputs.end(),
        [&outputs](const rsi::NumberOutput& number) { return std::isinf(outputs.*number.member); });
    if (outputs.state == RSI_STATE_UNAVAILABLE) {
        return finite;
    }
    return finite && is_within(outputs.warning_level, 0.0, 20.0) &&
           is_within(outputs.lateral_acceleration_mps2, -100.0, 100.0) &&
           is_within_if_known(outputs.roll_centre_deviation_m, 0.0, 0.5) &&
           is_within_if_known(outputs.roll_centre_vertical_m, -1.0, 1.0);
}

}  // namespace sil
