// The second estimator against the full vehicle's truth (24), over every manoeuvre of the catalogue.
#include "sil/studies/accuracy/roll_centre_accuracy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "sil/world/manoeuvres/catalogue.hpp"

namespace rsi_test {
namespace roll_centre_accuracy_test {
namespace {

using sil::accuracy::calibration_of;
using sil::accuracy::record;
using sil::accuracy::RecordedDrive;
using sil::accuracy::RollCentreAccuracy;
using sil::accuracy::SensorQuality;

constexpr std::array<const char*, 2> vehicles{"large_suv", "ordinary_suv"};
constexpr double after_zeroing_g = 0.005;
constexpr double raw_g = 0.03;

// If the nominal height is right to a centimetre already, no estimate from these sensors can be better:
// 0.2 deg of roll noise alone are 0.3 kN m of a side force's moment of 14 kN times one metre.
constexpr double sensor_floor_m = 0.01;

RollCentreAccuracy accuracy(const RecordedDrive& drive, const rsi::Parameters& parameters,
                            const SensorQuality& quality) {
    return sil::accuracy::roll_centre_accuracy(sil::accuracy::evaluate(drive, quality, parameters),
                                               parameters);
}

std::vector<std::string> names_of_all_manoeuvres() {
    std::vector<std::string> names;
    for (const sil::Manoeuvre& manoeuvre : sil::undisturbed_manoeuvres()) {
        names.push_back(manoeuvre.name);
    }
    return names;
}

std::string test_name(std::string name) {
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

TEST(RollCentreHeight, OfTheLargeSuvInTheJTurnHasAtMostHalfTheErrorOfTheConstant) {
    const RecordedDrive drive = record("j-turn-45", "large_suv");
    for (const double sign : {1.0, -1.0}) {
        for (std::uint64_t seed = 1U; seed <= 5U; ++seed) {
            const RollCentreAccuracy result =
                accuracy(drive, calibration_of(drive, RSI_ESTIMATOR_CONSIDER_KALMAN),
                         {true, sign * after_zeroing_g, after_zeroing_g, seed});
            ASSERT_GT(result.cycles, 500);
            EXPECT_LE(result.estimate_rms_m, 0.5 * result.constant_rms_m) << "seed " << seed;
        }
    }
}

// Its nominal height is right to 9 mm in the J-turn, so half of that is below the noise.
TEST(RollCentreHeight, OfTheOrdinarySuvInTheJTurnIsBetterThanTheConstant) {
    const RecordedDrive drive = record("j-turn-45", "ordinary_suv");
    for (std::uint64_t seed = 1U; seed <= 5U; ++seed) {
        const RollCentreAccuracy result =
            accuracy(drive, calibration_of(drive, RSI_ESTIMATOR_CONSIDER_KALMAN),
                     {true, after_zeroing_g, after_zeroing_g, seed});
        ASSERT_GT(result.cycles, 500);
        EXPECT_LE(result.estimate_rms_m, 0.75 * result.constant_rms_m) << "seed " << seed;
    }
}

class EveryManoeuvre : public testing::TestWithParam<std::tuple<const char*, std::string>> {
 protected:
    RecordedDrive drive_{record(std::get<1>(GetParam()), std::get<0>(GetParam()))};
};

TEST_P(EveryManoeuvre, LeavesTheHeightNoWorseThanTheConstantWithARawBias) {
    const rsi::Parameters parameters = calibration_of(drive_, RSI_ESTIMATOR_CONSIDER_KALMAN);
    for (const double sign : {1.0, -1.0}) {
        double mean_square_m2 = 0.0, constant_m = 0.0;
        for (std::uint64_t seed = 1U; seed <= 3U; ++seed) {
            const RollCentreAccuracy result = accuracy(drive_, parameters, {true, sign * raw_g, raw_g, seed});
            mean_square_m2 += result.estimate_rms_m * result.estimate_rms_m / 3.0;
            constant_m = result.constant_rms_m;
        }
        EXPECT_LE(std::sqrt(mean_square_m2), std::max(1.1 * constant_m, sensor_floor_m))
            << "bias " << sign * raw_g << " g, constant " << constant_m;
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryManoeuvre,
                         testing::Combine(testing::ValuesIn(vehicles),
                                          testing::ValuesIn(names_of_all_manoeuvres())),
                         [](const auto& run) {
                             return std::string{std::get<0>(run.param)} + "_" +
                                    test_name(std::get<1>(run.param));
                         });

class EveryVehicle : public testing::TestWithParam<const char*> {};

// (7) without the disturbance term.
TEST_P(EveryVehicle, FollowsTheTrueRollInTheJTurnWithTheEstimatesAlone) {
    const RecordedDrive drive = record("j-turn-45", GetParam());
    const RollCentreAccuracy result = accuracy(drive, calibration_of(drive, RSI_ESTIMATOR_CONSIDER_KALMAN),
                                               {true, after_zeroing_g, after_zeroing_g, 1U});
    EXPECT_LT(result.compensated_roll_rms_deg, 0.2);
}

// The estimator states what it does not know: a stiffness off by 10 % is 1.4 of the deviations that it
// assumes. For any distribution, at most 1/9 of the errors may lie beyond three standard deviations
// (Chebyshev), and of a distribution with one mode at most 4/81 (Vysochanskij and Petunin). The manoeuvres
// are those in which the roll equation holds: no lifted wheel, no rough road.
TEST_P(EveryVehicle, KnowsItsErrorForAStiffnessThatIsOffByTenPerCent) {
    double cycles = 0.0, within = 0.0, normalised = 0.0;
    for (const char* manoeuvre : {"j-turn-45", "slalom", "slow-ramp", "slowly-increasing-steer", "step-steer",
                                  "double-lane-change", "braking-in-turn", "roll-centre-moving"}) {
        const RecordedDrive drive = record(manoeuvre, GetParam());
        for (const float factor : {0.9F, 1.0F, 1.1F}) {
            rsi::Parameters parameters = calibration_of(drive, RSI_ESTIMATOR_CONSIDER_KALMAN);
            parameters.roll_stiffness_nmprad *= factor;
            parameters.roll_stiffness_cubic_nmprad3 *= factor;
            parameters.roll_stiffness_quintic_nmprad5 *= factor;
            const RollCentreAccuracy result =
                accuracy(drive, parameters, {true, after_zeroing_g, after_zeroing_g, 1U});
            EXPECT_GE(result.within_three_deviations, 8.0 / 9.0)
                << manoeuvre << ", stiffness times " << factor;
            cycles += result.cycles;
            within += result.cycles * result.within_three_deviations;
            normalised += result.cycles * result.normalised_square;
        }
    }
    EXPECT_GE(within / cycles, 1.0 - 4.0 / 81.0);
    // Nor may it claim to know nothing: errors of two thirds of the cases come from 10 % where 7 % are
    // assumed.
    EXPECT_GT(normalised / cycles, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Vehicles, EveryVehicle, testing::ValuesIn(vehicles),
                         [](const auto& run) { return std::string{run.param}; });

}  // namespace
}  // namespace roll_centre_accuracy_test
}  // namespace rsi_test
