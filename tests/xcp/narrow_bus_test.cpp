// On a bus that has no room: what is said to be missing, and to whom.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/xcp/bench.hpp"

namespace testing_xcp {
namespace {

// Bus with room for a number of frames in each cycle.
class NarrowBus final : public rsi::hal::CanBus {
 public:
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame&) noexcept override {
        return rsi::hal::ReceiveResult::empty;
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame&) noexcept override {
        if ((room == 0) || (refused > 0)) {
            --refused;
            ++statistics_.send_failures;
            return rsi::hal::SendResult::full;
        }
        --room;
        return rsi::hal::SendResult::sent;
    }
    rsi::hal::BusState state() const noexcept override { return rsi::hal::BusState::error_passive; }
    rsi::hal::BusStatistics statistics() const noexcept override {
        ++questions;
        return statistics_;
    }
    mutable int questions{0};
    int room{0};
    int refused{0};  // so many at first

 private:
    rsi::hal::BusStatistics statistics_{7U, 6U, 5U, 4U, 3U};
};

rsi::hal::CanFrame command_frame(const Bytes& bytes) {
    rsi::hal::CanFrame frame;
    frame.identifier = rsi::xcp::default_identifiers.command;
    frame.length = static_cast<std::uint8_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    return frame;
}

// A bus that takes the first frames of a cycle and no more.
TEST(DaqLists, SayThatAnyFrameWasNotTaken) {
    Bench bench;
    NarrowBus narrow;
    rsi::application::RolloverEcu& ecu = bench.ecu().ecu();
    rsi::application::CalibrationPages pages{ecu, nullptr, 0U, nullptr};
    rsi::xcp::DaqLists lists{pages};
    ASSERT_EQ(lists.allot_lists(1U), rsi::xcp::Error::none);
    ASSERT_EQ(lists.allot_parts(0U, 2U), rsi::xcp::Error::none);
    ASSERT_EQ(lists.start(0U), rsi::xcp::Error::none);
    for (int room = 0; room <= 2; ++room) {
        narrow.room = room;
        EXPECT_EQ(lists.sample(narrow, 0x6F1U, rsi::hal::Time{}, 0U), room == 2) << room;
    }
    narrow.room = 2;
    narrow.refused = 1;
    EXPECT_FALSE(lists.sample(narrow, 0x6F1U, rsi::hal::Time{}, 0U));
}

// A control unit with memory at every address, which remembers what was read last.
class EndlessTarget final : public rsi::xcp::Target {
 public:
    bool read(std::uint32_t address, rsi::xcp::Page, std::uint8_t* bytes,
              std::size_t count) const noexcept override {
        last_address = address;
        std::fill_n(bytes, count, std::uint8_t{0x5AU});
        return true;
    }
    bool checksum(std::uint32_t, rsi::xcp::Page, std::size_t, std::uint32_t&) const noexcept override {
        return false;
    }
    rsi::xcp::Error write(std::uint32_t, const std::uint8_t*, std::size_t) noexcept override {
        return rsi::xcp::Error::access_denied;
    }
    rsi::xcp::Error select(rsi::xcp::Page) noexcept override { return rsi::xcp::Error::page_not_valid; }
    rsi::xcp::Page selected() const noexcept override { return rsi::xcp::Page::working; }
    rsi::xcp::Error copy_reference() noexcept override { return rsi::xcp::Error::access_denied; }
    rsi::xcp::Error store() noexcept override { return rsi::xcp::Error::none; }
    Range calibration() const noexcept override { return {0U, 0U}; }
    Range name() const noexcept override { return {0U, 0U}; }

