#include "sil/studies/drives/replay_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "rsi/parameters.hpp"
#include "sil/page/page_recording.hpp"
#include "sil/page/page_text.hpp"
#include "sil/results/versions.hpp"
#include "sil/studies/drives/replay_csv.hpp"
#include "sil/studies/drives/replay_table.hpp"
#include "sil/studies/drives/verdict.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

using Facts = std::vector<std::pair<std::string, std::string>>;

constexpr std::size_t most_rows = 2U * PageRecording::longest_rows;

const std::vector<std::string>& wanted_columns() {
    static const std::vector<std::string> columns{
        "time_s",
        "sensor_lateral_acceleration_mps2",
        "sensor_roll_rate_degps",
        "sensor_roll_angle_deg",
        "sensor_bank_angle_deg",
        "sensor_speed_mps",
        "sensor_steering_wheel_angle_deg",
        "measured_load_transfer_ratio",
        "measured_wheel_load_front_left_n",
        "measured_wheel_load_front_right_n",
        "measured_wheel_load_rear_left_n",
        "measured_wheel_load_rear_right_n",
        "warning_level",
        "lateral_acceleration_mps2",
        "lateral_acceleration_threshold_mps2",
        "observed_roll_angle_deg",
        "rsi",
        "state",
        "side",
    };
    return columns;
}

bool is_against_horizon(const rsi::Parameters& parameters) {
    return parameters.roll_angle_reference == RSI_ROLL_AGAINST_HORIZON;
}

// Every n-th of a file's rows, which follow its header.
std::vector<std::string> some_lines(const std::string& text, std::size_t every) {
    std::vector<std::string> lines;
    std::size_t number = 0U;
    for (std::size_t begin = text.find('\n') + 1U; begin < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (number % every == 0U) {
            lines.push_back(text.substr(begin, end - begin));
        }
        begin = end + 1U;
    }
    return lines;
}

// Those in which any of these rows has a value. Against the horizon the sensor's roll angle is not that to
// the road.
std::vector<std::string> known_columns(const std::vector<std::string>& lines,
                                       const rsi::Parameters& parameters) {
    const std::vector<std::string> all = indices_csv_columns();
    std::vector<bool> known(all.size(), false);
    for (const std::string& line : lines) {
        const std::vector<std::string> cells = cells_of(line);
        for (std::size_t cell = 0U; cell < std::min(cells.size(), all.size()); ++cell) {
            known[cell] = known[cell] || !cells[cell].empty();
        }
    }
    std::vector<std::string> columns;
    for (const std::string& column : wanted_columns()) {
        const auto at = std::find(all.begin(), all.end(), column) - all.begin();
        if (known.at(static_cast<std::size_t>(at)) &&
            !(column == "sensor_roll_angle_deg" && is_against_horizon(parameters))) {
            columns.push_back(column);
        }
    }
    return columns;
}

// A calibration has the vehicle's track width and heights; the rest of the shape is that of a usual one.
PageVehicle page_vehicle(const rsi::Parameters& parameters, const LiftOff& lift_off) {
    PageVehicle vehicle;
    vehicle.track_width_m = static_cast<double>(parameters.track_width_m);
    vehicle.static_stability_factor = static_stability_factor(parameters);
    vehicle.cg_height_m = vehicle.track_width_m / (2.0 * vehicle.static_stability_factor);
    vehicle.wheel_radius_m = std::min(0.5, 0.45 * vehicle.cg_height_m);
    vehicle.half_width_m = 0.5 * vehicle.track_width_m + 0.12;
    vehicle.top_above_cg_m = 1.3 * vehicle.cg_height_m;
    vehicle.bottom_below_cg_m = 0.55 * vehicle.cg_height_m;
    vehicle.mass_kg =
        static_cast<double>(parameters.sprung_mass_kg) + static_cast<double>(parameters.unsprung_mass_kg);
    vehicle.up_below_n = lift_off.up_below_n;
    vehicle.outline_is_known = false;
    return vehicle;
}

std::string unknown_lift_off(const std::vector<ReplayWarning>& warnings) {
    const auto calm = std::find_if(warnings.begin(), warnings.end(), cannot_lift);
    return calm == warnings.end()
               ? "Whether wheels lifted is not known, so the warning cannot be judged."
               : fmt::format(
                     "Whether wheels lifted is not measured, but about the warning at {:.3f} s none can "
                     "have: the accelerometers show a load transfer ratio of at most {:.2f} there.",
                     calm->named.begin_s, calm->largest_load_transfer_ratio);
}

