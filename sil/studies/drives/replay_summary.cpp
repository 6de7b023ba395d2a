#include "sil/studies/drives/replay_summary.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "rsi/parameters.hpp"
#include "sil/results/summary.hpp"
#include "sil/studies/drives/verdict.hpp"

namespace sil {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    return std::isfinite(value) ? Json(std::round(value * 1.0e9) / 1.0e9) : Json(nullptr);
}

Json one_wheel_lead(const RunEvents& events) {
    return events.warning && events.one_wheel_lift
               ? number(events.one_wheel_lift->time_s - events.warning->time_s)
               : Json(nullptr);
}

std::string indicator_name(const rsi::Parameters& parameters) {
    return rsi::indicator_choices.at(static_cast<std::size_t>(parameters.warning_indicator));
}

Json as_of_a_run(const ReplaySource& source, const DriveReplay& replay) {
    Summary summary;
    summary.manoeuvre = source.drive;
    summary.vehicle = source.parameters;
    summary.versions = built_versions();
    summary.events = replay.events;
    summary.frames_sent = replay.frames_sent;
    summary.frames_received = replay.frames_received;
    Json json = Json::parse(summary_json(summary));
    for (const char* unknown :
         {"mirrored", "lock_step", "in_process", "seed", "noise", "bias_g", "quantisation_g"}) {
        json[unknown] = nullptr;
    }
    return json;
}

}  // namespace

std::string replay_summary_json(const ReplaySource& source, const DriveReplay& replay,
                                const rsi::Parameters& parameters) {
    Json json = as_of_a_run(source, replay);
    json["file"] = source.file;
    json["kind"] = source.kind;
    json["verdict"] = to_string(verdict(replay));
    json["lift_off_source"] = to_string(replay.lift_off.source);
    json["one_wheel_lead_time_s"] = one_wheel_lead(replay.events);
    json["largest_load_transfer_ratio"] = number(replay.largest_load_transfer_ratio);
    json["largest_warning_level"] = number(replay.largest_warning_level);
    json["warning_indicator"] = indicator_name(parameters);
    json["start_time_s"] = number(replay.cycles.front().sample.time_s);
    json["end_time_s"] = number(replay.events.end_time_s);
    json["cycles"] = replay.cycles.size();
    json["silent_cycles"] = replay.silent_cycles;
    json["confirmed_codes"] = Json::array();
    for (std::size_t code = 1U; code < 64U; ++code) {
        if (((replay.confirmed_codes >> code) & 1U) != 0U) {
            json["confirmed_codes"].push_back(code_names(std::uint64_t{1U} << code));
        }
    }
    json["ignored_columns"] = source.ignored_columns;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sil
