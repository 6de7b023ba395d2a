// Recorded sensor frames through the firmware, on every target: what it answers must be the same, byte for
// byte.
//
// replay_frames PARAMETERS SENSORS ECU [flushing]: reads the calibration (write_parameters.cpp makes it) and
// the candump log SENSORS, steps the ECU every 10 ms of the log's time, as sil::replay does, and writes its
// frames to the candump log ECU.
//
// With RSI_WITH_ACCESSES (replay_with_accesses, for the budgets) XCP and diagnosis are linked and not
// connected. The ECU then starts with the section that is linked, that of large_suv; PARAMETERS is only read.
//
// flushing: with an FPU that flushes subnormal numbers to zero.
#include <cstring>

#include "hal/memory/frame_replay.hpp"
#include "hal/memory/memory_bus.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "tests/targets/bit_digest.hpp"
#include "tests/targets/candump_text.hpp"
#include "tests/targets/support/flush_to_zero.hpp"
#include "tests/targets/support/program.hpp"
#include "tests/targets/support/text_file.hpp"

#ifdef RSI_WITH_ACCESSES
#include "tests/targets/budgets/target/ecu_with_accesses.hpp"
#endif

namespace {

constexpr rsi::hal::Time cycle_time = rsi::hal::Time::from_milliseconds(10);
constexpr std::size_t most_frames = 12000U;  // 40 s of three frames
constexpr std::size_t parameter_words = sizeof(rsi::Parameters) / sizeof(std::uint32_t);
static_assert(sizeof(rsi::Parameters) == parameter_words * sizeof(std::uint32_t));

struct Recording {
    rsi::hal::CanFrame frames[most_frames];
    std::size_t count;
    target::CandumpLine first;  // says the interface
};

class NoWatchdog final : public rsi::hal::Watchdog {
 public:
    void feed() noexcept override {}
};

int refuse(const char* path, const char* reason) {
    target::print("replay_frames: ");
    target::print(path);
    target::print(reason);
    return 1;
}

// One word of eight hexadecimal digits a line, in the order of the structure; a number, not bytes, so that
// the order of bytes does not matter.
bool read_parameters(target::LineReader reader, rsi::Parameters& parameters) {
    std::uint32_t words[parameter_words];
    char line[target::longest_line];
    for (std::uint32_t& word : words) {
        if (!reader.next(line) || !target::parse_hexadecimal(line, 8U, word)) {
            return false;
        }
    }
    std::memcpy(&parameters, words, sizeof(parameters));
    return reader.at_end();
}

bool read_recording(target::LineReader reader, Recording& recording) {
    char text[target::longest_line];
    target::CandumpLine line;
    while (reader.next(text)) {
        if ((recording.count == most_frames) || !target::parse_line(text, line)) {
            return false;
        }
        if (recording.count == 0U) {
            recording.first = line;
        }
        recording.frames[recording.count] = line.frame;
        ++recording.count;
    }
    return (recording.count > 0U) && reader.at_end();
}

void add_outputs(const rsi::Outputs& outputs, target::BitDigest& digest) {
    digest.add(static_cast<std::uint32_t>(outputs.state));
    digest.add(static_cast<std::uint32_t>(outputs.side));
    digest.add(static_cast<std::uint32_t>(outputs.roll_source));
    digest.add(static_cast<std::uint32_t>(outputs.roll_sensor_disagrees));
    digest.add(static_cast<std::uint32_t>(outputs.estimate_frozen));
    // All that follows is floats; how large an enumeration is, is the compiler's choice.
    constexpr std::size_t first = offsetof(rsi::Outputs, warning_level);
    constexpr std::size_t count = (sizeof(rsi::Outputs) - first) / sizeof(float);
    float values[count];
    std::memcpy(values, reinterpret_cast<const unsigned char*>(&outputs) + first, sizeof(values));
    for (const float value : values) {
        digest.add(value);
    }
}

void print_digest(std::uint64_t digest) {
    char text[] = "outputs 0123456789ABCDEF\n";
    for (std::size_t digit = 0U; digit < 16U; ++digit) {
        text[8U + digit] = "0123456789ABCDEF"[(digest >> (60U - (4U * digit))) & 0xFU];
    }
    target::print(text);
}

#ifdef RSI_WITH_ACCESSES
using Ecu = budgets::EcuWithAccesses;
#else
// The ECU alone.
class Ecu {
 public:
    Ecu(rsi::hal::CanBus& bus, const rsi::hal::Clock& clock, rsi::hal::Watchdog& watchdog) noexcept
        : ecu_{bus, clock, watchdog} {}
    bool init(const rsi::Parameters& parameters) noexcept { return ecu_.init(parameters).accepted != 0; }
    void cycle() noexcept { ecu_.step(0U); }
    const rsi::Outputs& outputs() const noexcept { return ecu_.outputs(); }

 private:
    rsi::application::RolloverEcu ecu_;
};
#endif

std::uint64_t answer(const Recording& recording, const rsi::Parameters& parameters, target::TextWriter& out) {
    static rsi::hal::VirtualClock clock;
    static rsi::hal::MemoryBus<2U> bus{clock};
    static NoWatchdog watchdog;
    static Ecu ecu{bus.endpoint(0U), clock, watchdog};
    ecu.init(parameters);
    rsi::hal::CanBus& world = bus.endpoint(1U);
    rsi::hal::FrameReplay player{recording.frames, recording.count, clock, world};
    target::BitDigest digest;
    target::CandumpLine line = recording.first;
    char text[target::longest_line];
    for (rsi::hal::Time time = recording.frames[0].receive_time;; time = time + cycle_time) {
        player.run_until(time);
        ecu.cycle();
        add_outputs(ecu.outputs(), digest);
        while (world.receive(line.frame) == rsi::hal::ReceiveResult::frame) {
            out.put(text, target::format_line(line, text));
        }
        if (player.finished()) {
            return digest.value();
        }
    }
}

}  // namespace

int target::run(int argc, const char* const* argv) {
    const bool flushing = (argc == 5) && (std::strcmp(argv[4], "flushing") == 0);
    if ((argc != 4) && !flushing) {
        return refuse("want PARAMETERS SENSORS ECU [flushing]", "\n");
    }
    if (flushing) {
        flush_to_zero();
    }
    static rsi::Parameters parameters;
    static Recording recording;
    const Handle parameter_file = open_to_read(argv[1]);
    if ((parameter_file == no_file) || !read_parameters(LineReader{parameter_file}, parameters)) {
        return refuse(argv[1], ": cannot be read, or is no calibration of this version\n");
    }
    const Handle sensors = open_to_read(argv[2]);
    if ((sensors == no_file) || !read_recording(LineReader{sensors}, recording)) {
        return refuse(argv[2], ": cannot be read, or is no candump log of classic frames, or is too long\n");
    }
    const Handle ecu = open_to_write(argv[3]);
    if (ecu == no_file) {
        return refuse(argv[3], ": cannot be written\n");
    }
    TextWriter out{ecu};
    print_digest(answer(recording, parameters, out));
    return (close(parameter_file) && close(sensors) && out.close())
               ? 0
               : refuse(argv[3], ": cannot be written\n");
}
