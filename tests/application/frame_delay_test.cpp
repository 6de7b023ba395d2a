// Frames that arrive in order, but late all the time.
#include "rsi/ecu/application/frame_delay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "rsi/ecu/monitoring/roll_lag.hpp"
#include "tests/application/bench.hpp"
#include "tests/application/roll_plane_vehicle.hpp"

namespace testing_application {
namespace {

using Degradation = rsi::can_dbc::RolloverDiagnosis::Degradation;
using State = rsi::can_dbc::RolloverWarning::State;

// Codes are reported in turn.
bool tells_imu_held_back(Bench& bench) {
    bool tells = false;
    for (int cycle = 0; cycle < 10; ++cycle) {
        bench.run_cycles(1);
        const rsi::can_dbc::RolloverDiagnosis told = bench.last().diagnosis.value;
        tells = tells || ((told.code == rsi::can_dbc::RolloverDiagnosis::Code::imu_held_back) &&
                          (told.code_status == rsi::can_dbc::RolloverDiagnosis::CodeStatus::confirmed));
    }
    return tells;
}

// A weave; the roll angle's frames can be made as old as `late_s` says.
struct Weave {
    explicit Weave(double amplitude_mps2) {
        bench.drive([this, amplitude_mps2](double time_s) {
            vehicle.advance(amplitude_mps2 * std::sin(3.0 * time_s));
            angles.push_back(vehicle.motion().roll_angle);
            motions.push_back(vehicle.motion());
            Motion motion = vehicle.motion();
            const auto imu_late = static_cast<std::size_t>(std::lround(imu_late_s * 100.0));
            motion.imu = motions[motions.size() > imu_late ? motions.size() - 1U - imu_late : 0U].imu;
            const auto late = static_cast<std::size_t>(std::lround(late_s * 100.0));
            motion.roll_angle = angles[angles.size() > late ? angles.size() - 1U - late : 0U];
            return motion;
        });
        bench.run_for(2.0);
    }

    // For so long no frame of it comes; then its counter goes on where it had stopped.
    void hold_back(double seconds, Sensor sensor = Sensor::roll_angle) {
        bench.stop(sensor);
        bench.run_for(seconds);
        bench.resume_all();
    }

    bool reported_lost() const { return bench.status().roll_angle_timeout; }
    bool imu_told_late() { return tells_imu_held_back(bench); }

