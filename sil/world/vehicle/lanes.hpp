// Lanes: one number of several vehicles, computed together in the processor's vector registers. Every operation
// works lane by lane and rounds as the same operation does on a double, so a vehicle's results do not depend on
// who is beside it.
//
// For vehicle_batch.cpp alone, which compiles all that uses it into one function for each kind of processor.
#pragma once

#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include "sil/world/vehicle/number.hpp"

namespace sil {

class LaneMask;

class Lanes {
 public:
    static constexpr std::size_t count = 8;
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
    [[gnu::always_inline]] friend Lanes operator+(const Lanes& a, const Lanes& b) { return a.lanes_ + b.lanes_; }
    [[gnu::always_inline]] friend Lanes operator-(const Lanes& a, const Lanes& b) { return a.lanes_ - b.lanes_; }
    [[gnu::always_inline]] friend Lanes operator*(const Lanes& a, const Lanes& b) { return a.lanes_ * b.lanes_; }
    [[gnu::always_inline]] friend Lanes operator/(const Lanes& a, const Lanes& b) { return a.lanes_ / b.lanes_; }
    [[gnu::always_inline]] friend Lanes operator-(const Lanes& a) { return -a.lanes_; }

 private:
    Register lanes_;
};

// A condition that holds in some lanes.
class LaneMask {
 public:
    using Register = long long __attribute__((vector_size(Lanes::count * sizeof(long long))));

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
    return LaneMask::Register(a.lanes() < b.lanes());
}
[[gnu::always_inline]] inline LaneMask operator>(const Lanes& a, const Lanes& b) {
    return LaneMask::Register(a.lanes() > b.lanes());
}
[[gnu::always_inline]] inline LaneMask operator<=(const Lanes& a, const Lanes& b) {
    return LaneMask::Register(a.lanes() <= b.lanes());
}

namespace number {

[[gnu::always_inline]] inline Lanes choose(const LaneMask& condition, const Lanes& if_true, const Lanes& if_false) {
    return condition.lanes() ? if_true.lanes() : if_false.lanes();
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

// Loops over plain arrays, which the compiler makes one instruction where there is one.
[[gnu::always_inline]] inline Lanes sqrt(const Lanes& value) {
    Lanes::Register result{};
    for (std::size_t i = 0; i < Lanes::count; ++i) {
        result[i] = std::sqrt(value[i]);
    }
    return result;
}

// The library's functions, lane after lane: a vector library's would round otherwise.
template <double function(double)>
[[gnu::always_inline]] inline Lanes each(const Lanes& value) {
    double values[Lanes::count];
    for (std::size_t i = 0; i < Lanes::count; ++i) {
        values[i] = value[i];
    }
    Lanes::Register result{};
    for (std::size_t i = 0; i < Lanes::count; ++i) {
        result[i] = function(values[i]);
    }
    return result;
}
template <double function(double, double)>
[[gnu::always_inline]] inline Lanes each(const Lanes& a, const Lanes& b) {
    Lanes::Register result{};
    for (std::size_t i = 0; i < Lanes::count; ++i) {
        result[i] = function(a[i], b[i]);
    }
    return result;
}

inline Lanes sin(const Lanes& value) {
    return each<number::sin>(value);
}
inline Lanes tan(const Lanes& value) {
    return each<number::tan>(value);
}
inline Lanes asin(const Lanes& value) {
    return each<number::asin>(value);
}
inline Lanes atan(const Lanes& value) {
    return each<number::atan>(value);
}
inline Lanes atan2(const Lanes& y, const Lanes& x) {
    return each<number::atan2>(y, x);
}
inline Lanes hypot(const Lanes& x, const Lanes& y) {
    return each<number::hypot>(x, y);
}
inline void sin_and_cos(const Lanes& value, Lanes& sine, Lanes& cosine) {
    Lanes::Register sines{};
    Lanes::Register cosines{};
    for (std::size_t i = 0; i < Lanes::count; ++i) {
        double one_sine;
        double one_cosine;
        number::sin_and_cos(value[i], one_sine, one_cosine);
        sines[i] = one_sine;
        cosines[i] = one_cosine;
    }
    sine = sines;
    cosine = cosines;
}

}  // namespace number
}  // namespace sil

template <>
struct Eigen::NumTraits<sil::Lanes> : Eigen::GenericNumTraits<double> {
    using Real = sil::Lanes;
    using NonInteger = sil::Lanes;
    using Nested = sil::Lanes;
};
template <typename Operation>
struct Eigen::ScalarBinaryOpTraits<double, sil::Lanes, Operation> {
    using ReturnType = sil::Lanes;
};
template <typename Operation>
struct Eigen::ScalarBinaryOpTraits<sil::Lanes, double, Operation> {
    using ReturnType = sil::Lanes;
};
