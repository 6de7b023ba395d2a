// XCP around the whole ECU: any frames of a master, with the key and without, broken off, repeated, while
// cycles are missed and the bus takes nothing. For any input, each cycle sends the ECU's frames, answers at
// most one command, sends no more samples than there are parts, and runs on parameters that validate accepts;
// without the key they stay as they were.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/memory_storage.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "rsi/ecu/application/calibrated_ecu.hpp"
#include "rsi/parameters.hpp"
#include "tests/quality/fuzz/support/byte_reader.hpp"
#include "tests/quality/fuzz/support/require.hpp"

// Length of firmware/calibrations/generated/large_suv.c.
extern "C" const unsigned char rsi_parameter_section[rsi::application::section::length];

namespace {

using fuzz::ByteReader;
using fuzz::require;
namespace map = rsi::application::calibration_map;

// Two changes of the vehicle and what is sent around them; more would find little and take long.
constexpr int most_cycles = 500;
constexpr int cycles_of_a_change = 210;
constexpr unsigned frames_of_the_ecu = rsi::application::sent_identifiers.size();

struct NoWatchdog final : rsi::hal::Watchdog {
    void feed() noexcept override {}
};

struct CountingRandom final : rsi::hal::RandomSource {
    bool fill(std::uint8_t* bytes, std::size_t length) noexcept override {
        std::fill_n(bytes, length, ++calls);
        return true;
    }
    std::uint8_t calls{0U};
};

// The answer is the seed with each bit turned over: AES is not what is searched.
struct PlainKeys final : rsi::hal::KeyStore {
    bool authenticate(rsi::hal::KeySlot, const std::uint8_t* bytes, std::size_t length,
                      rsi::hal::AuthenticationCode& code) noexcept override {
        for (std::size_t at = 0U; at < code.size(); ++at) {
            code[at] = static_cast<std::uint8_t>(~bytes[at % length]);
        }
        return true;
    }
    bool has_test_keys() const noexcept override { return true; }
};

class Session {
 public:
    Session() {
        access_.start();
        require(ecu_.init().refusal == rsi::application::ParametersRefusal::none, "the section is good");
        start_ = ecu_.ecu().parameters();
    }

    void play(ByteReader& bytes) {
        while (cycles_ < most_cycles && !bytes.empty()) {
            act(bytes);
        }
    }

 private:
    void act(ByteReader& bytes) {
        switch (bytes.below(10U)) {
            case 0U:
                unlock();
                break;
            case 1U:
                cycle(bytes.below(4U));
                break;
            case 2U:
                bus_.endpoint(0U).set_state(bytes.one_in(3U) ? rsi::hal::BusState::bus_off
                                                             : rsi::hal::BusState::error_active);
                cycle(0U);
                break;
            case 3U:
                for (int left = bytes.one_in(16U) ? cycles_of_a_change : 0; left > 0; --left) {
                    cycle(0U);
                }
                break;
            case 4U:
            case 5U:
                write(bytes);
                break;
            default:
                any(bytes);
                break;
        }
    }

    void send(const std::uint8_t* bytes, std::size_t length) {
        rsi::hal::CanFrame frame;
        frame.identifier = rsi::xcp::default_identifiers.command;
        frame.length = static_cast<std::uint8_t>(length);
        std::copy_n(bytes, length, frame.data.begin());
        bus_.endpoint(1U).send(frame);
    }

    void command(std::initializer_list<std::uint8_t> bytes) {
        send(bytes.begin(), bytes.size());
        cycle(0U);
    }

    // Codes that there are, twice as often as others.
    void any(ByteReader& bytes) {
        std::array<std::uint8_t, 8> data{};
        bytes.take_into(data.data(), data.size());
        const unsigned length = bytes.below(9U);
        if (bytes.one_in(2U)) {
            data[0] = static_cast<std::uint8_t>(0xD3U + data[0] % 45U);
        }
        send(data.data(), (length == 0U) ? data.size() : length);
        if (!bytes.one_in(8U)) {
            cycle(0U);
        }
    }

