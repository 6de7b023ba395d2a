// Lanes: one number of several vehicles, computed together in the processor's vector registers. Every
// operation works lane by lane and rounds as the same operation does on a double, so a vehicle's results do
// not depend on who is beside it.
//
// For lane_step_body.hpp alone, which is compiled once for each kind of processor, named by RSI_PROCESSOR:
// all that is of Lanes has a name of its own for each, so that no processor ever meets the instructions of
// another.
#pragma once

#ifndef RSI_PROCESSOR
#error "included by lane_step_body.hpp alone"
#endif

#include <cmath>
#include <cstddef>
#include <cstring>

#include <Eigen/Core>

#include "sil/world/vehicle/lane_count.hpp"
#include "sil/world/vehicle/number.hpp"

namespace sil {
namespace RSI_PROCESSOR {

class LaneMask;

class Lanes {
 public:
    static constexpr std::size_t count = lane_count;
    using Register = double __attribute__((vector_size(count * sizeof(double))));

    Lanes() = default;
    [[gnu::always_inline]] Lanes(double all)  // not explicit: constants of the equations mix with lanes
        : lanes_{all, all, all, all, all, all, all, all} {}
    [[gnu::always_inline]] Lanes(const Register& lanes) : lanes_{lanes} {}

    double operator[](std::size_t lane) const { return lanes_[lane]; }
    const Register& lanes() const { return lanes_; }

    [[gnu::always_inline]] Lanes& operator+=(const Lanes& b) {
        lanes_ += b.lanes_;
        return *this;
    }
    [[gnu::always_inline]] Lanes& operator-=(const Lanes& b) {
        lanes_ -= b.lanes_;
        return *this;
    }
    [[gnu::always_inline]] Lanes& operator*=(const Lanes& b) {
        lanes_ *= b.lanes_;
        return *this;
    }
    [[gnu::always_inline]] Lanes& operator/=(const Lanes& b) {
        lanes_ /= b.lanes_;
        return *this;
    }
    [[gnu::always_inline]] friend Lanes operator+(const Lanes& a, const Lanes& b) {
        return a.lanes_ + b.lanes_;
    }
    [[gnu::always_inline]] friend Lanes operator-(const Lanes& a, const Lanes& b) {
        return a.lanes_ - b.lanes_;
    }
    [[gnu::always_inline]] friend Lanes operator*(const Lanes& a, const Lanes& b) {
        return a.lanes_ * b.lanes_;
    }
    [[gnu::always_inline]] friend Lanes operator/(const Lanes& a, const Lanes& b) {
        return a.lanes_ / b.lanes_;
    }
    [[gnu::always_inline]] friend Lanes operator-(const Lanes& a) { return -a.lanes_; }

 private:
    Register lanes_;
};

// A condition that holds in some lanes.
class LaneMask {
 public:
    using Register = long long __attribute__((vector_size(Lanes::count * sizeof(long long))));

    // A comparison is written as a choice between these two, for which there are instructions everywhere.
    static constexpr Register everywhere{-1, -1, -1, -1, -1, -1, -1, -1};
    static constexpr Register nowhere{};

    [[gnu::always_inline]] LaneMask(const Register& lanes) : lanes_{lanes} {}
    const Register& lanes() const { return lanes_; }

    // Both sides are computed, as they are in registers anyhow.
    [[gnu::always_inline]] friend LaneMask operator&&(const LaneMask& a, const LaneMask& b) {
        return a.lanes_ & b.lanes_;
    }
    [[gnu::always_inline]] friend LaneMask operator||(const LaneMask& a, const LaneMask& b) {
        return a.lanes_ | b.lanes_;
    }
    [[gnu::always_inline]] friend LaneMask operator!(const LaneMask& a) { return ~a.lanes_; }

    [[gnu::always_inline]] bool any() const {
        long long bits = 0;
        for (std::size_t i = 0; i < Lanes::count; ++i) {
            bits |= lanes_[i];
        }
        return bits != 0;
    }

 private:
    Register lanes_;
};

[[gnu::always_inline]] inline LaneMask operator<(const Lanes& a, const Lanes& b) {
    return a.lanes() < b.lanes() ? LaneMask::everywhere : LaneMask::nowhere;
}
[[gnu::always_inline]] inline LaneMask operator>(const Lanes& a, const Lanes& b) {
    return a.lanes() > b.lanes() ? LaneMask::everywhere : LaneMask::nowhere;
}
[[gnu::always_inline]] inline LaneMask operator<=(const Lanes& a, const Lanes& b) {
    return a.lanes() <= b.lanes() ? LaneMask::everywhere : LaneMask::nowhere;
}

// Lane after lane through memory, which costs less than to take registers apart.
struct LaneArray {
    alignas(sizeof(Lanes)) double values[Lanes::count];