std::vector<std::string> remarks(const std::vector<std::string>& columns, const rsi::Parameters& parameters,
                                 const DriveReplay& replay) {
    const auto has = [&columns](const char* name) {
        return std::find(columns.begin(), columns.end(), name) != columns.end();
    };
    std::string missing;
    const auto miss = [&](const char* column, const char* words) {
        if (!has(column)) {
            missing += (missing.empty() ? "" : ", ") + std::string{words};
        }
    };
    miss("sensor_steering_wheel_angle_deg", "steering wheel angle");
    miss("sensor_speed_mps", "speed");
    miss("sensor_bank_angle_deg", "bank of the road");
    miss("measured_wheel_load_front_left_n", "wheel loads");
    std::vector<std::string> sentences;
    if (!missing.empty()) {
        sentences.push_back("Not recorded, and not shown: " + missing + ".");
    }
    if (!has("sensor_roll_angle_deg")) {
        const std::string observed = has("observed_roll_angle_deg")
                                         ? " Shown is the angle to the road that the component observes."
                                         : " None is shown.";
        sentences.push_back((is_against_horizon(parameters)
                                 ? "The recorded roll angle is relative to the horizon."
                                 : "No roll angle was recorded.") +
                            observed);
    }
    if (replay.lift_off.source == LiftOffSource::unknown) {
        sentences.push_back(unknown_lift_off(replay.warnings));
    } else if (replay.lift_off.source == LiftOffSource::given) {
        sentences.push_back("When wheels lifted is what the file states.");
    }
    sentences.push_back(
        "How far wheels lift, and the vehicle's outline, are not known: a usual outline is drawn, its "
        "wheels on the road.");
    return sentences;
}

std::vector<PageDiagnosis> diagnosis_of(const DriveReplay& replay) {
    std::vector<PageDiagnosis> changes;
    for (const ReplayCycle& cycle : replay.cycles) {
        const auto degradation = cycle.ecu.of<rsi::can_dbc::RolloverDiagnosis>().degradation;
        if (changes.empty() || changes.back().degradation != degradation ||
            !(changes.back().codes == cycle.codes)) {
            changes.push_back({cycle.sample.time_s, degradation, cycle.codes});
        }
    }
    return changes;
}

Facts facts_of(const ReplaySource& source, const DriveReplay& replay, const rsi::Parameters& parameters) {
    const RunEvents& events = replay.events;
    const bool known = replay.lift_off.source != LiftOffSource::unknown;
    const auto lift = [known](const std::optional<EventMoment>& event) {
        return !known ? std::string{"not known"}
                      : (event ? fmt::format("{:.3f} s", event->time_s) : std::string{"did not happen"});
    };
    const auto number = [](double value) {
        return std::isfinite(value) ? fmt::format("{:.3f}", value) : std::string{"not known"};
    };
    const std::string codes = code_names(replay.confirmed_codes);
    const std::string warnings = all_warnings(replay);
    Facts facts{
        {"Verdict", to_string(verdict(replay))},
        {"Warnings", warnings.empty() ? "none" : first_warnings(warnings)},
        {"One-wheel lift-off", lift(events.one_wheel_lift)},
        {"Two-wheel lift-off", lift(events.two_wheel_lift)},
        {"Lift-off is known by", to_string(replay.lift_off.source)},
        {"Lead time", events.judgement.lead_s ? fmt::format("{:.3f} s", *events.judgement.lead_s) : "none"},
        {"On the wrong side", fmt::format("{:.3f} s", events.judgement.wrong_side_s)},
        {"Unavailable", fmt::format("{:.3f} s", events.judgement.unavailable_s)},
        {"Largest |LTR|", number(replay.largest_load_transfer_ratio)},
        {"Largest level", number(replay.largest_warning_level)},
        {"Driven by", rsi::indicator_choices.at(static_cast<std::size_t>(parameters.warning_indicator))},
        {"Confirmed codes", codes.empty() ? "none" : codes},
        {"Cycles, without frames", fmt::format("{}, {}", replay.cycles.size(), replay.silent_cycles)},
        {"File", source.file},
    };
    std::string ignored;
    for (const std::string& column : source.ignored_columns) {
        ignored += (ignored.empty() ? "" : ", ") + column;
    }
    if (!ignored.empty()) {
        facts.emplace_back("Columns not used", ignored);
    }
    const Versions versions = built_versions();
    facts.emplace_back("Component", fmt::format("{} {}", versions.component, versions.git_revision));
    return facts;
}

}  // namespace

std::string replay_page(const ReplaySource& source, const DriveReplay& replay,
                        const rsi::Parameters& parameters, const std::string& indices) {
    const std::size_t every = (replay.cycles.size() + most_rows - 1U) / most_rows;
    const std::vector<std::string> lines = some_lines(indices, every);
    PageHead head;
    head.title = source.drive;
    head.subtitle = fmt::format("recorded drive ({}), replayed with the calibration {}: {}", source.kind,
                                source.parameters, to_string(verdict(replay)));
    head.vehicle = page_vehicle(parameters, replay.lift_off);
    head.facts = facts_of(source, replay, parameters);
    head.columns = known_columns(lines, parameters);
    head.lift_off_is_known = replay.lift_off.source != LiftOffSource::unknown;
    head.remarks = remarks(head.columns, parameters, replay);
    const PageCells cells{indices_csv_columns(), head.columns};
    std::vector<std::string> rows;
    for (const std::string& line : lines) {
        rows.push_back(cells.row(line));
    }
    return page_with(recording_json(head, replay.events, every, diagnosis_of(replay), rows));
}

}  // namespace sil
