// The system watchdog and the resets on fakes of their registers; QEMU has no such devices.
#include "hal/zynqmp_r5/system_watchdog.hpp"

#include <gtest/gtest.h>

#include "hal/zynqmp_r5/emulator/supervisor.hpp"
#include "hal/zynqmp_r5/silicon_policy.hpp"
#include "hal/zynqmp_r5/system_reset.hpp"
#include "tests/hal/zynqmp_r5/register_fake.hpp"

namespace rsi::hal::zynqmp_r5::testing {
namespace {

constexpr std::uint32_t clock_hz = 100'000'000U;

// SWDT as UG1087 has it: a write without its key is ignored.
class WatchdogDevice final : public Device {
 public:
    bool expired{false};

    void advance_microseconds(std::uint64_t microseconds) {
        const std::uint64_t counts = microseconds * (clock_hz / 1'000'000U) / 8U;
        if (!is_enabled_ || expired) {
            return;
        }
        expired = counts >= counter_ && resets_;
        counter_ -= expired ? counter_ : counts;
    }

    std::uint32_t on_read(RegisterAddress) override { return 0U; }
    void on_write(RegisterAddress address, std::uint32_t value) override {
        if (address == 0xFF15'0000U && (value & 0x00FF'F000U) == 0x00AB'C000U) {
            is_enabled_ = (value & 1U) != 0U;
            resets_ = (value & 2U) != 0U;
        } else if (address == 0xFF15'0004U && (value & 0x03FF'C000U) == 0x0092'0000U && !is_enabled_) {
            EXPECT_EQ(value & 3U, 0U) << "this fake divides its clock by 8 only";
            reload_ = (((value >> 2U) & 0xFFFU) << 12U) | 0xFFFU;
        } else if (address == 0xFF15'0008U && value == 0x1999U) {
            counter_ = reload_;
        }
    }

 private:
    bool is_enabled_{false};
    bool resets_{false};
    std::uint64_t reload_{0U};
    std::uint64_t counter_{0U};
};

class SystemWatchdogTest : public ::testing::Test {
 protected:
    WatchdogDevice device;
    SiliconPolicy::Watchdog<FakeRegisters> dog{FakeRegisters{&device}};
};

TEST_F(SystemWatchdogTest, StartsByTheseWritesInThisOrder) {
    dog.start();
    const std::vector<Write> expected{
        {0xFF15'0000U, 0x00AB'C000U},                 // off
        {0xFF15'0004U, 0x0092'0000U | (152U << 2U)},  // 152 * 4096 counts of 80 ns
        {0xFF15'0000U, 0x00AB'C033U},                 // on, with reset
        {0xFF15'0008U, 0x0000'1999U},                 // first feeding
    };
    EXPECT_EQ(device.writes, expected);
}

TEST_F(SystemWatchdogTest, FedInEveryCycleItNeverExpires) {
    dog.start();
    for (int cycle = 0; cycle < 1000; ++cycle) {
        device.advance_microseconds(10'000U);
        dog.feed();
    }
    device.advance_microseconds(49'000U);
    EXPECT_FALSE(device.expired);
}

TEST_F(SystemWatchdogTest, ExpiresFiftyMillisecondsAfterTheLastFeeding) {
    dog.start();
    device.advance_microseconds(30'000U);
    dog.feed();
    device.advance_microseconds(50'000U);
    EXPECT_FALSE(device.expired);
    device.advance_microseconds(500U);
    EXPECT_TRUE(device.expired);
}

// Writes are remembered; reads give them back.
class PlainDevice final : public Device {
 public:
    std::uint32_t value{0U};
    std::uint32_t on_read(RegisterAddress) override { return value; }
    void on_write(RegisterAddress, std::uint32_t written) override { value = written; }
};

TEST(SystemReset, SetsTheSoftResetAndLeavesTheOtherBits) {
    PlainDevice device;
    device.value = 0x0001'0003U;
    SystemReset<FakeRegisters>::request(FakeRegisters{&device});
    EXPECT_EQ(device.writes, (std::vector<Write>{{0xFF5E'0218U, 0x0001'0013U}}));
}

TEST(Supervisor, IsFedWithTheTimeLimitInItsPeriodsAndAskedForAResetByOne) {
    PlainDevice device;
    emulator::SupervisorWatchdog<FakeRegisters, 2000U> dog{FakeRegisters{&device}};
    dog.start();
    dog.feed();
    emulator::SupervisorReset<FakeRegisters>::request(FakeRegisters{&device});
    EXPECT_EQ(device.writes, (std::vector<Write>{{RSI_SUPERVISOR_COUNTDOWN, 2000U / RSI_SUPERVISOR_PERIOD_MS},
                                                 {RSI_SUPERVISOR_COUNTDOWN, 2000U / RSI_SUPERVISOR_PERIOD_MS},
                                                 {RSI_SUPERVISOR_COUNTDOWN, 1U}}));
}

}  // namespace
}  // namespace rsi::hal::zynqmp_r5::testing
