// Diagnostic memory: one event for each code, with the measurements at its first confirmation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/ecu/monitoring/diagnostic_code.hpp"
#include "rsi/ecu/monitoring/diagnostic_event.hpp"
#include "rsi/numeric/bounded.hpp"

namespace rsi::monitoring {

// Received values before plausibility checks; NaN if not available.
struct Snapshot {
    float lateral_acceleration_mps2{rsi::not_available};
    float roll_rate_radps{rsi::not_available};
    float roll_angle_rad{rsi::not_available};
    float speed_mps{rsi::not_available};
};

// An entry as it is reported.
struct DiagnosticRecord {
    DiagnosticCode code{DiagnosticCode::none};
    EventStatus status{EventStatus::none};
    std::uint8_t occurrences{0U};
    Snapshot first{};
};

class DiagnosticMemory {
 public:
    // Snapshot for the entries confirmed in this cycle.
    void begin_cycle(const Snapshot& snapshot) noexcept {
        snapshot_ = snapshot;
        tested_ = 0U;
    }
    const Snapshot& snapshot() const noexcept { return snapshot_; }

    // One cycle in which the code's condition could be judged; without a report the code keeps its status.
    // Nearly every report is a passed one of an inactive code, so that path is kept cheap.
    void report(DiagnosticCode code, bool failed) noexcept {
        if (failed || !entries_[index_of(code)].event.is_inactive()) {
            update(code, failed, debounce_of(code));
        }
    }

    // The code's condition has been debounced elsewhere.
    void confirm(DiagnosticCode code) noexcept { update(code, true, {1U, debounce_of(code).heal}); }

    // Checks that have run in this cycle under their enable condition, so that they would have seen the
    // fault. For such a code that is not active the cycle is a good test (ISO 14229-1), reported or not.
    void add_tested(CodeSet codes) noexcept { tested_ |= codes; }
    CodeSet tested_codes() const noexcept { return tested_; }

    // DTC fault detection counter of ISO 14229-1: 1 to 126 while the debounce count of the code runs, 127
    // while it is confirmed, else 0.
    std::uint8_t fault_detection_counter(DiagnosticCode code) const noexcept;

    // Debounce counts of these codes that are not confirmed begin anew.
    void restart(CodeSet codes) noexcept;

    // No code is set or confirmed, so a passed cycle of any code would change nothing.
    bool no_active_codes() const noexcept { return active_ == 0U; }
    CodeSet active_codes() const noexcept { return active_; }
    CodeSet confirmed_codes() const noexcept { return confirmed_; }
    bool active(DiagnosticCode code) const noexcept { return !entries_[index_of(code)].event.is_inactive(); }
    EventStatus status(DiagnosticCode code) const noexcept { return entries_[index_of(code)].event.status(); }
    bool confirmed(DiagnosticCode code) const noexcept { return entries_[index_of(code)].event.confirmed(); }

    // Entry to send in this cycle: a code confirmed since the last call has priority; else the codes whose
    // status is not `none` take turns (round robin); code `none` if there are none.
    DiagnosticRecord next() noexcept;

 private:
    struct Entry {
        DiagnosticEvent event{};
        Snapshot first{};
    };

    void update(DiagnosticCode code, bool failed, const Debounce& debounce) noexcept;
    std::size_t next_to_report() noexcept;
    std::size_t next_of(CodeSet codes) const noexcept;

    static constexpr std::size_t index_of(DiagnosticCode code) noexcept {
        return static_cast<std::size_t>(code);
    }

    std::array<Entry, diagnostic_code_count> entries_{};  // that of `none` stays empty
    Snapshot snapshot_{};
    std::size_t last_reported_{0U};
    CodeSet active_{0U};  // set or confirmed
    CodeSet confirmed_{0U};
    CodeSet seen_{0U};        // status other than `none`
    CodeSet unreported_{0U};  // confirmed, and not yet reported
    CodeSet tested_{0U};      // in this cycle
};

}  // namespace rsi::monitoring
