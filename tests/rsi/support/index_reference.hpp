// The further indicators once more, in double and straight from the equations, over a sequence of samples.
#pragma once

#include <algorithm>
#include <cmath>

#include "rsi/rsi.h"
#include "tests/rsi/support/nominal.hpp"

namespace rsi_test {

// The parameters by the equations' letters.
struct ReferenceVehicle {
    explicit ReferenceVehicle(const rsi_parameters& p)
        : m_s{p.sprung_mass_kg},
          m_u{p.unsprung_mass_kg},
          h{p.sprung_cg_height_m},
          h_u{p.unsprung_cg_height_m},
          h_rc{p.fixed_roll_centre_height_m},
          c_w{p.track_width_m},
          Ixx{p.roll_inertia_kgm2},
          c{p.roll_damping_nmsprad},
          K{p.roll_stiffness_nmprad},
          K_2{p.roll_stiffness_cubic_nmprad3},
          K_4{p.roll_stiffness_quintic_nmprad5} {}

    double roll_moment(double x) const { return K * x + K_2 * std::pow(x, 3) + K_4 * std::pow(x, 5); }

    double load_transfer(double A, double N, double x, double y) const {
        const double alpha = m_s * h_rc + m_u * h_u;
        return 2.0 / ((m_s + m_u) * N * c_w) * (alpha * A + roll_moment(x) + c * y);
    }

    double extended(double A, double N, double x, double roll_acceleration) const {
        const double s = (A < 0.0) ? -1.0 : 1.0;
        const double D = s * (h - h_rc) * std::tan(x);
        const double T = (m_s * (c_w / 2.0 - D) + m_u * c_w / 2.0 + s * Ixx * roll_acceleration / N) /
                         (m_s * h + m_u * h_u);
        return std::fabs(A / N) / T;
    }

    // Ixx x'' of the roll equation.
    double roll_acceleration(double a, double N, double x, double y) const {
        return (m_s * (h - h_rc) * (1.0 - 0.75 * e) * (a + N * std::tan(x)) - roll_moment(x) - c * y) / Ixx;
    }

    // load_transfer() with the force's arm that goes with the moment arm error.
    double corrected_load_transfer(double A, double N, double x, double y) const {
        return load_transfer(A, N, x, y) + 2.0 / ((m_s + m_u) * N * c_w) * 0.75 * e * m_s * (h - h_rc) * A;
    }

    // phi_c of (28), by bisection.
    double critical_angle() const {
        double low = 0.0;
        double high = 1.0;
        for (int halving = 0; halving < 100; ++halving) {
            const double phi = 0.5 * (low + high);
            const double T = (c_w / 2.0 - (h - h_rc) * std::tan(phi)) / h;
            const bool short_of_it = K * phi < m_s * (h - h_rc) * gravity_mps2 * (T + std::tan(phi));
            (short_of_it ? low : high) = phi;
        }
        return low;
    }

    double energy(double phi, double rate) const {
        const double H = h - h_rc;
        return K * phi * phi / 2.0 - m_s * gravity_mps2 * H * (1.0 - std::cos(phi)) +
               (Ixx + m_s * H * H) * rate * rate / 2.0;
    }

    double m_s, m_u, h, h_u, h_rc, c_w, Ixx, c, K, K_2, K_4;
    double e{0.0};  // moment arm error
};

// The Kalman filter on the moment arm error, in double, at 50 Hz. next() in every sample.
class ReferenceMomentArmError {
 public:
    double next(const ReferenceVehicle& v, double A, double N, double x, double y, double roll_acceleration,
                double excitation_mps2) {
        e_ *= 1.0 - 0.006;
        P_ += 0.012 * (0.0036 - P_);
        const double arm = v.m_s * (v.h - v.h_rc) * (A + N * std::tan(x));
        if (std::fabs(arm) > v.m_s * (v.h - v.h_rc) * excitation_mps2 &&
            std::fabs(v.load_transfer(A, N, x, y)) < 1.0) {
            const double inertia = v.Ixx * roll_acceleration;
            const double noise = std::pow(0.06 * gravity_mps2 * v.m_s * (v.h - v.h_rc), 2) +
                                 std::pow(0.07 * v.K * x, 2) + std::pow(0.25 * v.c * y, 2) +
                                 std::pow(0.3 * inertia, 2);
            const double gain = P_ * arm / (arm * arm * P_ + 3.0 * noise);
            e_ += gain * (arm - v.roll_moment(x) - v.c * y - inertia - arm * e_);
            P_ -= gain * arm * P_;
        }
        e_ = std::clamp(e_, -0.35, 0.35);
        P_ = std::clamp(P_, 0.0, 0.0036);
        return e_;
    }

