// Lists of measurements: allotted within bounds, sampled each cycle, complete or said not to be.
#include <gtest/gtest.h>

#include "tests/xcp/bench.hpp"

namespace testing_xcp {
namespace {

const Bytes good{0xFF};
constexpr std::uint8_t with_time = 0x10U;

Bytes error(int code) {
    return {0xFE, static_cast<std::uint8_t>(code)};
}

class Lists : public ::testing::Test {
 protected:
    Lists() { bench.connect_and_unlock(); }

    Bytes allot_lists(std::uint8_t count) { return bench.command({0xD5, 0, count, 0}); }
    Bytes allot_parts(std::uint8_t list, std::uint8_t count) {
        return bench.command({0xD4, 0, list, 0, count});
    }
    Bytes allot_entries(std::uint8_t list, std::uint8_t part, std::uint8_t count) {
        return bench.command({0xD3, 0, list, 0, part, count});
    }
    Bytes point_to(std::uint8_t list, std::uint8_t part, std::uint8_t entry) {
        return bench.command({0xE2, 0, list, 0, part, entry});
    }
    Bytes write(std::uint32_t address, std::uint8_t size) {
        return bench.command(Bench::with_word({0xE1, 0xFF, size, 0}, address));
    }
    Bytes set_mode(std::uint8_t list, std::uint8_t mode, std::uint8_t event = 0U,
                   std::uint8_t prescaler = 1U) {
        return bench.command({0xE0, mode, list, 0, event, 0, prescaler, 0});
    }
    Bytes start(std::uint8_t list) { return bench.command({0xDE, 1, list, 0}); }
    Bytes stop(std::uint8_t list) { return bench.command({0xDE, 0, list, 0}); }
    Bytes select(std::uint8_t list) { return bench.command({0xDE, 2, list, 0}); }

    // One list with one part of one entry each: the outputs' first word, and the one after it.
    void two_lists() {
        ASSERT_EQ(bench.command({0xD6}), good);
        ASSERT_EQ(allot_lists(2U), good);
        for (std::uint8_t list = 0U; list < 2U; ++list) {
            ASSERT_EQ(allot_parts(list, 1U), good);
        }
        for (std::uint8_t list = 0U; list < 2U; ++list) {
            ASSERT_EQ(allot_entries(list, 0U, 1U), good);
            ASSERT_EQ(point_to(list, 0U, 0U), good);
            ASSERT_EQ(write(map::outputs_at + 4U * list, 4U), good);
        }
    }