    [[gnu::always_inline]] explicit LaneArray(const Lanes& lanes) {
        const Lanes::Register all = lanes.lanes();
        std::memcpy(values, &all, sizeof(values));
    }
    [[gnu::always_inline]] Lanes lanes() const {
        Lanes::Register all;
        std::memcpy(&all, values, sizeof(values));
        return all;
    }
};

// The library's functions, lane after lane: a vector library's would round otherwise. Not taken in, for a
// call from among vector instructions costs more than from a function that has none.
template <double function(double)>
[[gnu::noinline]] inline void replace_each(double (&values)[Lanes::count]) {
    for (double& value : values) {
        value = function(value);
    }
}
template <double function(double)>
[[gnu::always_inline]] inline Lanes each(const Lanes& value) {
    LaneArray all{value};
    replace_each<function>(all.values);
    return all.lanes();
}
template <double function(double, double)>
[[gnu::noinline]] inline void replace_each(double (&first)[Lanes::count],
                                           const double (&second)[Lanes::count]) {
    for (std::size_t i = 0; i < Lanes::count; ++i) {
        first[i] = function(first[i], second[i]);
    }
}
template <double function(double, double)>
[[gnu::always_inline]] inline Lanes each(const Lanes& first, const Lanes& second) {
    LaneArray all{first};
    replace_each<function>(all.values, LaneArray{second}.values);
    return all.lanes();
}

[[gnu::noinline]] inline void sines_and_cosines(double (&values)[Lanes::count],
                                                double (&cosines)[Lanes::count]) {
    for (std::size_t i = 0; i < Lanes::count; ++i) {
        const double angle = values[i];
        values[i] = std::sin(angle);
        cosines[i] = std::cos(angle);
    }
}
}  // namespace RSI_PROCESSOR
}  // namespace sil

#ifdef __FMA__
#include "sil/world/vehicle/lane_functions.hpp"
#endif

namespace sil::number {

using RSI_PROCESSOR::each;
using RSI_PROCESSOR::LaneArray;
using RSI_PROCESSOR::LaneMask;
using RSI_PROCESSOR::Lanes;

[[gnu::always_inline]] inline Lanes choose(const LaneMask& condition, const Lanes& if_true,
                                           const Lanes& if_false) {
    return condition.lanes() != LaneMask::nowhere ? if_true.lanes() : if_false.lanes();
}
[[gnu::always_inline]] inline bool any(const LaneMask& condition) {
    return condition.any();
}
[[gnu::always_inline]] inline bool all(const LaneMask& condition) {
    return !(!condition).any();
}

// As std::max, std::min and std::clamp choose, zeros and what is no number included.
[[gnu::always_inline]] inline Lanes max(const Lanes& a, const Lanes& b) {
    return choose(a < b, b, a);
}
[[gnu::always_inline]] inline Lanes min(const Lanes& a, const Lanes& b) {
    return choose(b < a, b, a);
}
[[gnu::always_inline]] inline Lanes clamp(const Lanes& value, const Lanes& lowest, const Lanes& highest) {
    return choose(value < lowest, lowest, choose(highest < value, highest, value));
}

[[gnu::always_inline]] inline Lanes abs(const Lanes& value) {
    constexpr long long all_but_sign = 0x7FFF'FFFF'FFFF'FFFF;
    return Lanes::Register(LaneMask::Register(value.lanes()) & all_but_sign);
}

[[gnu::always_inline]] inline Lanes sqrt(const Lanes& value) {
    LaneArray all{value};
    for (double& one : all.values) {
        one = std::sqrt(one);  // one instruction for as many as a register holds
    }
    return all.lanes();
}

[[gnu::always_inline]] inline Lanes sin(const Lanes& value) {
#ifdef __FMA__
    return RSI_PROCESSOR::library_sin(value, function_tables());
#else
    return each<std::sin>(value);
#endif
}
[[gnu::always_inline]] inline Lanes tan(const Lanes& value) {
    return each<std::tan>(value);
}
[[gnu::always_inline]] inline Lanes asin(const Lanes& value) {
    return each<std::asin>(value);
}
[[gnu::always_inline]] inline Lanes atan(const Lanes& value) {
#ifdef __FMA__
    return RSI_PROCESSOR::library_atan(value, function_tables());
#else
    return each<std::atan>(value);
#endif
}
[[gnu::always_inline]] inline Lanes atan2(const Lanes& y, const Lanes& x) {
    return each<std::atan2>(y, x);
}
[[gnu::always_inline]] inline Lanes hypot(const Lanes& x, const Lanes& y) {
    return each<std::hypot>(x, y);
}

[[gnu::always_inline]] inline void sin_and_cos(const Lanes& value, Lanes& sine, Lanes& cosine) {
#ifdef __FMA__
    RSI_PROCESSOR::library_sin_and_cos(value, function_tables(), sine, cosine);
#else
    LaneArray sines{value};
    LaneArray cosines{value};
    RSI_PROCESSOR::sines_and_cosines(sines.values, cosines.values);
    sine = sines.lanes();
    cosine = cosines.lanes();
#endif
}

}  // namespace sil::number

template <>
struct Eigen::NumTraits<sil::RSI_PROCESSOR::Lanes> : Eigen::GenericNumTraits<double> {
    using Real = sil::RSI_PROCESSOR::Lanes;
    using NonInteger = sil::RSI_PROCESSOR::Lanes;
    using Nested = sil::RSI_PROCESSOR::Lanes;
};
template <typename Operation>
struct Eigen::ScalarBinaryOpTraits<double, sil::RSI_PROCESSOR::Lanes, Operation> {
    using ReturnType = sil::RSI_PROCESSOR::Lanes;
};
template <typename Operation>
struct Eigen::ScalarBinaryOpTraits<sil::RSI_PROCESSOR::Lanes, double, Operation> {
    using ReturnType = sil::RSI_PROCESSOR::Lanes;
};
