// Counted: a number that counts the floating-point operations made with it, for the vehicle's equations.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "sil/world/vehicle/number.hpp"

namespace counted {

inline std::uint64_t operations = 0U;

// + - * / and the square root count one each, as does each call of a function; comparisons and choices none.
class Counted {
 public:
    Counted() = default;
    Counted(double value) : value_{value} {}  // not explicit: constants of the equations mix with numbers

    double value() const { return value_; }

    Counted& operator+=(const Counted& b) { return *this = *this + b; }
    Counted& operator-=(const Counted& b) { return *this = *this - b; }
    Counted& operator*=(const Counted& b) { return *this = *this * b; }
    Counted& operator/=(const Counted& b) { return *this = *this / b; }
    friend Counted operator+(const Counted& a, const Counted& b) { return counting(a.value_ + b.value_); }
    friend Counted operator-(const Counted& a, const Counted& b) { return counting(a.value_ - b.value_); }
    friend Counted operator*(const Counted& a, const Counted& b) { return counting(a.value_ * b.value_); }
    friend Counted operator/(const Counted& a, const Counted& b) { return counting(a.value_ / b.value_); }
    friend Counted operator-(const Counted& a) { return -a.value_; }
    friend bool operator<(const Counted& a, const Counted& b) { return a.value_ < b.value_; }
    friend bool operator>(const Counted& a, const Counted& b) { return a.value_ > b.value_; }
    friend bool operator<=(const Counted& a, const Counted& b) { return a.value_ <= b.value_; }

    static Counted counting(double result) {
        ++operations;
        return result;
    }

 private:
    double value_{0.0};
};

}  // namespace counted

template <>
struct Eigen::NumTraits<counted::Counted> : Eigen::GenericNumTraits<double> {
    using Real = counted::Counted;
    using NonInteger = counted::Counted;
    using Nested = counted::Counted;
};
template <typename Operation>
struct Eigen::ScalarBinaryOpTraits<double, counted::Counted, Operation> {
    using ReturnType = counted::Counted;
};
template <typename Operation>
struct Eigen::ScalarBinaryOpTraits<counted::Counted, double, Operation> {
    using ReturnType = counted::Counted;
};

namespace sil::number {

using counted::Counted;

inline Counted choose(bool condition, const Counted& if_true, const Counted& if_false) {
    return condition ? if_true : if_false;
}
inline Counted max(const Counted& a, const Counted& b) {
    return a < b ? b : a;
}
inline Counted min(const Counted& a, const Counted& b) {
    return b < a ? b : a;
}
inline Counted clamp(const Counted& value, const Counted& lowest, const Counted& highest) {
    return value < lowest ? lowest : highest < value ? highest : value;
}
inline Counted abs(const Counted& value) {
    return std::abs(value.value());
}
inline Counted sqrt(const Counted& value) {
    return Counted::counting(std::sqrt(value.value()));
}
inline Counted sin(const Counted& value) {
    return Counted::counting(std::sin(value.value()));
}
inline Counted tan(const Counted& value) {
    return Counted::counting(std::tan(value.value()));
}
inline Counted asin(const Counted& value) {
    return Counted::counting(std::asin(value.value()));
}
inline Counted atan(const Counted& value) {
    return Counted::counting(std::atan(value.value()));
}
inline Counted atan2(const Counted& y, const Counted& x) {
    return Counted::counting(std::atan2(y.value(), x.value()));
}
inline Counted hypot(const Counted& x, const Counted& y) {
    return Counted::counting(std::hypot(x.value(), y.value()));
}
inline void sin_and_cos(const Counted& value, Counted& sine, Counted& cosine) {
    sine = Counted::counting(std::sin(value.value()));
    cosine = Counted::counting(std::cos(value.value()));
}

}  // namespace sil::number

#include "sil/world/vehicle/vehicle_model.hpp"

namespace counted {

struct LevelRoad {
    sil::BasicRoadPoint<Counted> at(const Counted&, const Counted&) const { return {}; }
    sil::Vector3Of<Counted> mean_normal(const Counted&, const Counted&) const { return {0.0, 0.0, 1.0}; }
};

// Operations of a vehicle that rolls on a level road, with the outputs for drivers and judges.
inline double operations_of_a_step(const sil::VehicleParameters& parameters) {
    constexpr std::size_t count = sizeof(sil::BasicVehicleParameters<double>) / sizeof(double);
    static_assert(sizeof(sil::BasicVehicleParameters<Counted>) == count * sizeof(Counted));
    const sil::BasicVehicleParameters<double>& numbers = parameters;
    sil::BasicVehicleParameters<Counted> counted_parameters;
    std::memcpy(static_cast<void*>(&counted_parameters), &numbers, sizeof(numbers));
    sil::VehicleModel<Counted> model{counted_parameters};
    model.state.position.z() = parameters.geometry.cg_height_m;
    model.state.velocity.x() = 20.0;
    model.state.wheel_spin_radps.fill(20.0 / parameters.geometry.wheel_radius_m);
    model.evaluate({}, 0.001, LevelRoad{});
    operations = 0U;
    model.step({}, 0.001, LevelRoad{});
    model.motion();
    return static_cast<double>(operations);
}

}  // namespace counted