    Bench bench;
};

TEST_F(Lists, AreAllottedInOrderAndWithinBounds) {
    EXPECT_EQ(allot_parts(0U, 1U), error(0x22));
    EXPECT_EQ(allot_lists(5U), error(0x30));
    EXPECT_EQ(allot_lists(2U), good);
    EXPECT_EQ(allot_lists(2U), error(0x29));
    EXPECT_EQ(bench.command({0xDA}), (Bytes{0xFF, 0x93, 2, 0, 2, 0, 0, 0}));
    EXPECT_EQ(allot_entries(0U, 0U, 1U), error(0x22));
    EXPECT_EQ(allot_parts(0U, 21U), error(0x30));
    EXPECT_EQ(allot_parts(0U, 15U), good);
    EXPECT_EQ(allot_parts(0U, 1U), error(0x29));
    EXPECT_EQ(allot_parts(1U, 6U), error(0x30));
    EXPECT_EQ(allot_parts(2U, 1U), error(0x22));
    EXPECT_EQ(allot_parts(1U, 5U), good);
    EXPECT_EQ(allot_entries(2U, 0U, 1U), error(0x22));
    EXPECT_EQ(allot_entries(1U, 5U, 1U), error(0x22));
    EXPECT_EQ(allot_entries(0U, 0U, 8U), error(0x30));
    for (std::uint8_t part = 0U; part < 9U; ++part) {
        EXPECT_EQ(allot_entries(0U, part, 7U), good);
    }
    EXPECT_EQ(allot_entries(0U, 9U, 2U), error(0x30));
    EXPECT_EQ(allot_entries(0U, 9U, 1U), good);
    EXPECT_EQ(allot_entries(0U, 9U, 1U), error(0x29));
    EXPECT_EQ(allot_parts(1U, 1U), error(0x29));
    EXPECT_EQ(bench.command({0xD6}), good);
    EXPECT_EQ(allot_lists(4U), good);
    EXPECT_EQ(allot_parts(3U, 20U), good);
}

TEST_F(Lists, AreWrittenWithWhatMayBeRead) {
    two_lists();
    EXPECT_EQ(write(map::outputs_at, 4U), error(0x29));  // behind the last entry
    EXPECT_EQ(point_to(2U, 0U, 0U), error(0x22));
    EXPECT_EQ(point_to(0U, 1U, 0U), error(0x22));
    EXPECT_EQ(point_to(0U, 0U, 1U), error(0x22));
    EXPECT_EQ(point_to(0U, 0U, 0U), good);
    EXPECT_EQ(write(map::outputs_at, 0U), error(0x24));
    EXPECT_EQ(write(map::outputs_at, 8U), error(0x24));
    EXPECT_EQ(write(map::outputs_at - 1U, 1U), error(0x24));
    EXPECT_EQ(write(map::outputs_at | 0x01000000U, 4U), error(0x24));
    EXPECT_EQ(bench.command(Bench::with_word({0xE1, 0x00, 4, 0}, map::outputs_at)), error(0x22));
    EXPECT_EQ(bench.command(Bench::with_word({0xE1, 0xFF, 4, 1}, map::outputs_at)), error(0x22));
    EXPECT_EQ(write(map::outputs_at, 7U), good);
}

TEST_F(Lists, HaveNoMoreBytesInAPartThanAFrame) {
    ASSERT_EQ(allot_lists(1U), good);
    ASSERT_EQ(allot_parts(0U, 1U), good);
    ASSERT_EQ(allot_entries(0U, 0U, 2U), good);
    ASSERT_EQ(point_to(0U, 0U, 0U), good);
    EXPECT_EQ(write(map::outputs_at, 4U), good);
    EXPECT_EQ(write(map::outputs_at, 4U), error(0x2A));
    EXPECT_EQ(set_mode(0U, 0U), good);
    EXPECT_EQ(start(0U), error(0x2A));  // an entry is still empty
    EXPECT_EQ(write(map::outputs_at, 3U), good);
    EXPECT_EQ(set_mode(0U, with_time), good);
    EXPECT_EQ(start(0U), error(0x2A));  // no room for the time
    EXPECT_EQ(set_mode(0U, 0U), good);
    EXPECT_EQ(start(0U), (Bytes{0xFF, 0}));
}

// The first of two entries is empty, and so is a whole part.
TEST_F(Lists, DoNotStartWithAnEmptyEntry) {
    ASSERT_EQ(allot_lists(1U), good);
    ASSERT_EQ(allot_parts(0U, 2U), good);
    ASSERT_EQ(allot_entries(0U, 0U, 2U), good);
    ASSERT_EQ(allot_entries(0U, 1U, 1U), good);
    ASSERT_EQ(point_to(0U, 0U, 1U), good);
    ASSERT_EQ(write(map::outputs_at, 1U), good);
    EXPECT_EQ(start(0U), error(0x2A));
    ASSERT_EQ(point_to(0U, 0U, 0U), good);
    ASSERT_EQ(write(map::outputs_at, 1U), good);
    EXPECT_EQ(start(0U), error(0x2A));
    ASSERT_EQ(point_to(0U, 1U, 0U), good);
    ASSERT_EQ(write(map::outputs_at, 1U), good);
    EXPECT_EQ(start(0U), (Bytes{0xFF, 0}));
    EXPECT_EQ(bench.samples.size(), 2U);
}

TEST_F(Lists, HaveAModeThatIsTold) {
    two_lists();
    EXPECT_EQ(set_mode(2U, 0U), error(0x22));
    EXPECT_EQ(set_mode(0U, 0U, 2U), error(0x22));
    EXPECT_EQ(set_mode(0U, 0U, 0U, 0U), error(0x22));
    EXPECT_EQ(set_mode(0U, 0x02U), error(0x27));  // stimulation
    EXPECT_EQ(set_mode(0U, 0x20U), error(0x27));  // without the part's number
    EXPECT_EQ(set_mode(1U, with_time, 1U, 3U), good);
    EXPECT_EQ(bench.command({0xDF, 0, 1, 0}), (Bytes{0xFF, 0x10, 0, 0, 1, 0, 3, 0}));
    EXPECT_EQ(select(1U), (Bytes{0xFF, 1}));
    EXPECT_EQ(bench.command({0xDF, 0, 1, 0}), (Bytes{0xFF, 0x11, 0, 0, 1, 0, 3, 0}));
    EXPECT_EQ(bench.command({0xDD, 1}), good);
    EXPECT_EQ(bench.command({0xDF, 0, 1, 0}), (Bytes{0xFF, 0x50, 0, 0, 1, 0, 3, 0}));
    EXPECT_EQ(bench.command({0xDF, 0, 2, 0}), error(0x22));
    EXPECT_EQ(set_mode(1U, 0U), error(0x11));
    EXPECT_EQ(point_to(1U, 0U, 0U), error(0x11));
    EXPECT_EQ(bench.command({0xFD}), (Bytes{0xFF, 0x40, 0, 0, 0, 0}));
}

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
    // One that cannot start holds all back.
    ASSERT_EQ(bench.command({0xE3, 0, 1, 0}), good);
    select(0U);
    select(1U);
    EXPECT_EQ(bench.command({0xDD, 1}), error(0x2A));
    EXPECT_TRUE(bench.samples.empty());
    EXPECT_EQ(bench.command({0xDD, 0}), good);
    EXPECT_EQ(bench.command({0xDD, 1}), error(0x2A));  // and is selected no longer
}

TEST_F(Lists, AreClearedWhileTheyRun) {
    two_lists();
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    EXPECT_EQ(bench.command({0xE3, 0, 2, 0}), error(0x22));
    EXPECT_EQ(bench.command({0xE3, 0, 0, 0}), good);
    EXPECT_TRUE(bench.samples.empty());
    EXPECT_EQ(start(0U), error(0x2A));
    ASSERT_EQ(point_to(0U, 0U, 0U), good);
    ASSERT_EQ(write(map::epk_at, 3U), good);
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    EXPECT_EQ(bench.samples, std::vector<Bytes>{(Bytes{0, 'r', 's', 'i'})});
    // Nothing is written into a list that runs, wherever the pointer stood.
    EXPECT_EQ(write(map::outputs_at, 4U), error(0x29));
    EXPECT_EQ(start(0U), (Bytes{0xFF, 0}));  // once more: it goes on
    EXPECT_EQ(bench.samples.size(), 1U);
}

// Nothing of what was allotted, written or set is left.
TEST_F(Lists, AreReleasedWhole) {
    two_lists();
    ASSERT_EQ(set_mode(1U, with_time, 1U, 3U), good);
    select(1U);
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    ASSERT_EQ(point_to(1U, 0U, 0U), good);
    ASSERT_EQ(bench.command({0xD6}), good);
    EXPECT_TRUE(bench.samples.empty());
    EXPECT_EQ(bench.command({0xFD}), (Bytes{0xFF, 0x00, 0, 0, 0, 0}));
    EXPECT_EQ(write(map::outputs_at, 4U), error(0x29));
    ASSERT_EQ(allot_lists(2U), good);
    EXPECT_EQ(bench.command({0xDF, 0, 1, 0}), (Bytes{0xFF, 0, 0, 0, 0, 0, 1, 0}));
    ASSERT_EQ(allot_parts(0U, 1U), good);
    ASSERT_EQ(allot_entries(0U, 0U, 1U), good);
    EXPECT_EQ(start(0U), error(0x2A));            // the entry is empty
    EXPECT_EQ(allot_parts(1U, 1U), error(0x29));  // behind entries
}

// Both parts with two entries each; the other list keeps its own.
TEST_F(Lists, AreClearedWholeAndAlone) {
    ASSERT_EQ(allot_lists(2U), good);
    ASSERT_EQ(allot_parts(0U, 2U), good);
    ASSERT_EQ(allot_parts(1U, 1U), good);
    for (const auto& [list, part] : {std::pair{0, 0}, std::pair{0, 1}, std::pair{1, 0}}) {
        ASSERT_EQ(allot_entries(static_cast<std::uint8_t>(list), static_cast<std::uint8_t>(part), 2U), good);
    }
    const auto fill = [&](std::uint8_t list, std::uint8_t part) {
        ASSERT_EQ(point_to(list, part, 0U), good);
        ASSERT_EQ(write(map::epk_at, 1U), good);
        ASSERT_EQ(write(map::epk_at + 1U, 2U), good);
    };
    fill(0U, 0U);
    fill(0U, 1U);
    fill(1U, 0U);
    select(0U);
    ASSERT_EQ(bench.command({0xE3, 0, 0, 0}), good);
    EXPECT_EQ(bench.command({0xDF, 0, 0, 0}).at(1U), 0U);  // selected no longer
    ASSERT_EQ(start(1U), (Bytes{0xFF, 2}));
    EXPECT_EQ(bench.samples, std::vector<Bytes>{(Bytes{2, 'r', 's', 'i'})});
    stop(1U);
    // Every entry is empty: filled one by one, the list starts with the last.
    for (const auto& [part, entry] : {std::pair{0, 0}, std::pair{0, 1}, std::pair{1, 0}, std::pair{1, 1}}) {
        EXPECT_EQ(start(0U), error(0x2A)) << part << entry;
        ASSERT_EQ(point_to(0U, static_cast<std::uint8_t>(part), static_cast<std::uint8_t>(entry)), good);
        ASSERT_EQ(write(map::epk_at, 1U), good);
    }
    EXPECT_EQ(start(0U), (Bytes{0xFF, 0}));
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
    EXPECT_EQ(bench.samples[1].size(), 8U);
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
    bench.ecu_bus().set_state(hal::BusState::bus_off);
    bench.cycle();
    bench.command({0xF9, 0x01});
    bench.ecu_bus().set_state(hal::BusState::error_active);
    bench.connect();
    EXPECT_EQ(bench.answers.size(), 1U);
}

TEST_F(Lists, WithoutPartsDoNotStart) {
    ASSERT_EQ(allot_lists(1U), good);
    EXPECT_EQ(start(0U), error(0x2A));
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
    bench.ecu_bus().set_state(hal::BusState::bus_off);
    bench.cycles(3);
    EXPECT_TRUE(bench.answers.empty());
    bench.ecu_bus().set_state(hal::BusState::error_active);
    bench.cycle();
    EXPECT_EQ(bench.answers, std::vector<Bytes>{(Bytes{0xFD, 0x06})});
    EXPECT_EQ(bench.samples.size(), 1U);
    bench.cycle();
    EXPECT_TRUE(bench.answers.empty());
}

// Bus with room for a number of frames in each cycle.
class NarrowBus final : public hal::CanBus {
 public:
    hal::ReceiveResult receive(hal::CanFrame&) noexcept override { return hal::ReceiveResult::empty; }
    hal::SendResult send(const hal::CanFrame&) noexcept override {
        if ((room == 0) || (refused > 0)) {
            --refused;
            return hal::SendResult::full;
        }
        --room;
        return hal::SendResult::sent;
    }
    hal::BusState state() const noexcept override { return hal::BusState::error_passive; }
    hal::BusStatistics statistics() const noexcept override { return {7U, 6U, 5U, 4U, 3U}; }
    int room{0};
    int refused{0};  // so many at first
};

// A bus that takes the first frames of a cycle and no more.
TEST(DaqLists, SayThatAnyFrameWasNotTaken) {
    Bench bench;
    NarrowBus narrow;
    application::RolloverEcu& ecu = bench.ecu().ecu();
    application::CalibrationPages pages{ecu, nullptr, 0U, nullptr};
    xcp::DaqLists lists{pages};
    ASSERT_EQ(lists.allot_lists(1U), xcp::Error::none);
    ASSERT_EQ(lists.allot_parts(0U, 2U), xcp::Error::none);
    ASSERT_EQ(lists.start(0U), xcp::Error::none);
    for (int room = 0; room <= 2; ++room) {
        narrow.room = room;
        EXPECT_EQ(lists.sample(narrow, 0x6F1U, hal::Time{}, 0U), room == 2) << room;
    }
    narrow.room = 2;
    narrow.refused = 1;
    EXPECT_FALSE(lists.sample(narrow, 0x6F1U, hal::Time{}, 0U));
}

TEST(Packet, EndsWithItsFrame) {
    xcp::Packet packet{0xFFU};
    packet.add_word(0x04030201U).add_word(0x08070605U);
    EXPECT_EQ(packet.length(), 8U);
    EXPECT_EQ(packet.bytes(), (std::array<std::uint8_t, 8>{0xFFU, 1U, 2U, 3U, 4U, 5U, 6U, 7U}));
}

// An extended or an FD frame of the same number is no command.
TEST(Slave, TakesStandardClassicFramesOnly) {
    Bench bench;
    hal::VirtualClock clock;
    hal::MemoryBus<1U> bus{clock};
    hal::SoftwareKeys keys{hal::test_keys};
    hal::MemoryStorage<64U> attempts;
    access_control::SeedAndKey access{keys, hal::KeySlot::calibration, bench.random, attempts};
    application::CalibrationPages pages{bench.ecu().ecu(), nullptr, 0U, nullptr};
    xcp::Slave slave{pages, access, xcp::default_identifiers};
    hal::CanFrame connect{};
    connect.identifier = xcp::default_identifiers.command;
    connect.length = 2U;
    connect.data[0] = 0xFFU;
    const auto is_connected_by = [&](const hal::CanFrame& frame) {
        slave.take(frame);
        static_cast<void>(slave.end_cycle(bus.endpoint(0U), clock, 0U));
        return slave.is_connected();
    };
    hal::CanFrame extended = connect;
    extended.extended = true;
    EXPECT_FALSE(is_connected_by(extended));
    hal::CanFrame flexible = connect;
    flexible.flexible_data_rate = true;
    EXPECT_FALSE(is_connected_by(flexible));
    hal::CanFrame other = connect;
    ++other.identifier;
    EXPECT_FALSE(is_connected_by(other));
    EXPECT_TRUE(is_connected_by(connect));
}

// Takes no frames from a lowest identifier on.
class RefusingBus final : public hal::CanBus {
 public:
    explicit RefusingBus(hal::CanBus& bus) : bus_{bus} {}
    hal::ReceiveResult receive(hal::CanFrame& frame) noexcept override { return bus_.receive(frame); }
    hal::SendResult send(const hal::CanFrame& frame) noexcept override {
        if (frame.identifier >= refused_from) {
            ++failures_;
            return hal::SendResult::full;
        }
        return bus_.send(frame);
    }
    hal::BusState state() const noexcept override { return bus_.state(); }
    hal::BusStatistics statistics() const noexcept override {
        hal::BusStatistics statistics = bus_.statistics();
        statistics.send_failures = failures_;
        return statistics;
    }
    std::uint32_t refused_from{xcp::default_identifiers.answer};

