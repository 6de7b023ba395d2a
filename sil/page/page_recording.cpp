#include "sil/page/page_recording.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "sil/page/json_text.hpp"
#include "sil/results/signal_csv.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

using Json = nlohmann::ordered_json;

Json rounded(double value) {
    return std::isfinite(value) ? Json(std::round(value * 1.0e9) / 1.0e9) : Json(nullptr);
}

void add_moment(Json& json, const char* name, const std::optional<EventMoment>& moment) {
    if (moment) {
        json[name] = {{"time_s", rounded(moment->time_s)},
                      {"ay_g", rounded(moment->lateral_acceleration_mps2 / g_mps2)},
                      {"roll_deg", rounded(moment->roll_angle_rad * degrees_per_radian)}};
    }
}

Json json_of(const PageVehicle& vehicle) {
    return {{"track_width_m", vehicle.track_width_m},
            {"cg_height_m", vehicle.cg_height_m},
            {"wheel_radius_m", vehicle.wheel_radius_m},
            {"half_width_m", vehicle.half_width_m},
            {"top_above_cg_m", vehicle.top_above_cg_m},
            {"bottom_below_cg_m", vehicle.bottom_below_cg_m},
            {"mass_kg", rounded(vehicle.mass_kg)},
            {"static_stability_factor", rounded(vehicle.static_stability_factor)},
            {"roof_load_kg", vehicle.roof_load_kg},
            {"up_below_n", rounded(vehicle.up_below_n)},
            {"outline_is_known", vehicle.outline_is_known}};
}

Json json_of(const PageHead& head) {
    Json json;
    json["title"] = head.title;
    json["subtitle"] = head.subtitle;
    json["vehicle"] = json_of(head.vehicle);
    json["facts"] = head.facts;
    json["columns"] = head.columns;
    json["lift_off_is_known"] = head.lift_off_is_known;
    json["remarks"] = head.remarks;
    return json;
}

bool is_word(const std::string& column) {
    return column == "ecu_state" || column == "ecu_side" || column == "state" || column == "side";
}

}  // namespace

PageVehicle page_vehicle(const VehicleParameters& parameters) {
    PageVehicle vehicle;
    vehicle.track_width_m = parameters.geometry.track_width_m;
    vehicle.cg_height_m = parameters.geometry.cg_height_m;
    vehicle.wheel_radius_m = parameters.geometry.wheel_radius_m;
    vehicle.half_width_m = parameters.hull.half_width_m;
    vehicle.top_above_cg_m = parameters.hull.top_above_cg_m;
    vehicle.bottom_below_cg_m = parameters.hull.bottom_below_cg_m;
    vehicle.mass_kg = total_mass_kg(parameters);
    vehicle.static_stability_factor = static_stability_factor(parameters);
    return vehicle;
}

const std::vector<std::string>& page_columns() {
    static const std::vector<std::string> columns{
        "time_s",
        "true_steering_wheel_angle_deg",
        "true_speed_mps",
        "true_roll_angle_deg",
        "true_bank_angle_deg",
        "true_roll_rate_degps",
        "true_lateral_acceleration_mps2",
        "true_wheel_load_front_left_n",
        "true_wheel_load_front_right_n",
        "true_wheel_load_rear_left_n",
        "true_wheel_load_rear_right_n",
        "true_wheel_gap_front_left_m",
        "true_wheel_gap_front_right_m",
        "true_wheel_gap_rear_left_m",
        "true_wheel_gap_rear_right_m",
        "sensor_lateral_acceleration_mps2",
        "sensor_roll_angle_deg",
        "ecu_warning_level",
        "ecu_lateral_acceleration_threshold_mps2",
        "ecu_rsi",
        "ecu_state",
        "ecu_side",
    };
    return columns;
}

std::vector<std::string> cells_of(const std::string& csv_row) {
    std::vector<std::string> cells;
    std::size_t begin = 0U;
    for (std::size_t end = 0U; end != std::string::npos; begin = end + 1U) {
        end = csv_row.find(',', begin);
        cells.push_back(csv_row.substr(begin, end - begin));
    }
    return cells;
}

