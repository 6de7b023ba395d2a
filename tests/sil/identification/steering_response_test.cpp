// How the lateral force follows the steering, and how much the tyres give.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sil/studies/identification/identification.hpp"
#include "sil/studies/identification/response_fit.hpp"
#include "sil/studies/identification/tyre_limit.hpp"
#include "sil/units.hpp"
#include "tests/sil/identification/known_body.hpp"

namespace {

using identification_test::KnownBody;
using identification_test::Recording;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr double fine_s = 1.0e-3;

// Two steps to both sides, so fast that a steering that is held is nearly the one that comes.
double demand(double time_s) {
    const auto step = [time_s](double start_s) {
        const double x = std::min(std::max((time_s - start_s) / 0.04, 0.0), 1.0);
        return x * x * (3.0 - 2.0 * x);
    };
    return 3.0 * (step(1.0) - step(4.0) - step(7.0) + step(10.0));
}

sil::Drive step_drive(double frequency_radps, double damping) {
    std::vector<double> force{0.0};
    double rate = 0.0;
    for (int k = 1; k < 15000; ++k) {
        rate += fine_s * (frequency_radps * frequency_radps * (demand(fine_s * k) - force.back()) -
                          2.0 * damping * frequency_radps * rate);
        force.push_back(force.back() + fine_s * rate);
    }
    Recording recording;
    recording.demand_mps2 = demand;
    return drive_of(
        KnownBody{}, 14.0,
        [&force](double time_s) { return force[static_cast<std::size_t>(std::max(time_s, 0.0) / fine_s)]; },
        recording);
}

std::vector<sil::PreparedDrive> steps(double frequency_radps, double damping) {
    return {sil::prepare_drive(step_drive(frequency_radps, damping),
                               identification_test::data_sheet_of(KnownBody{}), {})};
}

sil::SteeringModel model(double filter_lag_s) {
    const KnownBody body;
    return {body.wheelbase_m, body.steering_ratio, body.understeer_gradient_s2pm, 10.0, filter_lag_s};
}

// Somewhat faster than the force follows: the forecast holds the steering, and the driver goes on turning it.
TEST(SteeringResponse, IsThatWithWhichTheForceFollowsOrSomewhatFaster) {
    double before = 0.0;
    for (const double frequency_radps : {3.0, 5.0, 9.0}) {
        const auto fit = sil::fit_response(model(0.0), {}, steps(frequency_radps, 0.7));
        ASSERT_TRUE(fit);
        EXPECT_GT(fit->frequency_radps, std::max(before, frequency_radps)) << frequency_radps;
        EXPECT_LT(fit->frequency_radps, 1.8 * frequency_radps);
        EXPECT_NEAR(fit->damping, 0.7, 0.2) << frequency_radps;
        EXPECT_LT(fit->rms_mps2, 0.8 * fit->trend_rms_mps2) << frequency_radps;
        EXPECT_TRUE(fit->helps());
        EXPECT_FALSE(fit->at_a_bound);
        EXPECT_LT(fit->frequency_factor, 1.3) << frequency_radps;
        EXPECT_LT(fit->damping_factor, 1.3) << frequency_radps;
        before = fit->frequency_radps;
    }
}

TEST(SteeringResponse, StaysWithinWhatIsSearched) {
    const auto slow = sil::fit_response(model(0.0), {}, steps(0.5, 0.7));
    ASSERT_TRUE(slow);
    EXPECT_GE(slow->frequency_radps, sil::slowest_response_radps);
    const auto fast = sil::fit_response(model(0.0), {}, steps(100.0, 0.7));
    ASSERT_TRUE(fast);
    EXPECT_LE(fast->frequency_radps, sil::fastest_response_radps);
}

TEST(SteeringResponse, IsNotKnownWithoutSteering) {
    std::vector<sil::PreparedDrive> drives = steps(6.0, 0.7);
    drives.front().has_steering = false;
    EXPECT_FALSE(sil::fit_response(model(0.0), {}, drives));
    EXPECT_FALSE(sil::fit_response(model(0.0), {}, {}));
}

// Ramps without steering leave ratio and gradient to the vehicle data; a dynamic drive with it shows the
// rest.
TEST(SteeringResponse, IsFittedWithTheRatioAndTheGradientOfTheVehicleData) {
    const auto frequency = [](const sil::Identification& result) {
        const auto found =
            std::find_if(result.values.begin(), result.values.end(), [](const sil::IdentifiedValue& value) {
                return value.key == "lateral_response_frequency_radps";
            });
        return found->value;
    };
    const KnownBody body;
    Recording without_steering;
    without_steering.steering = false;
    const sil::Drive ramp = ramp_of(body, 5.5, without_steering);
    const sil::Drive dynamic = step_drive(5.0, 0.7);
    sil::VehicleData data = identification_test::data_sheet_of(body);
    EXPECT_EQ(frequency(sil::identify(data, {ramp}, {dynamic})), 0.0);  // the gradient is not known

    data.understeer_gradient_s2pm = body.understeer_gradient_s2pm;
    const sil::Identification known = sil::identify(data, {ramp}, {dynamic});
    EXPECT_FALSE(known.steering);
    EXPECT_GT(frequency(known), 5.0);
    EXPECT_LT(frequency(known), 1.8 * 5.0);
    EXPECT_THAT(known.warnings, Not(Contains(HasSubstr("does not show in the drives"))));

    const sil::Identification unseen = sil::identify(data, {ramp}, {steps_of(body, without_steering)});
    EXPECT_EQ(frequency(unseen), 0.0);
    EXPECT_THAT(unseen.warnings, Contains(HasSubstr("does not show in the drives")));
}

// As `steering_demand.cpp` of the component: V^2 delta / (L + K_us V^2), bounded.
TEST(SteeringResponse, TheDemandIsThatOfTheComponent) {
    sil::RollSample sample{};
    sample.speed_mps = 20.0;
    sample.steering_wheel_angle_rad = 0.3;
    const sil::SteeringModel given{2.8, 15.0, 0.002, 8.0, 0.02};
    EXPECT_NEAR(sil::steering_demand_mps2(given, sample), 400.0 * 0.02 / (2.8 + 0.8), 1e-12);
    sample.steering_wheel_angle_rad = -3.0;
    EXPECT_DOUBLE_EQ(sil::steering_demand_mps2(given, sample), -8.0);
    const sil::SteeringModel oversteering{2.8, 15.0, -0.0069, 8.0, 0.02};
    sample.steering_wheel_angle_rad = 0.05;
    EXPECT_NEAR(sil::steering_demand_mps2(oversteering, sample), 400.0 * 0.05 / 15.0 / 0.28, 1e-12);
}

class TyreLimit : public testing::Test {
 protected:
    KnownBody body_{};
    sil::VehicleData vehicle_{identification_test::data_sheet_of(body_)};
    sil::SteeringFit steering_{};

