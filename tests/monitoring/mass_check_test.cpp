// The check of the received vehicle mass: its range, its changes, and the load that driving has shown.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rsi/ecu/monitoring/input_monitor.hpp"
#include "tests/support/large_suv.h"

namespace monitoring_mass_check_test {
namespace {

using rsi::monitoring::DiagnosticCode;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

// Straight on at 30 m/s with a known load; the mass alone is fresh.
class AMass : public ::testing::Test {
 protected:
    AMass() {
        monitor.start(suv);
        inputs = rsi::Inputs{nan, nan, nan, nan, nan, nan, nan, nan, nan};
        inputs.speed_mps = 30.0F;
        before.state = RSI_STATE_READY;
        before.load_excess = 0.0F;
        before.load_excess_deviation = 0.25F;
    }

    void run(int cycles, float factor) {
        inputs.vehicle_mass_kg = suv.unsprung_mass_kg + factor * suv.sprung_mass_kg;
        go_on(cycles);
    }

    // With the same mass.
    void go_on(int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            qualified = monitor.qualify(inputs, {false, false, false}, before, memory);
        }
    }

    void know_the_load(float excess) {
        before.load_excess = excess;
        before.load_excess_deviation = 0.03F;
    }

    bool is_used() const { return qualified.vehicle_mass_kg == inputs.vehicle_mass_kg; }
    bool is_not_used() const { return std::isnan(qualified.vehicle_mass_kg); }
    bool confirmed(DiagnosticCode code) const { return memory.confirmed(code); }

