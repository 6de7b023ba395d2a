// The fixed-roll-centre model and the compensated one against (1) solved in double: rest position, step
// response, forces that change, stability.
#include "rsi/estimation/roll_plane_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rsi/parameters.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/recorded_like_signals.hpp"
#include "tests/rsi/support/roll_plane_vehicle.hpp"
#include "tests/support/nominal_roll_model.hpp"

namespace roll_plane_model_test {
namespace {

using rsi_test::RollPlaneVehicle;

rsi::Measurement forces(double parallel_mps2, double normal_mps2) {
    rsi::Measurement measurement;
    measurement.road_parallel_force_mps2 = static_cast<float>(parallel_mps2);
    measurement.road_normal_force_mps2 = static_cast<float>(normal_mps2);
    return measurement;
}

// Vehicle and state together, stepped as the component steps them.
struct FixedModel {
    explicit FixedModel(const rsi_parameters& parameters) : vehicle{parameters} { roll.reset(0.0F); }
    void step(const rsi::Measurement& measurement) { roll.update(vehicle, measurement); }
    rsi::Vehicle vehicle;
    rsi::FixedModelRoll roll;
};

TEST(RollPlaneModel, SettlesWhereTheMomentsBalance) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const RollPlaneVehicle truth(parameters, {});
    for (const double parallel : {-8.0, -3.0, 0.0, 1.0, 6.0, 9.0}) {
        for (const double normal : {7.0, rsi_test::gravity_mps2, 12.0}) {
            FixedModel fixed(parameters);
            for (int k = 0; k < 1000; ++k) {
                fixed.step(forces(parallel, normal));
            }
            EXPECT_NEAR(static_cast<double>(fixed.roll.angle_rad()), truth.steady_angle_rad(parallel, normal),
                        1.0e-6)
                << "A " << parallel << ", N " << normal;
        }
    }
}

// Time constant 0.1 s at 10 ms: the trapezoidal rule errs by (T/tau)^2 / 12 * (t/tau) exp(-t/tau), at
// most 3.1e-4 of the final angle; as much again is left to the linearised tangent.
TEST(RollPlaneModel, FollowsTheStepResponseOfTheDifferentialEquation) {
    const rsi_parameters parameters = rsi_test::large_suv();
    for (const double parallel : {-6.0, 2.0, 8.0}) {
        RollPlaneVehicle truth(parameters, {});
        const double final_angle = std::fabs(truth.steady_angle_rad(parallel, rsi_test::gravity_mps2));
        FixedModel fixed(parameters);
        for (int k = 0; k <= 200; ++k) {
            fixed.step(forces(parallel, rsi_test::gravity_mps2));
            ASSERT_NEAR(static_cast<double>(fixed.roll.angle_rad()), truth.angle_rad(), 6.2e-4 * final_angle)
                << "A " << parallel << ", step " << k;
            truth.advance(parallel, rsi_test::gravity_mps2, 0.01);
        }
    }
}

TEST(RollPlaneModel, GivesTheRateOfEquationOne) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const RollPlaneVehicle truth(parameters, {});
    FixedModel fixed(parameters);
    for (const float angle : {-0.3F, 0.0F, 0.05F, 0.4F}) {
        fixed.roll.reset(angle);
        fixed.step(forces(4.0, 9.0));
        // Moments near 2e4 N m over 8e3 N m s: float rounding stays below 1e-5 rad/s.
        EXPECT_NEAR(static_cast<double>(fixed.roll.rate_radps()),
                    truth.rate_radps(4.0, 9.0, static_cast<double>(angle)), 1.0e-5);
    }
}

// Forces of a lively drive on an uneven road, and a moment as (7) adds one.
double parallel_mps2(double time_s) {
    return rsi_test::lively_lateral_acceleration_mps2(time_s);
}
double normal_mps2(double time_s) {
    return rsi_test::gravity_mps2 + std::sin(2.0 * rsi_test::pi * 1.3 * time_s);
}
double moment_nm(double time_s) {
    return 3.0e3 * std::sin(2.0 * rsi_test::pi * 0.9 * time_s);
}

rsi_parameters large_suv_with_roll_plane_of(const char* vehicle) {
    const rsi_test::NominalRollModel nominal = rsi_test::nominal_roll_model(vehicle);
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.fixed_roll_centre_height_m = static_cast<float>(nominal.roll_centre_height_m);
    parameters.roll_stiffness_nmprad = static_cast<float>(nominal.stiffness_nmprad);
    parameters.roll_damping_nmsprad = static_cast<float>(nominal.damping_nmsprad);
    return parameters;
}

