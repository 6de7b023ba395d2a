// The firmware takes no heap memory, from its start on, whatever arrives.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <vector>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "tests/application/allocation_count.hpp"
#include "tests/application/bench.hpp"

namespace testing_application {
namespace {

void* volatile kept_from_the_optimiser = nullptr;

TEST(TheAllocationCount, SeesEveryWayToTheHeap) {
    std::uint64_t before = allocation_count();
    kept_from_the_optimiser = std::malloc(10U);
    EXPECT_EQ(allocation_count(), before + 1U) << "malloc";
    std::free(kept_from_the_optimiser);

    before = allocation_count();
    kept_from_the_optimiser = std::calloc(10U, 10U);
    EXPECT_EQ(allocation_count(), before + 1U) << "calloc";
    std::free(kept_from_the_optimiser);

    before = allocation_count();
    int* number = new int{3};
    kept_from_the_optimiser = number;
    EXPECT_EQ(allocation_count(), before + 1U) << "operator new";
    delete static_cast<int*>(kept_from_the_optimiser);

    struct alignas(64) Aligned {
        char bytes[64];
    };
    before = allocation_count();
    kept_from_the_optimiser = new Aligned{};
    EXPECT_EQ(allocation_count(), before + 1U) << "aligned operator new";
    delete static_cast<Aligned*>(kept_from_the_optimiser);
}

class RunningEcu : public ::testing::Test {
 protected:
    // Good frames, with every seventh damaged, silence in each third second, and a hard turn in every fourth.
    void cycle(unsigned number) {
        Motion motion;
        const unsigned counter = number % 15U;
        const unsigned second = number / 100U;
        motion.imu.lateral_acceleration_mps2 = second % 4U == 3U ? 9.0F : 0.1F;
        motion.roll_angle.roll_angle_deg = second % 4U == 3U ? 6.0F : 0.0F;
        if (second % 3U != 2U) {
            rsi::hal::CanFrame imu = frame_of(motion.imu, counter);
            if (number % 7U == 0U) {
                imu.data[0] ^= 0xFFU;
            }
            bus.endpoint(1U).send(imu);
            bus.endpoint(1U).send(frame_of(motion.roll_angle, counter));
            bus.endpoint(1U).send(frame_of(motion.vehicle_motion, counter));
        }
        clock.advance(rsi::hal::Time::from_milliseconds(10));
        ecu.step(number % 50U == 0U ? 1U : 0U);
        seen[static_cast<std::size_t>(ecu.outputs().state)] = true;
        rsi::hal::CanFrame frame;
        while (bus.endpoint(1U).receive(frame) == rsi::hal::ReceiveResult::frame) {
        }
    }

    rsi::hal::VirtualClock clock;
    rsi::hal::MemoryBus<2U, 16U> bus{clock};
    NoWatchdog watchdog;
    rsi::application::RolloverEcu ecu{bus.endpoint(0U), clock, watchdog};
    bool seen[4]{};
};

TEST_F(RunningEcu, TakesNoHeapMemory) {
    const rsi::Parameters parameters = large_suv();
    const std::uint64_t before = allocation_count();
    const rsi::Validation answer = ecu.init(parameters);
    for (unsigned number = 0U; number < 10'000U; ++number) {
        cycle(number);
    }
    const std::uint64_t after = allocation_count();
    EXPECT_EQ(after - before, 0U);
    EXPECT_EQ(answer.accepted, 1);
    EXPECT_TRUE(seen[RSI_STATE_UNAVAILABLE] && seen[RSI_STATE_READY] && seen[RSI_STATE_WARNING]);
}

TEST_F(RunningEcu, TakesNoHeapMemoryWhenItsParametersAreRefused) {
    const std::uint64_t before = allocation_count();
    const rsi::Validation answer = ecu.init(rsi::Parameters{});
    for (unsigned number = 0U; number < 1000U; ++number) {
        cycle(number);
    }
    EXPECT_EQ(allocation_count() - before, 0U);
    EXPECT_EQ(answer.accepted, 0);
}

}  // namespace
}  // namespace testing_application