PageCells::PageCells(const std::vector<std::string>& columns_of_file, const std::vector<std::string>& shown) {
    for (const std::string& column : shown) {
        const auto at = std::find(columns_of_file.begin(), columns_of_file.end(), column);
        if (at == columns_of_file.end()) {
            throw std::logic_error("there is no column " + column);
        }
        places_.push_back({static_cast<std::size_t>(at - columns_of_file.begin()), is_word(column)});
    }
}

std::string PageCells::row(const std::string& csv_row) const {
    const std::vector<std::string> cells = cells_of(csv_row);
    std::string row = "[";
    for (const Place& place : places_) {
        const std::string& cell = cells.at(place.index);
        row += row.size() > 1U ? "," : "";
        row += cell.empty() ? "null" : (place.is_word ? "\"" + cell + "\"" : cell);
    }
    return row + "]";
}

std::string page_row(const std::string& signal_csv_row) {
    static const PageCells cells{signal_csv_columns(), page_columns()};
    return cells.row(signal_csv_row);
}

std::string events_json(const RunEvents& events) {
    Json json = Json::object();
    add_moment(json, "warning", events.warning);
    add_moment(json, "one_wheel_lift", events.one_wheel_lift);
    add_moment(json, "two_wheel_lift", events.two_wheel_lift);
    add_moment(json, "ssf_crossing", events.ssf_crossing);
    return json_text(json);
}

std::string judgement_json(const RunEvents& events) {
    const WarningJudgement& judgement = events.judgement;
    Json json;
    json["lead_time_s"] = judgement.lead_s ? rounded(*judgement.lead_s) : Json(nullptr);
    json["falling_side"] = to_string(judgement.falling_side);
    return json_text(json);
}

std::string diagnosis_json(const PageDiagnosis& diagnosis) {
    Json json;
    json["time_s"] = rounded(diagnosis.time_s);
    json["degradation"] = rsi::can_dbc::RolloverDiagnosis::name_of(diagnosis.degradation);
    json["set"] = list_of_codes(diagnosis.codes.set);
    json["confirmed"] = list_of_codes(diagnosis.codes.confirmed);
    return json_text(json);
}

std::string head_json(const PageHead& head) {
    return json_text(json_of(head));
}

bool DiagnosisWatch::observe(double time_s, const rsi::can_dbc::RolloverDiagnosis& diagnosis) {
    listener_.take(diagnosis);
    const CodeSets codes = listener_.codes();
    if (heard_ && latest_.degradation == diagnosis.degradation && latest_.codes == codes) {
        return false;
    }
    heard_ = true;
    latest_ = {time_s, diagnosis.degradation, codes};
    return true;
}

void PageRecording::cycle(const std::string& signal_csv_row, const EcuFrames& ecu, double time_s) {
    if (watch_.observe(time_s, ecu.diagnosis())) {
        diagnosis_.push_back(watch_.latest());
    }
    if (cycles_++ % every_ != 0U) {
        return;
    }
    if (rows_.size() == 2U * longest_rows) {
        for (std::size_t row = 1U; row < longest_rows; ++row) {
            rows_[row] = std::move(rows_[2U * row]);
        }
        rows_.resize(longest_rows);
        every_ *= 2U;
    }
    rows_.push_back(page_row(signal_csv_row));
}

std::string PageRecording::json(const PageHead& head, const RunEvents& events) const {
    return recording_json(head, events, every_, diagnosis_, rows_);
}

std::string recording_json(const PageHead& head, const RunEvents& events, std::size_t every,
                           const std::vector<PageDiagnosis>& diagnosis,
                           const std::vector<std::string>& rows) {
    std::string text = head_json(head);
    text.pop_back();
    text += ",\n\"every\":" + std::to_string(every) + ",\"events\":" + events_json(events) +
            ",\"judgement\":" + judgement_json(events) + ",\n\"diagnosis\":[";
    for (std::size_t change = 0U; change < diagnosis.size(); ++change) {
        text += (change > 0U ? ",\n" : "") + diagnosis_json(diagnosis[change]);
    }
    text += "],\n\"rows\":[\n";
    for (std::size_t row = 0U; row < rows.size(); ++row) {
        text += (row > 0U ? ",\n" : "") + rows[row];
    }
    return text + "\n]}";
}

}  // namespace sil
