// The estimator in float against the same equations in double, on the recorded sensor frames of the
// regression set.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>

#include "hal/memory/frame_replay.hpp"
#include "hal/memory/memory_bus.hpp"
#include "rsi/component.hpp"
#include "rsi/ecu/application/sensor_reception.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/candump_log.hpp"

namespace rsi_test {
namespace recorded_signals_test {
namespace {

// Equations (1), (5), (8) to (11) in double, with a full covariance matrix, libm, and both Y and psi divided
// by sqrt(n_s): nothing is shared with the firmware but the measured A, N, roll angle and roll rate.
class Reference {
 public:
    explicit Reference(const rsi::Parameters& p)
        : p_{p}, H_{double{p.sprung_cg_height_m} - double{p.fixed_roll_centre_height_m}} {
        scale_ << double{p.initial_roll_centre_deviation_m}, double{p.initial_stiffness_deviation_nmprad},
            double{p.initial_damping_deviation_nmsprad};
        alpha_ = 1.0 - std::exp(-2.0 * 3.14159265358979323846 * double{p.disturbance_cutoff_hz} * 0.01);
    }

    void start(double phi_m) { phi_f_ = phi_m; }

    void step(double A, double N, double phi_m, double rate_m) {
        const double m_s = double{p_.sprung_mass_kg}, K = double{p_.roll_stiffness_nmprad},
                     c = double{p_.roll_damping_nmsprad};
        if (stepped_) {
            const double secant_squared = 1.0 + std::tan(phi_f_) * std::tan(phi_f_);
            const double mean_rate = 0.5 * (rate_f_ + rate(A, N));
            phi_f_ += 0.01 * mean_rate / (1.0 + 0.005 * (K - m_s * N * H_ * secant_squared) / c);
        }
        stepped_ = true;
        rate_f_ = rate(A, N);
        const double Y = c * (rate_f_ - rate_m) + (K - m_s * N * H_) * (phi_f_ - phi_m);
        update(Y, Eigen::Vector3d{m_s * A + m_s * N * std::tan(phi_m), phi_m, rate_m});
    }

    Eigen::Vector3d theta() const { return theta_.cwiseProduct(scale_); }
    double phi_f() const { return phi_f_; }

 private:
    // (1) solved for phi_f'.
    double rate(double A, double N) const {
        return (H_ * double{p_.sprung_mass_kg} * (A + N * std::tan(phi_f_)) -
                double{p_.roll_stiffness_nmprad} * phi_f_) /
               double{p_.roll_damping_nmsprad};
    }

    void update(double Y_nm, const Eigen::Vector3d& psi_si) {
        const double lambda = P_.trace() > double{p_.covariance_limit} ? 1.0 : double{p_.forgetting_factor};
        const Eigen::Vector3d psi_full = psi_si.cwiseProduct(scale_) / double{p_.regression_scale_nm};
        const double Y_full = Y_nm / double{p_.regression_scale_nm};
        const double root = std::sqrt(1.0 + psi_full.dot(P_ * psi_full));
        const Eigen::Vector3d psi = psi_full / root;
        const double innovation = (Y_full - psi_full.dot(theta_) - d_) / root;
        const Eigen::Matrix3d reduced = P_ - P_ * psi * psi.transpose() * P_ / (lambda + psi.dot(P_ * psi));
        theta_ += reduced * psi * innovation / lambda;  // (9) with P(k) of (10)
        d_ += alpha_ * innovation * root;
        P_ = reduced / lambda;
    }

    rsi::Parameters p_;
    double H_;
    double alpha_{0.0};
    Eigen::Vector3d scale_;
    Eigen::Vector3d theta_{Eigen::Vector3d::Zero()};
    Eigen::Matrix3d P_{Eigen::Matrix3d::Identity()};
    double d_{0.0};
    double phi_f_{0.0};
    double rate_f_{0.0};
    bool stepped_{false};
};

class RecordedSignals : public testing::TestWithParam<const char*> {};

TEST_P(RecordedSignals, GiveTheEstimatesOfTheDoublePrecisionReference) {
    const std::string source{RSI_SOURCE_DIR};
    std::vector<rsi::hal::CanFrame> frames;
    for (const sil::LoggedFrame& logged : sil::read_candump_log(
             source + "/tests/application/regression/logs/" + GetParam() + ".sensors.log")) {
        frames.push_back(logged.frame);
    }
    const rsi::Parameters parameters =
        sil::load_calibration(source + "/firmware/calibrations/large_suv.toml", {"estimator=published"});
    rsi::hal::VirtualClock clock;
    rsi::hal::MemoryBus<2U> bus{clock};
    rsi::hal::FrameReplay player{frames.data(), frames.size(), clock, bus.endpoint(0U)};
    rsi::application::SensorReception reception;
    rsi::Component component;
    ASSERT_EQ(component.init(parameters).accepted, 1);
    Reference reference{parameters};

    double largest_theta = 0.0;
    int compared = 0;
    for (rsi::hal::Time time = frames.front().receive_time; !player.finished();
         time = time + rsi::hal::Time::from_milliseconds(10)) {
        player.run_until(time);
        reception.receive(bus.endpoint(1U), 0U);
        const rsi::Inputs inputs = reception.inputs(reception.report(clock.now()));
        rsi::Outputs outputs;
        component.step(inputs, outputs);
        if (compared == 0) {
            reference.start(double{inputs.roll_angle_rad});
        }
        // The firmware clamps the fixed model at 0.5 rad and starts the estimator anew once the vehicle has
        // overturned; the reference does neither.
        if (std::abs(reference.phi_f()) > 0.4 || std::abs(inputs.roll_angle_rad) > 0.6F) {
            break;
        }
        reference.step(double{outputs.road_parallel_force_mps2}, double{outputs.road_normal_force_mps2},
                       double{inputs.roll_angle_rad}, double{inputs.roll_rate_radps});
        // The firmware linearises its step upright, the reference at the present state.
        EXPECT_NEAR(double{outputs.fixed_model_roll_angle_rad}, reference.phi_f(), 2.0e-5);
        // One thousandth of what the estimate may be at all: rounding, not another algorithm.
        EXPECT_NEAR(double{outputs.roll_centre_vertical_m}, reference.theta().x(), 1.0e-3);
        EXPECT_NEAR(double{outputs.roll_stiffness_deviation_nmprad}, reference.theta().y(), 100.0);
        EXPECT_NEAR(double{outputs.roll_damping_deviation_nmsprad}, reference.theta().z(), 10.0);
        largest_theta = std::max(largest_theta, std::abs(reference.theta().x()));
        ++compared;
    }
    EXPECT_GE(compared, 250);
    EXPECT_GT(largest_theta, 0.01);  // otherwise the agreement would be about nothing
}

INSTANTIATE_TEST_SUITE_P(RegressionSet, RecordedSignals,
                         testing::Values("j-turn-45", "j-turn-110", "j-turn-110-mirrored", "j-turn-110-noise",
                                         "slalom-noise"));

}  // namespace
}  // namespace recorded_signals_test
}  // namespace rsi_test
