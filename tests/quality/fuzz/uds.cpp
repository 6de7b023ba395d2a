// The UDS server and what it keeps, over any requests, faults, cycles, refusing memories and starts from new:
// an answer is one that the standard knows, and without the key nothing is cleared, written or downloaded.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "tests/diagnosis/tester.hpp"
#include "tests/quality/fuzz/support/byte_reader.hpp"
#include "tests/quality/fuzz/support/require.hpp"

namespace {

using fuzz::ByteReader;
using fuzz::require;
using testing_diagnosis::Bytes;
using testing_diagnosis::Tester;
using testing_diagnosis::operator+;

constexpr std::array<std::uint8_t, 16> services{0x10U, 0x11U, 0x14U, 0x19U, 0x22U, 0x27U, 0x28U, 0x2EU,
                                                0x31U, 0x34U, 0x36U, 0x37U, 0x3EU, 0x85U, 0x29U, 0x00U};

bool is_known(std::uint8_t code) {
    constexpr std::array<std::uint8_t, 17> codes{0x11U, 0x12U, 0x13U, 0x14U, 0x22U, 0x24U,
                                                 0x31U, 0x33U, 0x35U, 0x36U, 0x37U, 0x70U,
                                                 0x71U, 0x72U, 0x73U, 0x78U, 0x7FU};
    return std::find(codes.begin(), codes.end(), code) != codes.end();
}

bool needs_the_key(std::uint8_t service) {
    return service == 0x14U || service == 0x2EU || service == 0x34U || service == 0x36U || service == 0x37U;
}

class Drive {
 public:
    explicit Drive(ByteReader& reader) : reader_{reader} { tester_.emplace(memories_); }

    void turn() {
        switch (reader_.below(16U)) {
            case 0U:
                tester_->cycles(1 + static_cast<int>(reader_.below(32U)));
                break;
            case 1U:
                tester_->fail(code());
                break;
            case 2U:
                tester_->heal(code());
                break;
            case 3U:
                tester_->inputs.speed_mps = reader_.take<float>();
                tester_->measured.roll_rate_radps = reader_.take<float>();
                break;
            case 4U:
                memories_.one.refuse(reader_.one_in(2U));
                memories_.section_one.refuse(reader_.one_in(2U));
                memories_.section_other.refuse(reader_.one_in(2U));
                break;
            case 5U:
                start_anew();
                break;
            case 6U:
                if (reader_.one_in(4U)) {
                    tester_->unlock(static_cast<std::uint8_t>(2U + reader_.below(2U)));
                    has_used_the_key_ = true;
                }
                break;
            case 7U:
                tester_->send_frame(Tester::physical, payload(8U));
                tester_->cycle();
                break;
            default:
                ask();
                break;
        }
    }

    void end() {
        require(has_used_the_key_ ||
                    (memories_.section_one.record().empty() && memories_.section_other.record().empty()),
                "a section was stored without the key");
    }

 private:
    rsi::monitoring::DiagnosticCode code() {
        return static_cast<rsi::monitoring::DiagnosticCode>(
            1U + reader_.below(rsi::diagnosis::trouble_code_count));
    }
    Bytes payload(std::size_t length) {
        Bytes bytes(length);
        reader_.take_into(bytes.data(), length);
        return bytes;
    }
    void start_anew() {
        tester_.reset();
        tester_.emplace(memories_, reader_.one_in(2U));
    }
    void ask() {
        const std::uint8_t service = services[reader_.below(services.size())];
        const bool is_functional = reader_.one_in(8U);
        const std::size_t length = reader_.one_in(8U) ? reader_.below(140U) : reader_.below(7U);
        const Bytes request =
            Bytes{service} + payload(is_functional ? std::min(length, std::size_t{6U}) : length);
        const Bytes answer = is_functional ? tester_->ask_functional(request, 3) : tester_->ask(request, 3);
        if (answer.empty() || tester_->times_told_later != 0) {
            tester_->times_told_later = 0;
            return;
        }
        if (answer[0] == 0x7FU) {
            require(answer.size() == 3U && is_known(answer[2]), "a negative answer");
        } else {
            require(has_used_the_key_ || !needs_the_key(static_cast<std::uint8_t>(answer[0] - 0x40U)),
                    "a service without the key");
        }
    }

    ByteReader& reader_;
    testing_diagnosis::Memories memories_{};
    std::optional<Tester> tester_;
    bool has_used_the_key_{false};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    ByteReader reader{bytes, size};
    Drive drive{reader};
    for (int turns = 0; turns < 200 && !reader.empty(); ++turns) {
        drive.turn();
    }
    drive.end();
    return 0;
}
