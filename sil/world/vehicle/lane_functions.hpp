// Lane functions: arc tangent, sine and cosine of all lanes at once, to the bits of the library's functions.
//
// Each is computed to some 2^-60 of itself, as the double nearest to it and a remainder. The library's result
// (glibc's; its largest known errors are 0.523 of a unit in the last place) can differ from that double only
// where the remainder is nearly half a unit; there, in one of sixteen, and beyond the tables, the library
// itself is asked.
//
// For lanes.hpp alone, where there is a fused multiply-add.
#pragma once

#include <cmath>
#include <cstring>

#include "sil/world/vehicle/function_tables.hpp"

namespace sil::RSI_PROCESSOR {

using Bits = LaneMask::Register;
using Reals = Lanes::Register;

[[gnu::always_inline]] inline Bits bits_of(const Reals& value) {
    return Bits(value);
}
[[gnu::always_inline]] inline Reals magnitude(const Reals& value) {
    return Reals(bits_of(value) & 0x7FFF'FFFF'FFFF'FFFF);
}
// a b + c, rounded once.
[[gnu::always_inline]] inline Reals fused(const Reals& a, const Reals& b, const Reals& c) {
    LaneArray result{a};
    const LaneArray factor{b};
    const LaneArray summand{c};
    for (std::size_t i = 0; i < Lanes::count; ++i) {
        result.values[i] = __builtin_fma(result.values[i], factor.values[i], summand.values[i]);
    }
    return result.lanes().lanes();
}

// A number as a sum: high is the double nearest to it, but for its last bit.
struct Sum {
    Reals high;
    Reals low;
};
[[gnu::always_inline]] inline Sum two_sum(const Reals& a, const Reals& b) {
    const Reals sum = a + b;
    const Reals b_in_it = sum - a;
    return {sum, (a - (sum - b_in_it)) + (b - b_in_it)};
}
[[gnu::always_inline]] inline Sum two_product(const Reals& a, const Reals& b) {
    const Reals product = a * b;
    return {product, fused(a, b, -product)};
}

[[gnu::always_inline]] inline Sum look_up(const DoublePair* table, const Bits& index) {
    LaneArray high{0.0};
    LaneArray low{0.0};
    for (std::size_t i = 0; i < Lanes::count; ++i) {
        const DoublePair& pair = table[index[i]];
        high.values[i] = pair.high;
        low.values[i] = pair.low;
    }
    return {high.lanes().lanes(), low.lanes().lanes()};
}

// The sum rounded to a double, with the sign of `of`; the library's function where that may be another one,
// or where the sum is not `valid`.
template <double function(double)>
[[gnu::always_inline]] inline Reals rounded(const Sum& sum, const Bits& valid, const Reals& of,
                                            const Bits& sign) {
    constexpr long long exponent = 0x7FF0'0000'0000'0000;
    constexpr double sure_share = 0.47;  // of a unit in the last place
    const Reals nearest = sum.high + sum.low;
    const Reals remainder = (sum.high - nearest) + sum.low;
    // Spacing of the next smaller double, for the unit below a power of two is half of that above.
    const Reals unit = Reals((bits_of(nearest) - 1) & exponent) * 0x1p-52;
    const Bits sure =
        valid & (magnitude(remainder) <= unit * sure_share ? LaneMask::everywhere : LaneMask::nowhere);
    Reals result = Reals(bits_of(nearest) | sign);
    if (LaneMask{~sure}.any()) {
        LaneArray values{result};
        const LaneArray arguments{of};
        for (std::size_t i = 0; i < Lanes::count; ++i) {
            if (sure[i] == 0) {
                values.values[i] = function(arguments.values[i]);
            }
        }
        result = values.lanes().lanes();
    }
    return result;
}

// atan(x) = atan(c) + atan((x - c) / (1 + x c)), with c near x.
[[gnu::noinline]] inline Lanes library_atan(const Lanes& argument, const FunctionTables& tables) {
    constexpr int shift = 47;  // leaves five bits of the mantissa
    constexpr long long below_shift = (1LL << shift) - 1;
    const Reals x = magnitude(argument.lanes());
    const Bits valid = x < FunctionTables::atan_to ? LaneMask::everywhere : LaneMask::nowhere;
    const Bits small = x < FunctionTables::atan_from ? LaneMask::everywhere : LaneMask::nowhere;
    const Reals from = Lanes{FunctionTables::atan_from}.lanes();
    Bits index = (bits_of(x) - bits_of(from)) >> shift;
    const Bits last = LaneMask::nowhere + static_cast<long long>(FunctionTables::atan_count);
    index = (small | ~valid) != LaneMask::nowhere ? last : index;
    const Sum of_middle = look_up(tables.atan, index);
    const Reals middle = Reals(((bits_of(x) & ~below_shift) | (1LL << (shift - 1))) & ~small);

    const Reals numerator = x - middle;  // exact
    const Sum product = two_product(x, middle);
    const Sum denominator = two_sum(product.high, Lanes{1.0}.lanes());
    const Reals inverse = 1.0 / denominator.high;
    const Reals q = numerator * inverse;
    const Reals left = fused(-q, denominator.high, numerator) - q * (denominator.low + product.low);
    const Reals s = q * q;
    const Reals series =
        q * s * (-1.0 / 3.0 + s * (1.0 / 5.0 + s * (-1.0 / 7.0 + s * (1.0 / 9.0 + s * (-1.0 / 11.0)))));
    const Sum sum = two_sum(of_middle.high, q);
    return rounded<std::atan>({sum.high, sum.low + (of_middle.low + left * inverse + series)}, valid,
                              argument.lanes(), bits_of(argument.lanes()) & ~0x7FFF'FFFF'FFFF'FFFF);
}

// An angle as the nearest multiple in the tables and the rest, with the sine of the rest less the rest, and
// its cosine less 1.
struct ReducedAngle {
    Bits index;
    Reals rest;
    Reals sine;
    Reals cosine;
};
[[gnu::always_inline]] inline ReducedAngle reduced(const Reals& angle) {
    constexpr double whole = 0x1.8p52;  // added and taken away, it rounds to a whole number
    const Reals shifted = angle * FunctionTables::angle_parts + whole;
    const Reals rest = angle - (shifted - whole) * (1.0 / FunctionTables::angle_parts);  // exact
    const Reals s = rest * rest;
    return {bits_of(shifted) & static_cast<long long>(FunctionTables::angle_count - 1U), rest,
            rest * s * (-1.0 / 6.0 + s * (1.0 / 120.0 - s * (1.0 / 5040.0))),
            s * (-1.0 / 2.0 + s * (1.0 / 24.0 + s * (-1.0 / 720.0 + s * (1.0 / 40320.0))))};
}
// a + b rest, and what the series add: a cosine + b sine.
[[gnu::always_inline]] inline Sum turned(const Sum& a, const Sum& b, const ReducedAngle& angle) {
    const Sum product = two_product(b.high, angle.rest);
    const Sum sum = two_sum(a.high, product.high);
    return {sum.high, sum.low + (product.low + (a.low + (a.high * angle.cosine +
                                                         (b.high * angle.sine + b.low * angle.rest))))};
}
// Within the range of the tables and if, beside zeros but 0 itself, nothing has cancelled.
[[gnu::always_inline]] inline Bits valid_turn(const Reals& angle, const ReducedAngle& reduced,
                                              const Sum& sum) {
    const Bits in_tables = angle < 3.9 ? LaneMask::everywhere : LaneMask::nowhere;
    const Bits large = magnitude(sum.high) > 0x1p-6 ? LaneMask::everywhere : LaneMask::nowhere;
    const Bits first = reduced.index == LaneMask::nowhere ? LaneMask::everywhere : LaneMask::nowhere;
    return in_tables & (large | first);
}

[[gnu::noinline]] inline Lanes library_sin(const Lanes& argument, const FunctionTables& tables) {
    const Reals angle = magnitude(argument.lanes());
    const ReducedAngle by = reduced(angle);
    const Sum sum = turned(look_up(tables.sin, by.index), look_up(tables.cos, by.index), by);
    const Bits negative = (bits_of(argument.lanes()) ^ bits_of(sum.high)) & ~0x7FFF'FFFF'FFFF'FFFF;
    const Reals flip = Reals(bits_of(sum.high) & ~0x7FFF'FFFF'FFFF'FFFF);
    const Sum positive{Reals(bits_of(sum.high) ^ bits_of(flip)), Reals(bits_of(sum.low) ^ bits_of(flip))};
    return rounded<std::sin>(positive, valid_turn(angle, by, sum), argument.lanes(), negative);
}

[[gnu::noinline]] inline void library_sin_and_cos(const Lanes& argument, const FunctionTables& tables,
                                                  Lanes& sine, Lanes& cosine) {
    const Reals angle = magnitude(argument.lanes());
    const ReducedAngle by = reduced(angle);
    const Sum sines = look_up(tables.sin, by.index);
    const Sum cosines = look_up(tables.cos, by.index);
    const Sum of_sine = turned(sines, cosines, by);
    const Sum of_cosine = turned(cosines, {-sines.high, -sines.low}, by);
    const Bits small = angle < 1.5 ? LaneMask::everywhere : LaneMask::nowhere;  // both are positive
    sine = rounded<std::sin>(of_sine, small & valid_turn(angle, by, of_sine), argument.lanes(),
                             bits_of(argument.lanes()) & ~0x7FFF'FFFF'FFFF'FFFF);
    cosine = rounded<std::cos>(of_cosine, small & valid_turn(angle, by, of_cosine), argument.lanes(),
                               LaneMask::nowhere);
}

}  // namespace sil::RSI_PROCESSOR
