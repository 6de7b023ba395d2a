#include "sil/page/summary_facts.hpp"

#include <fmt/format.h>

#include <optional>

#include "sil/units.hpp"

namespace sil {
namespace {

std::string moment_text(const std::optional<EventMoment>& moment) {
    return moment ? fmt::format("{:.3f} s, {:+.3f} g", moment->time_s,
                                moment->lateral_acceleration_mps2 / g_mps2)
                  : std::string{"did not happen"};
}

std::string lead_text(const WarningJudgement& judgement) {
    return judgement.lead_s ? fmt::format("{:.3f} s", *judgement.lead_s) : std::string{"none"};
}

}  // namespace

const char* pace_name(bool in_process, bool lock_step) {
    return in_process ? "in one process with the ECU"
                      : (lock_step ? "in lock-step with the ECU" : "in real time");
}

std::vector<std::pair<std::string, std::string>> summary_facts(const Summary& summary) {
    const RunEvents& events = summary.events;
    return {
        {"First warning", moment_text(events.warning)},
        {"One-wheel lift-off", moment_text(events.one_wheel_lift)},
        {"Two-wheel lift-off", moment_text(events.two_wheel_lift)},
        {"SSF crossing", moment_text(events.ssf_crossing)},
        {"Lead time", lead_text(events.judgement)},
        {"Largest |LTR|", fmt::format("{:.3f}", events.judgement.largest_load_transfer_ratio)},
        {"Largest |a_y|", fmt::format("{:.3f} g", events.largest_lateral_acceleration_mps2 / g_mps2)},
        {"Final roll angle", fmt::format("{:+.2f} deg", events.final_roll_angle_rad * degrees_per_radian)},
        {"Sensors",
         summary.noise == "none" ? "without noise" : fmt::format("with noise, seed {}", summary.seed)},
        {"Frames sent, received", fmt::format("{}, {}", summary.frames_sent, summary.frames_received)},
        {"Component", fmt::format("{} {}", summary.versions.component, summary.versions.git_revision)},
    };
}

}  // namespace sil
