// Which indicator drives the warning, at which level, and towards which side.
#include "rsi/warning/indicator_level.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/output_table.hpp"
#include "tests/rsi/support/nominal.hpp"

namespace indicator_level_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

struct Expected {
    rsi_indicator indicator;
    double level;
    float side;
};

rsi_parameters driven_by(rsi_indicator indicator) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.warning_indicator = indicator;
    return parameters;
}

// Every indicator has another value, and the signs disagree on purpose.
rsi_outputs all_different() {
    rsi_outputs outputs{};
    outputs.rsi = 0.11F;
    outputs.rsi_bank_free = 0.22F;
    outputs.rsi_extended = 0.33F;
    outputs.load_transfer_ratio = -0.44F;
    outputs.predicted_load_transfer_ratio = -0.55F;
    outputs.predicted_rsi = 0.66F;
    outputs.static_stability_level = 0.77F;
    outputs.dynamic_stability_index = 0.405F;  // half of c_w/(2h) = 0.8097
    outputs.dynamic_stability_index_late = -0.81F;
    outputs.energy_margin = -0.25F;
    outputs.rollover_index = 0.88F;
    outputs.time_to_rollover_s = 0.25F;  // the limit is 0.5 s
    outputs.road_parallel_force_mps2 = 2.0F;
    outputs.lateral_acceleration_mps2 = -1.0F;
    return outputs;
}

rsi::IndicatedRisk indicated(const rsi_outputs& outputs, const rsi_parameters& parameters,
                             float roll_angle_rad) {
    return rsi::WarningIndicator{parameters}.evaluate(outputs, roll_angle_rad);
}

TEST(IndicatorLevel, OnlyThePredictedLoadTransferKnowsBothSides) {
    rsi_outputs outputs = all_different();
    outputs.opposite_load_transfer_ratio = 0.41F;
    for (const rsi::IndexOutput& index : rsi::index_outputs) {
        const rsi::IndicatedRisk risk = indicated(outputs, driven_by(index.number), 0.1F);
        const bool knows = index.number == RSI_INDICATOR_PREDICTED_LOAD_TRANSFER;
        EXPECT_EQ(risk.opposite, knows ? 0.41F : 0.0F) << index.number;
        if (knows) {
            EXPECT_LT(risk.direction, 0.0F);  // its own sign, not the roll angle's
        }
    }
}

TEST(IndicatorLevel, EachIndicatorHasItsOwnLevelAndSide) {
    const rsi_outputs outputs = all_different();
    const float roll_angle = -0.1F;
    const std::vector<Expected> all{
        {RSI_INDICATOR_PUBLISHED, 0.11, 1.0F},
        {RSI_INDICATOR_BANK_FREE, 0.22, 1.0F},
        {RSI_INDICATOR_EXTENDED, 0.33, 1.0F},
        {RSI_INDICATOR_LOAD_TRANSFER, 0.44, -1.0F},
        {RSI_INDICATOR_PREDICTED_LOAD_TRANSFER, 0.55, -1.0F},
        {RSI_INDICATOR_PREDICTED_RSI, 0.66, -1.0F},
        {RSI_INDICATOR_STATIC_STABILITY_FACTOR, 0.77, -1.0F},
        {RSI_INDICATOR_DYNAMIC_STABILITY, 0.5002, 1.0F},
        {RSI_INDICATOR_DYNAMIC_STABILITY_LATE, 1.0003, -1.0F},
        {RSI_INDICATOR_ENERGY, 1.25, -1.0F},
        {RSI_INDICATOR_ROLLOVER_INDEX, 0.88, -1.0F},
        {RSI_INDICATOR_TIME_TO_ROLLOVER, 2.0, -1.0F},
    };
    for (const Expected& expected : all) {
        const rsi_parameters parameters = driven_by(expected.indicator);
        EXPECT_NEAR(static_cast<double>(rsi::indicator_level(outputs, parameters)), expected.level, 1e-4)
            << expected.indicator;
        const rsi::IndicatedRisk risk = indicated(outputs, parameters, roll_angle);
        EXPECT_EQ(risk.level, rsi::indicator_level(outputs, parameters)) << expected.indicator;
        EXPECT_EQ(risk.direction < 0.0F, expected.side < 0.0F) << expected.indicator;
    }
}

// `all_different` names the indices one by one; a new row of the table is driven here.
TEST(IndicatorLevel, EveryRowOfTheTableHasTheLevelOfItsScaleAndFallsTowardsTheOutside) {
    const float value = 0.4F;
    for (const rsi::IndexOutput& index : rsi::index_outputs) {
        const rsi_parameters parameters = driven_by(index.number);
        float expected = value;
        if (index.scale == rsi::LevelScale::per_ssf) {
            expected = value / rsi::static_stability_factor(parameters);
        } else if (index.scale == rsi::LevelScale::complement) {
            expected = 1.0F - value;
        } else if (index.scale == rsi::LevelScale::limit_over) {
            expected = parameters.time_to_rollover_limit_s / value;
        }
        for (const float turn : {1.0F, -1.0F}) {
            rsi_outputs outputs{};
            outputs.road_parallel_force_mps2 = outputs.lateral_acceleration_mps2 = turn;
            outputs.predicted_load_transfer_ratio = turn;
            const bool turns = (index.side == rsi::RiskSide::own) || (index.side == rsi::RiskSide::both);
            outputs.*index.member = turns ? turn * value : value;
            const rsi::IndicatedRisk risk = indicated(outputs, parameters, turn);
            EXPECT_FLOAT_EQ(risk.level, expected) << rsi::indicator_choices[index.number];
            EXPECT_GT(risk.direction * turn, 0.0F) << rsi::indicator_choices[index.number];
        }
    }
}

