// Bench of XCP: the ECU with its sensors, and a master that may say anything, on one bus in simulated time.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/memory_storage.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "hal/software_keys/software_keys.hpp"
#include "rsi/ecu/application/calibrated_ecu.hpp"
#include "tests/access/cut_storage.hpp"
#include "tests/application/bench.hpp"

extern "C" const unsigned char rsi_parameter_section[rsi::application::section::length];

namespace testing_xcp {

using Bytes = std::vector<std::uint8_t>;
namespace map = rsi::application::calibration_map;

// Those of the image's section.
inline rsi::Parameters image_parameters() {
    return rsi::application::section::values_of(rsi_parameter_section);
}

// Other numbers each time.
class CountingRandom final : public rsi::hal::RandomSource {
 public:
    bool fill(std::uint8_t* bytes, std::size_t length) noexcept override;
    bool is_empty{false};

 private:
    std::uint8_t calls_{0U};
};

class Bench {
 public:
    Bench() { restart(); }

    // Power off and on again: what is stored stays.
    void restart();

    // 10 ms: the sensors, the ECU; what it sends lies in `answers`, `samples` and `others` of this cycle.
    void cycle(std::uint32_t missed_cycles = 0U);
    void cycles(int count);

    // A command and the cycle in which it is answered; empty: not at all.
    Bytes command(const Bytes& bytes);
    void send(const rsi::hal::CanFrame& frame) { bus_.endpoint(2U).send(frame); }

    Bytes connect() { return command({0xFF, 0x00}); }
    // The answer to the last piece of the key. Without an unlocked slave: wrong by one bit.
    Bytes unlock(bool with_good_key = true);
    void connect_and_unlock();

    // True: each piece of it was answered with "good".
    bool set_address(std::uint32_t address) { return is_good(command(with_word({0xF6, 0, 0, 0}, address))); }
    Bytes download(std::uint32_t address, const Bytes& bytes);
    Bytes upload(std::uint32_t address, std::uint8_t count);  // without the code before it
    std::uint32_t word(std::uint32_t address);
    bool write_float(const char* field, float value);
    float read_float(const char* field);

    // As the status block has them.
    std::uint8_t refused_field() { return upload(map::change_at + 2U, 1U).at(0U); }
    std::uint32_t changes() { return word(map::change_at + 4U); }

    static bool is_good(const Bytes& answer) { return !answer.empty() && answer[0] == 0xFFU; }
    static Bytes with_word(Bytes bytes, std::uint32_t word);

    const rsi::Parameters& used() { return ecu_->ecu().parameters(); }
    rsi::application::CalibratedEcu& ecu() { return *ecu_; }

    std::vector<Bytes> answers;  // answers, errors, events
    std::vector<Bytes> samples;
    std::vector<rsi::hal::CanFrame> others;  // of the ECU
    rsi::ParameterField field_of(const char* name) const;
    static std::uint32_t address_of(const char* name);

    CountingRandom random;
    bool has_memory{true};  // to store in, from the next restart on
    rsi_test::CutStorage one;
    rsi_test::CutStorage other;
    rsi::hal::MemoryBus<3U>::Endpoint& ecu_bus() { return bus_.endpoint(0U); }
    Bytes reference{rsi_parameter_section, rsi_parameter_section + rsi::application::section::length};

 private:
    rsi::hal::VirtualClock clock_;
    rsi::hal::MemoryBus<3U> bus_{clock_};
    testing_application::NoWatchdog watchdog_;
    rsi::hal::MemoryStorage<64U> attempts_;
    rsi::hal::SoftwareKeys keys_{rsi::hal::test_keys};
    std::optional<rsi::application::SectionRecord> stored_;
    std::optional<rsi::access::SeedAndKey> access_;
    std::optional<rsi::application::CalibratedEcu> ecu_;
    unsigned counter_{0U};
    rsi::hal::Time now_{};
};

}  // namespace testing_xcp
