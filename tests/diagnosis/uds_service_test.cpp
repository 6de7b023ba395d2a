// UDS, service by service, as a tester meets them.
#include <gtest/gtest.h>

#include <cstring>

#include "rsi/output_table.hpp"
#include "tests/application/bench.hpp"
#include "tests/diagnosis/tester.hpp"

namespace testing_diagnosis {
namespace {

class Uds : public ::testing::Test {
 protected:
    Bytes ask(const Bytes& request) { return tester_.ask(request); }
    // Switches the ECU off and on.
    void switch_on_again() {
        tester_.~Tester();
        new (&tester_) Tester{memories_};
    }

    Memories memories_{};
    Tester tester_{memories_};
};

Bytes text(const char* text, std::size_t length) {
    Bytes bytes(text, text + std::strlen(text));
    bytes.resize(length);
    return bytes;
}

float number_in(const Bytes& answer, std::size_t at) {
    std::uint32_t word = 0U;
    for (std::size_t byte = 0U; byte < 4U; ++byte) {
        word = (word << 8U) | answer.at(at + byte);
    }
    float value = 0.0F;
    std::memcpy(&value, &word, sizeof value);
    return value;
}

// Code of the lost IMU.
const Bytes imu_lost{0xD1U, 0x20U, 0x87U};

// ---- sessions

TEST_F(Uds, SessionsTellTheirTimes) {
    for (const std::uint8_t session : Bytes{0x03U, 0x02U, 0x01U}) {
        EXPECT_EQ(ask({0x10U, session}), (Bytes{0x50U, session, 0x00U, 0x32U, 0x01U, 0xF4U}));
        EXPECT_EQ(ask({0x22U, 0xF1U, 0x86U}), (Bytes{0x62U, 0xF1U, 0x86U, session}));
    }
}

TEST_F(Uds, AnAnswerComesInTheCycleOfTheRequest) {
    tester_.send_frame(Tester::physical, {0x02U, 0x3EU, 0x00U});
    tester_.cycle();
    EXPECT_EQ(tester_.payload(), (Bytes{0x02U, 0x7EU, 0x00U, 0xCCU, 0xCCU, 0xCCU, 0xCCU, 0xCCU}));
}

// S3.
TEST_F(Uds, ASessionEndsFiveSecondsAfterTheLastRequest) {
    ask({0x10U, 0x03U});
    tester_.cycles(480);
    ask({0x3EU, 0x00U});
    tester_.cycles(480);
    tester_.ask_functional({0x3EU, 0x80U}, 0);
    tester_.cycles(480);
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::extended);
    ask({0x3EU, 0x00U});
    tester_.cycles(499);
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::extended);
    tester_.cycles(1);
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::standard);
}

// However long the answer is on its way: the five seconds begin behind it.
TEST_F(Uds, ALongAnswerKeepsTheSessionWhileItGoes) {
    ask({0x10U, 0x03U});
    tester_.send({0x22U, 0xF1U, 0x90U});
    for (int wait = 0; wait < 8; ++wait) {
        tester_.cycles(90);
        tester_.send_frame(Tester::physical, {0x31U, 0U, 0U});
    }
    tester_.cycle();
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::extended);
    tester_.send_frame(Tester::physical, {0x30U, 0U, 0U});
    tester_.cycle();
    tester_.cycles(499);
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::extended);
    tester_.cycles(1);
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::standard);
}

TEST_F(Uds, ARequestThatWaitsForTheMemoryKeepsTheSession) {
    tester_.unlock();
    memories_.refuse(true);
    EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), no(0x14U, 0x72U));
    tester_.cycles(490);
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::extended);
    tester_.cycles(10);
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::standard);
}

TEST_F(Uds, ASessionThatTimesOutLocksAndRestores) {
    tester_.unlock();
    ask({0x85U, 0x02U});
    ask({0x28U, 0x01U, 0x01U});
    tester_.cycles(510);
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.cycles(3);
    EXPECT_EQ(ask({0x19U, 0x01U, 0x01U}), (Bytes{0x59U, 0x01U, 0x7FU, 0x01U, 0x00U, 0x01U}));
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask(Bytes{0x2EU, 0xF1U, 0x90U} + Bytes(17U, 'A')), no(0x2EU, 0x33U));
    EXPECT_TRUE(tester_.diagnosis().lets_ecu_send());
}

TEST_F(Uds, ALongRequestKeepsTheSessionWhileItComes) {
    ask({0x10U, 0x03U});
    tester_.cycles(495);
    tester_.send_frame(Tester::physical, {0x10U, 20U, 0x22U, 0xF1U, 0x86U, 0U, 0U, 0U});
    tester_.cycles(90);
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::extended);
}

TEST_F(Uds, EverySessionChangeLocks) {
    tester_.unlock();
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), no(0x14U, 0x33U));
}

TEST_F(Uds, AnUnlockedSessionDoesNotOutliveAStart) {
    tester_.unlock();
    tester_.start(false);
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), no(0x14U, 0x33U));
    EXPECT_EQ(ask(Bytes{0x2EU, 0xF1U, 0x90U} + Bytes(17U, 'A')), no(0x2EU, 0x33U));
}

TEST_F(Uds, NoProgrammingWhileTheVehicleMoves) {
    tester_.inputs.speed_mps = 1.5F;
    EXPECT_EQ(ask({0x10U, 0x02U}), no(0x10U, 0x22U));
    EXPECT_EQ(ask({0x10U, 0x03U})[0], 0x50U);
    tester_.inputs.speed_mps = 1.4F;
    EXPECT_EQ(ask({0x10U, 0x02U})[0], 0x50U);
}

// Without a speed, other sensors show that it moves; a speed that is there counts alone.
TEST_F(Uds, NoProgrammingWhileTheVehicleTurns) {
    tester_.inputs.speed_mps = rsi::not_available;
    EXPECT_EQ(ask({0x10U, 0x02U})[0], 0x50U) << "as on a bench";
    for (float rsi::Inputs::* const rate : {&rsi::Inputs::yaw_rate_radps, &rsi::Inputs::roll_rate_radps}) {
        for (const float sign : {-1.0F, 1.0F}) {
            tester_.inputs.speed_mps = rsi::not_available;
            tester_.inputs.*rate = 0.11F * sign;
            EXPECT_EQ(ask({0x10U, 0x02U}), no(0x10U, 0x22U));
            tester_.inputs.*rate = 0.1F * sign;
            EXPECT_EQ(ask({0x10U, 0x02U})[0], 0x50U);
            tester_.inputs.*rate = 0.11F * sign;
            tester_.inputs.speed_mps = 0.0F;
            EXPECT_EQ(ask({0x10U, 0x02U})[0], 0x50U) << "on a turntable";
        }
        tester_.inputs.*rate = rsi::not_available;
    }
}

