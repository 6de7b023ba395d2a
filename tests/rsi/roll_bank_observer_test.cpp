// The observer of roll angle and bank, against vehicles that obey its equations exactly.
#include "rsi/measurement/roll_bank_observer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rsi/measurement/roll_sensor_check.hpp"
#include "rsi/parameters.hpp"
#include "tests/rsi/support/banked_drive.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/recorded_like_signals.hpp"
#include "tests/rsi/support/stages.hpp"

namespace roll_bank_observer_test {
namespace {

using rsi_test::Drive;
using rsi_test::RollingVehicle;

constexpr double degrees_per_radian = 180.0 / rsi_test::pi;
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

void show(const RollingVehicle& vehicle, rsi_test::RollBankObserver& observer) {
    const rsi_inputs inputs = vehicle.inputs();
    observer.update(inputs.lateral_specific_force_mps2, inputs.roll_rate_radps, inputs.yaw_rate_radps,
                    inputs.speed_mps);
}

struct Errors {
    double roll_deg{0.0};  // largest
    double bank_deg{0.0};
};

Errors largest_errors(const Drive& drive, double from_s, double to_s) {
    const rsi_parameters parameters = rsi_test::large_suv();
    RollingVehicle vehicle{parameters, drive};
    rsi_test::RollBankObserver observer;
    observer.init(parameters);
    Errors errors;
    for (int k = 1; k <= std::lround(100.0 * to_s); ++k) {
        vehicle.advance_10_ms();
        show(vehicle, observer);
        if (0.01 * k < from_s) {
            continue;
        }
        EXPECT_TRUE(observer.roll_known()) << 0.01 * k;
        EXPECT_TRUE(observer.bank_known()) << 0.01 * k;
        errors.roll_deg = std::fmax(
            errors.roll_deg, degrees_per_radian * std::fabs(static_cast<double>(observer.roll_angle_rad()) -
                                                            vehicle.roll_angle_rad()));
        errors.bank_deg = std::fmax(
            errors.bank_deg, degrees_per_radian * std::fabs(static_cast<double>(observer.bank_angle_rad()) -
                                                            vehicle.bank_angle_rad()));
    }
    return errors;
}

TEST(RollBankObserver, FollowsTheRollOfASlalomOnALevelRoad) {
    Drive drive;
    drive.largest_acceleration_mps2 = 5.0;  // rolls to more than five degrees
    const Errors errors = largest_errors(drive, 1.0, 20.0);
    EXPECT_LT(errors.roll_deg, 0.15);
    EXPECT_LT(errors.bank_deg, 0.5);
}

TEST(RollBankObserver, FindsABankAndTakesItForNoRoll) {
    for (const double direction : {1.0, -1.0}) {
        Drive drive;
        drive.bank_rad = direction * 6.0 / degrees_per_radian;
        const Errors settled = largest_errors(drive, 12.0, 20.0);
        EXPECT_LT(settled.roll_deg, 0.05);
        EXPECT_LT(settled.bank_deg, 0.2);
        EXPECT_LT(largest_errors(drive, 1.0, 20.0).roll_deg, 0.9);  // while the bank rises by 3 deg/s
    }
}

TEST(RollBankObserver, AGyroBiasOfAFifthOfADegreePerSecondCostsLittleRoll) {
    Drive drive;
    drive.gyro_bias_radps = 0.2 / degrees_per_radian;
    const Errors errors = largest_errors(drive, 5.0, 20.0);
    EXPECT_LT(errors.roll_deg, 0.2);
    EXPECT_LT(errors.bank_deg, 1.0);
}

TEST(RollBankObserver, KnowsNothingAtTheStartAndTheRollWithinAFifthOfASecond) {
    const rsi_parameters parameters = rsi_test::large_suv();
    RollingVehicle vehicle{parameters, Drive{}};
    rsi_test::RollBankObserver observer;
    observer.init(parameters);
    EXPECT_FALSE(observer.roll_known());
    show(vehicle, observer);
    EXPECT_FALSE(observer.roll_known());
    EXPECT_FALSE(observer.bank_known());
    for (int k = 0; k < 20; ++k) {
        show(vehicle, observer);
    }
    EXPECT_TRUE(observer.roll_known());
    observer.reset();
    EXPECT_FALSE(observer.roll_known());
}

TEST(RollBankObserver, KnowsNothingRoughlyEitherBeforeItsFirstSample) {
    RollingVehicle vehicle{rsi_test::large_suv(), Drive{}};
    rsi_test::RollBankObserver observer;
    observer.init(rsi_test::large_suv());
    EXPECT_FALSE(observer.roll_roughly_known());
    for (int k = 0; k < 100; ++k) {
        vehicle.advance_10_ms();
        show(vehicle, observer);
    }
    EXPECT_TRUE(observer.roll_roughly_known());
    observer.reset();
    EXPECT_FALSE(observer.roll_roughly_known());
}

TEST(RollBankObserver, BelowFiveMetresASecondTheRollStaysKnownAndTheBankIsForgottenInTheEnd) {
    rsi_test::RollBankObserver observer;
    observer.init(rsi_test::large_suv());
    const auto bank_force = static_cast<float>(rsi_test::gravity_mps2 * std::sin(0.05));
    for (int k = 0; k < 1000; ++k) {
        observer.update(bank_force, 0.0F, 0.0F, 20.0F);
    }
    const float bank = observer.bank_angle_rad();
    ASSERT_GT(bank, 0.03F);
    ASSERT_TRUE(observer.bank_known());
    for (int k = 0; k < 100; ++k) {
        observer.update(bank_force, 0.0F, 0.0F, 4.0F);
    }
    EXPECT_TRUE(observer.bank_known());
    EXPECT_NEAR(observer.bank_angle_rad(), bank, 0.005F);
    for (int k = 0; k < 6000; ++k) {
        observer.update(bank_force, 0.0F, 0.0F, 0.0F);
    }
    EXPECT_TRUE(observer.roll_known());
    EXPECT_FALSE(observer.bank_known());
}

TEST(RollBankObserver, FollowsTheGyroWhileTheVehicleTipsOver) {
    rsi_test::RollBankObserver observer;
    observer.init(rsi_test::large_suv());
    for (int k = 0; k < 100; ++k) {
        observer.update(0.0F, 0.0F, 0.0F, 25.0F);
    }
    EXPECT_FALSE(observer.tipped());
    for (int k = 0; k < 150; ++k) {  // 1 rad at a steady rate, more force than the standing vehicle bears
        observer.update(9.0F, 1.0F / 1.5F, 0.3F, 25.0F);
    }
    EXPECT_TRUE(observer.tipped());
    EXPECT_TRUE(observer.roll_known());
    EXPECT_NEAR(observer.roll_angle_rad(), 1.0F, 0.1F);
    for (int k = 0; k < 150; ++k) {  // and back
        observer.update(5.0F, -1.0F / 1.5F, 0.3F, 25.0F);
    }
    for (int k = 0; k < 100; ++k) {
        observer.update(0.0F, 0.0F, 0.0F, 25.0F);
    }
    EXPECT_FALSE(observer.tipped());
    EXPECT_NEAR(observer.roll_angle_rad(), 0.0F, 0.005F);
}

TEST(RollBankObserver, MirroredSignalsGiveTheMirroredAnglesBitForBit) {
    rsi_test::RollBankObserver left;
    rsi_test::RollBankObserver right;
    left.init(rsi_test::large_suv());
    right.init(rsi_test::large_suv());
    rsi_test::Noise noise(5U);
    for (int k = 0; k < 3000; ++k) {
        const auto force = static_cast<float>(noise(6.0));
        const auto p = static_cast<float>(noise(0.3));
        const auto r = static_cast<float>(noise(0.3));
        left.update(force, p, r, 20.0F);
        right.update(-force, -p, -r, 20.0F);
        ASSERT_EQ(left.roll_angle_rad(), -right.roll_angle_rad()) << k;
        ASSERT_EQ(left.bank_angle_rad(), -right.bank_angle_rad()) << k;
    }
}

TEST(RollBankObserver, StaysFiniteAndBoundedUnderAnyInputsWithAnyAdmittedCalibration) {
    rsi_test::Noise noise(11U);
    int tried = 0;
    while (tried < 200) {
        rsi_parameters parameters = rsi_test::large_suv();
        for (const rsi::ParameterField& field : rsi::parameter_fields) {
            if (noise.unit() < 0.3) {
                const auto share = static_cast<float>(noise.unit() * noise.unit() * noise.unit());
                parameters.*field.member = field.minimum + share * (field.maximum - field.minimum);
            }
        }
        if (rsi::validate(parameters).accepted == 0) {
            parameters = rsi_test::large_suv();
        }
        ++tried;
        rsi_test::RollBankObserver observer;
        observer.init(parameters);
        for (int k = 0; k < 500; ++k) {
            observer.update(static_cast<float>(noise(30.0)), static_cast<float>(noise(5.0)),
                            static_cast<float>(noise(5.0)), static_cast<float>(noise(80.0)));
            ASSERT_LE(std::fabs(observer.roll_angle_rad()), 1.58F) << tried << ", " << k;
            ASSERT_LE(std::fabs(observer.bank_angle_rad()), 0.51F) << tried << ", " << k;
        }
    }
}

TEST(RollBankObserver, ANumberThatIsNotFiniteStartsItAnewAndLeavesNoTrace) {
    for (const float bad : {nan, infinity, -infinity}) {
        for (int which = 0; which < 4; ++which) {
            rsi_test::RollBankObserver observer;
            observer.init(rsi_test::large_suv());
            for (int k = 0; k < 100; ++k) {
                observer.update(2.0F, 0.1F, 0.1F, 20.0F);
            }
            ASSERT_TRUE(observer.roll_known());
            float signals[4] = {2.0F, 0.1F, 0.1F, 20.0F};
            signals[which] = bad;
            observer.update(signals[0], signals[1], signals[2], signals[3]);
            EXPECT_TRUE(std::isfinite(observer.roll_angle_rad()) || !observer.roll_known());
            for (int k = 0; k < 1000; ++k) {
                observer.update(0.0F, 0.0F, 0.0F, 20.0F);
            }
            EXPECT_TRUE(observer.roll_known()) << which;
            EXPECT_NEAR(observer.roll_angle_rad(), 0.0F, 1.0e-3F) << which;
        }
    }
}

TEST(RollSensorCheck, NeedsTheWholeTimeToSpeakAndToFallSilent) {
    rsi_test::RollSensorCheck check{rsi_test::large_suv()};  // 0.05 rad for 0.3 s
    const auto repeat = [&check](int samples, float difference_rad) {
        for (int k = 0; k < samples; ++k) {
            check.update(difference_rad);
        }
        return check.disagrees();
    };
    EXPECT_FALSE(repeat(1000, 0.049F));
    EXPECT_FALSE(repeat(30, -0.051F));
    EXPECT_FALSE(repeat(1, 0.0F));  // interrupted
    EXPECT_FALSE(repeat(30, 0.051F));
    EXPECT_TRUE(repeat(1, 0.051F));
    EXPECT_TRUE(repeat(1000, 0.026F));  // closer, but not by half
    EXPECT_TRUE(repeat(30, 0.024F));
    EXPECT_FALSE(repeat(1, 0.024F));
}

TEST(RollSensorCheck, SpeaksAfterTheSameTimeOnEitherSideAndFromTheStart) {
    for (const float side : {1.0F, -1.0F}) {
        rsi_test::RollSensorCheck check{rsi_test::large_suv()};
        for (int after_reset = 0; after_reset < 2; ++after_reset) {
            for (int k = 0; k < 30; ++k) {
                check.update(side * 0.051F);
                EXPECT_FALSE(check.disagrees()) << side << ' ' << k;
            }
            check.update(side * 0.051F);
            EXPECT_TRUE(check.disagrees()) << side;
            for (int k = 0; k < 100; ++k) {
                check.update(side * 0.026F);  // closer, but not by half
            }
            EXPECT_TRUE(check.disagrees()) << side;
            check.reset();
            EXPECT_FALSE(check.disagrees());
        }
    }
}

TEST(RollSensorCheck, CountsAnewAfterEachChange) {
    rsi_test::RollSensorCheck check{rsi_test::large_suv()};
    for (int change = 0; change < 4; ++change) {
        const bool before = (change % 2) != 0;
        const float difference_rad = before ? 0.024F : 0.051F;
        for (int k = 0; k < 30; ++k) {
            check.update(difference_rad);
            EXPECT_EQ(check.disagrees(), before) << change << ' ' << k;
        }
        check.update(difference_rad);
        EXPECT_EQ(check.disagrees(), !before) << change;
    }
}

TEST(RollBankObserver, KeepsItsAngleWithinAQuarterTurnWhileItTips) {
    for (const float side : {1.0F, -1.0F}) {
        rsi_test::RollBankObserver observer;
        observer.init(rsi_test::large_suv());
        float largest = 0.0F;
        for (int k = 0; k < 300; ++k) {
            const float rate_radps = (k < 100) ? 0.0F : 3.0F;
            observer.update(side * ((k < 100) ? 0.0F : 12.0F), side * rate_radps, 0.0F, 20.0F);
            largest = std::fmax(largest, side * observer.roll_angle_rad());
            ASSERT_LE(std::fabs(observer.roll_angle_rad()), 1.57F);
        }
        EXPECT_EQ(largest, 1.57F);
    }
}

// Tipping ends where the suspension would hold the body at its angle, and no sooner.
TEST(RollBankObserver, AVehicleTipsUntilItsBodyIsBackWhereTheSuspensionHoldsIt) {
    for (const float side : {1.0F, -1.0F}) {
        rsi_test::RollBankObserver observer;
        observer.init(rsi_test::large_suv());
        const auto drive = [&observer, side](int samples, float force_mps2) {
            for (int k = 0; k < samples; ++k) {
                observer.update(side * force_mps2, 0.0F, side * force_mps2 / 20.0F, 20.0F);
            }
        };
        drive(200, 3.0F);
        ASSERT_NEAR(side * observer.roll_angle_rad(), 0.05F, 0.02F);
        ASSERT_FALSE(observer.tipped());
        drive(2, 8.5F);
        EXPECT_TRUE(observer.tipped());
        drive(20, 2.7F);
        EXPECT_TRUE(observer.tipped());  // a little less force than holds it there
        drive(2, 3.6F);
        EXPECT_FALSE(observer.tipped());
    }
}

// Tipped by a force that was none, for example: a body on two wheels falls back without one.
TEST(RollBankObserver, AVehicleWithoutHalfTheForceForASecondHasNotTipped) {
    for (const float side : {1.0F, -1.0F}) {
        for (const float force_mps2 : {-3.5F, 0.0F, 3.5F, -4.5F, 4.5F}) {  // 8.1 tip it
            rsi_test::RollBankObserver observer;
            observer.init(rsi_test::large_suv());
            const auto drive = [&observer, side](int samples, float force, float rate_radps) {
                for (int k = 0; k < samples; ++k) {
                    observer.update(side * force, side * rate_radps, 0.0F, 0.0F);
                }
            };
            drive(200, 0.0F, 0.0F);
            drive(60, 9.0F, 1.0F);
            ASSERT_TRUE(observer.tipped());
            drive(99, force_mps2, 0.0F);
            EXPECT_TRUE(observer.tipped());
            drive(1, force_mps2, 0.0F);
            EXPECT_EQ(observer.tipped(), std::fabs(force_mps2) > 4.0F) << force_mps2;
            if (!observer.tipped()) {
                drive(200, 0.0F, 0.0F);
                EXPECT_NEAR(observer.roll_angle_rad(), 0.0F, 0.01F);
            }
        }
    }
}

TEST(RollBankObserver, TheForceMustBeMissingForTheWholeSecond) {
    for (const float now_and_then_mps2 : {4.5F, 9.0F}) {
        rsi_test::RollBankObserver observer;
        observer.init(rsi_test::large_suv());
        for (int k = 0; k < 260; ++k) {
            observer.update((k < 200) ? 0.0F : 9.0F, (k < 200) ? 0.0F : 1.0F, 0.0F, 0.0F);
        }
        for (int k = 0; k < 1000; ++k) {
            observer.update((k % 90 == 89) ? now_and_then_mps2 : 0.0F, 0.0F, 0.0F, 0.0F);
            ASSERT_TRUE(observer.tipped()) << k;
        }
    }
}

TEST(RollBankObserver, KeepsItsBankWithinHalfARadian) {
    for (const float side : {1.0F, -1.0F}) {
        rsi_test::RollBankObserver observer;
        observer.init(rsi_test::large_suv());
        for (int k = 0; k < 60000; ++k) {
            observer.update(side * 7.0F, 0.0F, 0.0F, 20.0F);
            ASSERT_LE(std::fabs(observer.bank_angle_rad()), 0.5F);
        }
        EXPECT_EQ(observer.bank_angle_rad(), side * 0.5F);
    }
}

// A body that has just begun to lean says little: the filter must know its angle before wheels can lift.
TEST(RollBankObserver, DoesNotTipBeforeItKnowsItsAngle) {
    for (const float side : {1.0F, -1.0F}) {
        rsi_test::RollBankObserver observer;
        observer.init(rsi_test::large_suv());
        int samples = 0;
        while (!observer.roll_known() && samples < 100) {
            observer.update(side * 9.0F, 0.0F, side * 0.45F, 20.0F);
            ++samples;
            EXPECT_FALSE(observer.tipped()) << samples;
        }
        EXPECT_GE(samples, 2);
        observer.update(side * 9.0F, 0.0F, side * 0.45F, 20.0F);
        EXPECT_TRUE(observer.tipped());
    }
}

TEST(RollBankObserver, StartsInBalanceWithinAFifthOfARadian) {
    for (const float side : {1.0F, -1.0F}) {
        rsi_test::RollBankObserver observer;
        observer.init(rsi_test::large_suv());
        observer.update(side * 20.0F, 0.0F, 0.0F, 20.0F);
        EXPECT_EQ(observer.roll_angle_rad(), side * 0.2F);
        observer.reset();
        observer.update(side * 3.0F, 0.0F, 0.0F, 20.0F);
        EXPECT_NEAR(observer.roll_angle_rad(), side * 0.05F, 0.02F);
    }
}

TEST(RollBankObserver, KnowsNothingOfATippedVehicleAfterAReset) {
    rsi_test::RollBankObserver observer;
    observer.init(rsi_test::large_suv());
    for (int k = 0; k < 100; ++k) {
        observer.update((k < 90) ? 0.0F : 9.0F, 0.0F, 0.0F, 20.0F);
    }
    ASSERT_TRUE(observer.tipped());
    observer.reset();
    observer.update(9.0F, 0.0F, 0.0F, 20.0F);
    EXPECT_FALSE(observer.tipped());
    EXPECT_FALSE(observer.roll_known());
}

TEST(RollSensorCheck, WantsTheWholeTimeAfterAReset) {
    rsi_test::RollSensorCheck check{rsi_test::large_suv()};
    for (int k = 0; k < 30; ++k) {
        check.update(0.051F);
    }
    check.reset();
    for (int k = 0; k < 30; ++k) {
        check.update(0.051F);
        EXPECT_FALSE(check.disagrees()) << k;
    }
    check.update(0.051F);
    EXPECT_TRUE(check.disagrees());
}

TEST(RollSensorCheck, TheSensorAgreesAgainWithinHalfOfTheLimitOnly) {
    rsi_test::RollSensorCheck check{rsi_test::large_suv()};  // 0.05 rad
    for (int k = 0; k < 31; ++k) {
        check.update(0.051F);
    }
    for (int k = 0; k < 100; ++k) {
        check.update(0.0251F);
    }
    EXPECT_TRUE(check.disagrees());
    for (int k = 0; k < 31; ++k) {
        check.update(0.0249F);
    }
    EXPECT_FALSE(check.disagrees());
}

// To the nearest of 10 ms.
TEST(RollSensorCheck, ItsTimeIsRoundedToSamples) {
    for (const float time_s : {0.2952F, 0.3048F}) {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.observer_disagreement_s = time_s;
        rsi_test::RollSensorCheck check{parameters};
        for (int k = 0; k < 30; ++k) {
            check.update(0.051F);
        }
        EXPECT_FALSE(check.disagrees()) << time_s;
        check.update(0.051F);
        EXPECT_TRUE(check.disagrees()) << time_s;
    }
}

}  // namespace
}  // namespace roll_bank_observer_test
