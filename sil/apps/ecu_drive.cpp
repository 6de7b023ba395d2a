// ecu-drive: the simulated vehicle and the ECU with XCP and diagnosis in one process, for a tester at the
// other end of two pipes, who says when time goes on. Therefore it needs no CAN interface, and nothing
// depends on the speed of a tester. sil/tools/simulated_bus.py is the other end.
//
//   use: ecu-drive VEHICLE.toml PARAMETERS.toml
//
// One command a line:
//   drive MANOEUVRE SECONDS [LOST...]
//     a new drive, the ECU off and on again before it; stored data stay. SECONDS 0: as long as the manoeuvre.
//     LOST: values without a sensor
//   drive bench 0
//     the ECU alone, without sensor frames
//   send ID#HEX
//     a frame of the tester, for the next cycle
//   step CYCLES
//     so many cycles; the vehicle is driven on after the manoeuvre's end
//   finish
//     cycles to the manoeuvre's end
// The answer to each ends in a line "done"; before it, "wrong REASON", or for each cycle:
//   cycle NUMBER STATE SIDE FRAMES NUMBERS
//     FRAMES: those of the ECU but a tester's. NUMBERS: a checksum of all outputs but state and side
//   frame ID#HEX
//     an answer to the tester
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "rsi/ecu/application/crc32.hpp"
#include "sil/apps/accessible_ecu.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/key_file.hpp"
#include "sil/simulation/closed_loop.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace {

struct SensorValue {
    const char* name;
    double sil::SensorSample::* value;
};

constexpr std::array<SensorValue, 7> sensor_values{{
    {"lateral_acceleration", &sil::SensorSample::lateral_acceleration_mps2},
    {"vertical_acceleration", &sil::SensorSample::vertical_acceleration_mps2},
    {"roll_rate", &sil::SensorSample::roll_rate_radps},
    {"roll_angle", &sil::SensorSample::roll_angle_rad},
    {"speed", &sil::SensorSample::speed_mps},
    {"yaw_rate", &sil::SensorSample::yaw_rate_radps},
    {"steering_wheel_angle", &sil::SensorSample::steering_wheel_angle_rad},
}};

SensorValue sensor_value(const std::string& name) {
    std::string known;
    for (const SensorValue& each : sensor_values) {
        if (each.name == name) {
            return each;
        }
        known += std::string{known.empty() ? "" : ", "} + each.name;
    }
    throw std::runtime_error(fmt::format("There is no sensor '{}'. Choose one of: {}.", name, known));
}

class LostSensors final : public sil::RunObserver {
 public:
    explicit LostSensors(std::vector<SensorValue> lost) : lost_{std::move(lost)} {}
    sil::SensorSample reported(const sil::SensorSample& sample) override {
        sil::SensorSample rest = sample;
        for (const SensorValue& each : lost_) {
            rest.*each.value = sil::SensorSample::not_available;
        }
        return rest;
    }

 private:
    std::vector<SensorValue> lost_;
};

// Longer than missing sensors take to be reported.
constexpr std::uint32_t cycles_on_a_bench = 300U;

class NoWatchdog final : public rsi::hal::Watchdog {
 public:
    void feed() noexcept override {}
};

// State that outlives the ECU.
struct Permanent {
    Permanent(const std::filesystem::path& vehicle_file, const std::filesystem::path& parameters_file)
        : vehicle{sil::load_vehicle(vehicle_file)},
          parameters{sil::load_calibration(parameters_file)},
          calibration{parameters, parameters_file.stem().string(), {}, sil::test_key_name},
          diagnosis{parameters_file.stem().string(), {}, &calibration.stored_section(), sil::test_key_name} {}

    sil::VehicleParameters vehicle;
    rsi::Parameters parameters;
    sil::CalibrationAccess calibration;
    sil::DiagnosisAccess diagnosis;
};

bool is_for_a_tester(std::uint32_t identifier) {
    return (identifier == rsi::xcp::default_identifiers.answer) ||
           (identifier == rsi::diagnosis::Addresses{}.response);
}

bool is_of_the_ecu(std::uint32_t identifier) {
    const auto& all = rsi::application::sent_identifiers;
    return std::find(all.begin(), all.end(), identifier) != all.end();
}

// The vehicle at the other end of the ECU's bus.
class Vehicle {
 public:
    Vehicle(const sil::VehicleParameters& vehicle, const std::string& manoeuvre, double seconds,
            std::vector<SensorValue> lost, rsi::hal::CanBus& bus, sil::Pace& pace)
        : plant_{vehicle, sil::find_manoeuvre(manoeuvre), options(seconds)},
          sensors_{sil::mounted_sensors(vehicle, {})},
          lost_{std::move(lost)},
          loop_{plant_, sensors_, bus, pace} {}

    // False at the manoeuvre's end.
    bool cycle() { return loop_.cycle(lost_); }

 private:
    static sil::RunOptions options(double seconds) {
        sil::RunOptions options;
        options.duration_s = seconds;
        return options;
    }

    sil::ManoeuvreRun plant_;
    sil::SensorSuite sensors_;
    LostSensors lost_;
    sil::ClosedLoop loop_;
};

class Drive final : private sil::Pace {
 public:
    Drive(Permanent& permanent, const std::string& manoeuvre, double seconds, std::vector<SensorValue> lost)
        : permanent_{permanent} {
        if (manoeuvre != "bench") {
            sil::Pace& pace = *this;
            vehicle_ = std::make_unique<Vehicle>(permanent.vehicle, manoeuvre, seconds, std::move(lost),
                                                 bus_.endpoint(1U), pace);
        }
        start(true);
    }

