// Summary: from a run's events to JSON.
#include "sil/results/summary.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "sil/files/file_io.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

using Json = nlohmann::ordered_json;

// Floating-point sums leave 2.0520000000000005 where 2.052 is meant; a nanounit is enough.
Json number(double value) {
    if (!std::isfinite(value)) {
        return nullptr;
    }
    const double rounded = std::round(value * 1e9) / 1e9;
    return rounded == 0.0 ? 0.0 : rounded;  // no "-0.0"
}

Json number(const std::optional<double>& value) {
    return value ? number(*value) : Json(nullptr);
}

Json time_of(const std::optional<EventMoment>& event) {
    return event ? number(event->time_s) : Json(nullptr);
}

Json side(WarningSide side) {
    return side == WarningSide::none ? Json(nullptr) : Json(to_string(side));
}

void add_judgement(Json& json, const WarningJudgement& judgement) {
    json["falling_side"] = side(judgement.falling_side);
    json["side_at_lift_off"] = side(judgement.side_at_lift_off);
    json["wrong_side_duration_s"] = number(judgement.wrong_side_s);
    json["load_transfer_band"] = judgement.lifted ? "lift" : to_string(judgement.band());
    json["warnings"] = judgement.warnings;
    json["advisories"] = judgement.advisories;
    json["warning_duration_s"] = number(judgement.warning_s);
    json["advisory_duration_s"] = number(judgement.advisory_s);
    json["unavailable_duration_s"] = number(judgement.unavailable_s);
}

Json acceleration_of(const std::optional<EventMoment>& event) {
    return event ? number(event->lateral_acceleration_mps2 / g_mps2) : Json(nullptr);
}

Json index_times(const Summary& summary) {
    Json json = nullptr;
    for (const auto& [name, time_s] : summary.index_times_s) {
        json[name] = number(time_s);
    }
    return json;
}

Json json_of(const Versions& versions) {
    Json json;
    json["component"] = versions.component;
    json["git_revision"] = versions.git_revision.empty() ? Json(nullptr) : Json(versions.git_revision);
    json["compiler"] = versions.compiler;
    return json;
}

}  // namespace

std::string summary_json(const Summary& summary) {
    const RunEvents& events = summary.events;
    Json json;
    json["manoeuvre"] = summary.manoeuvre;
    json["vehicle"] = summary.vehicle;
    json["mirrored"] = summary.mirrored;
    json["lock_step"] = summary.lock_step;
    json["seed"] = summary.seed;
    json["noise"] = summary.noise;
    json["bias_g"] = summary.bias_g;
    json["quantisation_g"] = summary.quantisation_g;
    json["versions"] = json_of(summary.versions);
    json["warning_time_s"] = time_of(events.warning);
    json["warning_side"] = side(events.warning_side);
    json["warning_ay_g"] = acceleration_of(events.warning);
    json["one_wheel_lift_time_s"] = time_of(events.one_wheel_lift);
    json["two_wheel_lift_time_s"] = time_of(events.two_wheel_lift);
    json["ssf_crossing_time_s"] = time_of(events.ssf_crossing);
    json["lead_time_s"] = number(events.judgement.lead_s);
    json["max_ay_g"] = number(events.largest_lateral_acceleration_mps2 / g_mps2);
    json["final_roll_deg"] = number(events.final_roll_angle_rad * degrees_per_radian);
    json["frames_sent"] = summary.frames_sent;
    json["frames_received"] = summary.frames_received;
    json["in_process"] = summary.in_process;
    json["front_axle_lift_time_s"] = time_of(events.front_axle_lift);
    json["rear_axle_lift_time_s"] = time_of(events.rear_axle_lift);
    json["max_load_transfer_ratio"] = number(events.judgement.largest_load_transfer_ratio);
    json["index_times_s"] = index_times(summary);
    add_judgement(json, events.judgement);
    // Names come from the command line: bytes that are not UTF-8 are replaced and never thrown about.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_summary(const Summary& summary, const std::filesystem::path& path) {
    write_file_atomically(path, summary_json(summary));
}

}  // namespace sil
