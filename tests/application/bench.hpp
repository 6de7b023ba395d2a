// Test bench: the ECU on a memory bus with three sensors that can be made to misbehave, and a listener on
// the bus.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <vector>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "tests/application/end_to_end.hpp"
#include "tests/support/large_suv.h"

namespace testing_application {

enum class Sensor : std::uint8_t { imu, roll_angle, vehicle_motion };
inline constexpr std::array<Sensor, 3> all_sensors{Sensor::imu, Sensor::roll_angle, Sensor::vehicle_motion};

constexpr const char* name_of(Sensor sensor) {
    constexpr std::array<const char*, 3> names{"Imu", "RollAngle", "VehicleMotion"};
    return names[static_cast<std::size_t>(sensor)];
}
// How a failing test shows a sensor.
inline void PrintTo(Sensor sensor, std::ostream* out) {
    *out << name_of(sensor);
}

// Inputs of the sensors. The default: straight on at 80 km/h on level ground, bank not measured.
struct Motion {
    rsi::can_dbc::Imu imu{0.0F, 9.80665F, 0.0F};
    rsi::can_dbc::RollAngle roll_angle{0.0F, rsi::can_dbc::not_available};
    rsi::can_dbc::VehicleMotion vehicle_motion{80.0F, 0.0F, 0.0F};
    rsi::can_dbc::VehicleMass vehicle_mass{};  // sent where it is available: most vehicles do not know it
};

// How many frames the ECU sends in one cycle.
inline constexpr std::size_t frames_per_cycle = rsi::can_dbc::MessagesFromRolloverEcu::size;

// They, as they came; those that matter here decoded.
struct Cycle {
    rsi::hal::Time time{};
    std::vector<rsi::hal::CanFrame> frames{};
    rsi::can_dbc::Decoded<rsi::can_dbc::RolloverWarning> warning{};
    rsi::can_dbc::Decoded<rsi::can_dbc::RollCentreEstimate> estimate{};
    rsi::can_dbc::Decoded<rsi::can_dbc::RolloverDiagnosis> diagnosis{};
    rsi::can_dbc::Decoded<rsi::can_dbc::RolloverStatus> status{};

    rsi::can_dbc::RolloverWarning::State state() const { return warning.value.state; }
};

// As a sensor sends it, with this counter.
template <typename Message>
rsi::hal::CanFrame frame_of(const Message& message, unsigned counter) {
    rsi::hal::CanFrame frame;
    frame.identifier = Message::identifier;
    frame.length = Message::length;
    const auto payload = rsi::can_dbc::encode(message);
    std::copy(payload.begin(), payload.end(), frame.data.begin());
    protect(frame, Message::e2e_data_id, counter);
    return frame;
}

// For tests that put an ECU on a bus of their own.
struct NoWatchdog final : rsi::hal::Watchdog {
    void feed() noexcept override {}
};

// The calibration of a large SUV, with the IMU at the centre of gravity.
inline rsi::Parameters large_suv() {
    return rsi_test_large_suv();
}

// Sensor frames are sent every 10 ms, the ECU steps `ecu_delay` after them.
class Bench {
 public:
    using FrameChange = std::function<void(rsi::hal::CanFrame&)>;

    explicit Bench(const rsi::Parameters& parameters = large_suv(),
                   rsi::hal::Time ecu_delay = rsi::hal::Time::from_milliseconds(1));

    // Starts the ECU anew, with the parameters of a section.
    rsi::application::ParameterSectionAnswer start_with(const std::vector<std::uint8_t>& section) {
        return ecu_.init(section.data(), section.size());
    }

    rsi::application::ParameterSectionAnswer start_with(const std::vector<std::uint8_t>& section,
                                                        rsi::application::SectionAuthority& authority) {
        return ecu_.init(section.data(), section.size(), authority);
    }
    // The same with parameters.
    rsi::Validation start_with(const rsi::Parameters& parameters) { return ecu_.init(parameters); }
    // Other parameters while it runs.
    void change(const rsi::ParameterChange& change) { ecu_.change(change); }

    // Before the start: what XCP or UDS ask for.
    void report_test_keys(const rsi::hal::KeyStore& keys) { ecu_.report_test_keys(keys); }

    // Before the start: where it keeps its load.
    void use_storage(rsi::hal::Storage& storage) { ecu_.use_storage(storage); }
    const rsi::Parameters& parameters() const { return ecu_.parameters(); }

    // Before the start: that it has a place for a section, and what was found in it.
    void report_stored_section(rsi::application::ParametersRefusal refusal) {
        ecu_.report_stored_section(refusal);
    }

