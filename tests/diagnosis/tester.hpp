// A tester on the bus of an ECU with diagnosis: sends requests, reads answers, and turns the ECU's cycles.
// Its ISO-TP is its own.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "hal/software_keys/software_keys.hpp"
#include "rsi/ecu/access/seed_and_key.hpp"
#include "rsi/ecu/diagnosis/diagnosis.hpp"
#include "rsi/ecu/diagnosis/section_store.hpp"
#include "tests/access/cut_storage.hpp"

namespace testing_diagnosis {

using Bytes = std::vector<std::uint8_t>;
using rsi::diagnosis::Nrc;
using rsi::monitoring::DiagnosticCode;

inline Bytes operator+(Bytes a, const Bytes& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// Other bytes each time.
class CountingRandom final : public rsi::hal::RandomSource {
 public:
    bool fill(std::uint8_t* bytes, std::size_t length) noexcept override {
        ++calls_;
        std::fill_n(bytes, length, static_cast<std::uint8_t>(calls_ & 0xFFU));
        return true;
    }

 private:
    unsigned calls_{0U};
};

// The memories that outlive a loss of power.
struct Memories {
    rsi_test::CutStorage one{};
    rsi_test::CutStorage other{};
    rsi_test::CutStorage section_one{};
    rsi_test::CutStorage section_other{};
    rsi_test::CutStorage attempts{};

    // The places of the trouble codes.
    void refuse(bool refused) {
        one.refuse(refused);
        other.refuse(refused);
    }
};

class Tester {
 public:
    static constexpr std::uint32_t physical = rsi::diagnosis::Addresses{}.physical_request;
    static constexpr std::uint32_t functional = rsi::diagnosis::Addresses{}.functional_request;
    static constexpr std::uint32_t response = rsi::diagnosis::Addresses{}.response;

    explicit Tester(Memories& memories, bool is_new_cycle = true)
        : memories_{memories},
          section_{memories.section_one, memories.section_other},
          store_{section_},
          access_{keys_, rsi::hal::KeySlot::diagnosis, random_, memories.attempts} {
        inputs.speed_mps = 0.0F;
        access_.start();
        static_cast<void>(store_.restore());
        start(is_new_cycle);
    }

    // The ECU starts anew; seed and key, which the platform has, do not.
    void start(bool is_new_cycle) {
        diagnosis_.emplace(bus_.endpoint(0U), rsi::diagnosis::Addresses{}, identification_, memories_.one,
                           memories_.other);
        diagnosis_->use(access_);
        diagnosis_->use(store_);
        diagnosis_->start(is_new_cycle);
    }

    // Parts of the ECU.
    rsi::Inputs inputs{};
    rsi::Outputs outputs{};
    rsi::application::CalibrationIdentity calibration{};
    rsi::monitoring::Snapshot measured{};
    rsi::monitoring::CodeSet tested{0U};  // checks that run in each cycle

    void fail(DiagnosticCode code) { failing_ |= rsi::monitoring::set_of(code); }
    void heal(DiagnosticCode code) { failing_ &= ~rsi::monitoring::set_of(code); }

    void cycle() {
        rsi::hal::CanFrame frame{};
        while (bus_.endpoint(0U).receive(frame) == rsi::hal::ReceiveResult::frame) {
            diagnosis_->listener().take(frame);
        }
        monitoring_.begin_cycle(measured);
        for (std::size_t code = 1U; code < rsi::monitoring::diagnostic_code_count; ++code) {
            monitoring_.report(static_cast<DiagnosticCode>(code), ((failing_ >> code) & 1U) != 0U);
        }
        monitoring_.add_tested(tested);
        diagnosis_->step(monitoring_, inputs, outputs, calibration);
        monitoring_.restart(diagnosis_->cleared_codes());
        clock_.set(clock_.now() + rsi::hal::Time::from_milliseconds(10));
    }
    void cycles(int count) {
        for (int turn = 0; turn < count; ++turn) {
            cycle();
        }
    }

    void send_frame(std::uint32_t identifier, const Bytes& payload) {
        rsi::hal::CanFrame frame{};
        frame.identifier = identifier;
        frame.length = static_cast<std::uint8_t>(payload.size());
        std::copy(payload.begin(), payload.end(), frame.data.begin());
        send_frame(frame);
    }
    void send_frame(const rsi::hal::CanFrame& frame) { bus_.endpoint(1U).send(frame); }
    // The next frame that the ECU has sent; empty: none.
    std::optional<rsi::hal::CanFrame> frame() {
        rsi::hal::CanFrame frame{};
        if (bus_.endpoint(1U).receive(frame) == rsi::hal::ReceiveResult::frame) {
            return frame;
        }
        return std::nullopt;
    }
    Bytes payload() {
        const auto got = frame();
        return got ? Bytes(got->data.begin(), got->data.begin() + got->length) : Bytes{};
    }

    // A whole request, and the whole answer; empty: none came within `cycles`. A "later" is followed to its
    // end.
    Bytes ask(const Bytes& request, int cycles = 12) {
        send(request);
        return receive_final(cycles);
    }
    Bytes receive_final(int cycles) {
        Bytes answer = receive(cycles);
        while (answer.size() == 3U && answer[0] == 0x7FU && answer[2] == 0x78U) {
            ++times_told_later;
            answer = receive(600);
        }
        return answer;
    }
    Bytes ask_functional(const Bytes& request, int cycles = 12) {
        send_frame(functional, Bytes{static_cast<std::uint8_t>(request.size())} + request);
        return receive(cycles);
    }
    int times_told_later{0};

    void send(const Bytes& request) {
        if (request.size() <= 7U) {
            send_frame(physical, Bytes{static_cast<std::uint8_t>(request.size())} + request);
            cycle();
            return;
        }
        const auto length = static_cast<unsigned>(request.size());
        send_frame(physical, Bytes{static_cast<std::uint8_t>(0x10U | (length >> 8U)),
                                   static_cast<std::uint8_t>(length & 0xFFU)} +
                                 Bytes(request.begin(), request.begin() + 6));
        cycle();
        if (payload() != Bytes{0x30U, 0U, 0U, 0xCCU, 0xCCU, 0xCCU, 0xCCU, 0xCCU}) {
            return;  // no room
        }
        unsigned number = 1U;
        for (std::size_t at = 6U; at < request.size(); at += 7U) {
            const std::size_t end = std::min(at + 7U, request.size());
            send_frame(physical, Bytes{static_cast<std::uint8_t>(0x20U | (number & 0x0FU))} +
                                     Bytes(request.begin() + static_cast<std::ptrdiff_t>(at),
                                           request.begin() + static_cast<std::ptrdiff_t>(end)));
            ++number;
        }
        cycle();
    }

    Bytes receive(int cycles) {
        Bytes answer;
        std::size_t length = 0U;
        for (int turn = 0; turn <= cycles; ++turn) {
            while (const auto got = frame()) {
                if (got->identifier != response) {
                    continue;
                }
                const auto& data = got->data;
                const unsigned kind = data[0] >> 4U;
                if (kind == 0U) {
                    return {data.begin() + 1, data.begin() + 1 + data[0]};
                }
                if (kind == 1U) {
                    length = ((data[0] & 0x0FU) << 8U) | data[1];
                    answer.assign(data.begin() + 2, data.begin() + 8);
                    send_frame(physical, {0x30U, 0U, 0U});
                } else if (kind == 2U) {
                    answer.insert(answer.end(), data.begin() + 1, data.begin() + 8);
                }
                if ((length != 0U) && (answer.size() >= length)) {
                    answer.resize(length);
                    return answer;
                }
            }
            cycle();
        }
        return {};
    }

    // Programming or extended session, unlocked with the test key.
    void unlock(std::uint8_t session = 0x03U) {
        ask({0x10U, session});
        const Bytes seed = ask({0x27U, 0x01U});
        if (seed.size() == 18U) {
            ask(Bytes{0x27U, 0x02U} + key_of(seed));
        }
    }
    // The key that belongs to the answer to a request of a seed.
    static Bytes key_of(const Bytes& seed_answer) {
        rsi::hal::SoftwareKeys keys{rsi::hal::test_keys};
        rsi::hal::AuthenticationCode code{};
        keys.authenticate(rsi::hal::KeySlot::diagnosis, seed_answer.data() + 2, 16U, code);
        return {code.begin(), code.end()};
    }

    rsi::diagnosis::Diagnosis& diagnosis() { return *diagnosis_; }
    rsi::diagnosis::SectionStore& store() { return store_; }
    Memories& memories() { return memories_; }
    const rsi::monitoring::DiagnosticMemory& monitoring() const { return monitoring_; }
    void set_bus_state(rsi::hal::BusState state) { bus_.endpoint(0U).set_state(state); }

 private:
    Memories& memories_;
    rsi::hal::VirtualClock clock_{};
    rsi::hal::MemoryBus<2U> bus_{clock_};
    rsi::hal::SoftwareKeys keys_{rsi::hal::test_keys};
    CountingRandom random_{};
    rsi::application::SectionRecord section_;
    rsi::diagnosis::SectionStore store_;
    rsi::access::SeedAndKey access_;
    rsi::diagnosis::Identification identification_{
        rsi::diagnosis::text_of<rsi::diagnosis::ShortText>("Rollover warning"),
        rsi::diagnosis::text_of<rsi::diagnosis::ShortText>("0.2.0"),
        rsi::diagnosis::text_of<rsi::diagnosis::LongText>("large_suv"),
        rsi::diagnosis::text_of<rsi::diagnosis::ShortText>("none"),
        rsi::diagnosis::text_of<rsi::diagnosis::ShortText>("4711")};
    std::optional<rsi::diagnosis::Diagnosis> diagnosis_;
    rsi::monitoring::DiagnosticMemory monitoring_{};
    rsi::monitoring::CodeSet failing_{0U};
};

// A negative answer.
inline Bytes no(std::uint8_t service, unsigned code) {
    return {0x7FU, service, static_cast<std::uint8_t>(code)};
}

}  // namespace testing_diagnosis
