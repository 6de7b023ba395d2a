// Trouble memory: status byte, counters and snapshots of each DTC (ISO 14229-1), kept over operation cycles
// and losses of power.
//
// The monitoring (monitoring/diagnostic_memory.hpp) decides when a code has failed and when it is good again,
// and says which checks could have found a fault; a code that it has confirmed is a failed test here. The
// monitoring starts afresh with the ECU; this memory is stored.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/ecu/diagnosis/trouble_codes.hpp"
#include "rsi/ecu/monitoring/diagnostic_memory.hpp"
#include "rsi/hal/saturating_count.hpp"

namespace rsi::diagnosis {

// The status byte of ISO 14229-1.
namespace status {
inline constexpr std::uint8_t test_failed = 0x01U;
inline constexpr std::uint8_t failed_this_cycle = 0x02U;
inline constexpr std::uint8_t pending = 0x04U;
inline constexpr std::uint8_t confirmed = 0x08U;
inline constexpr std::uint8_t not_completed_since_clear = 0x10U;
inline constexpr std::uint8_t failed_since_clear = 0x20U;
inline constexpr std::uint8_t not_completed_this_cycle = 0x40U;
// DTCStatusAvailabilityMask. Bit 7, warningIndicatorRequested, is not available: this control unit requests
// no indicator for a code.
inline constexpr std::uint8_t available = 0x7FU;
inline constexpr std::uint8_t failure = 0x2FU;  // bits set by a failed test
inline constexpr std::uint8_t cleared = 0x50U;  // not completed, neither way
}  // namespace status

// Data of one snapshot: measurements at a code's failure, as stored and sent, big-endian numbers of two
// bytes.
//   0  lateral acceleration, 0.01 m/s2        4  roll angle, 0.001 rad
//   2  roll rate, 0.001 rad/s                 6  speed, 0.01 m/s
//   8  seconds since the start, unsigned, saturating at 65535; the control unit has no clock of the day
// 0x8000: not available. Then numbers of four bytes:
//   10 operation cycle, counted since the memory was new
//   14 checksum of the calibration in use, as F1A0 has it
using FreezeFrame = std::array<std::uint8_t, 18>;

using CycleCount = std::array<std::uint8_t, 4>;  // big-endian

struct TroubleState {
    std::uint8_t status{status::cleared};
    std::uint8_t occurrences{0U};  // since it was cleared, saturating at 255
    std::uint8_t ageing{0U};       // operation cycles in which it was tested and never failed
};

struct TroubleSnapshots {
    std::uint8_t code{0U};  // number of the diagnostic code; 0: free
    FreezeFrame first{};
    FreezeFrame last{};
};

// Findings of the monitoring in one cycle.
struct Findings {
    monitoring::CodeSet failed;  // confirmed
    monitoring::CodeSet active;  // these, and those that are about to be
    monitoring::CodeSet tested;  // checks that have run under their enable condition
};

// Urgency of a change that is not stored yet.
enum class Storing : std::uint8_t { not_needed, later, now };

class TroubleMemory {
 public:
    static constexpr std::size_t snapshot_places = 8U;
    static constexpr std::uint8_t most_resets = 20U;
    static constexpr std::uint8_t ageing_cycles = 40U;  // a confirmed code is forgotten after so many

    // Before the first cycle, after what was stored has been restored. `is_new_cycle`: an operation cycle
    // begins, so the one before is counted; false after a reset within one.
    void start(bool is_new_cycle) noexcept;

    // One cycle. `checksum`: that of the calibration in use.
    void update(const Findings& found, const monitoring::Snapshot& measured,
                std::uint32_t checksum) noexcept {
        hal::count_up(cycles_);
        cleared_ = 0U;
        if (!is_recording_) {
            return;
        }
        if (found.failed != failed_) {
            take_change(found.failed, measured, checksum);
        }
        if (((found.tested | found.active) & untested_) != 0U) {
            count_tests(found);
        }
    }

    // Off: nothing is recorded (ControlDTCSetting). A code that still fails when it is on again is recorded
    // then.
    void set_recording(bool is_on) noexcept { is_recording_ = is_on; }

    void clear_all() noexcept;
    void clear(std::size_t row) noexcept;
    // Codes cleared since the last cycle. The monitoring is to debounce them anew.
    monitoring::CodeSet cleared_codes() const noexcept { return cleared_; }

    // Operation cycles since the memory was new, with the present one.
    const CycleCount& operation_cycles() const noexcept { return data_.operation_cycles; }

    // By the rows of trouble_codes.
    const TroubleState& state(std::size_t row) const noexcept { return data_.states[row]; }
    // nullptr where there is none: never failed, or displaced by newer ones.
    const TroubleSnapshots* snapshots(std::size_t row) const noexcept;

    // Limit of the resets by testers in an operation cycle, because each start has its other limits anew.
    bool takes_reset() const noexcept { return data_.states[resets_at].occurrences < most_resets; }
    void count_reset() noexcept {
        ++data_.states[resets_at].occurrences;
        request_storing(Storing::now);
    }

    Storing storing() const noexcept { return storing_; }
    void request_storing(Storing how) noexcept { storing_ = (how > storing_) ? how : storing_; }
    void stored() noexcept { storing_ = Storing::not_needed; }

    // Stored form: bytes without gaps, the same on every target. With room for all codes that a CodeSet can
    // hold but the last, so that software with another one more reads what this one has stored.
    static constexpr std::size_t most_codes = 63U;
    static_assert(trouble_code_count < most_codes);
    struct Stored {
        std::array<TroubleState, most_codes> states{};
        std::array<TroubleSnapshots, snapshot_places> snapshots{};
        CycleCount operation_cycles{};
    };
    static_assert(sizeof(Stored) == 3U * most_codes + 37U * snapshot_places + 4U);

    const Stored& stored_data() const noexcept { return data_; }
    // Accepts any content: unknown codes are left out.
    [[gnu::cold]] void restore(const Stored& stored) noexcept;

 private:
    // The last state is of no code: its occurrences are the resets by testers in this operation cycle.
    static constexpr std::size_t resets_at = most_codes - 1U;

    void count_operation_cycle() noexcept;
    void count_cycle(TroubleState& state, std::size_t row) noexcept;
    void take_change(monitoring::CodeSet failed, const monitoring::Snapshot& measured,
                     std::uint32_t checksum) noexcept;
    void fail(std::size_t row) noexcept;
    void count_tests(const Findings& found) noexcept;
    [[gnu::cold]] void begin_tests(monitoring::CodeSet codes) noexcept;
    void begin_test(std::size_t row) noexcept;
    [[gnu::cold]] void complete(monitoring::CodeSet codes) noexcept;
    void keep_snapshot(std::size_t row) noexcept;
    TroubleSnapshots* place_for(std::size_t row) noexcept;
    void forget_snapshots(std::size_t row) noexcept;

    Stored data_{};
    FreezeFrame measured_{};          // in this cycle
    monitoring::CodeSet failed_{0U};  // in the cycle before
    monitoring::CodeSet cleared_{0U};
    std::uint32_t cycles_{0U};  // since the start
    // Codes whose test is not completed since the start or a clear, and for each how many good tests in a row
    // it has had: bit n of its number is in the set n, so that all are counted at once. The number begins so
    // that it overflows after as many as heal a code.
    monitoring::CodeSet untested_{0U};
    std::array<monitoring::CodeSet, 9> good_tests_{};
    monitoring::CodeSet active_{0U};  // when they were last counted
    bool is_recording_{true};
    Storing storing_{Storing::not_needed};
};

}  // namespace rsi::diagnosis