    double late_s{0.0};
    double imu_late_s{0.0};
    std::vector<Motion> motions{};
    std::vector<rsi::can_dbc::RollAngle> angles{};
    RollPlaneVehicle vehicle{large_suv()};
    Bench bench;
};

TEST(ARollAngle, ThatIsHeldBackIsNotUsedAndTheObserverStandsIn) {
    Weave drive{0.5};
    drive.hold_back(0.1);
    for (int cycle = 0; cycle < 500; ++cycle) {
        drive.bench.run_cycles(1);
        ASSERT_TRUE(drive.reported_lost()) << cycle;
        ASSERT_EQ(drive.bench.state(), State::ready) << cycle;
        ASSERT_EQ(drive.bench.last().diagnosis.value.degradation, Degradation::roll_sensor_lost) << cycle;
    }
}

TEST(ARollAngle, ThatHasCaughtUpIsUsedAgain) {
    Weave drive{0.5};
    drive.hold_back(0.1);
    drive.bench.run_for(1.0);
    ASSERT_TRUE(drive.reported_lost());
    drive.bench.lose_frames(Sensor::roll_angle, 10U);
    drive.bench.run_cycles(2);  // the first one is out of sequence
    EXPECT_FALSE(drive.reported_lost());
}

TEST(ARollAngle, IsLateWhenItsCounterIsFourFramesBehindOrMore) {
    for (unsigned counted = 0U; counted < 14U; ++counted) {
        SCOPED_TRACE("counted " + std::to_string(counted));
        Weave drive{0.5};
        drive.hold_back(0.1);
        drive.bench.lose_frames(Sensor::roll_angle, counted);
        drive.bench.run_for(0.2);
        EXPECT_EQ(drive.reported_lost(), counted < 7U);
    }
}

TEST(ARollAngle, IsLateFromASilenceOfFourCyclesOn) {
    for (const double silence_s : {0.03, 0.04}) {
        Weave drive{0.5};
        drive.hold_back(silence_s);
        drive.bench.run_for(0.2);
        EXPECT_EQ(drive.reported_lost(), silence_s > 0.035) << silence_s;
    }
}

// From then on its counter is compared with that of the IMU as it is.
TEST(ARollAngle, IsLateWhateverTheImuHasLostBefore) {
    Weave drive{0.5};
    drive.bench.lose_frames(Sensor::imu, 9U);
    drive.bench.run_for(1.0);
    ASSERT_FALSE(drive.reported_lost());
    drive.hold_back(0.05);
    drive.bench.run_for(0.2);
    EXPECT_TRUE(drive.reported_lost());
}

TEST(ARollAngle, IsNotLateWhenItBeginsLater) {
    for (int cycles = 1; cycles < 20; ++cycles) {
        Bench bench;
        bench.stop(Sensor::roll_angle);
        bench.run_cycles(cycles);
        bench.resume_all();
        bench.run_cycles(10);
        EXPECT_FALSE(bench.status().roll_angle_timeout) << cycles;
    }
}

TEST(ARollAngle, IsNotLateWhenAllSendersHavePaused) {
    Weave drive{0.5};
    drive.bench.stop_all();
    drive.bench.run_for(0.1);
    drive.bench.resume_all();
    drive.bench.run_for(0.2);
    EXPECT_FALSE(drive.reported_lost());
}

TEST(ARollAngle, IsNotLateWhenItsSenderMayHaveStartedAnew) {
    for (const double silence_s : {0.12, 0.2, 1.0}) {
        Weave drive{0.5};
        drive.hold_back(silence_s);
        drive.bench.run_for(0.2);
        EXPECT_FALSE(drive.reported_lost()) << silence_s;
    }
    Weave drive{0.5};
    drive.hold_back(0.11);
    drive.bench.run_for(0.2);
    EXPECT_TRUE(drive.reported_lost());
}

TEST(ARollAngle, IsNotLateWhenTheImuPausesOrCatchesUp) {
    Weave drive{0.5};
    drive.bench.stop(Sensor::imu);
    drive.bench.run_for(0.1);
    drive.bench.resume_all();
    drive.bench.run_for(0.2);
    EXPECT_FALSE(drive.reported_lost());
    drive.bench.lose_frames(Sensor::imu, 10U);
    drive.bench.run_for(0.2);
    EXPECT_FALSE(drive.reported_lost());
}

// Its sender had only paused: the roll rate shows it.
TEST(ARollAngle, IsAcceptedAgainWhenItMovesWithTheRollRate) {
    Weave drive{4.0};
    drive.hold_back(0.1);
    drive.bench.run_for(0.2);
    EXPECT_TRUE(drive.reported_lost());
    drive.bench.run_for(10.0);
    EXPECT_FALSE(drive.reported_lost());
}

// By less than makes it too old, as a filter makes it.
TEST(ARollAngle, IsAcceptedAgainAtOnceWhenItMovesWithTheRollRateOrALittleLater) {
    for (const double late_s : {0.0, 0.01, 0.02}) {
        Weave drive{4.0};
        drive.late_s = late_s;
        drive.hold_back(0.1);
        drive.bench.run_for(0.2);
        EXPECT_TRUE(drive.reported_lost()) << late_s;
        drive.bench.run_for(1.5);
        EXPECT_FALSE(drive.reported_lost()) << late_s;
    }
}

TEST(ARollAngle, IsNotAcceptedAsLongAsItMovesLater) {
    Weave drive{4.0};
    drive.late_s = 0.1;
    drive.hold_back(0.1);
    for (int second = 0; second < 60; ++second) {
        drive.bench.run_for(1.0);
        ASSERT_TRUE(drive.reported_lost()) << second;
    }
}

// The newest counters of two senders that send in each cycle, as the receiver knows them.
struct Counters {
    void run(int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            ++imu_sent;
            ++roll_sent;
            imu_known = imu_comes ? imu_sent : imu_known;
            roll_known = roll_comes ? roll_sent : roll_known;
            delay.update(imu_known % 15U, roll_known % 15U, 0.0F, 0.0F);
        }
    }

