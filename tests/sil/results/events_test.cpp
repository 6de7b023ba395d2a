// Events: when they happen, what counts, and what does not.
#include <gtest/gtest.h>

#include <cmath>

#include "sil/results/events.hpp"
#include "sil/results/indices.hpp"

namespace {

constexpr double g_mps2 = 9.80665;
constexpr double ssf = 0.8;

sil::Truth truth_at(double time_s, double acceleration_g = 0.0, double roll_rad = 0.0) {
    sil::Truth truth;
    truth.time_s = time_s;
    truth.lateral_acceleration_mps2 = acceleration_g * g_mps2;
    truth.roll_angle_rad = roll_rad;
    truth.wheel_load_n = {5000.0, 5000.0, 6000.0, 6000.0};
    return truth;
}

sil::Truth truth_with_loads(double time_s, const std::array<double, 4>& loads_n) {
    sil::Truth truth = truth_at(time_s);
    truth.wheel_load_n = loads_n;
    return truth;
}

// These loads for the time that makes a lift-off of it.
void lift(sil::EventObserver& observer, double time_s, const std::array<double, 4>& loads_n) {
    observer.observe(truth_with_loads(time_s, loads_n));
    observer.observe(truth_with_loads(time_s + 0.05, loads_n));
}

sil::EcuOutput output_of(sil::WarningState state, sil::WarningSide side = sil::WarningSide::none) {
    sil::EcuOutput output;
    output.warning().state = state;
    output.warning().side = side;
    return output;
}

TEST(EventObserver, InAQuietRunNothingHappens) {
    sil::EventObserver observer(ssf);
    for (int step = 0; step < 1000; ++step) {
        observer.observe(truth_at(step * 0.001, -0.5, -0.04));
        observer.observe(output_of(sil::WarningState::advisory, sil::WarningSide::left), step * 0.001);
    }
    const sil::RunEvents& events = observer.events();
    EXPECT_FALSE(events.one_wheel_lift);
    EXPECT_FALSE(events.two_wheel_lift);
    EXPECT_FALSE(events.ssf_crossing);
    EXPECT_FALSE(events.warning);
    EXPECT_FALSE(events.judgement.lead_s);
    EXPECT_EQ(events.warning_side, sil::WarningSide::none);
    EXPECT_DOUBLE_EQ(events.largest_lateral_acceleration_mps2, 0.5 * g_mps2);
    EXPECT_EQ(events.final_roll_angle_rad, -0.04);
    EXPECT_DOUBLE_EQ(events.end_time_s, 0.999);
}

TEST(EventObserver, EachAxleHasItsOwnFirstLiftOff) {
    sil::EventObserver observer(ssf);
    observer.observe(truth_with_loads(1.0, {0.0, 5.0, 1.0, 5.0}));
    observer.observe(truth_with_loads(1.2, {1.0, 5.0, 5.0, 0.0}));
    lift(observer, 1.3, {0.0, 5.0, 0.0, 5.0});
    const sil::RunEvents& events = observer.events();
    ASSERT_TRUE(events.front_axle_lift && events.rear_axle_lift && events.one_wheel_lift &&
                events.two_wheel_lift);
    EXPECT_EQ(events.front_axle_lift->time_s, 1.0);
    EXPECT_EQ(events.rear_axle_lift->time_s, 1.2);
    EXPECT_EQ(events.one_wheel_lift->time_s, 1.0);
    EXPECT_EQ(events.two_wheel_lift->time_s, 1.3);
}

TEST(EventObserver, TheLargestLoadTransferIsOfEitherSideAndNotOfAVehicleInTheAir) {
    sil::EventObserver observer(ssf);
    observer.observe(truth_with_loads(1.0, {1.0, 2.0, 1.0, 2.0}));  // 1/3, a left turn
    observer.observe(truth_with_loads(1.1, {3.0, 1.0, 3.0, 1.0}));  // -1/2, a right turn
    observer.observe(truth_with_loads(1.2, {0.0, 0.0, 0.0, 0.0}));
    EXPECT_DOUBLE_EQ(observer.events().judgement.largest_load_transfer_ratio, 0.5);
}

TEST(TrueIndices, TheLoadTransferIsPositiveInALeftTurnAndOneWhereTheSideHasLifted) {
    const sil::Truth truth = truth_with_loads(0.0, {1000.0, 3000.0, 0.0, 4000.0});
    EXPECT_DOUBLE_EQ(sil::true_load_transfer_ratio(truth), 6000.0 / 8000.0);
    EXPECT_DOUBLE_EQ(sil::true_load_transfer_ratio(truth, sil::Axle::front), 0.5);
    EXPECT_DOUBLE_EQ(sil::true_load_transfer_ratio(truth, sil::Axle::rear), 1.0);
    const sil::Truth lifted = truth_with_loads(0.0, {3000.0, 0.0, 4000.0, 0.0});
    EXPECT_DOUBLE_EQ(sil::true_load_transfer_ratio(lifted), -1.0);
    EXPECT_TRUE(std::isnan(sil::true_load_transfer_ratio(truth_with_loads(0.0, {}))));
    EXPECT_DOUBLE_EQ(sil::true_load_transfer_ratio(truth_with_loads(0.0, {0.1, 0.3, 0.1, 0.3})), 0.5);
}

TEST(EventObserver, EveryWheelCanBeTheFirstToLift) {
    for (std::size_t wheel = 0U; wheel < 4U; ++wheel) {
        sil::EventObserver observer(ssf);
        std::array<double, 4> loads_n{1.0, 1.0, 1.0, 1.0};
        observer.observe(truth_with_loads(1.000, loads_n));
        loads_n[wheel] = 0.0;
        observer.observe(truth_with_loads(1.001, loads_n));
        observer.observe(truth_with_loads(1.002, loads_n));
        ASSERT_TRUE(observer.events().one_wheel_lift) << wheel;
        EXPECT_EQ(observer.events().one_wheel_lift->time_s, 1.001);
        EXPECT_FALSE(observer.events().two_wheel_lift);
    }
}

TEST(EventObserver, TwoWheelLiftNeedsBothWheelsOfOneSideAtTheSameTime) {
    sil::EventObserver observer(ssf);
    observer.observe(truth_with_loads(1.0, {0.0, 9.0, 9.0, 0.0}));  // diagonal
    observer.observe(truth_with_loads(1.1, {0.0, 0.0, 9.0, 9.0}));  // front axle
    observer.observe(truth_with_loads(1.2, {9.0, 9.0, 0.0, 9.0}));  // rear left, front left down again
    EXPECT_FALSE(observer.events().two_wheel_lift);
    lift(observer, 1.3, {0.0, 9.0, 0.0, 9.0});
    ASSERT_TRUE(observer.events().two_wheel_lift);
    EXPECT_EQ(observer.events().two_wheel_lift->time_s, 1.3);
    EXPECT_EQ(observer.events().one_wheel_lift->time_s, 1.0);
}

TEST(EventObserver, TwoWheelLiftOnTheRightSideCountsToo) {
    sil::EventObserver observer(ssf);
    lift(observer, 2.0, {9.0, 0.0, 9.0, 0.0});
    ASSERT_TRUE(observer.events().two_wheel_lift);
    EXPECT_EQ(observer.events().two_wheel_lift->time_s, 2.0);
    EXPECT_EQ(observer.events().judgement.falling_side, sil::WarningSide::left);
}

TEST(EventObserver, ALiftThatDoesNotLastIsNoTwoWheelLift) {
    sil::EventObserver observer(ssf);
    observer.observe(truth_with_loads(2.0, {9.0, 0.0, 9.0, 0.0}));
    observer.observe(truth_with_loads(2.049, {9.0, 0.0, 9.0, 0.0}));
    EXPECT_FALSE(observer.events().two_wheel_lift);
    EXPECT_FALSE(observer.events().judgement.lifted);
    observer.observe(truth_with_loads(2.050, {9.0, 0.0, 9.0, 0.0}));
    EXPECT_TRUE(observer.events().two_wheel_lift);
    EXPECT_TRUE(observer.events().judgement.lifted);
}

TEST(EventObserver, LiftBeforeTheStartDoesNotCount) {
    sil::EventObserver observer(ssf, 0.5);
    observer.observe(truth_with_loads(0.499, {0.0, 0.0, 0.0, 0.0}));
    EXPECT_FALSE(observer.events().one_wheel_lift);
    observer.observe(truth_with_loads(0.5, {0.0, 9.0, 9.0, 9.0}));
    ASSERT_TRUE(observer.events().one_wheel_lift);
    EXPECT_EQ(observer.events().one_wheel_lift->time_s, 0.5);
}

TEST(EventObserver, SsfIsCrossedInEitherDirectionAndOnlyTheFirstTimeCounts) {
    for (const double direction : {1.0, -1.0}) {
        sil::EventObserver observer(ssf);
        observer.observe(truth_at(1.0, direction * 0.799, direction * 0.10));
        EXPECT_FALSE(observer.events().ssf_crossing);
        observer.observe(truth_at(1.1, direction * 0.801, direction * 0.11));
        observer.observe(truth_at(1.2, direction * 0.7, direction * 0.12));
        observer.observe(truth_at(1.3, direction * 0.9, direction * 0.13));
        ASSERT_TRUE(observer.events().ssf_crossing);
        EXPECT_EQ(observer.events().ssf_crossing->time_s, 1.1);
        EXPECT_DOUBLE_EQ(observer.events().ssf_crossing->lateral_acceleration_mps2,
                         direction * 0.801 * g_mps2);
        EXPECT_EQ(observer.events().ssf_crossing->roll_angle_rad, direction * 0.11);
        EXPECT_DOUBLE_EQ(observer.events().largest_lateral_acceleration_mps2, 0.9 * g_mps2);
    }
}

TEST(EventObserver, TheSsfItselfIsCrossedAndTheLargestAccelerationIsKept) {
    sil::EventObserver observer(ssf);
    observer.observe(truth_at(1.0, ssf));
    observer.observe(truth_at(1.1, -0.3));
    ASSERT_TRUE(observer.events().ssf_crossing);
    EXPECT_EQ(observer.events().ssf_crossing->time_s, 1.0);
    EXPECT_DOUBLE_EQ(observer.events().largest_lateral_acceleration_mps2, ssf * g_mps2);
}

TEST(EventObserver, BeforeTheFirstTruthNothingIsKnown) {
    sil::EventObserver observer(ssf);
    observer.observe(output_of(sil::WarningState::warning, sil::WarningSide::right), 0.25);
    ASSERT_TRUE(observer.events().warning);
    EXPECT_EQ(observer.events().warning->time_s, 0.25);
    EXPECT_EQ(observer.events().warning->lateral_acceleration_mps2, 0.0);
    EXPECT_EQ(observer.events().warning->roll_angle_rad, 0.0);
    EXPECT_EQ(observer.events().end_time_s, 0.0);
    EXPECT_EQ(observer.events().final_roll_angle_rad, 0.0);
}

TEST(EventObserver, TheFirstWarningCountsWithTheTruthOfItsMoment) {
    sil::EventObserver observer(ssf);
    observer.observe(truth_at(1.683, 0.72, 0.09));
    observer.observe(output_of(sil::WarningState::advisory, sil::WarningSide::left), 1.683);
    EXPECT_FALSE(observer.events().warning);
    observer.observe(output_of(sil::WarningState::warning, sil::WarningSide::right), 1.684);
    observer.observe(truth_at(1.9, 0.79, 0.10));
    observer.observe(output_of(sil::WarningState::warning, sil::WarningSide::left), 1.9);
    ASSERT_TRUE(observer.events().warning);
    EXPECT_EQ(observer.events().warning->time_s, 1.684);
    EXPECT_DOUBLE_EQ(observer.events().warning->lateral_acceleration_mps2, 0.72 * g_mps2);
    EXPECT_EQ(observer.events().warning->roll_angle_rad, 0.09);
    EXPECT_EQ(observer.events().warning_side, sil::WarningSide::right);
}

// warning_judgement_test.cpp covers the lead.
TEST(EventObserver, JudgesTheWarningByTheTrueWheelLoads) {
    sil::EventObserver observer(ssf);
    observer.observe(truth_with_loads(1.0, {1.0, 9.0, 1.0, 9.0}));
    observer.observe(output_of(sil::WarningState::warning, sil::WarningSide::left), 1.0);
    observer.observe(truth_with_loads(1.3, {1.0, 9.0, 1.0, 9.0}));
    observer.observe(output_of(sil::WarningState::warning, sil::WarningSide::right), 1.5);
    lift(observer, 2.0, {0.0, 9.0, 0.0, 9.0});
    const sil::WarningJudgement& judgement = observer.events().judgement;
    EXPECT_DOUBLE_EQ(judgement.lead_s.value(), 0.5);
    EXPECT_EQ(judgement.falling_side, sil::WarningSide::right);
    EXPECT_EQ(observer.events().warning_side, sil::WarningSide::left) << "the first one's, for information";

    sil::EventObserver late(ssf);
    lift(late, 2.0, {0.0, 9.0, 0.0, 9.0});
    late.observe(output_of(sil::WarningState::warning, sil::WarningSide::right), 2.25);
    EXPECT_FALSE(late.events().judgement.lead_s);
    EXPECT_TRUE(late.events().judgement.late);
    EXPECT_EQ(late.events().warning->time_s, 2.25);
}

}  // namespace