    TyreLimit() {
        steering_.ratio.value = 10.0;
        steering_.understeer_gradient_s2pm.value = 0.0;
    }

    // A ramp that reaches `largest_mps2` and asks for `asked_mps2`.
    static sil::PreparedDrive ramp(double largest_mps2, double asked_mps2) {
        sil::PreparedDrive drive;
        drive.has_steering = true;
        drive.largest_parallel_mps2 = largest_mps2;
        sil::RollSample sample{};
        sample.speed_mps = 20.0;
        sample.steering_wheel_angle_rad = 10.0 * asked_mps2 * KnownBody{}.wheelbase_m / 400.0;
        drive.samples.push_back(sample);
        return drive;
    }

    double limit(const std::vector<sil::PreparedDrive>& ramps,
                 const std::vector<sil::PreparedDrive>& dynamics = {}) const {
        return sil::tyre_limit(vehicle_, &steering_, ramps, dynamics).largest_mps2;
    }
};

TEST_F(TyreLimit, IsFarBeyondARampThatALiftEnded) {
    sil::PreparedDrive lifted = ramp(6.0, 6.0);
    lifted.cut_by_load_transfer = true;
    EXPECT_DOUBLE_EQ(limit({lifted}), 1.4 * 6.0);
    EXPECT_DOUBLE_EQ(limit({lifted}, {ramp(9.0, 9.0)}), 1.05 * 9.0);
}

TEST_F(TyreLimit, IsReachedByARampThatAsksForMoreThanComes) {
    EXPECT_DOUBLE_EQ(limit({ramp(6.0, 1.31 * 6.0)}), 1.05 * 6.0);
    EXPECT_DOUBLE_EQ(limit({ramp(6.0, -1.31 * 6.0)}, {ramp(7.0, 0.0)}), 1.05 * 7.0);
}

TEST_F(TyreLimit, IsNotShownByADemandNearTheCriticalSpeed) {
    steering_.understeer_gradient_s2pm.value = -0.6 * vehicle_.wheelbase_m / 400.0;
    EXPECT_DOUBLE_EQ(limit({ramp(6.0, 6.0)}), 1.1 * sil::g_mps2);
    steering_.understeer_gradient_s2pm.value = -2.0 * vehicle_.wheelbase_m / 400.0;
    EXPECT_DOUBLE_EQ(limit({ramp(6.0, 0.1)}), 1.1 * sil::g_mps2);
}

TEST_F(TyreLimit, IsADryRoadsWhereNoRampShowsIt) {
    EXPECT_DOUBLE_EQ(limit({ramp(6.0, 1.29 * 6.0)}), 1.1 * sil::g_mps2);
    EXPECT_DOUBLE_EQ(limit({ramp(10.5, 10.5)}), 1.05 * 10.5);
    EXPECT_DOUBLE_EQ(sil::tyre_limit(vehicle_, nullptr, {ramp(6.0, 12.0)}, {}).largest_mps2,
                     1.1 * sil::g_mps2);
}

}  // namespace
