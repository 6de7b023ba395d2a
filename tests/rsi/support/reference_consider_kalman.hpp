// The consider-Kalman filter on the roll centre once more, in double and with the whole covariance of
// [dh, relative error of M(phi), d] as a matrix.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "rsi/measurement/measurement.hpp"
#include "rsi/rsi.h"
#include "tests/rsi/support/nominal.hpp"

namespace rsi_test {

// A signal through two first-order lags: its mean over the last sample, and its change in it.
class ReferenceTwoLags {
 public:
    explicit ReferenceTwoLags(double lag_s) : weight_{1.0 - std::exp(-0.01 / lag_s)} {}

    void next(double value) {
        if (!started_) {
            first_ = second_ = value;
            started_ = true;
        }
        first_ += weight_ * (value - first_);
        change = weight_ * (first_ - second_);
        mean = second_ + 0.5 * change;
        second_ += change;
    }

    double mean{0.0};
    double change{0.0};

 private:
    double weight_;
    double first_{0.0};
    double second_{0.0};
    bool started_{false};
};

class ReferenceConsiderKalman {
 public:
    explicit ReferenceConsiderKalman(const rsi_parameters& p)
        : p_(p),
          moment_{lag_s()},
          force_{lag_s()},
          rate_{lag_s()},
          offset_prior_{std::pow(0.03 * gravity_mps2 * arm(), 2)} {
        P_.diagonal() << prior(), 0.07 * 0.07, offset_prior_;
    }

    void next(const rsi::Measurement& measured, double extended_rsi, double speed_mps) {
        const double phi = wide(measured.roll_angle_rad);
        const double M =
            phi * (wide(p_.roll_stiffness_nmprad) + std::pow(phi, 2) * wide(p_.roll_stiffness_cubic_nmprad3) +
                   std::pow(phi, 4) * wide(p_.roll_stiffness_quintic_nmprad5));
        const double f =
            wide(p_.sprung_mass_kg) * (wide(measured.road_parallel_force_mps2) +
                                       wide(measured.road_normal_force_mps2) * wide(measured.tan_roll_angle));
        const double c_f = wide(p_.roll_damping_nmsprad);
        force_.next(f);
        rate_.next(wide(measured.roll_rate_radps));
        moment_.next(arm() / wide(p_.sprung_mass_kg) * f - M - c_f * wide(measured.roll_rate_radps));
        const double inertia = wide(p_.roll_inertia_kgm2) * rate_.change / 0.01;
        const bool settled = samples_++ >= 2 + std::lround(8.0 * lag_s() / 0.01);

        const bool speed_changes = changes_speed(speed_mps);
        const bool held = speed_changes || extended_rsi > wide(p_.freeze_level);
        const double excitation = wide(p_.sprung_mass_kg * p_.excitation_threshold_mps2);
        const bool excited = std::fabs(force_.mean) > excitation;
        const bool learns = settled && excited && !held && P_(2, 2) < 0.25 * offset_prior_;
        pass_time(excited, held);

        // z = G dh + M(phi) k + d, as innovation against dh and d.
        const Eigen::Vector3d h{force_.mean, M, 1.0};
        const double noise =
            3.0 * (std::pow(400.0, 2) + std::pow(0.25 * c_f * rate_.mean, 2) + std::pow(0.3 * inertia, 2));
        const Eigen::Vector3d c = P_ * h;
        const double S = h.dot(c) + noise;
        const double e = moment_.mean - inertia - force_.mean * dh_ - d_;
        const double weight = std::min(1.0, 0.25 * S / (e * e));
        if (learns) {
            correct(dh_, 0, c, weight, S, e);
            dh_ = std::clamp(dh_, -wide(p_.roll_centre_limit_m), wide(p_.roll_centre_limit_m));
            P_(0, 0) = std::clamp(P_(0, 0), 1.0e-6, prior());
        } else if (settled && std::fabs(force_.mean) < 0.5 * excitation && std::fabs(rate_.mean) < 0.01) {
            correct(d_, 2, c, weight, S, e);
            P_(2, 2) = std::max(P_(2, 2), drift());
        }
        frozen_ = !learns;
        outlier_ = (weight < 1.0);
        disturbance_nm_ = moment_.mean - inertia - force_.mean * dh_;
    }

    double movement_m() const { return dh_; }
    double deviation_m() const { return std::sqrt(P_(0, 0)); }
    double disturbance_nm() const { return disturbance_nm_; }
    bool frozen() const { return frozen_; }
    bool outlier() const { return outlier_; }

 private:
    static double wide(float value) { return static_cast<double>(value); }
    double lag_s() const { return wide(p_.estimator_filter_lag_s); }
    double prior() const { return std::pow(wide(p_.roll_centre_prior_deviation_m), 2); }
    double arm() const {
        return wide(p_.sprung_mass_kg) * (wide(p_.sprung_cg_height_m) - wide(p_.fixed_roll_centre_height_m));
    }
    double drift() const { return std::pow(0.0005 * gravity_mps2 * arm(), 2) * 0.01; }

    bool changes_speed(double speed_mps) {
        if (!(speed_mps >= 0.0 && speed_mps <= 150.0)) {
            speed_known_ = false;
            return false;
        }
        if (!speed_known_) {
            lagged_speed_mps_ = speed_mps;
            speed_known_ = true;
        }
        const double behind = lagged_speed_mps_ - speed_mps;
        lagged_speed_mps_ -= 0.1 * behind;
        return std::fabs(behind) > 0.25;
    }

    void pass_time(bool excited, bool held) {
        const double reversion = 1.0 - std::exp(-0.01 / wide(p_.roll_centre_reversion_s));
        const double kept =
            1.0 - std::min(0.5, (excited ? 0.1 : 1.0) * reversion + std::fabs(rate_.mean) * 0.01 / 0.05);
        P_(0, 0) = prior() + kept * kept * (P_(0, 0) - prior());
        P_(2, 2) = std::min(P_(2, 2) + drift(), offset_prior_);
        if (!held) {
            dh_ *= kept;
            P_(0, 1) = P_(1, 0) = kept * P_(0, 1);
            P_(0, 2) = P_(2, 0) = kept * P_(0, 2);
        }
    }

    // Moves one of the unknowns; the others are considered.
    void correct(double& unknown, int which, const Eigen::Vector3d& c, double weight, double S, double e) {
        const double gain = weight * c(which) / S;
        unknown += gain * e;
        for (const int other : {0, 1, 2}) {
            if (other == which) {
                P_(which, which) -= (2.0 - weight) * gain * c(which);
            } else {
                P_(which, other) = P_(other, which) = P_(which, other) - gain * c(other);
            }
        }
    }

    rsi_parameters p_;
    ReferenceTwoLags moment_;
    ReferenceTwoLags force_;
    ReferenceTwoLags rate_;
    double offset_prior_;
    Eigen::Matrix3d P_{Eigen::Matrix3d::Zero()};
    double dh_{0.0};
    double d_{0.0};
    int samples_{0};
    bool speed_known_{false};
    double lagged_speed_mps_{0.0};
    bool frozen_{true};
    bool outlier_{false};
    double disturbance_nm_{0.0};
};

}  // namespace rsi_test
