// A vehicle that obeys equation (2) exactly, integrated in double with small steps, and the fixed-roll-centre
// model (1) in the same precision.
#pragma once

#include <cmath>

#include "rsi/rsi.h"

namespace rsi_test {

// The truth behind the estimates: how the vehicle differs from the fixed-roll-centre model.
struct Deviation {
    double vertical_m{0.0};        // dh
    double stiffness_nmprad{0.0};  // dK
    double damping_nmsprad{0.0};   // dc
};

class RollPlaneVehicle {
 public:
    RollPlaneVehicle(const rsi_parameters& parameters, const Deviation& deviation)
        : mass_kg_(static_cast<double>(parameters.sprung_mass_kg)),
          arm_m_(static_cast<double>(parameters.sprung_cg_height_m) -
                 static_cast<double>(parameters.fixed_roll_centre_height_m) - deviation.vertical_m),
          stiffness_nmprad_(static_cast<double>(parameters.roll_stiffness_nmprad) +
                            deviation.stiffness_nmprad),
          damping_nmsprad_(static_cast<double>(parameters.roll_damping_nmsprad) + deviation.damping_nmsprad) {
    }

    void place(double angle_rad) { angle_rad_ = angle_rad; }

    double angle_rad() const { return angle_rad_; }

    // (2) solved for phi'.
    double rate_radps(double parallel_mps2, double normal_mps2, double angle_rad) const {
        const double moment_nm = mass_kg_ * arm_m_ * (parallel_mps2 + normal_mps2 * std::tan(angle_rad));
        return (moment_nm - stiffness_nmprad_ * angle_rad) / damping_nmsprad_;
    }

    // Classical Runge-Kutta over `time_s` in steps of at most 1 ms. The forces are functions of the time
    // since its start.
    template <typename Parallel, typename Normal>
    void advance_under(Parallel parallel_mps2, Normal normal_mps2, double time_s) {
        const int steps = static_cast<int>(std::ceil(time_s / 1.0e-3));
        const double dt = time_s / steps;
        const auto rate_at = [&](double t, double angle_rad) {
            return rate_radps(parallel_mps2(t), normal_mps2(t), angle_rad);
        };
        for (int step = 0; step < steps; ++step) {
            const double t = step * dt;
            const double k1 = rate_at(t, angle_rad_);
            const double k2 = rate_at(t + 0.5 * dt, angle_rad_ + 0.5 * dt * k1);
            const double k3 = rate_at(t + 0.5 * dt, angle_rad_ + 0.5 * dt * k2);
            const double k4 = rate_at(t + dt, angle_rad_ + dt * k3);
            angle_rad_ += dt * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
        }
    }

    // The forces held.
    void advance(double parallel_mps2, double normal_mps2, double time_s) {
        advance_under([=](double) { return parallel_mps2; }, [=](double) { return normal_mps2; }, time_s);
    }

    // The angle at which (2) stands still, by bisection between -0.5 and 0.5 rad.
    double steady_angle_rad(double parallel_mps2, double normal_mps2) const {
        double low = -0.5;
        double high = 0.5;
        for (int halving = 0; halving < 100; ++halving) {
            const double middle = 0.5 * (low + high);
            ((rate_radps(parallel_mps2, normal_mps2, middle) > 0.0) ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

 private:
    double mass_kg_;
    double arm_m_;
    double stiffness_nmprad_;
    double damping_nmsprad_;
    double angle_rad_{0.0};
};

}  // namespace rsi_test
