// Lists of measurements: sampled each cycle, complete or said not to be.
#include "tests/xcp/lists.hpp"

namespace testing_xcp {
namespace {

TEST_F(Lists, AreSampledAfterEachStepWithTheTime) {
    two_lists();
    ASSERT_EQ(set_mode(1U, with_time), good);
    ASSERT_EQ(start(1U), (Bytes{0xFF, 1}));
    EXPECT_EQ(bench.samples.size(), 1U);  // the cycle that starts it has its sample
    std::uint32_t before = bench.samples[0][1] + 256U * bench.samples[0][2];
    for (int k = 0; k < 200; ++k) {
        bench.cycle();
        ASSERT_EQ(bench.samples.size(), 1U);
        const Bytes& sample = bench.samples[0];
        ASSERT_EQ(sample.size(), 7U);
        EXPECT_EQ(sample[0], 1U);
        const std::uint32_t now = sample[1] + 256U * sample[2];
        EXPECT_EQ((now - before) & 0xFFFFU, 100U);
        before = now;
        EXPECT_EQ(sample[3], static_cast<std::uint8_t>(bench.ecu().ecu().outputs().side));
        EXPECT_EQ(bench.others.size(), testing_application::frames_per_cycle);
        EXPECT_TRUE(bench.answers.empty());
    }
    EXPECT_EQ(stop(1U), (Bytes{0xFF, 1}));
    EXPECT_TRUE(bench.samples.empty());
    EXPECT_EQ(bench.command({0xFD}), (Bytes{0xFF, 0x00, 0, 0, 0, 0}));
}

TEST_F(Lists, ComeAtTheirEventAndPrescaler) {
    two_lists();
    ASSERT_EQ(set_mode(0U, 0U, 0U, 3U), good);
    ASSERT_EQ(set_mode(1U, 0U, 1U, 2U), good);
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    ASSERT_EQ(start(1U), (Bytes{0xFF, 1}));
    int fast = 0;
    int slow = 0;
    for (int k = 0; k < 300; ++k) {
        bench.cycle();
        for (const Bytes& sample : bench.samples) {
            (sample[0] == 0U ? fast : slow) += 1;
        }
    }
    EXPECT_EQ(fast, 100);
    EXPECT_EQ(slow, 15);
}

TEST_F(Lists, StartAndStopTogether) {
    two_lists();
    EXPECT_EQ(bench.command({0xDD, 1}), error(0x2A));  // none is selected
    EXPECT_EQ(bench.command({0xDD, 3}), error(0x27));
    EXPECT_EQ(bench.command({0xDE, 3, 0, 0}), error(0x27));
    EXPECT_EQ(select(2U), error(0x22));
    EXPECT_EQ(start(2U), error(0x22));
    EXPECT_EQ(stop(2U), error(0x22));
    select(0U);
    select(1U);
    EXPECT_EQ(bench.command({0xDD, 1}), good);
    EXPECT_EQ(bench.samples.size(), 2U);
    select(0U);
    EXPECT_EQ(bench.command({0xDD, 2}), good);
    EXPECT_EQ(bench.samples.size(), 1U);
    EXPECT_EQ(bench.command({0xDD, 0}), good);
    EXPECT_TRUE(bench.samples.empty());
}

// Whether it comes before those that can, or behind them.
TEST_F(Lists, ThatCannotStartHoldTheOthersBack) {
    for (const std::uint8_t empty : {std::uint8_t{0U}, std::uint8_t{1U}}) {
        two_lists();
        ASSERT_EQ(bench.command({0xE3, 0, empty, 0}), good);
        select(0U);
        select(1U);
        EXPECT_EQ(bench.command({0xDD, 1}), error(0x2A));
        EXPECT_TRUE(bench.samples.empty());
        EXPECT_EQ(bench.command({0xFD}), (Bytes{0xFF, 0x00, 0, 0, 0, 0}));
        EXPECT_EQ(bench.command({0xDD, 0}), good);
        EXPECT_EQ(bench.command({0xDD, 1}), error(0x2A));  // and are selected no longer
    }
}

TEST_F(Lists, HaveTheTimeInTheirFirstPartAlone) {
    ASSERT_EQ(allot_lists(1U), good);
    ASSERT_EQ(allot_parts(0U, 2U), good);
    ASSERT_EQ(allot_entries(0U, 1U, 1U), good);
    ASSERT_EQ(point_to(0U, 1U, 0U), good);
    ASSERT_EQ(write(map::epk_at, 7U), good);
    ASSERT_EQ(set_mode(0U, with_time), good);
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    ASSERT_EQ(bench.samples.size(), 2U);
    EXPECT_EQ(bench.samples[0].size(), 3U);
    const Bytes second = bench.samples[1];
    ASSERT_EQ(second.size(), 8U);
    EXPECT_EQ((Bytes{second.begin() + 1, second.end()}), bench.upload(map::epk_at, 7U));
}

TEST_F(Lists, AreSelectedUntilTheyAreStopped) {
    two_lists();
    const auto selected = [&] { return bench.command({0xDF, 0, 1, 0}).at(1U) & 1U; };
    select(1U);
    EXPECT_EQ(selected(), 1U);
    EXPECT_EQ(bench.command({0xDD, 0}), good);
    EXPECT_EQ(selected(), 0U);
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    ASSERT_EQ(start(1U), (Bytes{0xFF, 1}));
    select(1U);
    EXPECT_EQ(bench.command({0xDD, 2}), good);
    EXPECT_EQ(selected(), 0U);
    ASSERT_EQ(bench.samples.size(), 1U);
    EXPECT_EQ(bench.samples[0][0], 0U);
}

// One that is started again begins at once, whatever its prescaler had left.
TEST_F(Lists, BeginAtOnceWhenTheyAreStartedAgain) {
    two_lists();
    ASSERT_EQ(set_mode(0U, 0U, 0U, 50U), good);
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    EXPECT_EQ(bench.samples.size(), 1U);
    stop(0U);
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    EXPECT_EQ(bench.samples.size(), 1U);
}

TEST_F(Lists, LeaveNoEventToAnotherSession) {
    two_lists();
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    bench.ecu_bus().set_state(rsi::hal::BusState::bus_off);
    bench.cycle();
    bench.command({0xF9, 0x01});
    bench.ecu_bus().set_state(rsi::hal::BusState::error_active);
    bench.connect();
    EXPECT_EQ(bench.answers.size(), 1U);
}

// At the slow event: its first sample within 100 ms of the start.
TEST_F(Lists, OfTheSlowEventBeginWithin100Milliseconds) {
    two_lists();
    ASSERT_EQ(set_mode(0U, 0U, 1U), good);
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));  // the first cycle
    std::size_t samples = bench.samples.size();
    for (int cycle = 2; cycle <= 10; ++cycle) {
        bench.cycle();
        samples += bench.samples.size();
    }
    EXPECT_EQ(samples, 1U);
}

