#include "sil/studies/faults/memory_flips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <numeric>
#include <type_traits>

#include "rsi/ecu/application/rollover_ecu.hpp"
#include "rsi/hal/clock.hpp"
#include "sil/files/require_accepted.hpp"
#include "sil/random.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/simulation/sensor_frames.hpp"
#include "sil/studies/faults/ecu_answer.hpp"
#include "sil/studies/faults/recorded_drive.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/sensors/sensor_suite.hpp"

namespace sil {
namespace {

using rsi::application::RolloverEcu;
// Its state is copied byte by byte: nothing in it owns anything.
static_assert(std::is_trivially_destructible_v<RolloverEcu>);

constexpr std::size_t first_flip = 100U;  // cycle: the ECU has started

// The ECU's end of a bus on which one cycle's frames wait, and on which it sends to the world's end.
class CycleBus final : public rsi::hal::CanBus {
 public:
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame& frame) noexcept override {
        return take(waiting_, frame);
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override {
        sent_.push_back(frame);
        return rsi::hal::SendResult::sent;
    }
    rsi::hal::BusState state() const noexcept override { return rsi::hal::BusState::error_active; }
    rsi::hal::BusStatistics statistics() const noexcept override { return {}; }

    void put(const std::vector<rsi::hal::CanFrame>& frames) {
        waiting_.assign(frames.begin(), frames.end());
        sent_.clear();
    }
    rsi::hal::ReceiveResult take_sent(rsi::hal::CanFrame& frame) noexcept { return take(sent_, frame); }

 private:
    static rsi::hal::ReceiveResult take(std::deque<rsi::hal::CanFrame>& frames,
                                        rsi::hal::CanFrame& frame) noexcept {
        if (frames.empty()) {
            return rsi::hal::ReceiveResult::empty;
        }
        frame = frames.front();
        frames.pop_front();
        return rsi::hal::ReceiveResult::frame;
    }

    std::deque<rsi::hal::CanFrame> waiting_{};
    std::deque<rsi::hal::CanFrame> sent_{};
};

// The other end of it: keeps what the sensors send, gives out what the ECU has sent.
class WorldEnd final : public rsi::hal::CanBus {
 public:
    explicit WorldEnd(CycleBus& bus) : bus_{bus} {}
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame& frame) noexcept override {
        return bus_.take_sent(frame);
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override {
        kept.push_back(frame);
        kept.back().receive_time = now;
        return rsi::hal::SendResult::sent;
    }
    rsi::hal::BusState state() const noexcept override { return rsi::hal::BusState::error_active; }
    rsi::hal::BusStatistics statistics() const noexcept override { return {}; }

    rsi::hal::Time now{};
    std::vector<rsi::hal::CanFrame> kept{};

 private:
    CycleBus& bus_;
};

class CountingWatchdog final : public rsi::hal::Watchdog {
 public:
    void feed() noexcept override { ++feeds; }
    int feeds{0};
};

rsi::hal::Time time_of(std::size_t cycle) {
    return rsi::hal::Time{static_cast<std::int64_t>(cycle) * cycle_time.nanoseconds};
}

using EcuBytes = std::array<unsigned char, sizeof(RolloverEcu)>;

// The ECU and its reader at the beginning of a cycle.
struct Moment {
    EcuBytes ecu;
    EcuAnswerReader reader;
};

using Frames = std::vector<std::vector<rsi::hal::CanFrame>>;  // one vector a cycle

class Line {
 public:
    explicit Line(const rsi::Parameters& calibration) : ecu_{bus_, clock_, watchdog_} {
        require_accepted(ecu_.init(calibration));
    }

    Moment moment() const {
        Moment moment{{}, reader_};
        std::memcpy(moment.ecu.data(), &ecu_, sizeof(ecu_));
        return moment;
    }

    // The addresses in it are those of this line.
    void go_to(const Moment& moment) {
        std::memcpy(static_cast<void*>(&ecu_), moment.ecu.data(), sizeof(ecu_));
        reader_ = moment.reader;
    }

    bool is_at(const Moment& moment) const {
        return std::memcmp(&ecu_, moment.ecu.data(), sizeof(ecu_)) == 0;
    }

    void flip(std::size_t byte, unsigned bit) {
        auto* const bytes = reinterpret_cast<unsigned char*>(&ecu_);
        bytes[byte] = static_cast<unsigned char>(bytes[byte] ^ (1U << bit));
    }