TEST_F(Uds, NothingIsClearedOrWrittenWhileTheVehicleMoves) {
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.cycles(3);
    tester_.unlock();
    tester_.inputs.speed_mps = 20.0F;
    EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), no(0x14U, 0x22U));
    EXPECT_EQ(ask(Bytes{0x14U} + imu_lost), no(0x14U, 0x22U));
    EXPECT_EQ(ask({0x14U, 0x12U, 0x34U, 0x56U}), no(0x14U, 0x31U));
    EXPECT_EQ(ask(Bytes{0x2EU, 0xF1U, 0x90U} + Bytes(17U, 'W')), no(0x2EU, 0x22U));
    EXPECT_EQ(ask({0x19U, 0x01U, 0x01U})[5], 1U);
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x90U}), Bytes({0x62U, 0xF1U, 0x90U}) + Bytes(17U, 0U));
}

// ---- reset

TEST_F(Uds, AResetIsAskedForOnceItIsAnswered) {
    ask({0x10U, 0x03U});
    tester_.inputs.speed_mps = 20.0F;
    EXPECT_EQ(ask({0x11U, 0x01U}), no(0x11U, 0x22U));
    EXPECT_FALSE(tester_.diagnosis().is_reset_requested());
    tester_.inputs.speed_mps = rsi::not_available;
    EXPECT_EQ(ask({0x11U, 0x03U}), (Bytes{0x51U, 0x03U}));
    EXPECT_TRUE(tester_.diagnosis().is_reset_requested());
}

TEST_F(Uds, AResetWaitsUntilTheAnswerIsOut) {
    ask({0x10U, 0x03U});
    rsi::hal::CanFrame frame{};
    frame.identifier = Tester::physical;
    frame.length = 3U;
    frame.data = {0x02U, 0x11U, 0x01U};
    tester_.diagnosis().listener().take(frame);
    tester_.set_bus_state(rsi::hal::BusState::bus_off);
    tester_.cycles(110);
    EXPECT_FALSE(tester_.diagnosis().is_reset_requested());
    tester_.set_bus_state(rsi::hal::BusState::error_active);
    tester_.cycles(2);
    EXPECT_TRUE(tester_.diagnosis().is_reset_requested());
}

// Each start has its limits anew, so that starts need one: over the operation cycle.
TEST_F(Uds, ResetsAreLimitedInAnOperationCycle) {
    for (int reset = 0; reset < 20; ++reset) {
        ask({0x10U, 0x03U});
        ASSERT_EQ(ask({0x11U, 0x01U}), (Bytes{0x51U, 0x01U})) << reset;
        tester_.start(false);
    }
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask({0x11U, 0x01U}), no(0x11U, 0x22U));
    switch_on_again();
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask({0x11U, 0x01U}), (Bytes{0x51U, 0x01U}));
}

// Within a second of the record before; a loss of power would take it away.
TEST_F(Uds, AResetWaitsForWhatIsToBeStored) {
    ask({0x10U, 0x03U});
    tester_.cycles(200);
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.cycles(2);
    tester_.fail(DiagnosticCode::roll_angle_lost);
    tester_.cycles(2);
    EXPECT_EQ(tester_.ask({0x11U, 0x81U}, 120), (Bytes{0x51U, 0x01U}))
        << "no longer suppressed once it took time";
    EXPECT_EQ(tester_.times_told_later, 1);
    EXPECT_TRUE(tester_.diagnosis().is_reset_requested());
    tester_.heal(DiagnosticCode::imu_lost);
    tester_.heal(DiagnosticCode::roll_angle_lost);
    tester_.start(false);
    EXPECT_EQ(ask({0x19U, 0x01U, 0x08U})[5], 2U);
}

// A count that would be stored within a minute.
TEST_F(Uds, AResetStoresWhatOnlyCountsFurther) {
    ask({0x10U, 0x03U});
    for (int time = 0; time < 2; ++time) {
        tester_.fail(DiagnosticCode::imu_lost);
        tester_.cycles(2);
        tester_.heal(DiagnosticCode::imu_lost);
        tester_.cycles(110);
    }
    EXPECT_EQ(tester_.ask({0x11U, 0x01U}, 120), (Bytes{0x51U, 0x01U}));
    tester_.start(false);
    EXPECT_EQ(ask(Bytes{0x19U, 0x06U} + imu_lost + Bytes{0x01U}).back(), 2U);
}

// Else a memory that is asked rarely would let a tester start the control unit without limit.
TEST_F(Uds, AResetIsNotGivenBeforeItsCountIsStored) {
    ask({0x10U, 0x03U});
    memories_.refuse(true);
    EXPECT_EQ(ask({0x11U, 0x01U}), no(0x11U, 0x72U));
    EXPECT_FALSE(tester_.diagnosis().is_reset_requested());
    memories_.refuse(false);
    EXPECT_EQ(ask({0x11U, 0x01U}), (Bytes{0x51U, 0x01U}));
    EXPECT_TRUE(tester_.diagnosis().is_reset_requested());
}

// Asked once a minute by then, it takes again what a tester orders.
TEST_F(Uds, AnOrderIsTriedAtOnceWhereTheMemoryHasRefusedForLong) {
    memories_.refuse(true);
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.cycles(30000);
    tester_.unlock();
    const int tries = memories_.one.tries() + memories_.other.tries();
    tester_.send({0x14U, 0xFFU, 0xFFU, 0xFFU});
    tester_.cycles(1);
    EXPECT_EQ(memories_.one.tries() + memories_.other.tries(), tries + 1);
    EXPECT_EQ(tester_.receive(460), no(0x14U, 0x78U));
    EXPECT_EQ(tester_.receive(460), no(0x14U, 0x72U));
    EXPECT_EQ(memories_.one.tries() + memories_.other.tries(), tries + 5) << "and once a second";
    memories_.refuse(false);
    EXPECT_EQ(ask(Bytes{0x2EU, 0xF1U, 0x90U} + Bytes(17U, 'W')), (Bytes{0x6EU, 0xF1U, 0x90U}));
    memories_.refuse(true);
    tester_.heal(DiagnosticCode::imu_lost);
    tester_.cycles(100);
    tester_.send({0x14U, 0xFFU, 0xFFU, 0xFFU});
    EXPECT_EQ(tester_.receive(10), no(0x14U, 0x78U));
    tester_.cycles(300);
    memories_.refuse(false);
    EXPECT_EQ(tester_.receive(110), (Bytes{0x54U}));
}