// (1), and the model that M_add compensates, integrated together by the classical Runge-Kutta rule: two
// angles.
class ReferenceModels {
 public:
    explicit ReferenceModels(const rsi_parameters& p)
        : moment_{static_cast<double>(p.sprung_mass_kg) *
                  (static_cast<double>(p.sprung_cg_height_m) -
                   static_cast<double>(p.fixed_roll_centre_height_m))},
          stiffness_{static_cast<double>(p.roll_stiffness_nmprad)},
          damping_{static_cast<double>(p.roll_damping_nmsprad)} {}

    void advance(double time_s) {
        constexpr double dt = 5.0e-4;
        for (const double end_s = time_s_ + time_s - 0.5 * dt; time_s_ < end_s; time_s_ += dt) {
            const Angles k1 = rates(time_s_, angles_);
            const Angles k2 = rates(time_s_ + 0.5 * dt, moved(k1, 0.5 * dt));
            const Angles k3 = rates(time_s_ + 0.5 * dt, moved(k2, 0.5 * dt));
            const Angles k4 = rates(time_s_ + dt, moved(k3, dt));
            angles_.fixed += dt * (k1.fixed + 2.0 * k2.fixed + 2.0 * k3.fixed + k4.fixed) / 6.0;
            angles_.compensated +=
                dt * (k1.compensated + 2.0 * k2.compensated + 2.0 * k3.compensated + k4.compensated) / 6.0;
        }
    }

    double fixed_rad() const { return angles_.fixed; }
    double compensated_rad() const { return angles_.compensated; }

 private:
    struct Angles {
        double fixed{0.0};
        double compensated{0.0};
    };

    Angles moved(const Angles& rate, double time_s) const {
        return {angles_.fixed + time_s * rate.fixed, angles_.compensated + time_s * rate.compensated};
    }

    Angles rates(double time_s, const Angles& at) const {
        const double force_nm = moment_ * (parallel_mps2(time_s) + normal_mps2(time_s) * std::tan(at.fixed));
        return {(force_nm - stiffness_ * at.fixed) / damping_,
                (force_nm + moment_nm(time_s) - stiffness_ * at.compensated) / damping_};
    }

    double moment_;
    double stiffness_;
    double damping_;
    double time_s_{0.0};
    Angles angles_{};
};

// Each angle belongs to the instant of its measurement: it is ten times nearer to the reference than the
// reference is to itself half a sample later.
TEST(RollPlaneModel, AnglesUnderChangingForcesBelongToTheInstantOfTheMeasurement) {
    constexpr double tolerance_rad = 1.0e-4;
    for (const char* vehicle : {"large SUV", "ordinary SUV", "van"}) {
        const rsi_parameters parameters = large_suv_with_roll_plane_of(vehicle);
        FixedModel fixed(parameters);
        rsi::CompensatedModelRoll compensated;
        compensated.reset(0.0F);
        ReferenceModels truth(parameters);
        double fixed_lag_rad = 0.0;
        double compensated_lag_rad = 0.0;
        for (int k = 0; k < 3000; ++k) {
            const double time_s = 0.01 * k;
            const rsi::Measurement measurement = forces(parallel_mps2(time_s), normal_mps2(time_s));
            fixed.step(measurement);
            compensated.update(fixed.vehicle, measurement, fixed.roll, static_cast<float>(moment_nm(time_s)));
            const double fixed_rad = truth.fixed_rad();
            const double compensated_rad = truth.compensated_rad();
            ASSERT_NEAR(static_cast<double>(fixed.roll.angle_rad()), fixed_rad, tolerance_rad)
                << vehicle << ", sample " << k;
            ASSERT_NEAR(static_cast<double>(compensated.angle_rad()), compensated_rad, tolerance_rad)
                << vehicle << ", sample " << k;
            truth.advance(0.005);
            fixed_lag_rad = std::fmax(fixed_lag_rad, std::fabs(truth.fixed_rad() - fixed_rad));
            compensated_lag_rad =
                std::fmax(compensated_lag_rad, std::fabs(truth.compensated_rad() - compensated_rad));
            truth.advance(0.005);
        }
        EXPECT_GT(fixed_lag_rad, 10.0 * tolerance_rad) << vehicle;
        EXPECT_GT(compensated_lag_rad, 10.0 * tolerance_rad) << vehicle;
    }
}

