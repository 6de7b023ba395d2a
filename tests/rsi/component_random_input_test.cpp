// With any input bits, the component never gives a number that is not one, and never leaves its ranges.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "rsi/component.hpp"
#include "rsi/output_table.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/output_fields.hpp"
#include "tests/rsi/support/recorded_like_signals.hpp"

namespace component_random_input_test {
namespace {

using rsi_test::Noise;

struct InputRange {
    float rsi_inputs::* field;
    float limit;
};

constexpr InputRange input_ranges[] = {
    {&rsi_inputs::lateral_specific_force_mps2, 60.0F},
    {&rsi_inputs::vertical_specific_force_mps2, 60.0F},
    {&rsi_inputs::roll_rate_radps, 10.0F},
    {&rsi_inputs::roll_angle_rad, 2.2F},
    {&rsi_inputs::yaw_rate_radps, 10.0F},
    {&rsi_inputs::bank_angle_rad, 0.8F},
    {&rsi_inputs::speed_mps, 120.0F},
    {&rsi_inputs::steering_wheel_angle_rad, 30.0F},
    {&rsi_inputs::vehicle_mass_kg, 7000.0F},
};

float of_bits(std::uint32_t bits) {
    float value = 0.0F;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
}

// Mostly values in range, so that the algorithm is reached; its limits, tiny values and any bits between.
float hostile(Noise& noise, float limit) {
    const double choice = noise.unit();
    const float sign = (noise.unit() < 0.5) ? -1.0F : 1.0F;
    if (choice < 0.02) {
        return of_bits(noise.bits());
    }
    if (choice < 0.25) {
        return sign * limit;
    }
    if (choice < 0.35) {
        return 0.0F;
    }
    if (choice < 0.40) {
        return sign * of_bits(noise.bits() & 0x007FFFFFU);  // subnormal
    }
    if (choice < 0.70) {
        return sign * 0.1F * limit * static_cast<float>(noise.unit());
    }
    return sign * limit * static_cast<float>(noise.unit());
}

struct Outcome {
    int available{0};
    int warnings{0};
};

Outcome survive(const rsi_parameters& parameters, std::uint64_t seed, int steps) {
    rsi::Component component;
    EXPECT_EQ(component.init(parameters).accepted, 1);
    Noise noise(seed);
    Outcome outcome;
    rsi_inputs inputs{};
    for (int k = 0; k < steps; ++k) {
        const bool hold = noise.unit() < 0.3;  // the same value twice is a pattern too
        for (const InputRange& range : input_ranges) {
            if (!hold) {
                inputs.*range.field = hostile(noise, range.limit);
            }
        }
        rsi_outputs outputs{};
        component.step(inputs, outputs);
        const bool numbers_good = rsi_test::all_finite(outputs) && (outputs.rsi >= 0.0F) &&
                                  (outputs.rsi <= 1.0F) && (outputs.rsi_bank_free >= 0.0F) &&
                                  (outputs.rsi_bank_free <= 20.0F) &&
                                  (std::fabs(outputs.lateral_acceleration_threshold_mps2) > 0.4F) &&
                                  (outputs.road_normal_force_mps2 > 0.98F) &&
                                  (std::fabs(outputs.fixed_model_roll_angle_rad) <= 0.5F) &&
                                  (std::fabs(outputs.compensated_roll_angle_rad) <= 0.5F);
        const bool side_named = outputs.side != RSI_SIDE_NONE;
        const bool risk_named = (outputs.state == RSI_STATE_ADVISORY) || (outputs.state == RSI_STATE_WARNING);
        // A held state without risk names no side.
        const bool must_be_named = risk_named && (outputs.warning_level >= parameters.advisory_on);
        const bool good =
            (!side_named || risk_named) && (side_named || !must_be_named) &&
            ((outputs.state == RSI_STATE_UNAVAILABLE) ? (numbers_good || rsi_test::all_not_available(outputs))
                                                      : numbers_good);
        if (!good) {
            for (const rsi::NumberOutput& field : rsi::number_outputs) {
                ADD_FAILURE() << "step " << k << ", state " << outputs.state << ", " << field.name << " = "
                              << outputs.*field.member;
            }
            return outcome;
        }
        outcome.available += (outputs.state != RSI_STATE_UNAVAILABLE) ? 1 : 0;
        outcome.warnings += (outputs.state == RSI_STATE_WARNING) ? 1 : 0;
    }
    return outcome;
}

rsi_parameters immediate() {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.imu_x_m = 1.0F;
    parameters.imu_y_m = -0.5F;
    parameters.imu_z_m = 0.5F;
    parameters.recovery_s = 0.0F;
    parameters.warning_hold_s = 0.0F;
    parameters.advisory_hold_s = 0.0F;
    return parameters;
}

TEST(ComponentUnderRandomInput, AMillionStepsOfAnythingGiveNumbersInRange) {
    const Outcome outcome = survive(immediate(), 53U, 1000000);
    EXPECT_GT(outcome.available, 500000);
    EXPECT_LT(outcome.available, 1000000);
    EXPECT_GT(outcome.warnings, 10000);
}

TEST(ComponentUnderRandomInput, AnAngleAgainstTheHorizonGivesNumbersInRangeToo) {
    rsi_parameters parameters = immediate();
    parameters.roll_angle_reference = RSI_ROLL_AGAINST_HORIZON;
    const Outcome outcome = survive(parameters, 61U, 200000);
    EXPECT_GT(outcome.available, 100000);
    EXPECT_LT(outcome.available, 200000);
    EXPECT_GT(outcome.warnings, 2000);
}

TEST(ComponentUnderRandomInput, EveryCalibrationThatIsAdmittedSurvives) {
    Noise noise(59U);
    int tried = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        rsi_parameters parameters = immediate();
        for (const rsi::ParameterField& field : rsi::parameter_fields) {
            const double choice = noise.unit();
            if (choice < 0.2) {
                parameters.*field.member = field.minimum;
            } else if (choice < 0.4) {
                parameters.*field.member = field.maximum;
            } else if (choice < 0.6) {
                parameters.*field.member =
                    field.minimum + static_cast<float>(noise.unit()) * (field.maximum - field.minimum);
            }
        }
        parameters.warning_indicator = static_cast<std::int32_t>(noise.bits() % rsi::index_outputs.size());
        parameters.recovery_s = 0.0F;
        // The rules between fields would refuse most of them otherwise.
        parameters.advisory_off = parameters.warning_off = 0.5F;
        parameters.advisory_on = 0.6F;
        parameters.warning_on = 0.9F;
        if (rsi::validate(parameters).accepted == 0) {
            continue;
        }
        ++tried;
        survive(parameters, 1000U + static_cast<std::uint64_t>(trial), 3000);
        parameters.roll_angle_reference = RSI_ROLL_AGAINST_HORIZON;
        survive(parameters, 5000U + static_cast<std::uint64_t>(trial), 1000);
        ASSERT_FALSE(HasFailure()) << "trial " << trial;
    }
    EXPECT_GT(tried, 100);
}

}  // namespace
}  // namespace component_random_input_test
