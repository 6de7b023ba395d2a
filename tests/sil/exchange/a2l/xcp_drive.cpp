// xcp-drive: the simulated vehicle and the ECU with XCP in one process, for a master of XCP on the other end
// of two pipes, who says when time goes on. Therefore nothing depends on the speed of a master. One command a
// line:
//   drive MANOEUVRE SECONDS   a new drive, the ECU off and on again before it; what was stored stays
//   send HEX                  a frame of the master, for the next cycle
//   step CYCLES               at most so many cycles; fewer where the drive ends
// The answer to each ends in a line "done"; before it, for each cycle:
//   cycle NUMBER STATE SIDE FRAMES NUMBERS   frames of the ECU but XCP's; a checksum of all outputs but state
//   and side xcp HEX                                  a frame of the slave
#include <fmt/format.h>

#include <charconv>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "hal/linux/system_random.hpp"
#include "hal/memory/memory_bus.hpp"
#include "hal/memory/memory_storage.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "hal/software_keys/software_keys.hpp"
#include "rsi/ecu/application/calibrated_ecu.hpp"
#include "rsi/ecu/application/crc32.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/parameter_section_file.hpp"
#include "sil/simulation/closed_loop.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace {

const std::string project_folder = RSI_PROJECT_FOLDER;

class NoWatchdog final : public rsi::hal::Watchdog {
 public:
    void feed() noexcept override {}
};

// State that outlives the ECU.
struct Permanent {
    rsi::hal::SoftwareKeys keys{rsi::hal::test_keys};
    rsi::hal::SystemRandom random;
    rsi::hal::MemoryStorage<64U> attempts;
    rsi::hal::MemoryStorage<rsi::application::SectionRecord::length> one;
    rsi::hal::MemoryStorage<rsi::application::SectionRecord::length> other;
    rsi::application::SectionRecord parameters{one, other};
    std::vector<std::uint8_t> section = sil::parameter_section(
        sil::load_calibration(project_folder + "/firmware/calibrations/large_suv.toml"), "large_suv");
};

class Drive final : private sil::Pace {
 public:
    Drive(Permanent& permanent, const std::string& manoeuvre, double seconds)
        : access_{permanent.keys, rsi::hal::KeySlot::calibration, permanent.random, permanent.attempts},
          ecu_{bus_.endpoint(0U),
               clock_,
               watchdog_,
               access_,
               permanent.section.data(),
               permanent.section.size(),
               &permanent.parameters},
          plant_{vehicle_, sil::find_manoeuvre(manoeuvre), options(seconds)},
          sensors_{sil::mounted_sensors(vehicle_, {})},
          loop_{plant_, sensors_, bus_.endpoint(1U), *this} {
        access_.start();
        static_cast<void>(ecu_.init());
    }

    void send(const rsi::hal::CanFrame& frame) { bus_.endpoint(2U).send(frame); }

    // False after the last cycle.
    bool cycle() {
        sil::RunObserver no_observer;
        const bool goes_on = loop_.cycle(no_observer);
        report();
        return goes_on;
    }

 private:
    static sil::RunOptions options(double seconds) {
        sil::RunOptions options;
        options.duration_s = seconds;
        return options;
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
        ecu_.step(0U);
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
            if (frame.identifier == rsi::xcp::default_identifiers.answer) {
                answers += "xcp ";
                for (std::size_t at = 0U; at < frame.length; ++at) {
                    answers += fmt::format("{:02X}", frame.data[at]);
                }
                answers += '\n';
            } else if ((frame.identifier & 0x7F0U) != 0x120U) {
                ++frames;
            }
        }
        rsi::Outputs numbers = ecu_.ecu().outputs();
        const int state = numbers.state;
        const int side = numbers.side;
        numbers.state = 0;
        numbers.side = 0;
        const auto* const bytes = static_cast<const std::uint8_t*>(static_cast<const void*>(&numbers));
        fmt::print("cycle {} {} {} {} {:08X}\n{}", number_, state, side, frames,
                   rsi::application::crc32(bytes, sizeof numbers), answers);
    }

    rsi::hal::VirtualClock clock_;
    rsi::hal::MemoryBus<3U> bus_{clock_};
    NoWatchdog watchdog_;
    rsi::access::SeedAndKey access_;
    rsi::application::CalibratedEcu ecu_;
    sil::VehicleParameters vehicle_ = sil::load_vehicle(project_folder + "/sil/vehicles/large_suv.toml");
    sil::ManoeuvreRun plant_;
    sil::SensorSuite sensors_;
    sil::ClosedLoop loop_;
    std::uint32_t number_{0U};
    bool stepped_{false};
};

rsi::hal::CanFrame frame_of(const std::string& hex) {
    rsi::hal::CanFrame frame;
    frame.identifier = rsi::xcp::default_identifiers.command;
    for (std::size_t at = 0U; at + 1U < hex.size() && frame.length < 8U; at += 2U) {
        std::uint8_t byte = 0U;
        std::from_chars(hex.data() + at, hex.data() + at + 2U, byte, 16);
        frame.data[frame.length] = byte;
        ++frame.length;
    }
    return frame;
}

}  // namespace

int main() {
    Permanent permanent;
    std::optional<Drive> drive;
    std::string line;
    while (std::getline(std::cin, line)) {
        std::istringstream words{line};
        std::string command;
        words >> command;
        if (command == "drive") {
            std::string manoeuvre;
            double seconds = 0.0;
            words >> manoeuvre >> seconds;
            drive.emplace(permanent, manoeuvre, seconds);
        } else if (command == "send" && drive) {
            std::string hex;
            words >> hex;
            drive->send(frame_of(hex));
        } else if (command == "step" && drive) {
            unsigned count = 0U;
            words >> count;
            for (unsigned cycle = 0U; cycle < count && drive->cycle(); ++cycle) {
            }
        } else {
            fmt::print("unknown {}\n", line);
        }
        fmt::print("done\n");
        std::fflush(stdout);
    }
}