// Counts alone would be stored within a minute.
TEST_F(Uds, AnOrderlyEndStoresTheRest) {
    for (const bool is_orderly : {false, true}) {
        tester_.cycles(350);
        for (int time = 0; time < 3; ++time) {
            tester_.fail(DiagnosticCode::imu_lost);
            tester_.cycles(2);
            tester_.heal(DiagnosticCode::imu_lost);
            tester_.cycles(110);
        }
        const int writes = memories_.one.writes() + memories_.other.writes();
        if (is_orderly) {
            tester_.diagnosis().stop();
        }
        EXPECT_EQ(memories_.one.writes() + memories_.other.writes() - writes, is_orderly ? 1 : 0);
        tester_.diagnosis().stop();
        const int written = memories_.one.writes() + memories_.other.writes();
        tester_.diagnosis().stop();
        EXPECT_EQ(memories_.one.writes() + memories_.other.writes(), written) << "nothing is left";
    }
}

// ---- trouble codes

TEST_F(Uds, TellsHowManyAndWhichCodesByTheirStatus) {
    EXPECT_EQ(ask({0x19U, 0x01U, 0x0FU}), (Bytes{0x59U, 0x01U, 0x7FU, 0x01U, 0x00U, 0x00U}));
    EXPECT_EQ(ask({0x19U, 0x01U, 0x10U}),
              (Bytes{0x59U, 0x01U, 0x7FU, 0x01U, 0x00U, rsi::diagnosis::trouble_code_count}));
    EXPECT_EQ(ask({0x19U, 0x02U, 0x0FU}), (Bytes{0x59U, 0x02U, 0x7FU}));
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.fail(DiagnosticCode::own_identifier_received);
    tester_.cycles(2);
    tester_.heal(DiagnosticCode::imu_lost);
    tester_.cycles(20);
    EXPECT_EQ(ask({0x19U, 0x01U, 0x08U}), (Bytes{0x59U, 0x01U, 0x7FU, 0x01U, 0x00U, 0x02U}));
    EXPECT_EQ(ask({0x19U, 0x02U, 0x01U}), (Bytes{0x59U, 0x02U, 0x7FU, 0xD0U, 0xD0U, 0x08U, 0x2FU}));
    const Bytes both = Bytes{0x59U, 0x02U, 0x7FU} + imu_lost + Bytes{0x2EU, 0xD0U, 0xD0U, 0x08U, 0x2FU};
    EXPECT_EQ(ask({0x19U, 0x02U, 0x08U}), both);
    EXPECT_EQ(ask({0x19U, 0x02U, 0x80U}), (Bytes{0x59U, 0x02U, 0x7FU}));
}

TEST_F(Uds, ListsEveryCode) {
    const Bytes answer = ask({0x19U, 0x0AU});
    ASSERT_EQ(answer.size(), 3U + 4U * rsi::diagnosis::trouble_code_count);
    for (std::size_t row = 0U; row < rsi::diagnosis::trouble_code_count; ++row) {
        EXPECT_EQ(rsi::diagnosis::Request(answer.data(), answer.size(), false).u24_at(3U + 4U * row),
                  rsi::diagnosis::trouble_codes[row].number);
        EXPECT_EQ(answer[6U + 4U * row], 0x50U);
    }
}

TEST_F(Uds, TellsSnapshots) {
    tester_.measured = {1.0F, -0.002F, 0.5F, 12.34F};
    tester_.calibration.checksum = 0x89ABCDEFU;
    tester_.cycles(99);
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.cycles(1);
    tester_.heal(DiagnosticCode::imu_lost);
    tester_.cycles(100);
    tester_.measured.lateral_acceleration_mps2 = rsi::not_available;
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.cycles(1);
    const Bytes head = Bytes{0x59U, 0x04U} + imu_lost + Bytes{0x2FU};
    const Bytes of_both{0U, 0U, 0U, 1U, 0x89U, 0xABU, 0xCDU, 0xEFU};  // operation cycle, checksum
    const Bytes first = Bytes{0x01U, 0x01U, 0x02U, 0x00U, 0x00U, 100U,  0xFFU,
                              0xFEU, 0x01U, 0xF4U, 0x04U, 0xD2U, 0x00U, 0x01U} +
                        of_both;
    const Bytes last =
        Bytes{0x02U, 0x01U, 0x02U, 0x00U, 0x80U, 0U, 0xFFU, 0xFEU, 0x01U, 0xF4U, 0x04U, 0xD2U, 0x00U, 0x02U} +
        of_both;
    EXPECT_EQ(ask(Bytes{0x19U, 0x04U} + imu_lost + Bytes{0x01U}), head + first);
    EXPECT_EQ(ask(Bytes{0x19U, 0x04U} + imu_lost + Bytes{0x02U}), head + last);
    EXPECT_EQ(ask(Bytes{0x19U, 0x04U} + imu_lost + Bytes{0xFFU}), head + first + last);
    EXPECT_EQ(ask(Bytes{0x19U, 0x04U} + imu_lost + Bytes{0x03U}), no(0x19U, 0x31U));
    EXPECT_EQ(ask({0x19U, 0x04U, 0x12U, 0x34U, 0x56U, 0xFFU}), no(0x19U, 0x31U));
    EXPECT_EQ(ask({0x19U, 0x04U, 0xD0U, 0xD0U, 0x08U, 0xFFU}),
              (Bytes{0x59U, 0x04U, 0xD0U, 0xD0U, 0x08U, 0x50U}));
}

