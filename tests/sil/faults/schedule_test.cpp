// When faults are there in a long drive.
#include "sil/studies/faults/fault_schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sil/studies/faults/driven_world.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace faults_test {
namespace {

TEST(FaultSchedule, HasFaultsOfBothSignsAndTwoThatOverlap) {
    sil::FaultSchedule schedule{1U};
    int negative = 0;
    int pairs = 0;
    int overlaps = 0;
    for (int count = 0; count < 400; ++count) {
        schedule.draw(1000U);
        const auto& [first, second] = schedule.faults();
        EXPECT_GE(first.begin, 1100U);
        EXPECT_LE(first.begin, 3000U);
        EXPECT_GT(first.end, first.begin);
        EXPECT_GE(schedule.over(), first.end);
        negative += first.fault.magnitude < 0.0 ? 1 : 0;
        if (schedule.has_two()) {
            ++pairs;
            EXPECT_NE(first.fault.place, second.fault.place);
            EXPECT_GE(schedule.over(), second.end);
            overlaps += second.begin < first.end ? 1 : 0;
        }
    }
    EXPECT_GT(negative, 20);
    EXPECT_GT(pairs, 60);
    EXPECT_GT(overlaps, pairs / 2);
}

TEST(FaultSchedule, IsDrawnTowardsADueWarningOnce) {
    int drawn = 0;
    for (std::uint64_t seed = 0U; seed < 200U; ++seed) {
        sil::FaultSchedule schedule{seed};
        schedule.draw(10000U);
        if (schedule.draw_towards(10600U, 10000U)) {
            ++drawn;
            EXPECT_GE(schedule.begin(), 10300U);
            EXPECT_LE(schedule.begin(), 10600U);
            EXPECT_FALSE(schedule.draw_towards(10700U, 10001U));
        }
    }
    EXPECT_GT(drawn, 140);
    EXPECT_LT(drawn, 180);
}

TEST(FaultSchedule, LeavesAFaultThatHasBegun) {
    sil::FaultSchedule schedule{1U};
    schedule.draw(0U);
    const std::uint64_t at = schedule.begin();
    for (int count = 0; count < 20; ++count) {
        EXPECT_FALSE(schedule.draw_towards(at + 500U, at));
    }
    EXPECT_EQ(schedule.begin(), at);
    EXPECT_FALSE(schedule.is_near(at - 1U));
    EXPECT_TRUE(schedule.is_near(at));
    EXPECT_TRUE(schedule.is_near(schedule.over() + 199U));
    EXPECT_FALSE(schedule.is_near(schedule.over() + 200U));
}

// No value steps when the vehicle comes to a stop or starts: that would be a fault.
TEST(DrivenWorld, StopsAndGoesOnWithoutAStep) {
    const sil::VehicleParameters vehicle = sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/large_suv.toml");
    sil::DrivenWorld world{vehicle, 2U, 300.0};
    double largest_change_mps = 0.0;
    double last_mps = 110.0 / 3.6;
    int standing = 0;
    for (int cycle = 0; cycle < 20000; ++cycle) {
        const auto sample = world.next();
        if (!sample) {
            last_mps = 110.0 / 3.6;
            continue;
        }
        largest_change_mps = std::max(largest_change_mps, std::abs(sample->speed_mps - last_mps));
        last_mps = sample->speed_mps;
        if (world.stands()) {
            ++standing;
            EXPECT_LT(std::abs(sample->speed_mps), 0.5);
        }
    }
    EXPECT_GE(world.stops(), 1U);
    EXPECT_GT(standing, 300);
    EXPECT_LT(largest_change_mps, 1.0);
}

}  // namespace
}  // namespace faults_test