    rsi::Parameters suv{rsi_test_large_suv()};
    rsi::monitoring::InputMonitor monitor;
    rsi::monitoring::DiagnosticMemory memory;
    rsi::Inputs inputs{};
    rsi::Outputs before{};
    rsi::Inputs qualified{};
};

TEST_F(AMass, ThatIsPlausibleIsUsed) {
    for (const float factor : {1.0F, 0.61F, 2.99F}) {
        monitor = {};
        monitor.start(suv);
        run(10, factor);
        EXPECT_TRUE(is_used()) << factor;
    }
    EXPECT_TRUE(memory.no_active_codes());
}

// Most vehicles do not know theirs.
TEST_F(AMass, ThatIsNotAvailableIsNoFault) {
    run(10, nan);
    EXPECT_TRUE(is_not_used());
    EXPECT_TRUE(memory.no_active_codes());
}

// Each check says when it has run: the last one once the load is known.
TEST_F(AMass, IsTestedAsFarAsItCanBeJudged) {
    using rsi::monitoring::set_of;
    const auto tested = [this](float factor) {
        memory = {};
        run(1, factor);
        return memory.tested_codes() & rsi::monitoring::mass_codes;
    };
    EXPECT_EQ(tested(nan), 0U);
    EXPECT_EQ(tested(9.0F), set_of(DiagnosticCode::vehicle_mass_invalid));
    EXPECT_EQ(tested(1.0F), set_of(DiagnosticCode::vehicle_mass_invalid, DiagnosticCode::vehicle_mass_jump));
    know_the_load(0.0F);
    EXPECT_EQ(tested(1.0F), rsi::monitoring::mass_codes);
}

TEST_F(AMass, BeyondWhatTheCalibratedVehicleCanBeIsInvalid) {
    for (const float factor : {0.59F, 3.01F, 30.0F, -0.1F}) {
        run(2, factor);
        EXPECT_TRUE(is_not_used()) << factor;
        EXPECT_FALSE(confirmed(DiagnosticCode::vehicle_mass_invalid)) << factor;
        run(1, factor);
        EXPECT_TRUE(confirmed(DiagnosticCode::vehicle_mass_invalid)) << factor;
        run(5, 1.0F);
        EXPECT_FALSE(confirmed(DiagnosticCode::vehicle_mass_invalid)) << factor;
        EXPECT_TRUE(is_used()) << factor;
    }
}

TEST_F(AMass, ThatChangesWhileTheVehicleMovesIsNotUsedUntilItIsBackOrTheVehicleStands) {
    run(10, 1.0F);
    run(10, 1.04F);  // fuel, an axle that is braked
    EXPECT_TRUE(is_used());
    run(3, 1.1F);
    EXPECT_TRUE(confirmed(DiagnosticCode::vehicle_mass_jump));
    run(1000, 1.1F);
    EXPECT_TRUE(is_not_used());
    EXPECT_TRUE(confirmed(DiagnosticCode::vehicle_mass_jump));
    run(50, 1.04F);
    EXPECT_FALSE(confirmed(DiagnosticCode::vehicle_mass_jump));
    EXPECT_TRUE(is_used());
    run(3, 1.06F);  // nor in small steps
    EXPECT_TRUE(is_not_used());
    run(100, 1.3F);
    inputs.speed_mps = nan;  // which may be any
    run(100, 1.3F);
    EXPECT_TRUE(is_not_used());
    inputs.speed_mps = 0.4F;
    run(50, 1.3F);
    EXPECT_TRUE(is_used());
    inputs.speed_mps = 30.0F;
    run(100, 1.3F);
    EXPECT_TRUE(is_used());
    EXPECT_TRUE(memory.no_active_codes());
}

// The masses of another calibration change no load.
TEST_F(AMass, IsTheSameForAnotherCalibration) {
    run(10, 1.0F);
    suv.sprung_mass_kg *= 1.2F;
    monitor.start(suv);
    go_on(10);
    EXPECT_TRUE(is_used());
    EXPECT_TRUE(memory.no_active_codes());
}

TEST_F(AMass, MayChangeByATwentiethOfTheSprungMass) {
    run(3, 1.0F);
    run(3, 1.048F);
    EXPECT_TRUE(is_used());
    run(1, 1.052F);
    EXPECT_TRUE(is_not_used());
    inputs.speed_mps = 0.51F;
    run(1, 1.052F);
    EXPECT_TRUE(is_not_used());
    inputs.speed_mps = 0.49F;
    run(1, 1.052F);
    EXPECT_TRUE(is_used());
}

TEST_F(AMass, ThatIsGoneIsNotHeldAgainstTheLoad) {
    run(10, 1.5F);
    know_the_load(0.0F);
    before.load_excess_deviation = 0.06F;  // not known well enough yet
    memory = {};
    run(1, 1.5F);
    EXPECT_EQ(memory.tested_codes() & rsi::monitoring::set_of(DiagnosticCode::vehicle_mass_contradicts_load),
              0U);
    know_the_load(0.0F);
    memory = {};
    run(1000, nan);
    EXPECT_TRUE(memory.no_active_codes());
}

TEST_F(AMass, IsNotJudgedBeforeTheStart) {
    monitor = {};
    run(10, 1.0F);
    EXPECT_TRUE(is_not_used());
    EXPECT_TRUE(memory.no_active_codes());
}

TEST_F(AMass, IsNotJudgedWithoutParameters) {
    monitor = {};
    monitor.start(rsi::Parameters{});
    for (int cycle = 0; cycle < 10; ++cycle) {
        inputs.vehicle_mass_kg = (cycle % 2 == 0) ? 0.0F : 2000.0F;
        go_on(1);
        EXPECT_TRUE(is_not_used());
    }
    EXPECT_TRUE(memory.no_active_codes());
}

// A speed that its own check holds back is no stop.
TEST_F(AMass, DoesNotTakeASingleZeroOfTheSpeedForAStop) {
    for (int cycle = 0; cycle < 20; ++cycle) {
        const bool is_other = cycle >= 10;
        inputs.speed_mps = (cycle == 10) ? 0.0F : 30.0F;
        inputs.vehicle_mass_kg = suv.unsprung_mass_kg + (is_other ? 1.5F : 1.0F) * suv.sprung_mass_kg;
        qualified = monitor.qualify(inputs, {false, false, true}, before, memory);
        EXPECT_EQ(is_not_used(), is_other) << cycle;
    }
}

TEST_F(AMass, ThatWasKnownBeforeAStallIsKnownAfterIt) {
    run(10, 1.0F);
    monitor.start(suv);
    run(3, 1.3F);
    EXPECT_TRUE(confirmed(DiagnosticCode::vehicle_mass_jump));
}

TEST_F(AMass, ThatTheLearntLoadRefutesIsNotUsed) {
    run(200, 1.4F);
    EXPECT_TRUE(is_used());  // nothing is known of the load yet
    know_the_load(0.0F);
    run(2, 1.4F);
    EXPECT_FALSE(confirmed(DiagnosticCode::vehicle_mass_contradicts_load));
    run(1, 1.4F);
    EXPECT_TRUE(confirmed(DiagnosticCode::vehicle_mass_contradicts_load));
    EXPECT_TRUE(is_not_used());
    before.load_excess_deviation = 0.2F;  // a stop: nothing is judged
    run(200, 1.4F);
    EXPECT_TRUE(is_not_used());
    know_the_load(0.4F);
    run(100, 1.4F);
    EXPECT_TRUE(is_used());
    EXPECT_FALSE(confirmed(DiagnosticCode::vehicle_mass_contradicts_load));
}

TEST_F(AMass, ThatIsNotThereSetsAndClearsNothing) {
    know_the_load(0.0F);
    run(10, 1.4F);
    ASSERT_TRUE(confirmed(DiagnosticCode::vehicle_mass_contradicts_load));
    run(1000, nan);
    EXPECT_TRUE(confirmed(DiagnosticCode::vehicle_mass_contradicts_load));
}

}  // namespace
}  // namespace monitoring_mass_check_test
