// The number of steps of a look ahead, which memory has changed: it is bounded where it is used, so that the
// cycle is, too.
#include <gtest/gtest.h>

#include <cstddef>

#include "rsi/prediction/roll_predictor.hpp"
#include "tests/rsi/support/stages.hpp"
#include "tests/support/large_suv.h"
#include "tests/support/memory_damage.hpp"

namespace {

class ADamagedCount : public ::testing::Test {
 protected:
    void SetUp() override {
        response.init(parameters);
        motion.road_parallel_force_mps2 = 2.0F;
        motion.road_normal_force_mps2 = 9.8F;
        motion.road_parallel_force_rate_mps3 = 5.0F;
        ASSERT_TRUE(response.update(motion, demand));
    }

    static rsi::Parameters responding() {
        rsi::Parameters parameters = rsi_test_large_suv();
        parameters.lateral_response_frequency_radps = 3.0F;  // slow: the load transfer still grows at the end
        parameters.lateral_response_damping = 0.7F;
        parameters.response_margin_per_s = 0.0F;
        return parameters;
    }

    rsi::RollPredictor with_horizon(float horizon_s) const {
        rsi::Parameters with = parameters;
        with.response_horizon_s = horizon_s;
        return rsi::RollPredictor{with};
    }

    float ahead(const rsi::RollPredictor& predictor) const {
        const rsi::TransferredLoad load =
            rsi::transferred_load(vehicle, parameters.load_transfer_inertial_weight, motion);
        return predictor
            .evaluate(vehicle, motion, load, demand, response.response, &response.target, 0.0F, 0.0F)
            .load_transfer_ratio;
    }

    const rsi::Parameters parameters = responding();
    const rsi::DemandedForce demand{0.0F, 8.0F, 8.0F, true};
    const rsi::Vehicle vehicle{parameters};
    rsi_test::LateralResponse response;
    rsi::RollMotion motion;
};

TEST_F(ADamagedCount, OfTheStepsAheadIsTakenForTheLongestHorizon) {
    const rsi::RollPredictor sound = with_horizon(0.2F);
    const float largest = ahead(with_horizon(0.5F));
    ASSERT_GT(largest, ahead(with_horizon(0.48F)));  // all 13 steps
    int as_the_longest = 0;
    for (std::size_t byte = 0U; byte < sizeof sound; ++byte) {
        for (unsigned bit = 0U; bit < 8U; ++bit) {
            rsi::RollPredictor damaged = sound;
            rsi_test::flip(damaged, byte, bit);
            as_the_longest += (ahead(damaged) == largest) ? 1 : 0;
        }
    }
    EXPECT_GE(as_the_longest, 27);  // of the 32 bits of the count, those from 16 on
}

}  // namespace