 private:
    hal::CanBus& bus_;
    std::uint32_t failures_{0U};
};

// The ECU reports a fault of the bus when its own frames are not taken, and none when those of XCP are not.
TEST(CalibratedEcu, WhatTheBusDoesNotTakeOfXcpIsNoFaultOfTheBus) {
    using monitoring::DiagnosticCode;
    Bench bench;
    hal::VirtualClock clock;
    hal::MemoryBus<2U> bus{clock};
    RefusingBus refusing{bus.endpoint(0U)};
    testing_application::NoWatchdog watchdog;
    hal::SoftwareKeys keys{hal::test_keys};
    hal::MemoryStorage<64U> attempts;
    access_control::SeedAndKey access{keys, hal::KeySlot::calibration, bench.random, attempts};
    application::CalibratedEcu ecu{
        refusing, clock, watchdog, access, bench.reference.data(), bench.reference.size(), nullptr};
    static_cast<void>(ecu.init());
    hal::CanFrame connect{};
    connect.identifier = xcp::default_identifiers.command;
    connect.length = 2U;
    connect.data[0] = 0xFFU;
    const auto cycles = [&](int count) {
        for (int cycle = 0; cycle < count; ++cycle) {
            bus.endpoint(1U).send(connect);
            ecu.step(0U);
        }
    };
    cycles(5);
    EXPECT_TRUE(ecu.slave().is_connected());
    EXPECT_EQ(refusing.statistics().send_failures, 5U);
    EXPECT_FALSE(ecu.ecu().diagnostic_memory().active(DiagnosticCode::bus_error));
    refusing.refused_from = 0U;
    cycles(2);
    EXPECT_TRUE(ecu.ecu().diagnostic_memory().active(DiagnosticCode::bus_error));
}

}  // namespace
}  // namespace testing_xcp
