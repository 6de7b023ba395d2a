// ConsoleSummary: the readable live report of a run.
#pragma once

#include "sil/simulation/closed_loop.hpp"

namespace sil {

// Prints a line each half second of simulated time and a line for each event, when it happens.
class ConsoleSummary {
 public:
    // `pace` in words: "in real time".
    void begin(const Manoeuvre& manoeuvre, const RunOptions& options, const char* pace, double duration_s);
    void cycle(const Truth& truth, const EcuFrames& ecu, const RunEvents& events, double duration_s);
    void end(const RunEvents& events, const EcuFrames& ecu, std::uint64_t frames_sent,
             std::uint64_t missed_cycles);

 private:
    void report_state(const Truth& truth, const EcuOutput& output);
    void report_events(const RunEvents& events);
    void report_diagnostics(const Truth& truth, const rsi::can_dbc::RolloverStatus& status);

    double next_line_s_{0.0};
    WarningState state_{WarningState::unavailable};
    WarningSide side_{WarningSide::none};
    bool one_wheel_reported_{false};
    bool two_wheel_reported_{false};
    bool ssf_reported_{false};
    rsi::can_dbc::RolloverStatus reported_status_{};
};

}  // namespace sil
