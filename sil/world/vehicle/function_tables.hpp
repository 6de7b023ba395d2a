// Function tables: arc tangents, sines and cosines as pairs of doubles, for the functions of lanes.
#pragma once

#include <cstddef>

namespace sil {

// A number to some 2^-64 of itself.
struct DoublePair {
    double high;
    double low;
};

struct FunctionTables {
    // Arc tangents of the middles of intervals: atan_parts to each power of two, from atan_from on to
    // atan_to. After them that of 0.
    static constexpr int atan_parts = 32;
    static constexpr double atan_from = 0x1p-6;
    static constexpr double atan_to = 0x1p10;
    static constexpr std::size_t atan_count = 16U * atan_parts;
    DoublePair atan[atan_count + 1U];

    // Values at multiples of 1 / angle_parts.
    static constexpr double angle_parts = 32.0;
    static constexpr std::size_t angle_count = 128U;
    DoublePair sin[angle_count];
    DoublePair cos[angle_count];
};

// Made once, by the library's long double functions.
const FunctionTables& function_tables();

}  // namespace sil
