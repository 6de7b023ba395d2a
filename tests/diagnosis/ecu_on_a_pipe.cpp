// An ECU with diagnosis whose bus is a pipe and whose time is its tester's, for testers in other languages.
//
//   use: ecu_on_a_pipe FOLDER       FOLDER: where it keeps what outlives it
//
// In, a line each: a frame as `7A6#023E00`, or a number of cycles to run. Out: the frames sent by diagnosis,
// then `.` after each number of cycles, or `reset` where a tester has asked for one and the ECU has started
// anew. It has no sensors, so that it has trouble codes; `speed N` on its input gives it a speed in m/s
// instead of none.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "sil/apps/tool_access.hpp"
#include "sil/files/key_file.hpp"
#include "tests/application/bench.hpp"

namespace {

using testing_application::frame_of;

class EcuOnAPipe {
 public:
    explicit EcuOnAPipe(const char* folder) : access_{"large_suv", folder, nullptr, sil::test_key_name} {
        start(true);
    }

    void take(const std::string& line) {
        if (line.rfind("speed ", 0U) == 0U) {
            speed_kmh_ = std::stof(line.substr(6U)) * 3.6F;
        } else if (line.find('#') != std::string::npos) {
            send(line);
        } else {
            run(std::stoi(line));
        }
    }

 private:
    void start(bool is_switched_on) {
        ecu_.reset();
        diagnosis_.emplace(bus_.endpoint(0U), rsi::diagnosis::Addresses{}, access_.identification(),
                           access_.one(), access_.other());
        diagnosis_->use(access_.seed_and_key());
        diagnosis_->use(access_.store());
        diagnosis_->start(is_switched_on);
        ecu_.emplace(bus_.endpoint(0U), clock_, watchdog_);
        ecu_->add_listener(diagnosis_->listener());
        const bool is_downloaded = access_.store().restore();
        ecu_->report_stored_section(access_.store().refusal());
        if (is_downloaded) {
            ecu_->init(access_.store().section(), access_.store().length());
        } else {
            ecu_->init(testing_application::large_suv());
        }
    }

    void send(const std::string& line) {
        rsi::hal::CanFrame frame{};
        frame.identifier = static_cast<std::uint32_t>(std::stoul(line.substr(0U, 3U), nullptr, 16));
        for (std::size_t at = 4U; at + 1U < line.size() && frame.length < 8U; at += 2U) {
            frame.data.at(frame.length) =
                static_cast<std::uint8_t>(std::stoul(line.substr(at, 2U), nullptr, 16));
            ++frame.length;
        }
        bus_.endpoint(1U).send(frame);
    }

    void run(int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            if (speed_kmh_) {
                rsi::can_dbc::VehicleMotion motion{};
                motion.speed_kmh = *speed_kmh_;
                bus_.endpoint(1U).send(frame_of(motion, counter_));
                counter_ = (counter_ + 1U) % 15U;
            }
            ecu_->step(0U);
            diagnosis_->step(*ecu_);
            clock_.advance(rsi::hal::Time::from_milliseconds(10));
            print();
            if (diagnosis_->is_reset_requested()) {
                start(false);
                std::puts("reset");
            }
        }
        std::puts(".");
        std::fflush(stdout);
    }

    void print() {
        rsi::hal::CanFrame frame{};
        while (bus_.endpoint(1U).receive(frame) == rsi::hal::ReceiveResult::frame) {
            if (frame.identifier != rsi::diagnosis::Addresses{}.response) {
                continue;
            }
            std::printf("%03X#", frame.identifier);
            for (std::size_t byte = 0U; byte < frame.length; ++byte) {
                std::printf("%02X", frame.data.at(byte));
            }
            std::puts("");
        }
    }

    sil::DiagnosisAccess access_;
    rsi::hal::VirtualClock clock_{};
    rsi::hal::MemoryBus<2U> bus_{clock_};
    testing_application::NoWatchdog watchdog_{};
    std::optional<rsi::diagnosis::Diagnosis> diagnosis_;
    std::optional<rsi::application::RolloverEcu> ecu_;
    std::optional<float> speed_kmh_;
    unsigned counter_{0U};
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2 || !std::filesystem::is_directory(argv[1])) {
        std::fputs("use: ecu_on_a_pipe FOLDER, an existing one\n", stderr);
        return 2;
    }
    try {
        EcuOnAPipe ecu{argv[1]};
        for (std::string line; std::getline(std::cin, line);) {
            ecu.take(line);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ecu_on_a_pipe: %s\n", error.what());
        return 1;
    }
    return 0;
}
