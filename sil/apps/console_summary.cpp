#include "sil/apps/console_summary.hpp"
#include "sil/units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <type_traits>

namespace sil {
namespace {

constexpr double line_interval_s = 0.5;

void print_line(const std::string& line) {
    std::fputs((line + "\n").c_str(), stdout);
    std::fflush(stdout);
}

std::string optional_number(double value, const char* format) {
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : std::string{"-"};
}

void print_event(double time_s, const std::string& what) {
    print_line(fmt::format("{:7.3f} s  >> {}", time_s, what));
}

void tell_once(bool& reported, const std::optional<EventMoment>& moment, const char* what) {
    if (moment && !reported) {
        reported = true;
        print_event(moment->time_s, fmt::format("{} at {:+.3f} g, roll {:+.2f} deg", what,
                                                moment->lateral_acceleration_mps2 / g_mps2,
                                                moment->roll_angle_rad * degrees_per_radian));
    }
}

std::string moment_line(const char* what, const std::optional<EventMoment>& moment) {
    if (!moment) {
        return fmt::format("  {:<22} did not happen", what);
    }
    return fmt::format("  {:<22} {:7.3f} s  at {:+.3f} g", what, moment->time_s,
                       moment->lateral_acceleration_mps2 / g_mps2);
}

std::string lead_text(const WarningJudgement& judgement) {
    if (!judgement.lifted) {
        return "none: no two wheels of a side have lifted";
    }
    const char* falling = to_string(judgement.falling_side);
    if (judgement.lead_s) {
        return fmt::format("{:7.3f} s before two-wheel lift-off, {} side", *judgement.lead_s, falling);
    }
    const char* named = to_string(judgement.side_at_lift_off);
    if (judgement.side_at_lift_off != WarningSide::none) {
        return fmt::format("none: the warning names the {} side, the vehicle falls to the {}", named,
                           falling);
    }
    return fmt::format("none: no warning when the vehicle falls to the {}{}", falling,
                       judgement.late ? ", one after it" : "");
}

std::string load_transfer_text(const WarningJudgement& judgement) {
    return fmt::format("{:7.3f}, {}", judgement.largest_load_transfer_ratio,
                       judgement.lifted ? "two wheels lifted" : to_string(judgement.band()));
}

// Names of the one-bit diagnostic flags that are set.
std::string flags_of(const rsi::can_dbc::RolloverStatus& status) {
    std::string names;
    rsi::can_dbc::RolloverStatus::visit_signals([&](const char* name, const char*, auto member, auto) {
        using Value = std::remove_cv_t<std::remove_reference_t<decltype(status.*member)>>;
        if constexpr (std::is_same_v<Value, bool>) {
            if (status.*member) {
                names += (names.empty() ? "" : " ") + std::string{name};
            }
        }
    });
    return names;
}

}  // namespace

void ConsoleSummary::begin(const Manoeuvre& manoeuvre, const RunOptions& options, const char* pace,
                           double duration_s) {
    print_line(fmt::format("{}{}: {}", manoeuvre.name, options.mirrored ? " (mirrored)" : "",
                           manoeuvre.description));
    print_line(fmt::format("{:.0f} s of simulated time, {}", duration_s, pace));
}

void ConsoleSummary::cycle(const Truth& truth, const EcuFrames& ecu, const RunEvents& events,
                           double duration_s) {
    if (truth.time_s >= next_line_s_ - 1.0e-6) {
        next_line_s_ += line_interval_s;
        const EcuOutput& output = ecu.output();
        print_line(
            fmt::format("{:7.2f} s  {:3.0f} %  {:5.1f} km/h  steer {:+6.0f} deg  a_y {:+.3f} g  roll "
                        "{:+6.2f} deg  level {:>5}  {}",
                        truth.time_s, 100.0 * truth.time_s / duration_s, truth.speed_mps * 3.6,
                        truth.steering_wheel_angle_rad * degrees_per_radian,
                        truth.lateral_acceleration_mps2 / g_mps2, truth.roll_angle_rad * degrees_per_radian,
                        optional_number(static_cast<double>(output.warning().warning_level), "{:.3f}"),
                        to_string(output.state())));
    }
    report_state(truth, ecu.output());
    report_events(events);
    report_diagnostics(truth, ecu.status());
}

void ConsoleSummary::report_state(const Truth& truth, const EcuOutput& output) {
    if (output.state() == state_ && output.side() == side_) {
        return;
    }
    state_ = output.state();
    side_ = output.side();
    const std::string side =
        output.side() == WarningSide::none ? "" : fmt::format(", {} side", to_string(output.side()));
    print_event(truth.time_s, fmt::format("ECU: {}{}", to_string(output.state()), side));
}

void ConsoleSummary::report_events(const RunEvents& events) {
    tell_once(one_wheel_reported_, events.one_wheel_lift, "one wheel lifts");
    tell_once(two_wheel_reported_, events.two_wheel_lift, "two wheels of one side have lifted");
    tell_once(ssf_reported_, events.ssf_crossing, "static stability factor crossed");
}

void ConsoleSummary::report_diagnostics(const Truth& truth, const rsi::can_dbc::RolloverStatus& status) {
    const std::string flags = flags_of(status);
    if (flags != flags_of(reported_status_)) {
        print_event(truth.time_s,
                    flags.empty() ? "ECU: no diagnostic flags" : "ECU diagnostic flags: " + flags);
    }
    reported_status_ = status;
}

void ConsoleSummary::end(const RunEvents& events, const EcuFrames& ecu, std::uint64_t frames_sent,
                         std::uint64_t missed_cycles) {
    print_line("");
    print_line(moment_line("first warning", events.warning) +
               (events.warning ? fmt::format(", {} side", to_string(events.warning_side)) : ""));
    print_line(moment_line("one-wheel lift-off", events.one_wheel_lift));
    print_line(moment_line("two-wheel lift-off", events.two_wheel_lift));
    print_line(moment_line("SSF crossing", events.ssf_crossing));
    print_line(fmt::format("  {:<22} {}", "lead time", lead_text(events.judgement)));
    print_line(fmt::format("  {:<22} {:7.3f} s", "on the wrong side", events.judgement.wrong_side_s));
    print_line(fmt::format("  {:<22} {}", "largest |LTR|", load_transfer_text(events.judgement)));
    print_line(fmt::format("  {:<22} {:.3f} g; final roll {:+.2f} deg", "largest |a_y|",
                           events.largest_lateral_acceleration_mps2 / g_mps2,
                           events.final_roll_angle_rad * degrees_per_radian));
    print_line(fmt::format("  {:<22} {} sensor frames sent, {} ECU frames received, {} refused", "bus",
                           frames_sent, ecu.frames_received(), ecu.frames_refused()));
    if (missed_cycles > 0U) {
        print_line(fmt::format(
            "  {:<22} {} cycles of the world came late: this machine was busy, so times on the bus "
            "are less exact",
            "real time", missed_cycles));
    }
}

}  // namespace sil