TEST_F(Lists, EndWithTheSession) {
    two_lists();
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    bench.connect();
    EXPECT_TRUE(bench.samples.empty());
    bench.connect_and_unlock();
    EXPECT_EQ(start(0U), error(0x22));
}

// Twenty parts: as many as there are, with a value each, each cycle.
TEST_F(Lists, TakeTwentyValuesInEachCycle) {
    ASSERT_EQ(allot_lists(1U), good);
    ASSERT_EQ(allot_parts(0U, 20U), good);
    for (std::uint8_t part = 0U; part < 20U; ++part) {
        ASSERT_EQ(allot_entries(0U, part, 1U), good);
    }
    for (std::uint8_t part = 0U; part < 20U; ++part) {
        ASSERT_EQ(point_to(0U, part, 0U), good);
        ASSERT_EQ(write(map::outputs_at + 4U * part, 4U), good);
    }
    ASSERT_EQ(set_mode(0U, with_time), good);
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    for (int k = 0; k < 50; ++k) {
        bench.cycle();
        ASSERT_EQ(bench.samples.size(), 20U);
        for (std::uint8_t part = 0U; part < 20U; ++part) {
            ASSERT_EQ(bench.samples[part][0], part);
        }
    }
}

TEST_F(Lists, SayThatSamplesAreMissing) {
    two_lists();
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    bench.cycle(1U);
    EXPECT_EQ(bench.answers, std::vector<Bytes>{(Bytes{0xFD, 0x06})});
    bench.cycle();
    EXPECT_TRUE(bench.answers.empty());
}

// A bus that takes nothing: told once it takes frames again.
TEST_F(Lists, SayThatTheBusTookNothing) {
    two_lists();
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    bench.ecu_bus().set_state(rsi::hal::BusState::bus_off);
    bench.cycles(3);
    EXPECT_TRUE(bench.answers.empty());
    bench.ecu_bus().set_state(rsi::hal::BusState::error_active);
    bench.cycle();
    EXPECT_EQ(bench.answers, std::vector<Bytes>{(Bytes{0xFD, 0x06})});
    EXPECT_EQ(bench.samples.size(), 1U);
    bench.cycle();
    EXPECT_TRUE(bench.answers.empty());
}

}  // namespace
}  // namespace testing_xcp
