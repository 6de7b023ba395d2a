// K_f and c_f as docs/calibration.md tells an engineer to find them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/sil/files/test_drive.hpp"

namespace {

using calibration_test::Sample;

class NominalModel : public testing::TestWithParam<const char*> {
 protected:
    rsi::Parameters calibration_{calibration_test::calibration_of(GetParam())};
    double stiffness_nmprad_{static_cast<double>(calibration_.roll_stiffness_nmprad)};

    double damping_of(double duration_s, const std::function<double(double)>& handwheel_deg) const {
        return calibration_test::roll_damping_nmsprad(
            calibration_, stiffness_nmprad_, calibration_test::drive(GetParam(), duration_s, handwheel_deg));
    }
};

// Ramps to both sides until 0.5 g is passed.
TEST_P(NominalModel, StiffnessOfTheCalibrationIsThatOfASlowRampSteer) {
    std::vector<Sample> samples;
    for (const double side : {1.0, -1.0}) {
        for (const Sample& sample : calibration_test::drive(GetParam(), 28.0, [side](double time_s) {
                 return side * 3.0 * std::max(time_s - 1.0, 0.0);
             })) {
            samples.push_back(sample);
        }
    }
    EXPECT_NEAR(calibration_test::roll_stiffness_nmprad(calibration_, samples), stiffness_nmprad_,
                0.005 * stiffness_nmprad_);
}

// Two manoeuvres of different speed must give one damping, or the procedure were worth nothing.
TEST_P(NominalModel, DampingFromAStepThereAndBackAgreesWithThatFromASineSteer) {
    const double from_step = damping_of(14.0, [](double time_s) {
        return std::clamp(250.0 * (time_s - 1.0), 0.0, 40.0) - std::clamp(250.0 * (time_s - 6.0), 0.0, 40.0);
    });
    const double from_sine = damping_of(24.0, [](double time_s) {
        constexpr double pi = 3.14159265358979323846;
        const double periods = std::clamp(0.5 * (time_s - 1.0), 0.0, 10.0);
        return 40.0 * std::sin(2.0 * pi * periods);
    });
    EXPECT_NEAR(from_step, from_sine, 0.1 * from_sine);
}

INSTANTIATE_TEST_SUITE_P(Vehicles, NominalModel, testing::Values("large_suv", "ordinary_suv"),
                         [](const auto& test) { return std::string{test.param}; });

// A body with roll inertia, c_f and K_f known, excited from rest to rest: the inertia must not enter.
TEST(DampingFromAStepThereAndBack, DoesNotDependOnTheRollInertia) {
    const rsi::Parameters calibration = calibration_test::calibration_of("large_suv");
    const double arm_m = calibration_test::moment_arm_m(calibration);
    const double mass_kg = static_cast<double>(calibration.sprung_mass_kg);
    const double stiffness_nmprad = static_cast<double>(calibration.roll_stiffness_nmprad);
    const double damping_nmsprad = 6000.0;
    for (const double inertia_kgm2 : {200.0, 600.0, 1200.0}) {
        std::vector<Sample> samples;
        double angle_rad = 0.0, rate_radps = 0.0;
        constexpr double step_s = 1.0e-4;
        for (int k = 0; k < 120000; ++k) {
            const double time_s = step_s * k;
            const double parallel_mps2 = 3.0 * (std::clamp(5.0 * (time_s - 1.0), 0.0, 1.0) -
                                                std::clamp(5.0 * (time_s - 6.0), 0.0, 1.0));
            if (k % 100 == 0) {
                samples.push_back(Sample{time_s, parallel_mps2, 9.80665, angle_rad, rate_radps});
            }
            const double moment_nm = mass_kg * arm_m * (parallel_mps2 + 9.80665 * std::tan(angle_rad)) -
                                     stiffness_nmprad * angle_rad - damping_nmsprad * rate_radps;
            rate_radps += step_s * moment_nm / inertia_kgm2;
            angle_rad += step_s * rate_radps;
        }
        EXPECT_NEAR(calibration_test::roll_damping_nmsprad(calibration, stiffness_nmprad, samples),
                    damping_nmsprad, 0.01 * damping_nmsprad)
            << inertia_kgm2;
    }
}

}  // namespace