TEST_F(Uds, TellsExtendedData) {
    for (int time = 0; time < 3; ++time) {
        tester_.fail(DiagnosticCode::imu_lost);
        tester_.cycles(1);
        tester_.heal(DiagnosticCode::imu_lost);
        tester_.cycles(20);
    }
    const Bytes head = Bytes{0x59U, 0x06U} + imu_lost + Bytes{0x2EU};
    EXPECT_EQ(ask(Bytes{0x19U, 0x06U} + imu_lost + Bytes{0x01U}), head + Bytes({0x01U, 3U}));
    EXPECT_EQ(ask(Bytes{0x19U, 0x06U} + imu_lost + Bytes{0x02U}), head + Bytes({0x02U, 0U}));
    EXPECT_EQ(ask(Bytes{0x19U, 0x06U} + imu_lost + Bytes{0xFFU}), head + Bytes({0x01U, 3U, 0x02U, 0U}));
    EXPECT_EQ(ask(Bytes{0x19U, 0x06U} + imu_lost + Bytes{0x00U}), no(0x19U, 0x31U));
    EXPECT_EQ(ask({0x19U, 0x06U, 0x12U, 0x34U, 0x56U, 0x01U}), no(0x19U, 0x31U));
}

// A fault that grows, or comes and goes, before the code is confirmed.
TEST_F(Uds, TellsTheCountersOfWhatIsAboutToFail) {
    const Bytes none{0x59U, 0x14U};
    const auto ask_once = [&] {  // a cycle
        tester_.send({0x19U, 0x14U});
        return tester_.receive(0);
    };
    EXPECT_EQ(ask_once(), none);
    EXPECT_EQ(ask({0x19U, 0x14U, 0xFFU}), no(0x19U, 0x13U));
    tester_.fail(DiagnosticCode::imu_damaged);  // confirmed after three cycles
    tester_.fail(DiagnosticCode::imu_lost);     // after one: never about to be
    EXPECT_EQ(ask_once(), none + Bytes({0xD1U, 0x20U, 0x83U, 42U})) << "2 of 6";
    tester_.heal(DiagnosticCode::imu_damaged);
    EXPECT_EQ(ask_once(), none + Bytes({0xD1U, 0x20U, 0x83U, 21U})) << "1 of 6";
    EXPECT_EQ(ask_once(), none);
    tester_.fail(DiagnosticCode::imu_damaged);
    tester_.cycles(3);
    EXPECT_EQ(ask_once(), none) << "confirmed";
}

// Those of a code that is cleared begin again at zero, and so does its good test.
TEST_F(Uds, AClearBeginsTheDebounceAnew) {
    tester_.unlock();
    tester_.fail(DiagnosticCode::imu_damaged);
    tester_.fail(DiagnosticCode::roll_angle_damaged);
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.cycles(1);
    tester_.heal(DiagnosticCode::imu_damaged);
    tester_.heal(DiagnosticCode::roll_angle_damaged);
    tester_.send({0x14U, 0xD1U, 0x20U, 0x83U});
    EXPECT_EQ(tester_.monitoring().fault_detection_counter(DiagnosticCode::imu_damaged), 0U);
    EXPECT_EQ(tester_.monitoring().status(DiagnosticCode::imu_damaged), rsi::monitoring::EventStatus::none);
    EXPECT_GT(tester_.monitoring().fault_detection_counter(DiagnosticCode::roll_angle_damaged), 0U);
    EXPECT_TRUE(tester_.monitoring().confirmed(DiagnosticCode::imu_lost)) << "the monitoring goes on";
}

// Each check by itself: one that cannot run, for want of its sensor, leaves the others alone.
TEST_F(Uds, TellsWhichTestsAreCompleted) {
    tester_.tested = rsi::monitoring::set_of(DiagnosticCode::imu_lost, DiagnosticCode::imu_damaged);
    tester_.fail(DiagnosticCode::roll_angle_lost);
    tester_.cycles(100);
    const Bytes codes = ask({0x19U, 0x0AU});
    for (std::size_t row = 0U; row < rsi::diagnosis::trouble_code_count; ++row) {
        const bool is_tested = (row <= 1U);
        const bool has_failed = (row == 2U);
        EXPECT_EQ(codes.at(6U + 4U * row), has_failed ? 0x2FU : (is_tested ? 0x00U : 0x50U)) << row;
    }
}

TEST_F(Uds, ClearsWithTheKeyOnlyAndStoresThat) {
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.fail(DiagnosticCode::roll_angle_lost);
    tester_.cycles(2);
    tester_.heal(DiagnosticCode::imu_lost);
    tester_.heal(DiagnosticCode::roll_angle_lost);
    tester_.cycles(200);
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), no(0x14U, 0x33U));
    tester_.unlock();
    EXPECT_EQ(ask(Bytes{0x14U} + imu_lost), (Bytes{0x54U}));
    EXPECT_EQ(ask({0x19U, 0x02U, 0x08U}), (Bytes{0x59U, 0x02U, 0x7FU, 0xD1U, 0x21U, 0x87U, 0x2EU}));
    EXPECT_EQ(ask({0x14U, 0x12U, 0x34U, 0x56U}), no(0x14U, 0x31U));
    EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), (Bytes{0x54U}));
    switch_on_again();
    EXPECT_EQ(ask({0x19U, 0x01U, 0x2FU}), (Bytes{0x59U, 0x01U, 0x7FU, 0x01U, 0x00U, 0x00U}));
}

TEST_F(Uds, CodesOutliveALossOfPower) {
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.cycles(150);
    switch_on_again();
    EXPECT_EQ(ask({0x19U, 0x02U, 0x08U}), Bytes({0x59U, 0x02U, 0x7FU}) + imu_lost + Bytes(1U, 0x6CU));
}

// The record before was written less than a second ago.
TEST_F(Uds, AClearThatTakesTimeIsAnnounced) {
    tester_.unlock();
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.cycles(100);
    tester_.heal(DiagnosticCode::imu_lost);
    tester_.cycles(12);
    ask({0x14U, 0xFFU, 0xFFU, 0xFFU});
    const int told = tester_.times_told_later;
    EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), (Bytes{0x54U}));
    EXPECT_EQ(tester_.times_told_later, told + 1);
}

TEST_F(Uds, AMemoryThatTakesNothingIsSaid) {
    tester_.unlock();
    memories_.refuse(true);
    EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), no(0x14U, 0x72U));
    tester_.cycles(200);
    EXPECT_EQ(ask({0x31U, 0x01U, 0x02U, 0x03U}), (Bytes{0x71U, 0x01U, 0x02U, 0x03U, 0x20U}));
    EXPECT_TRUE(tester_.diagnosis().is_storage_failing());
    memories_.refuse(false);
    tester_.cycles(1024);
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask({0x31U, 0x01U, 0x02U, 0x03U}), (Bytes{0x71U, 0x01U, 0x02U, 0x03U, 0x00U}));
}

