// How the lateral force follows the steering, and how much the tyres give.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
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

// A ramp to the left and back, as its driver steers it: `force_mps2` says what comes of what is asked for.
sil::PreparedDrive ramp(double most_asked_mps2, const std::function<double(double)>& force_mps2,
                        const KnownBody& body = {}) {
    const auto asked = [most_asked_mps2](double time_s) {
        return most_asked_mps2 * std::clamp(std::min((time_s - 1.0) / 12.0, (16.0 - time_s) / 3.0), 0.0, 1.0);
    };
    Recording recording;
    recording.demand_mps2 = asked;
    return sil::prepare_drive(
        drive_of(
            body, 17.0, [&](double time_s) { return force_mps2(asked(time_s)); }, recording),
        identification_test::data_sheet_of(body), {});
}

constexpr double grip_mps2 = 7.0;

// A brush tyre: linear at first, and no more than the grip.
double of_brush_tyres(double asked_mps2) {
    const double rest = 1.0 - std::min(asked_mps2 / (3.0 * grip_mps2), 1.0);
    return grip_mps2 * (1.0 - rest * rest * rest);
}

// Its driver stops at 6.3 m/s^2, where |LTR| is about 0.7.
double of_good_tyres(double asked_mps2) {
    return asked_mps2;
}

// Understeers more and more, but the force grows on: for 5 m/s^2 it asks for 7.5.
double of_understeering_tyres(double asked_mps2) {
    double force = 0.0;
    for (int k = 0; k < 100; ++k) {
        force = asked_mps2 / (1.0 + force * force / 50.0);
    }
    return force;
}

double load_transfer_ratio(const sil::PreparedDrive& drive, const KnownBody& body = {}) {
    double largest = 0.0;
    for (const sil::RollSample& sample : drive.samples) {
        largest = std::max(largest, std::abs(sample.load_moment_nm));
    }
    return 2.0 * largest / ((body.sprung_mass_kg + body.unsprung_mass_kg) * sil::g_mps2 * body.track_width_m);
}

sil::TyreLimit tyre_limit(const std::vector<sil::PreparedDrive>& ramps,
                          const std::vector<sil::PreparedDrive>& dynamics, const KnownBody& body = {}) {
    return sil::tyre_limit(identification_test::data_sheet_of(body), ramps, dynamics);
}

TEST(TyreLimit, IsShownByARampWhoseForceStopsGrowing) {
    const sil::TyreLimit limit = tyre_limit({ramp(20.0, of_brush_tyres)}, {});
    EXPECT_TRUE(limit.is_shown);
    EXPECT_NEAR(limit.largest_mps2, grip_mps2, 0.1 * grip_mps2);
    EXPECT_THAT(limit.origin, HasSubstr("grew no more while the steering did"));
}

TEST(TyreLimit, IsShownByATurnToEitherSide) {
    sil::PreparedDrive to_the_right = ramp(20.0, of_brush_tyres);
    for (sil::RollSample& sample : to_the_right.samples) {
        sample.parallel_mps2 *= -1.0;
        sample.steering_wheel_angle_rad *= -1.0;
    }
    EXPECT_TRUE(tyre_limit({to_the_right}, {}).is_shown);
}

TEST(TyreLimit, LiesAboveADynamicDriveThatReachesMore) {
    const sil::PreparedDrive dynamic = ramp(8.0, of_good_tyres);
    const sil::TyreLimit limit = tyre_limit({ramp(20.0, of_brush_tyres)}, {dynamic});
    EXPECT_DOUBLE_EQ(limit.largest_mps2, 1.05 * dynamic.largest_parallel_mps2);
    sil::PreparedDrive fast = dynamic;
    fast.largest_parallel_mps2 = 12.0;
    const sil::TyreLimit open = tyre_limit({ramp(6.0, of_good_tyres)}, {fast});
    EXPECT_DOUBLE_EQ(open.largest_mps2, 1.05 * 12.0);
    EXPECT_THAT(open.origin, HasSubstr("open: 5 % above the largest seen"));
}

TEST(TyreLimit, IsOpenWhereTheDriverStopped) {
    const sil::PreparedDrive stopped = ramp(6.3, of_good_tyres);
    EXPECT_NEAR(load_transfer_ratio(stopped), 0.7, 0.05);
    const sil::TyreLimit limit = tyre_limit({stopped}, {});
    EXPECT_FALSE(limit.is_shown);
    EXPECT_DOUBLE_EQ(limit.largest_mps2, 1.1 * sil::g_mps2);
    const sil::PreparedDrive hard = ramp(9.0, of_good_tyres);
    EXPECT_DOUBLE_EQ(tyre_limit({hard}, {}).largest_mps2, 1.4 * hard.largest_parallel_mps2);
}

// A limit below the threshold would foretell that it never lifts a wheel. Axles and wheels belong to what the
// tyres carry sideways: their low CG puts the threshold above that of the body alone.
TEST(TyreLimit, IsOpenBeyondWhatLiftsTheWheels) {
    KnownBody low;
    low.sprung_cg_height_m = 0.55;
    low.roll_centre_height_m = 0.1;
    for (const double unsprung_mass_kg : {0.0, 280.0, 900.0}) {
        low.unsprung_mass_kg = unsprung_mass_kg;
        const double whole_kg = low.sprung_mass_kg + low.unsprung_mass_kg;
        const double cg_height_m =
            (low.sprung_mass_kg * low.sprung_cg_height_m + low.unsprung_mass_kg * low.unsprung_cg_height_m) /
            whole_kg;
        const sil::TyreLimit limit = tyre_limit({ramp(6.0, of_good_tyres, low)}, {}, low);
        EXPECT_NEAR(limit.largest_mps2, low.track_width_m / (2.0 * cg_height_m) * sil::g_mps2, 1e-9)
            << unsprung_mass_kg;
        EXPECT_THAT(limit.origin, HasSubstr("the whole vehicle's static rollover threshold"));
    }
}

