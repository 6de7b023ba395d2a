// Diagnostic codes: those that the ECU's frames have reported.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/ecu/monitoring/diagnostic_code.hpp"

namespace sil {

// Sets of diagnostic codes, one bit for each.
struct CodeSets {
    std::uint64_t set{0U};  // the fault is there, or not yet gone for long enough; confirmed ones included
    std::uint64_t confirmed{0U};
};

inline bool operator==(const CodeSets& one, const CodeSets& other) {
    return one.set == other.set && one.confirmed == other.confirmed;
}

// "imu lost", "speed stuck".
std::vector<std::string> list_of_codes(std::uint64_t codes);

// "imu lost; speed stuck"; empty without codes.
std::string code_names(std::uint64_t codes);

// The frames report one code a cycle, in turn: one that is no longer reported is gone.
class CodeListener {
 public:
    // Once a cycle.
    void take(const rsi::can_dbc::RolloverDiagnosis& diagnosis);

    CodeSets codes() const;

 private:
    static constexpr std::size_t code_count = rsi::monitoring::diagnostic_code_count;
    static_assert(code_count <= 64U, "a set of codes has 64 bits");

    struct Reported {
        std::size_t at{0U};
        bool set{false};
        bool confirmed{false};
    };
    std::array<Reported, code_count> reported_{};
    std::size_t now_{0U};
};

}  // namespace sil