// With the key too: no more than a memory lasts for, until the next operation cycle.
TEST_F(Uds, OrdersAreLimitedOfAStart) {
    tester_.unlock();
    for (int order = 0; order < 100; ++order) {
        tester_.cycles(100);
        ASSERT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), (Bytes{0x54U})) << order;
    }
    const int writes = memories_.one.writes() + memories_.other.writes();
    EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), no(0x14U, 0x22U));
    EXPECT_EQ(ask(Bytes{0x2EU, 0xF1U, 0x90U} + Bytes(17U, 'W')), no(0x2EU, 0x22U));
    tester_.cycles(200);
    EXPECT_EQ(memories_.one.writes() + memories_.other.writes(), writes);
}

// While it waits for the memory, neither another request nor a functional one gets between.
TEST_F(Uds, WhileItWaitsNoOtherRequestIsServed) {
    tester_.unlock();
    memories_.refuse(true);
    tester_.send({0x14U, 0xFFU, 0xFFU, 0xFFU});
    tester_.send_frame(Tester::physical, {0x02U, 0x10U, 0x01U});
    EXPECT_EQ(tester_.ask_functional({0x10U, 0x01U}), no(0x14U, 0x78U));
    EXPECT_EQ(tester_.ask_functional({0x3EU, 0x80U}), Bytes{});
    tester_.send_frame(Tester::physical, {0x02U, 0x10U, 0x01U});
    tester_.cycles(3);
    memories_.refuse(false);
    EXPECT_EQ(tester_.receive(110), (Bytes{0x54U}));
    tester_.cycles(3);
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::extended);
}

// The bus takes no frame while "later" is to be said.
TEST_F(Uds, AnAnswerWaitsUntilLaterHasBeenSaid) {
    tester_.unlock();
    tester_.cycles(110);  // the last record is a second old: the next is taken as soon as the memory may
    memories_.refuse(true);
    tester_.send({0x14U, 0xFFU, 0xFFU, 0xFFU});
    tester_.set_bus_state(rsi::hal::BusState::bus_off);
    tester_.cycles(10);
    memories_.refuse(false);
    tester_.cycles(10);
    tester_.set_bus_state(rsi::hal::BusState::error_active);
    EXPECT_EQ(tester_.receive(2), no(0x14U, 0x78U));
    EXPECT_EQ(tester_.receive(110), (Bytes{0x54U}));
}

TEST_F(Uds, AFunctionalRequestMayClear) {
    tester_.unlock();
    memories_.refuse(true);
    EXPECT_EQ(tester_.ask_functional({0x14U, 0xFFU, 0xFFU, 0xFFU}), no(0x14U, 0x78U));
    tester_.ask_functional({0x3EU, 0x80U}, 2);
    memories_.refuse(false);
    EXPECT_EQ(tester_.receive(110), (Bytes{0x54U}));

    // Functional requests are dropped again while an answer goes out.
    tester_.send({0x22U, 0xF1U, 0x90U});
    tester_.send_frame(Tester::functional, {0x02U, 0x10U, 0x01U});
    tester_.cycle();
    EXPECT_EQ(tester_.receive(20).size(), 20U);
    tester_.cycles(3);
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::extended);
}

TEST_F(Uds, RecordingIsOffUntilItIsOnOrTheSessionEnds) {
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask({0x85U, 0x02U}), (Bytes{0xC5U, 0x02U}));
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.cycles(10);
    EXPECT_EQ(ask({0x19U, 0x02U, 0x08U}), (Bytes{0x59U, 0x02U, 0x7FU}));
    EXPECT_EQ(ask({0x85U, 0x01U}), (Bytes{0xC5U, 0x01U}));
    EXPECT_EQ(ask({0x19U, 0x01U, 0x08U})[5], 1U);
}

TEST_F(Uds, RecordingIsOffAtRestOnly) {
    ask({0x10U, 0x03U});
    for (const float speed_mps : {1.5F, rsi::not_available}) {
        tester_.inputs.speed_mps = speed_mps;
        EXPECT_EQ(ask({0x85U, 0x02U}), no(0x85U, 0x22U));
        EXPECT_EQ(ask({0x85U, 0x01U}), (Bytes{0xC5U, 0x01U}));
    }
    tester_.inputs.speed_mps = 0.0F;
    EXPECT_EQ(ask({0x85U, 0x02U}), (Bytes{0xC5U, 0x02U}));
    tester_.inputs.speed_mps = 1.5F;
    tester_.cycles(1);
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.cycles(3);
    EXPECT_EQ(ask({0x19U, 0x01U, 0x08U})[5], 1U);
}

// ---- data

TEST_F(Uds, TellsWhatItIs) {
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x82U}), Bytes({0x62U, 0xF1U, 0x82U}) + text("large_suv", 48U));
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x8CU}), Bytes({0x62U, 0xF1U, 0x8CU}) + text("4711", 16U));
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x91U}), Bytes({0x62U, 0xF1U, 0x91U}) + text("none", 16U));
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x95U}), Bytes({0x62U, 0xF1U, 0x95U}) + text("0.2.0", 16U));
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x97U}), Bytes({0x62U, 0xF1U, 0x97U}) + text("Rollover warning", 16U));
}

// That of the section in use, where there is one, and of the values themselves.
TEST_F(Uds, TellsTheCalibrationInUse) {
    EXPECT_EQ(ask({0x22U, 0xF1U, 0xA0U}), (Bytes{0x62U, 0xF1U, 0xA0U, 0U, 0U, 0U, 0U}));
    tester_.calibration.checksum = 0x89ABCDEFU;
    const Bytes name = text("van, winter", 48U);
    std::copy(name.begin(), name.end(), tester_.calibration.name.begin());
    EXPECT_EQ(ask({0x22U, 0xF1U, 0xA0U}), (Bytes{0x62U, 0xF1U, 0xA0U, 0x89U, 0xABU, 0xCDU, 0xEFU}));
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x82U}), Bytes({0x62U, 0xF1U, 0x82U}) + name);
    tester_.calibration.name = {'A'};
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x82U}), Bytes({0x62U, 0xF1U, 0x82U}) + text("A", 48U));
}

