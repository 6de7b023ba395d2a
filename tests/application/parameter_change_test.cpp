// Other parameters for a control unit that is running: what it checks its sensors by follows, what it has
// seen stays.
#include "rsi/parameter_change.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "rsi/model/vehicle_lengths.hpp"
#include "tests/access/cut_storage.hpp"
#include "tests/application/bench.hpp"

namespace testing_application {
namespace {

using rsi::monitoring::DiagnosticCode;

rsi::ParameterChange change_to(const rsi::Parameters& to, const rsi::Parameters& from = large_suv()) {
    rsi::ParameterChange change;
    EXPECT_EQ(change.begin(from, to).accepted, 1);
    for (int share = 0; share < 1000 && !change.prepare(); ++share) {
    }
    return change;
}

// Every second sample is higher by so much, as from an accelerometer without a filter.
std::function<Motion(double)> shaken_by(float mps2) {
    return [mps2](double time_s) {
        Motion motion;
        const bool is_odd = (static_cast<int>(time_s * 100.0 + 0.5) % 2) != 0;
        motion.imu.lateral_acceleration_mps2 += is_odd ? mps2 : 0.0F;
        return motion;
    };
}

bool finds_a_jump(const rsi::Parameters& later) {
    Bench bench;
    bench.run_until_ready();
    bench.change(change_to(later));
    bench.drive(shaken_by(2.0F));
    bench.run_for(1.0);
    return bench.diagnostic_memory().active(DiagnosticCode::lateral_acceleration_jump);
}

TEST(AChangedControlUnit, ExpectsTheNoiseOfItsNewSensors) {
    rsi::Parameters noisy = large_suv();
    noisy.accelerometer_noise_mps2 = 2.0F;
    EXPECT_TRUE(finds_a_jump(large_suv()));
    EXPECT_FALSE(finds_a_jump(noisy));
}

// A turn whose force the yaw rate and this vehicle's roll show, and half of which the accelerometer shows:
// what half of the springs would make of that roll.
bool finds_the_accelerometer_alone(const rsi::Parameters& later) {
    const rsi::Parameters stiff = large_suv();
    const float force_mps2 = 8.0F;
    const float roll_rad =
        force_mps2 * stiff.sprung_mass_kg * rsi::roll_arm_m(stiff) / stiff.roll_stiffness_nmprad;
    Bench bench;
    bench.run_until_ready();
    bench.change(change_to(later));
    for (int cycle = 1; cycle <= 200; ++cycle) {  // within a second
        const float share = std::min(0.01F * static_cast<float>(cycle), 1.0F);
        Motion motion;
        motion.imu.lateral_acceleration_mps2 = share * 0.5F * force_mps2;
        motion.imu.roll_rate_deg_per_s = (share < 1.0F) ? roll_rad * 57.29578F : 0.0F;
        motion.roll_angle.roll_angle_deg = share * roll_rad * 57.29578F;
        motion.vehicle_motion.yaw_rate_deg_per_s = share * force_mps2 / (80.0F / 3.6F) * 57.29578F;
        bench.drive(motion);
        bench.run_cycles(1);
    }
    return bench.diagnostic_memory().active(DiagnosticCode::lateral_acceleration_contradicts_yaw_rate) ||
           bench.diagnostic_memory().active(DiagnosticCode::lateral_acceleration_gain);
}

TEST(AChangedControlUnit, HoldsTheForceAgainstTheRollOfItsNewVehicle) {
    rsi::Parameters soft = large_suv();
    soft.roll_stiffness_nmprad *= 0.5F;
    soft.roll_stiffness_cubic_nmprad3 = 0.0F;
    soft.roll_stiffness_quintic_nmprad5 = 0.0F;
    EXPECT_TRUE(finds_the_accelerometer_alone(large_suv()));
    EXPECT_FALSE(finds_the_accelerometer_alone(soft));
}

// The first value of a check that begins anew is accepted.
TEST(AChangedControlUnit, GoesOnWithWhatItHasSeenOfTheSameSensorsInTheSameVehicle) {
    rsi::Parameters earlier = large_suv();
    earlier.warning_on = 0.95F;
    Bench bench;
    bench.run_until_ready();
    bench.change(change_to(earlier));
    Motion motion;
    motion.imu.lateral_acceleration_mps2 = 25.0F;
    bench.drive(motion);
    bench.run_cycles(1);
    EXPECT_NEAR(bench.inputs().lateral_specific_force_mps2, 0.0F, 0.01F);
}

// Initialising iterates over more than a cycle, and reads a memory: neither within a cycle.
class ARefusedControlUnit : public ::testing::Test {
 protected:
    ARefusedControlUnit() {
        rsi::Parameters bad = large_suv();
        bad.warning_on = 1.3F;
        bench_.use_storage(load_);
        EXPECT_EQ(bench_.start_with(bad).accepted, 0);
        bench_.run_for(1.0);
    }
    // The observer's roll angle in a motion that it follows.
    float observed_after(const rsi::ParameterChange& change) {
        bench_.change(change);
        Motion motion;
        motion.imu.roll_rate_deg_per_s = 4.0F;
        bench_.drive(motion);
        bench_.run_for(1.0);
        return bench_.outputs().observed_roll_angle_rad;
    }

    rsi_test::CutStorage load_{};
    Bench bench_{};
};

TEST_F(ARefusedControlUnit, StartsWithAChangeAndReadsNoMemory) {
    EXPECT_EQ(bench_.parameters().track_width_m, 0.0F) << "none is in use";
    EXPECT_TRUE(bench_.diagnostic_memory().confirmed(DiagnosticCode::parameters_refused));
    const int reads = load_.reads();
    bench_.change(change_to(large_suv(), bench_.parameters()));
    bench_.run_for(1.0);
    EXPECT_EQ(load_.reads(), reads);
    EXPECT_EQ(bench_.parameters().track_width_m, large_suv().track_width_m);
    EXPECT_FALSE(bench_.diagnostic_memory().confirmed(DiagnosticCode::parameters_refused));
    EXPECT_EQ(bench_.state(), rsi::can_dbc::RolloverWarning::State::ready);
}

TEST_F(ARefusedControlUnit, TakesTheGainsAsTheyWerePrepared) {
    rsi::ParameterChange begun;
    ASSERT_EQ(begun.begin(bench_.parameters(), large_suv()).accepted, 1);
    ASSERT_FALSE(begun.prepare());
    const rsi::ParameterChange whole = change_to(large_suv(), bench_.parameters());
    const float of_begun = observed_after(begun);
    rsi::Parameters bad = large_suv();
    bad.warning_on = 1.3F;
    ASSERT_EQ(bench_.start_with(bad).accepted, 0);
    bench_.drive(Motion{});
    bench_.run_for(1.0);
    EXPECT_NE(observed_after(whole), of_begun);
    EXPECT_NE(of_begun, 0.0F);
}

}  // namespace
}  // namespace testing_application