    void send(const rsi::hal::CanFrame& frame) { bus_.endpoint(2U).send(frame); }

    // False at the manoeuvre's end.
    bool cycle() {
        const bool goes_on = vehicle_ ? vehicle_->cycle() : bench_cycle();
        report();
        if (ecu_->is_reset_requested()) {
            start(false);
        }
        return goes_on;
    }

 private:
    void start(bool is_switched_on) {
        ecu_.emplace(bus_.endpoint(0U), clock_, watchdog_, permanent_.parameters,
                     sil::Accesses{&permanent_.calibration, &permanent_.diagnosis}, is_switched_on);
    }

    bool bench_cycle() {
        begin_cycle(bench_cycles_);
        ++bench_cycles_;
        return wait_for_answer(0U) && (bench_cycles_ < cycles_on_a_bench);
    }

    void begin_cycle(std::uint32_t number) override {
        clock_.set(rsi::hal::Time{number * sil::cycle_time.nanoseconds});
        number_ = number;
        stepped_ = false;
    }
    void frames_sent(std::uint32_t) override {}
    bool wait_for_answer(std::uint32_t) override {
        if (stepped_) {
            return false;
        }
        ecu_->step(0U);
        stepped_ = true;
        return true;
    }
    double reception_time_s(const rsi::hal::CanFrame& frame) const override {
        return static_cast<double>(frame.receive_time.nanoseconds) * 1.0e-9;
    }

    void report() {
        std::string answers;
        unsigned frames = 0U;
        rsi::hal::CanFrame frame;
        while (bus_.endpoint(2U).receive(frame) == rsi::hal::ReceiveResult::frame) {
            if (is_for_a_tester(frame.identifier)) {
                answers += fmt::format("frame {:03X}#", frame.identifier);
                for (std::size_t at = 0U; at < frame.length; ++at) {
                    answers += fmt::format("{:02X}", frame.data[at]);
                }
                answers += '\n';
            } else if (is_of_the_ecu(frame.identifier)) {
                ++frames;
            }
        }
        rsi::Outputs numbers = ecu_->outputs();
        const int state = numbers.state;
        const int side = numbers.side;
        numbers.state = 0;
        numbers.side = 0;
        const auto* const bytes = static_cast<const std::uint8_t*>(static_cast<const void*>(&numbers));
        fmt::print("cycle {} {} {} {} {:08X}\n{}", number_, state, side, frames,
                   rsi::application::crc32(bytes, sizeof numbers), answers);
    }

    Permanent& permanent_;
    rsi::hal::VirtualClock clock_;
    rsi::hal::MemoryBus<3U> bus_{clock_};
    NoWatchdog watchdog_;
    std::optional<sil::AccessibleEcu> ecu_;
    std::unique_ptr<Vehicle> vehicle_;  // none on a bench
    std::uint32_t number_{0U};
    std::uint32_t bench_cycles_{0U};
    bool stepped_{false};
};

rsi::hal::CanFrame frame_of(const std::string& text) {
    rsi::hal::CanFrame frame;
    const char* const end = text.data() + text.size();
    const char* at = std::from_chars(text.data(), end, frame.identifier, 16).ptr;
    if (at == end || *at != '#') {
        throw std::runtime_error(fmt::format("'{}' is not a frame, as 6F0#FF00", text));
    }
    for (++at; end - at >= 2 && frame.length < 8U; at += 2) {
        std::uint8_t byte = 0U;
        std::from_chars(at, at + 2, byte, 16);
        frame.data.at(frame.length) = byte;
        ++frame.length;
    }
    return frame;
}

class Answers {
 public:
    explicit Answers(Permanent& permanent) : permanent_{permanent} {}

    void take(const std::string& line) {
        std::istringstream words{line};
        std::string command;
        words >> command;
        if (command == "drive") {
            begin(words);
        } else if (command == "send" && drive_) {
            std::string frame;
            words >> frame;
            drive_->send(frame_of(frame));
        } else if (command == "step" && drive_) {
            unsigned count = 0U;
            words >> count;
            for (; count > 0U; --count) {
                static_cast<void>(drive_->cycle());
            }
        } else if (command == "finish" && drive_) {
            while (drive_->cycle()) {
            }
        } else {
            throw std::runtime_error(fmt::format("'{}' is not a command, or before a drive", line));
        }
    }

 private:
    void begin(std::istringstream& words) {
        std::string manoeuvre;
        double seconds = 0.0;
        words >> manoeuvre >> seconds;
        std::vector<SensorValue> lost;
        for (std::string name; words >> name;) {
            lost.push_back(sensor_value(name));
        }
        drive_.reset();
        drive_ = std::make_unique<Drive>(permanent_, manoeuvre, seconds, std::move(lost));
    }

    Permanent& permanent_;
    std::unique_ptr<Drive> drive_;
};

void serve(char** argv) {
    Permanent permanent{argv[1], argv[2]};
    Answers answers{permanent};
    for (std::string line; std::getline(std::cin, line);) {
        try {
            answers.take(line);
        } catch (const std::exception& error) {
            fmt::print("wrong {}\n", error.what());
        }
        fmt::print("done\n");
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        fmt::print(stderr, "use: ecu-drive VEHICLE.toml PARAMETERS.toml\n");
        return 2;
    }
    try {
        serve(argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "ecu-drive: {}\n", error.what());
        return 1;
    }
    return 0;
}