    // Into the parameters, whole words or parts of them.
    void write(ByteReader& bytes) {
        const std::uint32_t address =
            map::parameters_at + 4U * bytes.below(68U) + (bytes.one_in(8U) ? bytes.below(4U) : 0U);
        command({0xF6, 0, 0, 0, static_cast<std::uint8_t>(address), static_cast<std::uint8_t>(address >> 8U),
                 static_cast<std::uint8_t>(address >> 16U), 0});
        std::array<std::uint8_t, 8> data{0xF0, 4U};
        if (bytes.one_in(4U)) {
            data[1] = static_cast<std::uint8_t>(1U + bytes.below(6U));
        }
        bytes.take_into(&data[2], 6U);
        send(data.data(), 2U + data[1]);
        cycle(0U);
    }

    void unlock() {
        command({0xFF, 0});
        command({0xF8, 0, 1});
        command({0xF8, 1, 1});
        command({0xF8, 1, 1});
        const auto key = static_cast<std::uint8_t>(~random_.calls);
        command({0xF7, 16, key, key, key, key, key, key});
        command({0xF7, 10, key, key, key, key, key, key});
        command({0xF7, 4, key, key, key, key});
        was_unlocked_ = was_unlocked_ || access_.is_unlocked();
    }

    void cycle(std::uint32_t missed) {
        now_ = now_ + rsi::hal::Time::from_milliseconds(10);
        clock_.set(now_);
        ecu_.step(missed);
        ++cycles_;
        unsigned own = 0U;
        unsigned answers = 0U;
        unsigned samples = 0U;
        rsi::hal::CanFrame frame;
        while (bus_.endpoint(1U).receive(frame) == rsi::hal::ReceiveResult::frame) {
            if (frame.identifier != rsi::xcp::default_identifiers.answer) {
                ++own;
            } else {
                require(frame.length >= 1U && frame.length <= 8U, "a packet has one to eight bytes");
                (frame.data[0] >= 0xFEU ? answers : samples) += (frame.data[0] == 0xFDU) ? 0U : 1U;
            }
        }
        const bool on_bus = bus_.endpoint(0U).state() == rsi::hal::BusState::error_active;
        require(own == (on_bus ? frames_of_the_ecu : 0U), "the ECU sends its frames in every cycle");
        require(answers <= 1U, "at most one answer a cycle");
        require(samples <= rsi::xcp::most_parts, "no more samples than parts");
        const rsi::Parameters& used = ecu_.ecu().parameters();
        require(rsi::validate(used).accepted == 1, "the component runs on accepted parameters");
        require(was_unlocked_ || std::memcmp(&used, &start_, sizeof used) == 0,
                "nothing changes without the key");
    }

    rsi::hal::VirtualClock clock_;
    rsi::hal::MemoryBus<2U> bus_{clock_};
    NoWatchdog watchdog_;
    rsi::hal::MemoryStorage<64U> attempts_;
    rsi::hal::MemoryStorage<rsi::application::SectionRecord::length> one_;
    rsi::hal::MemoryStorage<rsi::application::SectionRecord::length> other_;
    rsi::application::SectionRecord stored_{one_, other_};
    PlainKeys keys_;
    CountingRandom random_;
    rsi::access::SeedAndKey access_{keys_, rsi::hal::KeySlot::calibration, random_, attempts_};
    rsi::application::CalibratedEcu ecu_{bus_.endpoint(0U),
                                         clock_,
                                         watchdog_,
                                         access_,
                                         rsi_parameter_section,
                                         rsi::application::section::length,
                                         &stored_};
    rsi::Parameters start_{};
    rsi::hal::Time now_{};
    int cycles_{0};
    bool was_unlocked_{false};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    ByteReader reader{bytes, size};
    Session session;
    session.play(reader);
    return 0;
}