// Every corner of the vehicle's ranges that validation admits, with the least damping and stiffness it admits
// too.
template <typename Check>
void for_each_extreme_vehicle(Check check) {
    for (const float mass : {100.0F, 60000.0F}) {
        for (const float height : {0.2F, 4.0F}) {
            for (const float arm : {0.0101F, 0.5F, 2.0F}) {
                for (const float stiffness_ratio : {1.2001F, 50.0F}) {
                    for (const float time_constant_s : {0.005001F, 0.1F, 10.0F}) {
                        rsi_parameters parameters = rsi_test::large_suv();
                        parameters.sprung_mass_kg = mass;
                        parameters.sprung_cg_height_m = height;
                        parameters.track_width_m = std::fmin(parameters.track_width_m, 5.9F * height);
                        parameters.fixed_roll_centre_height_m = height - arm;
                        parameters.roll_stiffness_nmprad =
                            std::fmax(stiffness_ratio * mass * 9.80665F * arm, 1.0e3F);
                        parameters.roll_damping_nmsprad =
                            std::fmax(time_constant_s * parameters.roll_stiffness_nmprad, 1.0e2F);
                        if (rsi::validate(parameters).accepted != 0) {
                            check(parameters);
                        }
                    }
                }
            }
        }
    }
}

TEST(RollPlaneModel, ExtremeAdmittedVehiclesComeToRest) {
    int vehicles = 0;
    for_each_extreme_vehicle([&vehicles](const rsi_parameters& parameters) {
        ++vehicles;
        const RollPlaneVehicle truth(parameters, {});
        const double stiffness = static_cast<double>(parameters.roll_stiffness_nmprad);
        const double damping = static_cast<double>(parameters.roll_damping_nmsprad);
        FixedModel fixed(parameters);
        fixed.roll.reset(0.3F);
        // At least 20 time constants of the softest admitted vehicle, K - m_s g H = K / 6.
        const int steps = static_cast<int>(20.0 * 6.0 * damping / stiffness / 0.01) + 100;
        for (int k = 0; k < steps; ++k) {
            fixed.step(forces(0.3, rsi_test::gravity_mps2));
        }
        EXPECT_NEAR(static_cast<double>(fixed.roll.angle_rad()),
                    truth.steady_angle_rad(0.3, rsi_test::gravity_mps2), 2.0e-4)
            << "m_s " << parameters.sprung_mass_kg << ", h " << parameters.sprung_cg_height_m << ", K_f "
            << stiffness << ", c_f " << damping;
    });
    EXPECT_GT(vehicles, 10);
}

TEST(RollPlaneModel, ExtremeForcesOnExtremeVehiclesNeverLeaveTheModelsRange) {
    std::mt19937 random(7U);
    std::uniform_real_distribution<float> parallel(-100.0F, 100.0F);
    std::uniform_real_distribution<float> normal(0.98F, 85.0F);
    std::uniform_real_distribution<float> moment(-1.0e6F, 1.0e6F);
    for_each_extreme_vehicle([&](const rsi_parameters& parameters) {
        FixedModel fixed(parameters);
        rsi::CompensatedModelRoll compensated;
        compensated.reset(0.0F);
        for (int k = 0; k < 2000; ++k) {
            rsi::Measurement measurement;
            measurement.road_parallel_force_mps2 = parallel(random);
            measurement.road_normal_force_mps2 = normal(random);
            fixed.step(measurement);
            compensated.update(fixed.vehicle, measurement, fixed.roll, moment(random));
            // The negated comparison catches NaN too.
            ASSERT_FALSE(!(std::fabs(fixed.roll.angle_rad()) <= 0.5F));
            ASSERT_FALSE(!(std::fabs(compensated.angle_rad()) <= 0.5F));
        }
    });
}

TEST(RollPlaneModel, TheAngleGoesTheWayOfTheRateAndNoFurtherThanItInOneSample) {
    const rsi::Vehicle vehicle{rsi_test::large_suv()};
    const float with_gravity_s = vehicle.loaded.upright_step_s;
    const float without_s = vehicle.suspension.spring_step_s;
    EXPECT_GT(without_s, 0.0F);
    EXPECT_LT(without_s, with_gravity_s);  // the spring alone is stiffer
    EXPECT_LT(with_gravity_s, rsi::sample_time_s);
}

}  // namespace
}  // namespace roll_plane_model_test