// By it a tester knows how long ago a snapshot is.
TEST_F(Uds, TellsTheOperationCycle) {
    EXPECT_EQ(ask({0x22U, 0xF1U, 0xA1U}), (Bytes{0x62U, 0xF1U, 0xA1U, 0U, 0U, 0U, 1U}));
    switch_on_again();
    EXPECT_EQ(ask({0x22U, 0xF1U, 0xA1U}), (Bytes{0x62U, 0xF1U, 0xA1U, 0U, 0U, 0U, 2U}));
}

TEST_F(Uds, TellsEveryOutputAndInput) {
    for (std::size_t number = 0U; number < rsi::number_outputs.size(); ++number) {
        tester_.outputs.*rsi::number_outputs[number].member = 0.1F + static_cast<float>(number);
        const Bytes answer = ask({0x22U, 0x10U, static_cast<std::uint8_t>(number)});
        ASSERT_EQ(answer.size(), 7U);
        EXPECT_EQ(number_in(answer, 3U), 0.1F + static_cast<float>(number));
    }
    for (std::size_t code = 0U; code < rsi::code_outputs.size(); ++code) {
        tester_.outputs.*rsi::code_outputs[code].member = static_cast<std::int32_t>(code + 1U);
        EXPECT_EQ(
            ask({0x22U, 0x11U, static_cast<std::uint8_t>(code)}),
            (Bytes{0x62U, 0x11U, static_cast<std::uint8_t>(code), static_cast<std::uint8_t>(code + 1U)}));
    }
    for (std::size_t input = 0U; input < rsi::diagnosis::input_values.size(); ++input) {
        tester_.inputs.*rsi::diagnosis::input_values[input].member = -1.25F * static_cast<float>(input);
        EXPECT_EQ(number_in(ask({0x22U, 0x12U, static_cast<std::uint8_t>(input)}), 3U),
                  -1.25F * static_cast<float>(input));
    }
    EXPECT_EQ(ask({0x22U, 0x10U, static_cast<std::uint8_t>(rsi::number_outputs.size())}), no(0x22U, 0x31U));
    EXPECT_EQ(ask({0x22U, 0x11U, static_cast<std::uint8_t>(rsi::code_outputs.size())}), no(0x22U, 0x31U));
    EXPECT_EQ(ask({0x22U, 0x12U, static_cast<std::uint8_t>(rsi::diagnosis::input_values.size())}),
              no(0x22U, 0x31U));
}

TEST(DataIdentifiers, TheMembersOfATableAreInItsOrder) {
    auto table = rsi::code_outputs;
    const auto members = rsi::diagnosis::members_of<std::int32_t rsi::Outputs::*>(table);
    ASSERT_EQ(members.size(), table.size());
    for (std::size_t row = 0U; row < table.size(); ++row) {
        EXPECT_EQ(members[row], table[row].member);
    }
}

TEST_F(Uds, SeveralIdentifiersComeTogetherAndUnknownOnesAreLeftOut) {
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x86U, 0x00U, 0x01U, 0x11U, 0x00U}),
              (Bytes{0x62U, 0xF1U, 0x86U, 0x01U, 0x11U, 0x00U, 0x00U}));
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x86U, 0x00U, 0x01U}), (Bytes{0x62U, 0xF1U, 0x86U, 0x01U}));
    EXPECT_EQ(ask({0x22U, 0x00U, 0x01U, 0x0FU, 0xFFU}), no(0x22U, 0x31U));
    Bytes much{0x22U};
    for (int time = 0; time < 6; ++time) {
        much = much + Bytes{0xF1U, 0x82U};
    }
    EXPECT_EQ(ask(much), no(0x22U, 0x14U));
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x86U}), (Bytes{0x62U, 0xF1U, 0x86U, 0x01U}));
}

TEST_F(Uds, WritesIdentificationWithTheKeyOnlyAndStoresIt) {
    const Bytes number(17U, 'W');
    EXPECT_EQ(ask(Bytes{0x2EU, 0xF1U, 0x90U} + number), no(0x2EU, 0x7FU));
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask(Bytes{0x2EU, 0xF1U, 0x90U} + number), no(0x2EU, 0x33U));
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x90U}), Bytes({0x62U, 0xF1U, 0x90U}) + Bytes(17U, 0U));
    tester_.unlock();
    EXPECT_EQ(ask(Bytes{0x2EU, 0xF1U, 0x90U} + number), (Bytes{0x6EU, 0xF1U, 0x90U}));
    EXPECT_EQ(ask({0x2EU, 0xF1U, 0x99U, 0x20U, 0x26U, 0x11U, 0x25U}), (Bytes{0x6EU, 0xF1U, 0x99U}));
    EXPECT_EQ(ask({0x2EU, 0xF1U, 0x99U, 0x20U, 0x26U, 0x11U}), no(0x2EU, 0x13U));
    EXPECT_EQ(ask({0x2EU, 0xF1U, 0x95U, 1U}), no(0x2EU, 0x31U));
    switch_on_again();
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x90U}), Bytes({0x62U, 0xF1U, 0x90U}) + number);
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x99U}), (Bytes{0x62U, 0xF1U, 0x99U, 0x20U, 0x26U, 0x11U, 0x25U}));
}

TEST_F(Uds, TakesNumbersOfVehiclesOnly) {
    tester_.unlock();
    const auto write = [&](const Bytes& number) { return ask(Bytes{0x2EU, 0xF1U, 0x90U} + number); };
    const Bytes good{'W', 'V', 'W', 'Z', 'Z', 'Z', '1', 'J', 'A', '0', '9', 'W', '0', '0', '0', '0', '1'};
    EXPECT_EQ(write(good), (Bytes{0x6EU, 0xF1U, 0x90U}));
    for (const std::size_t place : {std::size_t{0U}, std::size_t{16U}}) {
        for (const char wrong : {'I', 'O', 'Q', 'a', 'z', '/', ':', '@', '[', ' ', '\0', '\xFF'}) {
            Bytes number = good;
            number[place] = static_cast<std::uint8_t>(wrong);
            EXPECT_EQ(write(number), no(0x2EU, 0x31U)) << wrong;
        }
    }
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x90U}), Bytes({0x62U, 0xF1U, 0x90U}) + good);
}