    Statement cycle(std::size_t number, const std::vector<rsi::hal::CanFrame>& frames) {
        clock_.now_ = time_of(number);
        bus_.put(frames);
        const int feeds = watchdog_.feeds;
        ecu_.step(0U);
        const EcuAnswer answer = reader_.read(world_);
        const bool warns = answer.state == WarningState::warning;
        return {answer.state, warns ? answer.side : WarningSide::none, answer.degradation, answer.codes,
                answer.complete && answer.defined && watchdog_.feeds == feeds + 1};
    }

 private:
    // Goes back as well, with the ECU.
    struct SteeredClock final : rsi::hal::Clock {
        rsi::hal::Time now() const noexcept override { return now_; }
        rsi::hal::Time now_{};
    };

    CycleBus bus_{};
    WorldEnd world_{bus_};
    SteeredClock clock_{};
    CountingWatchdog watchdog_{};
    RolloverEcu ecu_;
    EcuAnswerReader reader_{};
};

// A drive and what the undisturbed ECU makes of it.
struct Drive {
    std::string name{};
    Frames frames{};
    std::vector<Moment> moments{};
    std::vector<Statement> statements{};
};

Frames record(const VehicleParameters& vehicle, const Manoeuvre& manoeuvre, const RunOptions& options) {
    ManoeuvreRun plant{vehicle, manoeuvre, options};
    SensorFlaws flaws;
    flaws.noise = true;
    flaws.seed = recording_noise_seed;
    SensorSuite sensors{mounted_sensors(vehicle, flaws)};
    CycleBus bus;
    WorldEnd world{bus};
    SensorFrames sender;
    Frames frames;
    sensors.observe(plant.truth());
    while (!plant.finished() && std::abs(plant.truth().roll_angle_rad) < recorded_roll_rad) {
        world.now = time_of(frames.size());
        world.kept.clear();
        sender.send(world, sensors.report(plant.truth()));
        frames.push_back(world.kept);
        for (int step = 0; step < recorded_steps; ++step) {
            plant.step();
            sensors.observe(plant.truth());
        }
    }
    return frames;
}

Drive undisturbed(Line& line, const Moment& start, std::string name, Frames frames) {
    Drive drive{std::move(name), std::move(frames), {}, {}};
    line.go_to(start);
    for (std::size_t cycle = 0U; cycle < drive.frames.size(); ++cycle) {
        drive.moments.push_back(line.moment());
        drive.statements.push_back(line.cycle(cycle, drive.frames[cycle]));
    }
    return drive;
}

std::vector<Drive> drives_of(Line& line, const VehicleParameters& vehicle) {
    const Moment start = line.moment();
    const auto drive = [&](const char* name, const char* manoeuvre, double speed_factor, double duration_s) {
        RunOptions options;
        options.speed_factor = speed_factor;
        options.duration_s = duration_s;
        return undisturbed(line, start, name, record(vehicle, find_manoeuvre(manoeuvre), options));
    };
    return {drive("J-turn", "j-turn-110", 1.0, 0.0), drive("fishhook", "fishhook-1b", 1.0, 0.0),
            drive("calm lane change", "double-lane-change", 0.7, 0.0),
            drive("straight", "straight", 1.0, 6.0)};
}

FlipEffect run_flip(Line& line, const Drive& drive, const Flip& flip) {
    std::vector<Statement> statements = drive.statements;
    line.go_to(drive.moments[flip.cycle]);
    line.flip(flip.byte, flip.bit);
    for (std::size_t cycle = flip.cycle; cycle < drive.frames.size(); ++cycle) {
        statements[cycle] = line.cycle(cycle, drive.frames[cycle]);
        // Nothing is left of it.
        if (cycle + 1U < drive.frames.size() && statements[cycle] == drive.statements[cycle] &&
            line.is_at(drive.moments[cycle + 1U])) {
            break;
        }
    }
    return effect_of(statements, drive.statements, flip.cycle);
}

std::vector<std::size_t> bytes_to_flip(const std::vector<MemoryPart>& parts) {
    std::vector<std::size_t> bytes;
    for (const MemoryPart& part : parts) {
        if (!part.is_address) {
            bytes.resize(bytes.size() + part.length);
            std::iota(bytes.end() - static_cast<std::ptrdiff_t>(part.length), bytes.end(), part.begin);
        }
    }
    return bytes;
}

Flip drawn(RandomStream& chance, const std::vector<Drive>& drives, const std::vector<std::size_t>& bytes) {
    Flip flip;
    flip.drive = chance.below(drives.size());
    flip.cycle = first_flip + chance.below(drives[flip.drive].frames.size() - first_flip);
    flip.byte = bytes[chance.below(bytes.size())];
    flip.bit = static_cast<unsigned>(chance.below(8U));
    return flip;
}

std::string row(const std::string& name, std::size_t bytes, const FlipCount& count) {
    const std::size_t all = total(count);
    std::string text = fmt::format("| {:<30} | {:>5} | {:>7} |", name, bytes, all);
    for (const std::size_t one : count) {
        text += fmt::format(" {:>7} |", one);
    }
    const double share =
        (all > 0U) ? 1000.0 * static_cast<double>(silent(count)) / static_cast<double>(all) : 0.0;
    return text + fmt::format(" {:>11.2f} |\n", share);
}

}  // namespace

MemoryFlips run_memory_flips(const VehicleParameters& vehicle, const rsi::Parameters& calibration,
                             std::size_t count, std::uint64_t seed) {
    Line line{calibration};
    const std::vector<Drive> drives = drives_of(line, vehicle);
    MemoryFlips result;
    for (const Drive& drive : drives) {
        result.drives.push_back(drive.name);
    }
    result.parts = memory_map();
    const std::vector<std::size_t> bytes = bytes_to_flip(result.parts);
    RandomStream chance{seed};
    for (std::size_t number = 0U; number < count; ++number) {
        Flip flip = drawn(chance, drives, bytes);
        flip.effect = run_flip(line, drives[flip.drive], flip);
        result.flips.push_back(flip);
    }
    return result;
}

FlipCount count_flips(const MemoryFlips& result, const MemoryPart& part) {
    FlipCount count{};
    for (const Flip& flip : result.flips) {
        if (flip.byte >= part.begin && flip.byte < part.begin + part.length) {
            ++count[static_cast<std::size_t>(flip.effect)];
        }
    }
    return count;
}

FlipCount count_flips(const MemoryFlips& result) {
    return count_flips(result, MemoryPart{"all", 0U, sizeof(RolloverEcu), false});
}

FlipCount count_component_flips(const MemoryFlips& result) {
    return count_flips(result, component_memory());
}

std::size_t total(const FlipCount& count) {
    return std::accumulate(count.begin(), count.end(), std::size_t{0U});
}

std::size_t silent(const FlipCount& count) {
    std::size_t sum = 0U;
    for (std::size_t effect = 0U; effect < flip_effect_count; ++effect) {
        sum += is_silent(static_cast<FlipEffect>(effect)) ? count[effect] : 0U;
    }
    return sum;
}

std::string memory_flips_table(const MemoryFlips& result) {
    std::string text = fmt::format("| {:<30} | bytes |   flips |", "part of the ECU's memory");
    for (std::size_t effect = 0U; effect < flip_effect_count; ++effect) {
        text += fmt::format(" {:>7} |", to_string(static_cast<FlipEffect>(effect)));
    }
    text += " silent of 1,000 |\n";
    for (const MemoryPart& part : result.parts) {
        if (!part.is_address) {
            text += row(part.name, part.length, count_flips(result, part));
        }
    }
    text += row("the component", component_memory().length, count_component_flips(result));
    return text + row("all", bytes_to_flip(result.parts).size(), count_flips(result));
}

std::string silent_flips(const MemoryFlips& result) {
    std::string text;
    for (const Flip& flip : result.flips) {
        if (!is_silent(flip.effect)) {
            continue;
        }
        const auto part = std::find_if(result.parts.begin(), result.parts.end(), [&](const MemoryPart& one) {
            return flip.byte < one.begin + one.length;
        });
        text += fmt::format("{}: byte {} of {}, bit {}, before {:.2f} s of the {}\n", to_string(flip.effect),
                            flip.byte - part->begin, part->name, flip.bit,
                            static_cast<double>(flip.cycle) * cycle_time_s, result.drives[flip.drive]);
    }
    return text;
}

}  // namespace sil