    // A tester has cleared these codes.
    void restart_debounce(rsi::monitoring::CodeSet codes) { ecu_.restart_debounce(codes); }

    // Why the ECU's controller started.
    void start_after(rsi::hal::ResetReason reason) { ecu_.set_reset_reason(reason); }

    // Inputs of the sensors from now on.
    void drive(const Motion& motion);
    // The same as a function of the time in seconds.
    void drive(std::function<Motion(double time_s)> motion) { motion_ = std::move(motion); }

    void run_cycles(int count);
    void run_for(double seconds);
    // A fresh bench after its recovery time: the ECU is ready.
    void run_until_ready();

    void stop(Sensor sensor) { line(sensor).silent = true; }
    void stop_all();
    void resume(Sensor sensor) { line(sensor).silent = false; }
    void resume_all();

    // Lets `change` alter each frame of a sensor after it was protected; an empty one ends that.
    void tamper(Sensor sensor, FrameChange change) { line(sensor).change = std::move(change); }
    // Moves a sensor's counter on, as if `count` frames had been lost on the way.
    void lose_frames(Sensor sensor, unsigned count);
    // Sends the sensor's next frames with the counter of the one before.
    void repeat_counter(Sensor sensor, bool repeat) { line(sensor).counter_stands = repeat; }

    // A frame of another node, at once.
    void send_foreign(const rsi::hal::CanFrame& frame) { bus_.endpoint(world).send(frame); }
    // The last frame that a sensor has sent.
    const rsi::hal::CanFrame& last_frame(Sensor sensor) { return line(sensor).last; }
    // When the last sensor frame went out.
    rsi::hal::Time last_sensor_time() const { return last_sensor_time_; }

    // The ECU's object, for tests that damage it.
    unsigned char* memory() { return reinterpret_cast<unsigned char*>(&ecu_); }
    static constexpr std::size_t memory_size = sizeof(rsi::application::RolloverEcu);

    // All clocks go on from there.
    void move_clock(rsi::hal::Time by) { clock_offset_ = clock_offset_ + by; }

    // Reported to the ECU with each further cycle.
    void miss_cycles(std::uint32_t count) { missed_cycles_ = count; }
    void set_bus_state(rsi::hal::BusState state) { bus_.endpoint(ecu).set_state(state); }

    const std::vector<Cycle>& cycles() const { return cycles_; }
    const Cycle& last() const { return cycles_.back(); }
    rsi::can_dbc::RolloverWarning::State state() const { return last().state(); }
    const rsi::can_dbc::RolloverStatus& status() const { return last().status.value; }
    // Inputs that the ECU took from the sensors' frames in its last cycle.
    const rsi::Inputs& inputs() const { return ecu_.inputs(); }
    const rsi::monitoring::DiagnosticMemory& diagnostic_memory() const { return ecu_.diagnostic_memory(); }
    const rsi::Outputs& outputs() const { return ecu_.outputs(); }
    rsi::hal::Time cycle_shift() const { return ecu_.cycle_shift(); }
    int watchdog_feeds() const { return watchdog_.feeds; }
    const rsi::Validation& parameters_answer() const { return answer_; }

 private:
    static constexpr std::size_t ecu = 0U;
    static constexpr std::size_t world = 1U;

    struct Line {
        bool silent{false};
        bool counter_stands{false};
        unsigned counter{0U};
        FrameChange change{};
        rsi::hal::CanFrame last{};
    };

    struct CountingWatchdog final : rsi::hal::Watchdog {
        void feed() noexcept override { ++feeds; }
        int feeds{0};
    };

    Line& line(Sensor sensor) { return lines_[static_cast<std::size_t>(sensor)]; }
    void send_sensor_frames();
    template <typename Message>
    void send(Line& line, const Message& message);
    void step_ecu();

    rsi::hal::Time ecu_delay_;
    rsi::hal::VirtualClock clock_{};
    rsi::hal::MemoryBus<2U> bus_{clock_};
    CountingWatchdog watchdog_{};
    rsi::application::RolloverEcu ecu_{bus_.endpoint(ecu), clock_, watchdog_};
    rsi::Validation answer_;
    std::function<Motion(double)> motion_{};
    std::array<Line, 3> lines_{};
    Line mass_line_{};
    std::int64_t cycle_number_{0};
    rsi::hal::Time last_sensor_time_{};
    rsi::hal::Time clock_offset_{};
    std::uint32_t missed_cycles_{0U};
    std::vector<Cycle> cycles_{};
};

}  // namespace testing_application