TEST_F(Uds, TakesDatesOnly) {
    tester_.unlock();
    const auto is_taken = [&](const Bytes& date) {
        const Bytes answer = ask(Bytes{0x2EU, 0xF1U, 0x99U} + date);
        EXPECT_TRUE(answer == no(0x2EU, 0x31U) || answer == Bytes({0x6EU, 0xF1U, 0x99U}));
        return answer[0] == 0x6EU;
    };
    for (const Bytes& good : {Bytes{0x20U, 0x00U, 0x01U, 0x01U}, Bytes{0x20U, 0x99U, 0x12U, 0x31U},
                              Bytes{0x20U, 0x28U, 0x02U, 0x29U}, Bytes{0x20U, 0x26U, 0x04U, 0x30U}}) {
        EXPECT_TRUE(is_taken(good));
    }
    for (const Bytes& bad : {Bytes{0x19U, 0x99U, 0x12U, 0x31U}, Bytes{0x20U, 0x9AU, 0x12U, 0x31U},
                             Bytes{0x20U, 0xA0U, 0x12U, 0x31U}, Bytes{0x20U, 0x26U, 0x00U, 0x01U},
                             Bytes{0x20U, 0xA1U, 0x12U, 0x31U}, Bytes{0x20U, 0x1AU, 0x12U, 0x31U},
                             Bytes{0x1AU, 0x26U, 0x12U, 0x31U}, Bytes{0x20U, 0x26U, 0x0AU, 0x01U},
                             Bytes{0x20U, 0x26U, 0x13U, 0x01U}, Bytes{0x20U, 0x26U, 0x12U, 0x00U},
                             Bytes{0x20U, 0x26U, 0x12U, 0x32U}, Bytes{0x20U, 0x26U, 0x02U, 0x29U},
                             Bytes{0x20U, 0x28U, 0x02U, 0x30U}, Bytes{0x20U, 0x26U, 0x04U, 0x31U},
                             Bytes{0x20U, 0x28U, 0x04U, 0x31U}, Bytes{0x20U, 0x26U, 0x12U, 0x1FU},
                             Bytes{0xFFU, 0xFFU, 0xFFU, 0xFFU}, Bytes{0U, 0U, 0U, 0U}}) {
        EXPECT_FALSE(is_taken(bad)) << unsigned{bad[1]} << ' ' << unsigned{bad[2]} << ' ' << unsigned{bad[3]};
    }
}

// ---- access

TEST_F(Uds, TheKeyOfTheSeedUnlocksAndNoOther) {
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask(Bytes{0x27U, 0x02U} + Bytes(16U, 1U)), no(0x27U, 0x24U)) << "no seed was given";
    Bytes seed = ask({0x27U, 0x01U});
    ASSERT_EQ(seed.size(), 18U);
    EXPECT_NE(Bytes(seed.begin() + 2, seed.end()), Bytes(16U, 0U));
    Bytes wrong = Tester::key_of(seed);
    wrong[15] ^= 1U;
    EXPECT_EQ(ask(Bytes{0x27U, 0x02U} + wrong), no(0x27U, 0x35U));
    EXPECT_EQ(ask(Bytes{0x27U, 0x02U} + Tester::key_of(seed)), no(0x27U, 0x24U)) << "the seed is used up";
    seed = ask({0x27U, 0x01U});
    EXPECT_EQ(ask(Bytes{0x27U, 0x02U} + Tester::key_of(seed)), (Bytes{0x67U, 0x02U}));
    EXPECT_EQ(ask({0x27U, 0x01U}), Bytes({0x67U, 0x01U}) + Bytes(16U, 0U)) << "unlocked already";
    EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), (Bytes{0x54U}));
}

TEST_F(Uds, WrongKeysCostTimeAlsoAfterARestart) {
    ask({0x10U, 0x03U});
    for (int attempt = 1; attempt <= 3; ++attempt) {
        ASSERT_EQ(ask({0x27U, 0x01U}).size(), 18U);
        EXPECT_EQ(ask(Bytes{0x27U, 0x02U} + Bytes(16U, 1U)), no(0x27U, attempt < 3 ? 0x35U : 0x36U));
    }
    EXPECT_EQ(ask({0x27U, 0x01U}), no(0x27U, 0x37U));
    switch_on_again();
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask({0x27U, 0x01U}), no(0x27U, 0x37U));
    for (int second = 0; second < 11; ++second) {
        tester_.cycles(100);
        ask({0x3EU, 0x00U});
    }
    EXPECT_EQ(ask({0x27U, 0x01U}).size(), 18U);
}

TEST(UdsWithoutAccess, NothingIsUnlockedAndNoSectionTaken) {
    Memories memories;
    rsi::hal::VirtualClock clock;
    rsi::hal::MemoryBus<2U> bus{clock};
    const rsi::diagnosis::Identification identification{};
    rsi::diagnosis::Diagnosis diagnosis{bus.endpoint(0U), {}, identification, memories.one, memories.other};
    diagnosis.start(true);
    const rsi::monitoring::DiagnosticMemory memory{};
    const auto ask = [&](const Bytes& request) {
        rsi::hal::CanFrame frame{};
        frame.identifier = Tester::physical;
        frame.length = static_cast<std::uint8_t>(request.size() + 1U);
        frame.data[0] = static_cast<std::uint8_t>(request.size());
        std::copy(request.begin(), request.end(), frame.data.begin() + 1);
        bus.endpoint(1U).send(frame);
        bus.endpoint(0U).receive(frame);
        diagnosis.listener().take(frame);
        diagnosis.step(memory, {}, {}, {});
        bus.endpoint(1U).receive(frame);
        return Bytes(frame.data.begin() + 1, frame.data.begin() + 1 + frame.data[0]);
    };
    ask({0x10U, 0x02U});
    EXPECT_EQ(ask({0x27U, 0x01U}), no(0x27U, 0x22U));
    EXPECT_EQ(ask({0x34U, 0x00U, 0x11U, 0U, 1U}), no(0x34U, 0x33U));
}

TEST_F(Uds, ASeedWhoseAttemptCannotBeStoredIsNotGivenAndNoDelayIsToBlame) {
    memories_.attempts.refuse(true);
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask({0x27U, 0x01U}), no(0x27U, 0x22U));
    memories_.attempts.refuse(false);
    EXPECT_EQ(ask({0x27U, 0x01U}).size(), 18U);
}

// ---- communication

