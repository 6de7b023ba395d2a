// What the ECU puts on the bus: order, kind, protection, counters.
#include <gtest/gtest.h>

#include <iterator>

#include "tests/application/bench.hpp"
#include "tests/application/end_to_end.hpp"
#include "tests/application/roll_plane_vehicle.hpp"

namespace testing_application {
namespace {

// Three seconds with everything in it: unavailable, a hard turn, silence.
std::vector<Cycle> eventful_run() {
    Bench bench;
    bench.run_for(0.5);
    RollPlaneVehicle vehicle{large_suv()};
    bench.drive([&vehicle](double) {
        vehicle.advance(8.0);
        return vehicle.motion();
    });
    bench.run_for(1.0);
    bench.drive(Motion{});
    bench.stop_all();
    bench.run_for(0.5);
    bench.resume_all();
    bench.run_for(1.0);
    return bench.cycles();
}

struct Expected {
    std::uint32_t identifier;
    std::uint16_t data_id;
};

// From the DBC file: the warning first, because it matters most, the status last.
constexpr Expected expected_frames[] = {{0x0D0U, 0x61EU}, {0x230U, 0x7D4U}, {0x232U, 0x9A6U},
                                        {0x233U, 0xAC3U}, {0x234U, 0xBE8U}, {0x235U, 0xCD3U},
                                        {0x231U, 0x88BU}};

TEST(EachCycle, SendsTheWarningFirstAndTheStatusLast) {
    for (const Cycle& cycle : eventful_run()) {
        ASSERT_EQ(cycle.frames.size(), std::size(expected_frames));
        for (std::size_t index = 0U; index < std::size(expected_frames); ++index) {
            const hal::CanFrame& frame = cycle.frames[index];
            ASSERT_EQ(frame.identifier, expected_frames[index].identifier);
            ASSERT_EQ(frame.length, 8U);
            ASSERT_FALSE(frame.extended);
            ASSERT_FALSE(frame.flexible_data_rate);
        }
    }
}

TEST(EachSentFrame, PassesAnIndependentEndToEndCheckAndCountsFrom0To14) {
    unsigned counter = 0U;
    for (const Cycle& cycle : eventful_run()) {
        for (std::size_t index = 0U; index < std::size(expected_frames); ++index) {
            ASSERT_TRUE(is_profile_11(cycle.frames.at(index), expected_frames[index].data_id));
            ASSERT_EQ(counter_of(cycle.frames[index]), counter);
        }
        counter = (counter + 1U) % 15U;
    }
}

TEST(EachSentStatus, BearsTheSoftwaresVersion) {
    for (const Cycle& cycle : eventful_run()) {
        ASSERT_TRUE(cycle.status.status.all_valid());
        ASSERT_GT(cycle.status.value.software_version, 0U);
    }
}

}  // namespace
}  // namespace testing_application
