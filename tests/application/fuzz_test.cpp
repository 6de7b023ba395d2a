// Random payloads with a good end-to-end protection: whatever the sensors say, the ECU's answer is defined.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "tests/application/bench.hpp"
#include "tests/application/end_to_end.hpp"

namespace testing_application {
namespace {

using rsi::can_dbc::RolloverWarning;
using State = RolloverWarning::State;

// A bench without records, for a million cycles.
class FuzzBench {
 public:
    explicit FuzzBench(const rsi::Parameters& parameters) { ecu_.init(parameters); }

    // One cycle on four random payloads.
    void random_cycle() {
        send_random(0x120U, 0x3A7U);
        send_random(0x121U, 0x45CU);
        send_random(0x122U, 0x5B1U);
        send_random(0x123U, 0xEA1U);
        step();
    }

    // One cycle on values at random that a vehicle could have: no step is too wide for the plausibility
    // checks, roll angle and yaw rate go with roll rate and lateral acceleration.
    void wandering_cycle() {
        const auto wander = [this](float& value, float step, float most) {
            value += step * (2.0F * static_cast<float>(random_()) / 1.8446744e19F - 1.0F);
            value = std::clamp(value, -most, most);
        };
        wander(wanderer_.imu.lateral_acceleration_mps2, 3.0F, 14.0F);
        wander(wanderer_.imu.roll_rate_deg_per_s, 8.0F, 30.0F);
        float& angle = wanderer_.roll_angle.roll_angle_deg;
        if (angle * wanderer_.imu.roll_rate_deg_per_s > 0.0F && std::abs(angle) > 10.0F) {
            wanderer_.imu.roll_rate_deg_per_s = 0.0F;
        }
        angle += 0.01F * wanderer_.imu.roll_rate_deg_per_s;
        wanderer_.vehicle_motion.yaw_rate_deg_per_s =
            57.29578F * 3.6F * wanderer_.imu.lateral_acceleration_mps2 / wanderer_.vehicle_motion.speed_kmh;
        cycle(wanderer_);
    }

    // One cycle on three given messages.
    void cycle(const Motion& motion) {
        send(0x120U, 0x3A7U, rsi::can_dbc::encode(motion.imu));
        send(0x121U, 0x45CU, rsi::can_dbc::encode(motion.roll_angle));
        send(0x122U, 0x5B1U, rsi::can_dbc::encode(motion.vehicle_motion));
        step();
    }

    std::uint64_t cycles{0U};
    std::uint64_t undefined{0U};   // cycles with a state, side or number that the DBC file does not define
    std::uint64_t incomplete{0U};  // cycles with a state other than unavailable and a number missing
    std::uint64_t states[4]{};     // how often each state was sent
    std::uint64_t frames_missing{0U};  // cycles that did not send all frames
    RolloverWarning last{};

 private:
    template <typename Payload>
    void send(std::uint32_t identifier, std::uint16_t data_id, const Payload& payload) {
        rsi::hal::CanFrame frame;
        frame.identifier = identifier;
        frame.length = 8U;
        std::copy(payload.begin(), payload.end(), frame.data.begin());
        protect(frame, data_id, static_cast<unsigned>(cycles % 15U));
        bus_.endpoint(1U).send(frame);
    }

    void send_random(std::uint32_t identifier, std::uint16_t data_id) {
        std::array<std::uint8_t, 8> payload;
        const std::uint64_t bits = random_();
        for (std::size_t index = 0U; index < payload.size(); ++index) {
            payload[index] = static_cast<std::uint8_t>(bits >> (8U * index));
        }
        send(identifier, data_id, payload);
    }

    void step() {
        clock_.advance(rsi::hal::Time::from_milliseconds(10));
        ecu_.step(0U);
        ++cycles;
        int frames = 0;
        rsi::hal::CanFrame frame;
        while (bus_.endpoint(1U).receive(frame) == rsi::hal::ReceiveResult::frame) {
            ++frames;
            judge(frame);
        }
        frames_missing += frames == 8 ? 0U : 1U;
    }

