#include "sil/world/vehicle/function_tables.hpp"

#include <cmath>
#include <limits>

namespace sil {
namespace {

static_assert(std::numeric_limits<long double>::digits >= 64,
              "the low parts come from what a double has not");

DoublePair pair_of(long double value) {
    const auto high = static_cast<double>(value);
    return {high, static_cast<double>(value - static_cast<long double>(high))};
}

FunctionTables made() {
    FunctionTables tables{};
    for (std::size_t i = 0U; i < FunctionTables::atan_count; ++i) {
        const int exponent = static_cast<int>(i) / FunctionTables::atan_parts;
        const double part =
            (static_cast<double>(i % FunctionTables::atan_parts) + 0.5) / FunctionTables::atan_parts;
        tables.atan[i] = pair_of(std::atan(std::ldexp(
            static_cast<long double>(FunctionTables::atan_from) * (1.0L + static_cast<long double>(part)),
            exponent)));
    }
    for (std::size_t i = 0U; i < FunctionTables::angle_count; ++i) {
        const long double angle =
            static_cast<long double>(i) / static_cast<long double>(FunctionTables::angle_parts);
        tables.sin[i] = pair_of(std::sin(angle));
        tables.cos[i] = pair_of(std::cos(angle));
    }
    return tables;
}

}  // namespace

const FunctionTables& function_tables() {
    static const FunctionTables tables = made();
    return tables;
}

}  // namespace sil