 private:
    double e_{0.0};
    double P_{0.0036};
};

// How A goes on from an instant: towards A + A' tau_j, bounded where the steering's demand is known.
struct ReferenceForce {
    double A{0.0};
    double rate{0.0};
    double trend_s{1.0};
    bool bounded{false};
    double demand{0.0};

    double at(double time_s) const {
        const double a = A + rate * trend_s * (1.0 - std::exp(-time_s / trend_s));
        return bounded ? std::clamp(a, std::min({A, demand, 0.0}), std::max({A, demand, 0.0})) : a;
    }
};

// The load transfer of largest magnitude at now and at the ends of four equal parts of the horizon, of the
// roll equation integrated by Runge and Kutta's rule in `steps` steps a part.
inline double predicted_load_transfer(const ReferenceVehicle& v, const ReferenceForce& force, double N,
                                      double x, double y, double horizon_s, int steps = 200) {
    double worst = v.load_transfer(force.A, N, x, y);
    const double offset = worst - v.corrected_load_transfer(force.A, N, x, y);
    const double dt = horizon_s / (4.0 * steps);
    for (int k = 0; k < 4 * steps; ++k) {
        const double t = k * dt;
        const auto acceleration = [&](double later_s, double angle, double rate) {
            return v.roll_acceleration(force.at(t + later_s), N, angle, rate);
        };
        const double x1 = y;
        const double y1 = acceleration(0.0, x, y);
        const double x2 = y + 0.5 * dt * y1;
        const double y2 = acceleration(0.5 * dt, x + 0.5 * dt * x1, x2);
        const double x3 = y + 0.5 * dt * y2;
        const double y3 = acceleration(0.5 * dt, x + 0.5 * dt * x2, x3);
        const double x4 = y + dt * y3;
        const double y4 = acceleration(dt, x + dt * x3, x4);
        x += dt * (x1 + 2.0 * x2 + 2.0 * x3 + x4) / 6.0;
        y += dt * (y1 + 2.0 * y2 + 2.0 * y3 + y4) / 6.0;
        if ((k + 1) % steps == 0) {
            const double L = offset + v.corrected_load_transfer(force.at(t + dt), N, x, y);
            worst = (std::fabs(L) > std::fabs(worst)) ? L : worst;
        }
    }
    return worst;
}

// How near the component's one step of 0.11 s must come. Far from a warning it misses
// most, by 0.07: there the transfer may have its peak within the horizon. It is nearer at the level of a
// warning; beyond 1 the body runs into stiff stops.
inline double prediction_tolerance(double load_transfer) {
    if (std::fabs(load_transfer) < 0.7) {
        return 0.075;
    }
    return (std::fabs(load_transfer) <= 1.0) ? 0.045 : 0.045 * load_transfer * load_transfer;
}

// A first-order lag at 100 Hz that starts at its first value.
class ReferenceLag {
 public:
    explicit ReferenceLag(double lag_s) : weight_{1.0 - std::exp(-0.01 / lag_s)} {}
    void start(double value) { value_ = value; }
    double next(double value) {
        value_ += weight_ * (value - value_);
        return value_;
    }

 private:
    double weight_;
    double value_{0.0};
};

// A signal through two lags, and the difference quotient of what comes out.
class ReferenceSignal {
 public:
    explicit ReferenceSignal(double lag_s) : first_{lag_s}, second_{lag_s} {}
    void next(double value) {
        if (!started_) {
            first_.start(value);
            second_.start(value);
            value_ = value;
            started_ = true;
        }
        const double before = value_;
        value_ = second_.next(first_.next(value));
        derivative_ = (value_ - before) / 0.01;
    }
    double value() const { return value_; }
    double derivative() const { return derivative_; }

 private:
    ReferenceLag first_;
    ReferenceLag second_;
    bool started_{false};
    double value_{0.0};
    double derivative_{0.0};
};

}  // namespace rsi_test
