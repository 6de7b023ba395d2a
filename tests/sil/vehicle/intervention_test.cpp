// Intervention: begins after its delay, comes and goes by its ramp, and does what its kind says.
#include "sil/world/manoeuvres/intervention.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "scenario.hpp"

namespace intervention_test {
namespace {

constexpr double step_s = 0.001;

sil::DriverCommand straight_at_speed(double) {
    return {1.0, sil::SpeedPolicy::held};
}

// The commands of two seconds, one a step, of an intervention that is demanded from 0.5 s to 1 s.
std::vector<sil::DriverCommand> commands(const sil::Intervention& intervention) {
    sil::InterventionEffect effect{intervention, scenario::van()};
    std::vector<sil::DriverCommand> all;
    for (int step = 0; step < 2000; ++step) {
        const double time_s = step * step_s;
        effect.demand(time_s > 0.4999 && time_s < 0.9999, time_s);
        all.push_back(effect.changed(straight_at_speed(time_s), time_s));
    }
    return all;
}

TEST(Intervention, BrakesAfterItsDelayByItsRampAndLetsGoTheSameWay) {
    const auto all = commands({sil::InterventionKind::brake, 0.1, 0.2, 4.0, 0.0});
    const double whole = all[999].brake;
    EXPECT_EQ(all[599].brake, 0.0);
    EXPECT_GT(all[602].brake, 0.0);
    EXPECT_NEAR(all[700].brake, 0.5 * whole, 0.02 * whole);
    EXPECT_NEAR(all[801].brake, whole, 1.0e-9);
    EXPECT_EQ(all[1099].brake, whole);
    EXPECT_NEAR(all[1200].brake, 0.5 * whole, 0.02 * whole);
    EXPECT_EQ(all[1302].brake, 0.0);
    EXPECT_EQ(all[599].speed_policy, sil::SpeedPolicy::held);
    EXPECT_EQ(all[700].speed_policy, sil::SpeedPolicy::off_throttle);
    EXPECT_EQ(all[1302].speed_policy, sil::SpeedPolicy::held);
    for (const sil::DriverCommand& command : all) {
        EXPECT_EQ(command.steering_wheel_angle_rad, 1.0);
    }
}

TEST(Intervention, OfADriverTurnsBackTheShareOfTheHandwheelAngleAndDoesNotBrake) {
    const auto all = commands({sil::InterventionKind::driver, 0.3, 0.0, 0.0, 0.75});
    EXPECT_EQ(all[798].steering_wheel_angle_rad, 1.0);
    EXPECT_EQ(all[798].speed_policy, sil::SpeedPolicy::held);
    EXPECT_EQ(all[801].steering_wheel_angle_rad, 0.25);
    EXPECT_EQ(all[801].speed_policy, sil::SpeedPolicy::off_throttle);
    EXPECT_EQ(all[1302].steering_wheel_angle_rad, 1.0);
    for (const sil::DriverCommand& command : all) {
        EXPECT_EQ(command.brake, 0.0);
    }
}

TEST(Intervention, LeavesTheCommandAloneUntilItIsDemandedAndLongerThanItsDelay) {
    sil::InterventionEffect effect{{sil::InterventionKind::brake, 0.2, 0.0, 4.0, 0.0}, scenario::van()};
    for (int step = 0; step < 1000; ++step) {
        const double time_s = step * step_s;
        effect.demand(step >= 900, time_s);
        EXPECT_EQ(effect.changed({0.3}, time_s).brake, 0.0);
    }
    EXPECT_EQ(effect.times(), 0U);
    EXPECT_EQ(effect.duration_s(), 0.0);
}

TEST(Intervention, DelaysADemandThatIsShorterThanTheDelay) {
    sil::InterventionEffect effect{{sil::InterventionKind::brake, 0.5, 0.0, 4.0, 0.0}, scenario::van()};
    int braked = 0;
    for (int step = 0; step < 2000; ++step) {
        const double time_s = step * step_s;
        effect.demand(step >= 100 && step < 200, time_s);
        braked += effect.changed({0.0}, time_s).brake > 0.0 ? 1 : 0;
    }
    EXPECT_EQ(braked, 100);
    EXPECT_EQ(effect.times(), 1U);
    EXPECT_NEAR(effect.duration_s(), 0.1, 1.0e-9);
}

TEST(Intervention, BrakesNoLessThanTheDriverAndNeverMoreThanThereIs) {
    sil::InterventionEffect gentle{{sil::InterventionKind::brake, 0.0, 0.0, 1.0, 0.0}, scenario::van()};
    gentle.demand(true, 0.0);
    EXPECT_EQ(gentle.changed({0.0, sil::SpeedPolicy::held, 0.9}, 0.0).brake, 0.9);
    sil::InterventionEffect hard{{sil::InterventionKind::brake, 0.0, 0.0, 100.0, 0.0}, scenario::van()};
    hard.demand(true, 0.0);
    EXPECT_EQ(hard.changed({0.0}, 0.0).brake, 1.0);
}

TEST(Intervention, GivesItsDecelerationOnAStraightRoad) {
    for (const sil::VehicleParameters& vehicle : {scenario::large_suv(), scenario::van()}) {
        sil::ManoeuvreRun run{vehicle,
                              scenario::manoeuvre(90.0, 2.0, [](double) { return sil::DriverCommand{}; })};
        run.add_intervention({sil::InterventionKind::brake, 0.1, 0.2, 4.0, 0.0});
        run.demand_intervention(true);
        double speed_at_1_s_mps = 0.0;
        while (!run.finished()) {
            run.step();
            speed_at_1_s_mps = run.truth().time_s < 1.0005 ? run.truth().speed_mps : speed_at_1_s_mps;
        }
        // Drag and the engine are there, too.
        EXPECT_NEAR(speed_at_1_s_mps - run.truth().speed_mps, 4.5, 0.5);
        EXPECT_EQ(run.intervention()->times(), 1U);
    }
}

TEST(Intervention, IsCopiedWithItsRun) {
    sil::ManoeuvreRun run{scenario::van(),
                          scenario::manoeuvre(90.0, 1.0, [](double) { return sil::DriverCommand{}; })};
    run.add_intervention({sil::InterventionKind::brake, 0.2, 0.1, 4.0, 0.0});
    run.demand_intervention(true);
    for (int step = 0; step < 250; ++step) {
        run.step();
    }
    sil::ManoeuvreRun other{run};
    run.step();
    other.step();
    EXPECT_GT(other.intervention()->effect(), 0.0);
    EXPECT_EQ(other.intervention()->effect(), run.intervention()->effect());
    EXPECT_EQ(other.truth().speed_mps, run.truth().speed_mps);
}

}  // namespace
}  // namespace intervention_test