    // Nothing of it comes for so long; then its counter goes on where it had stopped.
    void hold_back(bool imu, int cycles) {
        (imu ? imu_comes : roll_comes) = false;
        run(cycles);
        (imu ? imu_sent : roll_sent) -= static_cast<std::uint32_t>(cycles);
        imu_comes = true;
        roll_comes = true;
    }

    std::uint32_t imu_sent{0U}, roll_sent{0U};
    std::uint32_t imu_known{0U}, roll_known{0U};
    bool imu_comes{true}, roll_comes{true};
    rsi::application::FrameDelay delay{};
};

// Both are damaged or lost, the IMU's frames for longer, or the IMU has just come back.
TEST(ARollAngle, IsNotLateBecauseTheImuIsNotKnown) {
    for (int imu_before = 0; imu_before < 25; ++imu_before) {
        for (int together = 4; together < 12; ++together) {
            for (int imu_after = 0; imu_after < 25; ++imu_after) {
                Counters counters;
                counters.run(20);
                counters.imu_comes = false;
                counters.run(imu_before);
                counters.roll_comes = false;
                counters.run(together);
                counters.roll_comes = true;
                counters.run(imu_after);
                counters.imu_comes = true;
                counters.run(20);
                ASSERT_FALSE(counters.delay.roll_angle_is_late())
                    << imu_before << ' ' << together << ' ' << imu_after;
            }
        }
    }
}

// The effect of a pause is judged once: later the IMU may lose frames without one.
TEST(ARollAngle, IsNotLateByAPauseThatIsLongOver) {
    Counters counters;
    counters.run(20);
    counters.roll_comes = false;
    counters.run(5);
    counters.roll_comes = true;
    counters.run(10);
    counters.imu_sent += 5U;
    counters.run(10);
    EXPECT_FALSE(counters.delay.roll_angle_is_late());
}

// Held back in the same moment: found as soon as the IMU is known again, unless that takes so long that its
// sender may have started anew.
TEST(ARollAngle, IsFoundLateWhenTheImuIsKnownAgain) {
    for (int imu_after = 0; imu_after < 25; ++imu_after) {
        Counters counters;
        counters.run(20);
        counters.imu_comes = false;
        counters.roll_comes = false;
        counters.run(5);
        counters.roll_sent -= 5U;
        counters.roll_comes = true;
        counters.run(imu_after);
        counters.imu_comes = true;
        counters.run(2);
        EXPECT_EQ(counters.delay.roll_angle_is_late(), imu_after <= 6) << imu_after;
    }
}

TEST(ARollAngle, IsJudgedWhileTheImuHasLostUpToThreeFrames) {
    for (int lost = 0; lost < 6; ++lost) {
        Counters counters;
        counters.run(20);
        counters.roll_comes = false;
        counters.run(9 - lost);
        counters.imu_comes = false;
        counters.run(lost - 1);
        counters.roll_sent -= 8U;
        counters.roll_comes = true;
        counters.run(1);
        EXPECT_EQ(counters.delay.roll_angle_is_late(), lost <= 3) << lost;
    }
}

// The warning goes on, and is late: a reader of the codes sees it.
TEST(AnImu, ThatIsHeldBackIsReportedAndUsed) {
    for (const double held_back_s : {0.05, 0.07, 0.11}) {
        Weave drive{0.5};
        drive.hold_back(held_back_s, Sensor::imu);
        drive.bench.run_for(2.0);
        for (int tenth = 0; tenth < 50; ++tenth) {
            ASSERT_TRUE(drive.imu_told_late()) << held_back_s << ' ' << tenth;
            ASSERT_FALSE(drive.reported_lost()) << held_back_s << ' ' << tenth;
            ASSERT_EQ(drive.bench.state(), State::ready) << held_back_s << ' ' << tenth;
        }
    }
}

TEST(AnImu, IsNotLateAfterAShorterSilenceOrOneInWhichItMayHaveStartedAnew) {
    for (const double silence_s : {0.04, 0.12, 0.2, 1.0}) {
        Weave drive{0.5};
        drive.hold_back(silence_s, Sensor::imu);
        drive.bench.run_for(2.0);
        EXPECT_FALSE(drive.imu_told_late()) << silence_s;
    }
}

TEST(AnImu, IsNotLateWhenFramesWereLostOrItHasCaughtUp) {
    Weave lost{0.5};
    lost.bench.lose_frames(Sensor::imu, 10U);
    lost.bench.run_for(0.5);
    EXPECT_FALSE(lost.imu_told_late());
    Weave drive{0.5};
    drive.hold_back(0.1, Sensor::imu);
    drive.bench.run_for(1.0);
    ASSERT_TRUE(drive.imu_told_late());
    drive.bench.lose_frames(Sensor::imu, 10U);
    drive.bench.run_for(3.0);  // the code heals
    EXPECT_FALSE(drive.imu_told_late());
}

TEST(AnImu, IsAcceptedAgainWhenItMovesWithTheRollAngleAndNotIfItMovesLater) {
    Weave drive{4.0};
    drive.hold_back(0.1, Sensor::imu);
    drive.bench.run_for(1.0);
    EXPECT_TRUE(drive.imu_told_late());
    drive.bench.run_for(10.0);
    EXPECT_FALSE(drive.imu_told_late());

    Weave late{4.0};
    late.imu_late_s = 0.1;
    late.hold_back(0.1, Sensor::imu);
    for (int second = 0; second < 60; ++second) {
        late.bench.run_for(1.0);
        ASSERT_FALSE(late.bench.status().roll_angle_timeout) << second;
    }
    EXPECT_TRUE(late.imu_told_late());
}

// A lead that changes without a pause is no delay, but what a delay is measured from.
TEST(ASender, ThatIsHeldBackIsMeasuredFromWhereItWas) {
    for (const std::uint32_t lost_before : {0U, 2U, 3U}) {
        for (const bool imu : {true, false}) {
            Counters counters;
            counters.run(20);
            (imu ? counters.roll_sent : counters.imu_sent) += lost_before;
            counters.run(20);
            counters.hold_back(imu, 11);
            counters.run(1);
            EXPECT_EQ(counters.delay.imu_is_late(), imu) << lost_before;
            EXPECT_EQ(counters.delay.roll_angle_is_late(), !imu) << lost_before;
        }
    }
}

TEST(ASender, ThatSendsAtOnceWhatItHasHeldBackIsInTime) {
    for (const bool imu : {true, false}) {
        Counters counters;
        counters.run(20);
        counters.hold_back(imu, 8);
        counters.run(10);
        ASSERT_TRUE(imu ? counters.delay.imu_is_late() : counters.delay.roll_angle_is_late());
        (imu ? counters.imu_sent : counters.roll_sent) += 8U;
        counters.run(1);
        EXPECT_FALSE(counters.delay.imu_is_late() || counters.delay.roll_angle_is_late());
    }
}

// The length of its silence while no cycle ran is not known.
TEST(ASender, IsNotLateAfterMissedCycles) {
    for (const bool imu : {true, false}) {
        Counters counters;
        counters.run(20);
        counters.hold_back(imu, 5);
        counters.delay.miss_cycles();
        counters.run(10);
        EXPECT_FALSE(counters.delay.imu_is_late() || counters.delay.roll_angle_is_late());
        counters.delay.miss_cycles();
        counters.run(10);
        counters.hold_back(imu, 5);
        counters.run(1);
        EXPECT_TRUE(imu ? counters.delay.imu_is_late() : counters.delay.roll_angle_is_late());
    }
}

TEST(ARollAngle, IsNotLateAfterASilenceInWhichCyclesWereMissed) {
    for (const std::uint32_t missed : {0U, 1U}) {
        Weave drive{0.5};
        drive.bench.stop(Sensor::roll_angle);
        drive.bench.run_cycles(8);
        drive.bench.miss_cycles(missed);
        drive.bench.run_cycles(1);
        drive.bench.miss_cycles(0U);
        drive.bench.resume_all();
        drive.bench.run_for(0.2);
        EXPECT_EQ(drive.reported_lost(), missed == 0U);
    }
}

TEST(AnImu, IsNotLateWithARollAngleThatIsHeldBackLongAfterItWasSilentItself) {
    Counters counters;
    counters.run(20);
    counters.imu_comes = false;
    counters.run(5);
    counters.imu_comes = true;
    counters.run(10);
    counters.hold_back(false, 5);
    counters.run(1);
    EXPECT_TRUE(counters.delay.roll_angle_is_late());
    EXPECT_FALSE(counters.delay.imu_is_late());
}

// Evidence that the first one was over says nothing of the second.
TEST(ASender, ThatIsHeldBackTwiceIsLateTwice) {
    for (const Sensor sensor : {Sensor::imu, Sensor::roll_angle}) {
        Weave drive{4.0};
        drive.hold_back(0.1, sensor);
        drive.bench.run_for(12.0);
        EXPECT_FALSE(drive.reported_lost());
        EXPECT_FALSE(drive.imu_told_late());
        drive.hold_back(0.1, sensor);
        drive.bench.run_for(0.1);
        EXPECT_TRUE((sensor == Sensor::imu) ? drive.imu_told_late() : drive.reported_lost());
    }
}

// Both are silent, in any order; the counter of the roll angle begins anew, the IMU's goes on.
TEST(AnImu, IsNotLateWhenTheRollAngleMayHaveStartedAnew) {
    for (int together = 1; together < 12; ++together) {
        for (int imu_after = 0; together + imu_after < 12; ++imu_after) {
            for (std::uint32_t anew = 0U; anew < 15U; ++anew) {
                Counters counters;
                counters.run(20);
                counters.roll_comes = false;
                counters.run(12);
                counters.imu_comes = false;
                counters.run(together);
                counters.roll_sent = 30U + anew;
                counters.roll_comes = true;
                counters.run(imu_after);
                counters.imu_comes = true;
                counters.run(20);
                ASSERT_FALSE(counters.delay.imu_is_late()) << together << ' ' << imu_after << ' ' << anew;
            }
        }
    }
    for (int roll_before = 0; roll_before < 25; ++roll_before) {
        for (int together = 0; together < 12; ++together) {
            for (int roll_after = 0; roll_after < 25; ++roll_after) {
                if (roll_before + together + roll_after < 12) {
                    continue;
                }
                for (std::uint32_t anew = 0U; anew < 15U; ++anew) {
                    Counters counters;
                    counters.run(20);
                    counters.roll_comes = false;
                    counters.run(roll_before);
                    counters.imu_comes = false;
                    counters.run(together);
                    counters.imu_comes = true;
                    counters.run(roll_after);
                    counters.roll_sent = 30U + anew;
                    counters.roll_comes = true;
                    counters.run(20);
                    ASSERT_FALSE(counters.delay.imu_is_late())
                        << roll_before << ' ' << together << ' ' << roll_after << ' ' << anew;
                    ASSERT_FALSE(counters.delay.roll_angle_is_late());
                }
            }
        }
    }
}

// A gentle roll, in which the roll rate is taken out for contradicting the angle and is right again.
struct RollRateInvalidated {
    RollRateInvalidated() {
        bench.drive([this](double time_s) {
            Motion motion;
            const double error = faulty ? 25.0 : 0.0;
            motion.imu.roll_rate_deg_per_s = static_cast<float>(error + std::sin(3.0 * time_s));
            const double jump = std::lround(100.0 * time_s) % 2 == 0 ? jump_deg : -jump_deg;
            motion.roll_angle.roll_angle_deg = static_cast<float>(jump - std::cos(3.0 * time_s) / 3.0);
            return motion;
        });
        bench.run_for(2.0);
        faulty = true;
        bench.run_for(0.5);
        faulty = false;
    }