TEST(IndicatorLevel, TheSideIsThatOfItsOwnSignalAndOfNoOther) {
    const auto turned = [](rsi_indicator indicator, float force, float acceleration, float predicted,
                           float roll) {
        rsi_outputs outputs = all_different();
        outputs.road_parallel_force_mps2 = force;
        outputs.lateral_acceleration_mps2 = acceleration;
        outputs.predicted_load_transfer_ratio = predicted;
        return indicated(outputs, driven_by(indicator), roll).direction < 0.0F;
    };
    EXPECT_TRUE(turned(RSI_INDICATOR_EXTENDED, -1.0F, 1.0F, 1.0F, 1.0F));
    EXPECT_FALSE(turned(RSI_INDICATOR_EXTENDED, 1.0F, -1.0F, -1.0F, -1.0F));
    EXPECT_TRUE(turned(RSI_INDICATOR_STATIC_STABILITY_FACTOR, 1.0F, -1.0F, 1.0F, 1.0F));
    EXPECT_FALSE(turned(RSI_INDICATOR_STATIC_STABILITY_FACTOR, -1.0F, 1.0F, -1.0F, -1.0F));
    EXPECT_TRUE(turned(RSI_INDICATOR_PREDICTED_RSI, 1.0F, 1.0F, -1.0F, 1.0F));
    EXPECT_FALSE(turned(RSI_INDICATOR_PREDICTED_RSI, -1.0F, -1.0F, 1.0F, -1.0F));
    EXPECT_TRUE(turned(RSI_INDICATOR_ENERGY, 1.0F, 1.0F, 1.0F, -1.0F));
    EXPECT_FALSE(turned(RSI_INDICATOR_ENERGY, -1.0F, -1.0F, -1.0F, 1.0F));
}

TEST(IndicatorLevel, IsTheSameOnTheOtherSide) {
    const rsi_outputs left = all_different();
    rsi_outputs right = left;
    right.load_transfer_ratio = -left.load_transfer_ratio;
    right.predicted_load_transfer_ratio = -left.predicted_load_transfer_ratio;
    right.dynamic_stability_index = -left.dynamic_stability_index;
    right.dynamic_stability_index_late = -left.dynamic_stability_index_late;
    for (const rsi_indicator indicator :
         {RSI_INDICATOR_LOAD_TRANSFER, RSI_INDICATOR_PREDICTED_LOAD_TRANSFER, RSI_INDICATOR_DYNAMIC_STABILITY,
          RSI_INDICATOR_DYNAMIC_STABILITY_LATE}) {
        const rsi_parameters parameters = driven_by(indicator);
        EXPECT_EQ(rsi::indicator_level(right, parameters), rsi::indicator_level(left, parameters))
            << indicator;
        EXPECT_EQ(indicated(right, parameters, 0.0F).direction, -indicated(left, parameters, 0.0F).direction)
            << indicator;
    }
}

TEST(IndicatorLevel, OneThatIsNotAvailableHasNoLevel) {
    rsi_outputs outputs = all_different();
    outputs.predicted_rsi = nan;
    EXPECT_TRUE(std::isnan(rsi::indicator_level(outputs, driven_by(RSI_INDICATOR_PREDICTED_RSI))));
}

TEST(IndicatorLevel, ATimeToRolloverThatIsNotAvailableHasNoLevel) {
    rsi_outputs outputs = all_different();
    outputs.time_to_rollover_s = nan;
    EXPECT_TRUE(std::isnan(rsi::indicator_level(outputs, driven_by(RSI_INDICATOR_TIME_TO_ROLLOVER))));
}

// Validation refuses such a selection; should one come through nevertheless, nothing is claimed.
TEST(IndicatorLevel, OfASelectionThatDoesNotExistIsNotAvailable) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.warning_indicator = static_cast<std::int32_t>(rsi::index_outputs.size());
    EXPECT_TRUE(std::isnan(rsi::indicator_level(all_different(), parameters)));
    EXPECT_TRUE(std::isnan(indicated(all_different(), parameters, -0.1F).level));
    parameters.warning_indicator = -1;
    EXPECT_TRUE(std::isnan(rsi::indicator_level(all_different(), parameters)));
}

TEST(IndicatorLevel, StaysBetweenZeroAndTwenty) {
    rsi_outputs outputs = all_different();
    outputs.time_to_rollover_s = 0.0F;
    EXPECT_EQ(rsi::indicator_level(outputs, driven_by(RSI_INDICATOR_TIME_TO_ROLLOVER)), 20.0F);
    outputs.energy_margin = 1.0F;
    EXPECT_EQ(rsi::indicator_level(outputs, driven_by(RSI_INDICATOR_ENERGY)), 0.0F);
}

TEST(IndicatorLevel, EndsAtTwentyItself) {
    rsi_parameters parameters = rsi_test::large_suv();
    rsi_outputs outputs{};
    parameters.warning_indicator = RSI_INDICATOR_ENERGY;
    outputs.energy_margin = -20.0F;
    EXPECT_EQ(rsi::indicator_level(outputs, parameters), 20.0F);
    outputs.energy_margin = -18.5F;
    EXPECT_EQ(rsi::indicator_level(outputs, parameters), 19.5F);
}

TEST(IndicatorLevel, ATimeBelowTenMillisecondsCountsAsTen) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.warning_indicator = RSI_INDICATOR_TIME_TO_ROLLOVER;
    parameters.time_to_rollover_limit_s = 0.1F;
    rsi_outputs outputs{};
    outputs.time_to_rollover_s = 0.0F;
    EXPECT_FLOAT_EQ(rsi::indicator_level(outputs, parameters), 10.0F);
}

}  // namespace
}  // namespace indicator_level_test
