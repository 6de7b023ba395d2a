// The whole ECU without any library: sensor frames in, warning frames out, on a platform of a few lines.
//
// The same proof as component_run.cpp, for the application, the generated codec and the end-to-end
// protection. The platform below is also the least that a port has to write.
#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "tests/support/large_suv.h"
#include "tests/targets/freestanding/start.hpp"

namespace {

constexpr unsigned sensor_frames = 3U;
constexpr unsigned ecu_frames = rsi::can_dbc::MessagesFromRolloverEcu::size;

// The frames of one cycle; the test refills and reads them between two cycles.
class Bus final : public rsi::hal::CanBus {
 public:
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame& frame) noexcept override {
        if (taken_ == sensor_frames) {
            return rsi::hal::ReceiveResult::empty;
        }
        frame = to_ecu[taken_++];
        return rsi::hal::ReceiveResult::frame;
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override {
        if (sent_ == ecu_frames) {
            return rsi::hal::SendResult::full;
        }
        from_ecu[sent_++] = frame;
        return rsi::hal::SendResult::sent;
    }
    rsi::hal::BusState state() const noexcept override { return rsi::hal::BusState::error_active; }
    rsi::hal::BusStatistics statistics() const noexcept override { return {}; }

    void begin_cycle() {
        taken_ = 0U;
        sent_ = 0U;
    }
    unsigned sent() const { return sent_; }

    rsi::hal::CanFrame to_ecu[sensor_frames]{};
    rsi::hal::CanFrame from_ecu[ecu_frames]{};

 private:
    unsigned taken_{0U};
    unsigned sent_{0U};
};

class Clock final : public rsi::hal::Clock {
 public:
    rsi::hal::Time now() const noexcept override { return time; }
    rsi::hal::Time time{};
};

class Watchdog final : public rsi::hal::Watchdog {
 public:
    void feed() noexcept override { ++feeds; }
    int feeds{0};
};

template <typename Message>
class SensorLine {
 public:
    void put(const Message& message, rsi::hal::Time time, rsi::hal::CanFrame& frame) {
        auto payload = rsi::can_dbc::encode(message);
        sender_.protect(payload);
        frame.identifier = Message::identifier;
        frame.length = Message::length;
        frame.receive_time = time;
        for (unsigned index = 0U; index < Message::length; ++index) {
            frame.data[index] = payload[index];
        }
    }

 private:
    rsi::can_dbc::e2e::Profile11Sender sender_{Message::e2e_data_id};
};

// A frame's values, if it is this message and undamaged; its counter must follow the one before.
template <typename Message>
class Ear {
 public:
    bool hear(const rsi::hal::CanFrame& frame) {
        const bool good =
            (frame.identifier == Message::identifier) &&
            (receiver_.check(frame.data, frame.length).status == rsi::can_dbc::e2e::CheckStatus::ok);
        if (good) {
            latest = rsi::can_dbc::decode<Message>(frame.data);
        }
        return good;
    }
    rsi::can_dbc::Decoded<Message> latest{};

 private:
    rsi::can_dbc::e2e::Profile11Receiver receiver_{Message::e2e_data_id, Message::length, 1U};
};

// An ear for each frame of the ECU, in the order in which they are sent.
template <typename List>
class Ears;
template <typename... Messages>
class Ears<rsi::can_dbc::MessageList<Messages...>> : private Ear<Messages>... {
 public:
    bool hear(const rsi::hal::CanFrame (&frames)[sizeof...(Messages)]) {
        unsigned index = 0U;
        return (Ear<Messages>::hear(frames[index++]) && ...);
    }
    template <typename Message>
    const Message& latest() const {
        return Ear<Message>::latest.value;
    }
};

struct World {
    Bus bus{};
    Clock clock{};
    Watchdog watchdog{};
    rsi::application::RolloverEcu ecu{bus, clock, watchdog};
    SensorLine<rsi::can_dbc::Imu> imu{};
    SensorLine<rsi::can_dbc::RollAngle> roll_angle{};
    SensorLine<rsi::can_dbc::VehicleMotion> vehicle_motion{};
    Ears<rsi::can_dbc::MessagesFromRolloverEcu> ears{};

    // One cycle; whether the ECU sent its frames as it should.
    bool cycle(float lateral_acceleration_mps2, float roll_angle_deg) {
        clock.time = clock.time + rsi::hal::Time::from_milliseconds(10);
        bus.begin_cycle();
        imu.put({lateral_acceleration_mps2, 9.80665F, 0.0F}, clock.time, bus.to_ecu[0]);
        roll_angle.put({roll_angle_deg, rsi::can_dbc::not_available}, clock.time, bus.to_ecu[1]);
        vehicle_motion.put({80.0F, 0.0F, 0.0F}, clock.time, bus.to_ecu[2]);
        ecu.step(0U);
        return (bus.sent() == ecu_frames) && ears.hear(bus.from_ecu);
    }

    bool drive(int cycles, float lateral_acceleration_mps2, float roll_angle_deg) {
        bool good = true;
        for (int k = 0; k < cycles; ++k) {
            good = cycle(lateral_acceleration_mps2, roll_angle_deg) && good;
        }
        return good;
    }
};

}  // namespace

extern "C" long run() {
    using rsi::can_dbc::RolloverWarning;
    World world;
    if (world.ecu.init(rsi_test_large_suv()).accepted == 0) {
        return 1;
    }
    if (!world.drive(100, 2.0F, 1.1F)) {
        return 2;
    }
    const RolloverWarning& warning = world.ears.latest<RolloverWarning>();
    if (warning.state != RolloverWarning::State::ready) {
        return 3;
    }
    if (!world.drive(100, 9.0F, 6.3F)) {
        return 4;
    }
    if ((warning.state != RolloverWarning::State::warning) ||
        (warning.side != RolloverWarning::Side::right)) {
        return 5;
    }
    if (world.ears.latest<rsi::can_dbc::RolloverStatus>().imu_timeout || (world.watchdog.feeds != 200)) {
        return 6;
    }
    return 0;
}