    void hold_back_the_angle() {
        bench.stop(Sensor::roll_angle);
        bench.run_for(0.1);
        bench.resume_all();
        bench.run_cycles(10);
    }

    bool faulty{false};
    double jump_deg{0.0};
    Bench bench;
};

TEST(ARollAngle, ThatIsHeldBackClearsARollRateWithWhichItAgrees) {
    RollRateInvalidated drive;
    drive.hold_back_the_angle();
    ASSERT_TRUE(drive.bench.status().roll_angle_timeout);
    ASSERT_EQ(drive.bench.state(), State::unavailable);
    drive.bench.run_for(1.5);
    EXPECT_TRUE(drive.bench.status().roll_angle_timeout);
    EXPECT_EQ(drive.bench.state(), State::ready);
}

TEST(ARollAngle, ThatNoLongerComesClearsNoRollRate) {
    RollRateInvalidated drive;
    drive.hold_back_the_angle();
    drive.bench.stop(Sensor::roll_angle);
    drive.bench.run_for(5.0);
    EXPECT_EQ(drive.bench.state(), State::unavailable);
    drive.bench.resume_all();
    drive.bench.run_for(2.0);
    EXPECT_EQ(drive.bench.state(), State::ready);
}

TEST(ARollAngle, ThatJumpsClearsNoRollRate) {
    RollRateInvalidated drive;
    drive.jump_deg = 1.5;  // by 3 deg, which would be no contradiction within 0.2 s
    drive.bench.run_for(3.0);
    EXPECT_EQ(drive.bench.state(), State::unavailable);
    drive.jump_deg = 0.0;
    drive.bench.run_for(2.5);
    EXPECT_EQ(drive.bench.state(), State::ready);
}

// The angle of a sine of the roll rate, late by `delay_s`.
rsi::monitoring::RollLag lag_after(double delay_s, double seconds, double amplitude_radps) {
    rsi::monitoring::RollLag lag;
    for (int sample = 0; sample < static_cast<int>(seconds * 100.0); ++sample) {
        const double time_s = 0.01 * sample;
        const double angle = 0.3 - amplitude_radps / 4.0 * std::cos(4.0 * (time_s - delay_s));
        lag.update(static_cast<float>(angle), static_cast<float>(amplitude_radps * std::sin(4.0 * time_s)));
    }
    return lag;
}

TEST(RollLag, TellsAnAngleInTimeFromOneThatIsTooOld) {
    for (const double delay_s : {0.0, 0.01, 0.02, 0.03}) {
        EXPECT_TRUE(lag_after(delay_s, 5.0, 0.2).angle_is_in_time()) << delay_s;
    }
    for (const double delay_s : {0.045, 0.06, 0.1, 0.13}) {
        EXPECT_FALSE(lag_after(delay_s, 5.0, 0.2).angle_is_in_time()) << delay_s;
    }
}

TEST(RollLag, KnowsNothingOfABodyThatHasHardlyRolled) {
    EXPECT_FALSE(lag_after(0.0, 5.0, 0.02).angle_is_in_time());
    EXPECT_FALSE(lag_after(0.0, 0.3, 0.2).angle_is_in_time());
    EXPECT_FALSE(lag_after(0.0, 5.0, 0.02).rate_is_in_time());
}

TEST(RollLag, TellsARateInTimeFromOneThatIsTooOld) {
    for (const double delay_s : {0.0, 0.01, 0.02, 0.03}) {
        EXPECT_TRUE(lag_after(-delay_s, 5.0, 0.2).rate_is_in_time()) << delay_s;
    }
    for (const double delay_s : {0.045, 0.06, 0.1, 0.13}) {
        EXPECT_FALSE(lag_after(-delay_s, 5.0, 0.2).rate_is_in_time()) << delay_s;
    }
}

TEST(RollLag, StartsAnewWithANumberThatIsNotFinite) {
    rsi::monitoring::RollLag lag = lag_after(0.0, 5.0, 0.2);
    lag.update(std::numeric_limits<float>::quiet_NaN(), 0.0F);
    EXPECT_FALSE(lag.angle_is_in_time());
}

}  // namespace
}  // namespace testing_application