    mutable std::uint32_t last_address{0U};
};

// Lists that were never released have nothing to write into, and take the addresses that an entry can
// hold, which are those below 16 MiB, and no other.
TEST(DaqLists, MeasureBelow16MiB) {
    const EndlessTarget target;
    NarrowBus bus;
    rsi::xcp::DaqLists lists{target};
    EXPECT_FALSE(lists.is_running());
    EXPECT_EQ(lists.write(0U, 1U), rsi::xcp::Error::sequence);
    ASSERT_EQ(lists.allot_lists(1U), rsi::xcp::Error::none);
    ASSERT_EQ(lists.allot_parts(0U, 1U), rsi::xcp::Error::none);
    EXPECT_EQ(lists.first_part(0U), 0U);
    ASSERT_EQ(lists.allot_entries(0U, 0U, 1U), rsi::xcp::Error::none);
    ASSERT_EQ(lists.point_to(0U, 0U, 0U), rsi::xcp::Error::none);
    EXPECT_EQ(lists.write(0x01000000U, 7U), rsi::xcp::Error::access_denied);
    EXPECT_EQ(lists.write(0xFFFFFFFFU, 7U), rsi::xcp::Error::access_denied);
    EXPECT_EQ(lists.write(0x00FFFFFFU, 7U), rsi::xcp::Error::none);
    ASSERT_EQ(lists.start(0U), rsi::xcp::Error::none);
    bus.room = 1;
    EXPECT_TRUE(lists.sample(bus, 0x6F1U, rsi::hal::Time{}, 0U));
    EXPECT_EQ(target.last_address, 0x00FFFFFFU);
    EXPECT_EQ(bus.room, 0);
}

TEST(Packet, EndsWithItsFrame) {
    rsi::xcp::Packet packet{0xFFU};
    packet.add_word(0x04030201U).add_word(0x08070605U);
    EXPECT_EQ(packet.length(), 8U);
    EXPECT_EQ(packet.bytes(), (std::array<std::uint8_t, 8>{0xFFU, 1U, 2U, 3U, 4U, 5U, 6U, 7U}));
}

// That a page was stored, and that samples are missing, is reported within the session or never.
TEST(Slave, LeavesNoEventToAnotherSession) {
    EndlessTarget target;
    NarrowBus narrow;
    rsi::hal::VirtualClock clock;
    CountingRandom random;
    rsi::hal::SoftwareKeys keys{rsi::hal::test_keys};
    rsi::hal::MemoryStorage<64U> attempts;
    rsi::access::SeedAndKey access{keys, rsi::hal::KeySlot::calibration, random, attempts};
    access.start();
    rsi::xcp::Slave slave{target, access, rsi::xcp::default_identifiers};
    const auto command = [&](const Bytes& bytes, int room) {
        slave.take(command_frame(bytes));
        narrow.room = room;
        static_cast<void>(slave.end_cycle(narrow, clock, 0U));
        return room - narrow.room;  // frames sent
    };
    const auto unlock = [&] {
        rsi::access::Block seed{};
        rsi::access::Block key{};
        return access.give_seed(seed) &&
               keys.authenticate(rsi::hal::KeySlot::calibration, seed.data(), seed.size(), key) &&
               access.take_key(key) == rsi::access::KeyAnswer::unlocked;
    };
    ASSERT_EQ(command({0xFF, 0x00}, 9), 1);
    ASSERT_TRUE(unlock());
    ASSERT_EQ(command({0xF9, 0x01}, 9), 2);  // the answer and the event
    ASSERT_EQ(command({0xF9, 0x01}, 1), 1);  // the event waits
    EXPECT_EQ(command({0xFD}, 9), 2);        // and comes
    ASSERT_EQ(command({0xF9, 0x01}, 1), 1);
    EXPECT_EQ(command({0xFF, 0x00}, 9), 1);
    EXPECT_EQ(command({0xFD}, 9), 1);
}

// Before and after a session it costs the cycle nothing, and has no failures to be forgiven.
TEST(Slave, LeavesTheBusAloneWithoutAConnection) {
    EndlessTarget target;
    NarrowBus narrow;
    rsi::hal::VirtualClock clock;
    CountingRandom random;
    rsi::hal::SoftwareKeys keys{rsi::hal::test_keys};
    rsi::hal::MemoryStorage<64U> attempts;
    rsi::access::SeedAndKey access{keys, rsi::hal::KeySlot::calibration, random, attempts};
    rsi::xcp::Slave slave{target, access, rsi::xcp::default_identifiers};
    const auto failures_of_a_cycle = [&] { return slave.end_cycle(narrow, clock, 0U); };
    EXPECT_EQ(failures_of_a_cycle(), 0U);
    EXPECT_EQ(narrow.questions, 0);
    slave.take(command_frame({0xFF, 0x00}));
    EXPECT_EQ(failures_of_a_cycle(), 1U);  // the answer has no room
    EXPECT_TRUE(slave.is_connected());
    EXPECT_GT(narrow.questions, 0);
    slave.take(command_frame({0xFE}));
    EXPECT_EQ(failures_of_a_cycle(), 1U);
    narrow.questions = 0;
    EXPECT_EQ(failures_of_a_cycle(), 0U);
    EXPECT_EQ(narrow.questions, 0);
}

// An extended or an FD frame of the same number is no command.
TEST(Slave, TakesStandardClassicFramesOnly) {
    Bench bench;
    rsi::hal::VirtualClock clock;
    rsi::hal::MemoryBus<1U> bus{clock};
    rsi::hal::SoftwareKeys keys{rsi::hal::test_keys};
    rsi::hal::MemoryStorage<64U> attempts;
    rsi::access::SeedAndKey access{keys, rsi::hal::KeySlot::calibration, bench.random, attempts};
    rsi::application::CalibrationPages pages{bench.ecu().ecu(), nullptr, 0U, nullptr};
    rsi::xcp::Slave slave{pages, access, rsi::xcp::default_identifiers};
    rsi::hal::CanFrame connect{};
    connect.identifier = rsi::xcp::default_identifiers.command;
    connect.length = 2U;
    connect.data[0] = 0xFFU;
    const auto is_connected_by = [&](const rsi::hal::CanFrame& frame) {
        slave.take(frame);
        static_cast<void>(slave.end_cycle(bus.endpoint(0U), clock, 0U));
        return slave.is_connected();
    };
    rsi::hal::CanFrame extended = connect;
    extended.extended = true;
    EXPECT_FALSE(is_connected_by(extended));
    rsi::hal::CanFrame flexible = connect;
    flexible.flexible_data_rate = true;
    EXPECT_FALSE(is_connected_by(flexible));
    rsi::hal::CanFrame other = connect;
    ++other.identifier;
    EXPECT_FALSE(is_connected_by(other));
    EXPECT_TRUE(is_connected_by(connect));
}

// Takes no frames from a lowest identifier on.
class RefusingBus final : public rsi::hal::CanBus {
 public:
    explicit RefusingBus(rsi::hal::CanBus& bus) : bus_{bus} {}
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame& frame) noexcept override {
        return bus_.receive(frame);
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override {
        if (frame.identifier >= refused_from) {
            ++failures_;
            return rsi::hal::SendResult::full;
        }
        return bus_.send(frame);
    }
    rsi::hal::BusState state() const noexcept override { return bus_.state(); }
    rsi::hal::BusStatistics statistics() const noexcept override {
        rsi::hal::BusStatistics statistics = bus_.statistics();
        statistics.send_failures = failures_;
        return statistics;
    }
    std::uint32_t refused_from{rsi::xcp::default_identifiers.answer};

 private:
    rsi::hal::CanBus& bus_;
    std::uint32_t failures_{0U};
};

// The ECU reports a fault of the bus when its own frames are not taken, and none when those of XCP are not.
TEST(CalibratedEcu, XcpFramesThatTheBusDoesNotTakeAreNoFaultOfTheBus) {
    using rsi::monitoring::DiagnosticCode;
    Bench bench;
    rsi::hal::VirtualClock clock;
    rsi::hal::MemoryBus<2U> bus{clock};
    RefusingBus refusing{bus.endpoint(0U)};
    testing_application::NoWatchdog watchdog;
    rsi::hal::SoftwareKeys keys{rsi::hal::test_keys};
    rsi::hal::MemoryStorage<64U> attempts;
    rsi::access::SeedAndKey access{keys, rsi::hal::KeySlot::calibration, bench.random, attempts};
    rsi::application::CalibratedEcu ecu{
        refusing, clock, watchdog, access, bench.reference.data(), bench.reference.size(), nullptr};
    static_cast<void>(ecu.init());
    rsi::hal::CanFrame connect{};
    connect.identifier = rsi::xcp::default_identifiers.command;
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
