// The recorded drives of the regression through the mutated firmware: each frame must be what the firmware
// without a mutant sends. Only for the mutated build: tests/application/regression compares the firmware with
// what is committed.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "hal/memory/frame_replay.hpp"
#include "hal/memory/memory_bus.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"

extern "C" const unsigned char rsi_parameter_section[rsi::application::section::length];

namespace mutation {
extern int active;
}

namespace {

struct NoWatchdog final : rsi::hal::Watchdog {
    void feed() noexcept override {}
};

std::vector<rsi::hal::CanFrame> sensor_frames(const std::string& drive) {
    std::ifstream file{std::string{RSI_REGRESSION_LOGS} + "/" + drive + ".sensors.log"};
    std::vector<rsi::hal::CanFrame> frames;
    double time_s = 0.0;
    unsigned identifier = 0U;
    char data[17] = "";
    for (std::string line; std::getline(file, line);) {
        if (std::sscanf(line.c_str(), "(%lf) %*s %3x#%16s", &time_s, &identifier, data) != 3) {
            std::abort();
        }
        rsi::hal::CanFrame frame{};
        frame.identifier = identifier;
        const std::string digits{data};
        frame.length = static_cast<std::uint8_t>(digits.size() / 2U);
        for (std::size_t byte = 0U; byte < frame.length; ++byte) {
            frame.data[byte] =
                static_cast<std::uint8_t>(std::strtoul(digits.substr(2U * byte, 2U).c_str(), nullptr, 16));
        }
        frame.receive_time = rsi::hal::Time{static_cast<std::int64_t>(time_s * 1.0e6 + 0.5) * 1000};
        frames.push_back(frame);
    }
    return frames;
}

std::string answers(const std::vector<rsi::hal::CanFrame>& frames) {
    rsi::hal::VirtualClock clock;
    rsi::hal::MemoryBus<2U> bus{clock};
    NoWatchdog watchdog;
    rsi::application::RolloverEcu ecu{bus.endpoint(0U), clock, watchdog};
    ecu.init(rsi_parameter_section, rsi::application::section::length);
    rsi::hal::FrameReplay replay{frames.data(), frames.size(), clock, bus.endpoint(1U)};
    std::string sent;
    for (std::int64_t cycle = 0; !replay.finished() && cycle < 6000; ++cycle) {
        replay.run_until(rsi::hal::Time::from_milliseconds(10 * cycle + 1));
        ecu.step(0U);
        rsi::hal::CanFrame frame{};
        while (bus.endpoint(1U).receive(frame) == rsi::hal::ReceiveResult::frame) {
            sent.append(reinterpret_cast<const char*>(frame.data.data()), frame.length);
        }
    }
    return sent;
}

constexpr const char* drives[] = {"j-turn-110", "banked-straight-bank-sensor", "braking-in-turn",
                                  "bus-faults-noise", "double-lane-change-noise"};

struct Reference {
    std::vector<rsi::hal::CanFrame> frames;
    std::string answers;
};

// Computed before the first mutant is born.
const std::map<std::string, Reference> references = [] {
    std::map<std::string, Reference> all;
    for (const char* drive : drives) {
        Reference reference;
        reference.frames = sensor_frames(drive);
        reference.answers = answers(reference.frames);
        all[drive] = reference;
    }
    return all;
}();

class Replay : public ::testing::TestWithParam<const char*> {};

TEST_P(Replay, SendsTheSameFrames) {
    const Reference& reference = references.at(GetParam());
    ASSERT_GT(reference.answers.size(), 10000U);
    EXPECT_TRUE(answers(reference.frames) == reference.answers);
}

INSTANTIATE_TEST_SUITE_P(OfADrive, Replay, ::testing::ValuesIn(drives), [](const auto& tested) {
    std::string name{tested.param};
    for (char& letter : name) {
        letter = (letter == '-') ? '_' : letter;
    }
    return name;
});

}  // namespace