// More asked for than came is no evidence: the force still grows.
TEST(TyreLimit, IsOpenWhereTheSteeringAsksForHalfAsMuchAgain) {
    const sil::PreparedDrive understeering = ramp(7.5, of_understeering_tyres);
    EXPECT_LT(understeering.largest_parallel_mps2, 7.5 / 1.45);
    const sil::TyreLimit limit = tyre_limit({understeering}, {});
    EXPECT_FALSE(limit.is_shown);
    EXPECT_GE(limit.largest_mps2, 1.4 * understeering.largest_parallel_mps2);
    EXPECT_THAT(limit.origin, HasSubstr("open"));
}

// A turn in miniature to the other side, where the force stops growing, as that of a drift among noise may.
TEST(TyreLimit, IsNotShownByADriftBeforeTheRamp) {
    sil::PreparedDrive drive = ramp(6.0, of_good_tyres);
    sil::PreparedDrive drift = ramp(20.0, of_brush_tyres);
    for (sil::RollSample& sample : drift.samples) {
        sample.parallel_mps2 *= -0.02;
        sample.steering_wheel_angle_rad *= -0.02;
    }
    drive.samples.insert(drive.samples.begin(), drift.samples.begin(), drift.samples.end());
    EXPECT_FALSE(tyre_limit({drive}, {}).is_shown);
}

// Half of the grip is used.
TEST(TyreLimit, IsOpenWhereBrushTyresHaveAReserve) {
    EXPECT_FALSE(tyre_limit({ramp(6.0, of_brush_tyres)}, {}).is_shown);
}

// The steering asks for no more than came: speed is lost while the wheel turns on.
TEST(TyreLimit, IsOpenWhereTheSpeedIsLost) {
    sil::PreparedDrive slowing = ramp(5.6, of_good_tyres);
    for (sil::RollSample& sample : slowing.samples) {
        const double lost = std::clamp((sample.time_s - 9.0) / 4.0, 0.0, 1.0);
        sample.speed_mps *= 1.0 - 0.3 * lost;
        sample.parallel_mps2 *= std::pow(1.0 - 0.3 * lost, 2);
    }
    EXPECT_FALSE(tyre_limit({slowing}, {}).is_shown);
}

// As `force` of linear tyres at its speed and steering: the driver steers, then mainly speeds up to twice the
// speed and steers on by `steered_on`.
sil::PreparedDrive speeding_ramp(double steered_on, double grip) {
    KnownBody understeering;
    understeering.understeer_gradient_s2pm = 0.006;
    sil::PreparedDrive drive = ramp(4.0, of_good_tyres, understeering);
    drive.largest_parallel_mps2 = 0.0;
    for (sil::RollSample& sample : drive.samples) {
        const double steered = std::clamp((sample.time_s - 1.0) / 6.0, 0.0, 1.0);
        const double sped_up = std::clamp((sample.time_s - 7.0) / 6.0, 0.0, 1.0);
        const double back = std::clamp((16.0 - sample.time_s) / 3.0, 0.0, 1.0);
        sample.steering_wheel_angle_rad =
            1.0 * std::min(steered * (1.0 - steered_on) + sped_up * steered_on, back);
        sample.speed_mps = understeering.speed_mps * (1.0 + sped_up);
        const double square = sample.speed_mps * sample.speed_mps;
        sample.parallel_mps2 =
            std::min(grip, square * sample.steering_wheel_angle_rad / understeering.steering_ratio /
                               (understeering.wheelbase_m + understeering.understeer_gradient_s2pm * square));
        drive.largest_parallel_mps2 = std::max(drive.largest_parallel_mps2, sample.parallel_mps2);
    }
    return drive;
}

// Speed times itself outgrows what it gives in an understeering vehicle: no tyre has reached its limit.
TEST(TyreLimit, IsOpenWhereTheSpeedRises) {
    for (const double steered_on : {0.0, 0.05, 0.1, 0.2}) {
        const sil::PreparedDrive drive = speeding_ramp(steered_on, 100.0);
        EXPECT_FALSE(tyre_limit({drive}, {}).is_shown) << steered_on;
    }
}

TEST(TyreLimit, IsShownWhereTheSpeedRisesAndTheForceDoesNot) {
    EXPECT_TRUE(tyre_limit({speeding_ramp(0.5, 3.0)}, {}).is_shown);
}

TEST(TyreLimit, IsOpenWhereALiftEndedTheRamp) {
    sil::PreparedDrive lifted = ramp(20.0, of_brush_tyres);
    lifted.cut_by_load_transfer = true;
    const sil::TyreLimit limit = tyre_limit({lifted}, {});
    EXPECT_FALSE(limit.is_shown);
    EXPECT_DOUBLE_EQ(limit.largest_mps2, 1.1 * sil::g_mps2);
    // One inner wheel that carries little lifts early, far below what the tyres give.
    sil::PreparedDrive early = ramp(4.0, of_good_tyres);
    early.cut_by_load_transfer = true;
    EXPECT_DOUBLE_EQ(tyre_limit({early}, {}).largest_mps2, 1.1 * sil::g_mps2);
}

TEST(TyreLimit, IsOpenWithoutSteering) {
    sil::PreparedDrive unknown = ramp(20.0, of_brush_tyres);
    unknown.has_steering = false;
    EXPECT_FALSE(tyre_limit({unknown}, {}).is_shown);
    EXPECT_DOUBLE_EQ(tyre_limit({unknown}, {}).largest_mps2, 1.1 * sil::g_mps2);
}

}  // namespace