TEST_F(Uds, TheEcusFramesStayAwayAtRestOnly) {
    const auto is_sent = [&] { return tester_.diagnosis().lets_ecu_send(); };
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask({0x28U, 0x01U, 0x00U}), no(0x28U, 0x31U));
    EXPECT_EQ(ask({0x28U, 0x01U, 0x04U}), no(0x28U, 0x31U));
    EXPECT_EQ(ask({0x28U, 0x01U, 0x02U}), (Bytes{0x68U, 0x01U}))
        << "network management, which there is none of";
    EXPECT_TRUE(is_sent());
    tester_.inputs.speed_mps = 1.4F;
    EXPECT_EQ(ask({0x28U, 0x01U, 0x01U}), (Bytes{0x68U, 0x01U}));
    tester_.cycles(100);
    EXPECT_FALSE(is_sent());
    EXPECT_EQ(ask({0x28U, 0x00U, 0x01U}), (Bytes{0x68U, 0x00U}));
    EXPECT_TRUE(is_sent());
    for (const float speed : {1.5F, rsi::not_available}) {
        tester_.inputs.speed_mps = 0.0F;
        EXPECT_EQ(ask({0x28U, 0x01U, 0x03U}), (Bytes{0x68U, 0x01U}));
        EXPECT_FALSE(is_sent());
        tester_.inputs.speed_mps = speed;
        tester_.cycle();
        EXPECT_TRUE(is_sent()) << "it moves, or this is not known";
        EXPECT_EQ(ask({0x28U, 0x01U, 0x03U}), no(0x28U, 0x22U));
        EXPECT_EQ(ask({0x28U, 0x00U, 0x03U}), (Bytes{0x68U, 0x00U}));
    }
}

// With the ECU itself: while it is silent it goes on, and finds no fault of the bus.
TEST(UdsBesideTheEcu, TakesItsFramesFromTheBusAndGivesThemBack) {
    Memories memories;
    rsi::hal::VirtualClock clock;
    rsi::hal::MemoryBus<2U> bus{clock};
    testing_application::NoWatchdog watchdog;
    const rsi::diagnosis::Identification identification{};
    rsi::diagnosis::Diagnosis diagnosis{bus.endpoint(0U), {}, identification, memories.one, memories.other};
    rsi::application::RolloverEcu ecu{bus.endpoint(0U), clock, watchdog};
    ASSERT_TRUE(ecu.add_listener(diagnosis.listener()));
    diagnosis.start(true);
    ecu.init(testing_application::large_suv());
    unsigned counter = 0U;
    rsi::hal::Time now{};
    const auto frames_after = [&](const Bytes& request) {
        rsi::hal::CanFrame frame{};
        frame.identifier = Tester::physical;
        frame.length = static_cast<std::uint8_t>(request.size() + 1U);
        frame.data[0] = static_cast<std::uint8_t>(request.size());
        std::copy(request.begin(), request.end(), frame.data.begin() + 1);
        bus.endpoint(1U).send(frame);
        std::size_t sent = 0U;
        for (int cycle = 0; cycle < 2; ++cycle) {  // the second is as the tester wants it
            now = now + rsi::hal::Time::from_milliseconds(10);
            clock.set(now);
            rsi::can_dbc::VehicleMotion standing{};
            standing.speed_kmh = 0.0F;
            bus.endpoint(1U).send(testing_application::frame_of(standing, counter));
            counter = (counter + 1U) % 15U;
            ecu.step(0U);
            diagnosis.step(ecu);
            sent = 0U;
            while (bus.endpoint(1U).receive(frame) == rsi::hal::ReceiveResult::frame) {
                sent += (frame.identifier == Tester::response) ? 0U : 1U;
            }
        }
        return sent;
    };
    EXPECT_EQ(frames_after({0x10U, 0x03U}), testing_application::frames_per_cycle);
    EXPECT_EQ(frames_after({0x28U, 0x01U, 0x01U}), 0U);
    EXPECT_EQ(frames_after({0x28U, 0x00U, 0x01U}), testing_application::frames_per_cycle);
    EXPECT_FALSE(ecu.diagnostic_memory().active(DiagnosticCode::bus_error));
}

// ---- self test

// Without a key, and while it drives.
TEST_F(Uds, TheSelfTestWritesNothing) {
    tester_.cycles(500);
    tester_.inputs.speed_mps = 20.0F;
    ask({0x10U, 0x03U});
    const int writes = memories_.one.writes() + memories_.other.writes();
    for (int second = 0; second < 60; ++second) {
        EXPECT_EQ(ask({0x31U, 0x01U, 0x02U, 0x03U}).size(), 5U);
        tester_.cycles(98);
    }
    EXPECT_EQ(memories_.one.writes() + memories_.other.writes(), writes);
}

TEST_F(Uds, TheSelfTestTellsWhatIsWrong) {
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask({0x31U, 0x03U, 0x02U, 0x03U}), no(0x31U, 0x24U)) << "not yet run";
    EXPECT_EQ(ask({0x31U, 0x01U, 0x02U, 0x03U}), (Bytes{0x71U, 0x01U, 0x02U, 0x03U, 0x00U}));
    const std::pair<DiagnosticCode, std::uint8_t> found[]{{DiagnosticCode::parameters_refused, 0x01U},
                                                          {DiagnosticCode::parameters_damaged, 0x01U},
                                                          {DiagnosticCode::memory_restored, 0x02U},
                                                          {DiagnosticCode::estimate_out_of_range, 0x04U},
                                                          {DiagnosticCode::output_not_finite, 0x04U},
                                                          {DiagnosticCode::cycle_overrun, 0x08U},
                                                          {DiagnosticCode::cycle_stall, 0x08U},
                                                          {DiagnosticCode::clock_jump, 0x08U},
                                                          {DiagnosticCode::bus_error, 0x10U},
                                                          {DiagnosticCode::receive_overflow, 0x10U},
                                                          {DiagnosticCode::stored_parameters_refused, 0x01U},
                                                          {DiagnosticCode::storage_failed, 0x20U},
                                                          {DiagnosticCode::imu_lost, 0x00U}};
    for (const auto& [code, bit] : found) {
        tester_.fail(code);
        tester_.cycles(3);
        EXPECT_EQ(ask({0x31U, 0x01U, 0x02U, 0x03U}), (Bytes{0x71U, 0x01U, 0x02U, 0x03U, bit}));
        EXPECT_EQ(ask({0x31U, 0x03U, 0x02U, 0x03U}), (Bytes{0x71U, 0x03U, 0x02U, 0x03U, bit}));
        tester_.heal(code);
        tester_.cycles(110);
    }
}

}  // namespace
}  // namespace testing_diagnosis