    void judge(const rsi::hal::CanFrame& frame) {
        if (frame.identifier == RolloverWarning::identifier) {
            judge_warning(rsi::can_dbc::decode<RolloverWarning>(frame.data), frame.data[2]);
        } else if (frame.identifier == rsi::can_dbc::RollCentreEstimate::identifier) {
            judge_estimate(rsi::can_dbc::decode<rsi::can_dbc::RollCentreEstimate>(frame.data));
        }
    }

    // State and side are the lowest five bits of byte 2, read here without the codec.
    void judge_warning(const rsi::can_dbc::Decoded<RolloverWarning>& warning, std::uint8_t byte) {
        const unsigned state = byte & 0x7U;
        const unsigned side = (byte >> 3U) & 0x3U;
        last = warning.value;
        if (state > 3U || side > 2U || any_out_of_range<RolloverWarning>(warning)) {
            ++undefined;
            return;
        }
        ++states[state];
        const bool available = state != 0U;
        const bool sided = state >= 2U;
        if ((available && !warning.status.all_valid()) || sided != (side != 0U)) {
            ++incomplete;
        }
        available_ = available;
    }

    void judge_estimate(const rsi::can_dbc::Decoded<rsi::can_dbc::RollCentreEstimate>& estimate) {
        undefined += any_out_of_range<rsi::can_dbc::RollCentreEstimate>(estimate) ? 1U : 0U;
        incomplete += available_ && !estimate.status.all_valid() ? 1U : 0U;
    }

    template <typename Message>
    static bool any_out_of_range(const rsi::can_dbc::Decoded<Message>& decoded) {
        bool found = false;
        Message::visit_signals([&](const char*, const char*, auto, auto status) {
            found = found || decoded.status.*status == rsi::can_dbc::SignalStatus::out_of_range;
        });
        return found;
    }

    rsi::hal::VirtualClock clock_;
    rsi::hal::MemoryBus<2U, 16U> bus_{clock_};
    NoWatchdog watchdog_;
    rsi::application::RolloverEcu ecu_{bus_.endpoint(0U), clock_, watchdog_};
    std::mt19937_64 random_{20090815U};
    Motion wanderer_{};
    bool available_{false};
};

// The parameter: which indicator drives the warning.
class RandomPayloads : public ::testing::TestWithParam<rsi_indicator> {
 protected:
    // Without a recovery time, so that many cycles make a statement.
    static rsi::Parameters parameters() {
        rsi::Parameters parameters = large_suv();
        parameters.warning_indicator = GetParam();
        parameters.recovery_s = 0.0F;
        parameters.warning_confirmation_s = 0.0F;
        parameters.warning_hold_s = 0.0F;
        parameters.advisory_hold_s = 0.0F;
        return parameters;
    }
};

TEST_P(RandomPayloads, GiveAMillionDefinedAnswersAndDoNotPoisonTheEcu) {
    FuzzBench bench{parameters()};
    // Wholly random values jump more than any vehicle, so nearly all of them are invalidated; in between the
    // values wander for long enough that it is used again.
    for (int cycle = 0; cycle < 1'000'000; ++cycle) {
        if (cycle % 1000 < 200) {
            bench.random_cycle();
        } else {
            bench.wandering_cycle();
        }
    }
    EXPECT_EQ(bench.frames_missing, 0U);
    EXPECT_EQ(bench.undefined, 0U);
    EXPECT_EQ(bench.incomplete, 0U);
    // The test has reached every state, or it would prove little.
    EXPECT_GT(bench.states[0], 1000U);
    EXPECT_GT(bench.states[1], 1000U);
    EXPECT_GT(bench.states[2], 100U);
    EXPECT_GT(bench.states[3], 1000U);

    for (int cycle = 0; cycle < 500; ++cycle) {
        bench.cycle(Motion{});
    }
    EXPECT_EQ(bench.last.state, State::ready);
    EXPECT_NEAR(static_cast<double>(bench.last.warning_level), 0.0, 1.0e-3);
    EXPECT_EQ(bench.incomplete, 0U);
}

INSTANTIATE_TEST_SUITE_P(WithEitherIndicator, RandomPayloads,
                         ::testing::Values(RSI_INDICATOR_PUBLISHED, RSI_INDICATOR_BANK_FREE),
                         [](const auto& tested) {
                             return std::string{tested.param == RSI_INDICATOR_PUBLISHED ? "Published"
                                                                                        : "BankFree"};
                         });

}  // namespace
}  // namespace testing_application
