#include "sil/studies/procedures/procedure_files.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "sil/files/csv_writer.hpp"
#include "sil/files/file_io.hpp"
#include "sil/results/versions.hpp"
#include "sil/studies/procedures/procedure_text.hpp"

namespace sil {
namespace {

using Json = nlohmann::ordered_json;

constexpr int csv_decimals = 6;

Json number(const std::optional<double>& value) {
    if (!value || !std::isfinite(*value)) {
        return nullptr;
    }
    const double rounded = std::round(*value * 1e9) / 1e9;
    return rounded == 0.0 ? 0.0 : rounded;  // no "-0.0"
}

Json side(WarningSide side) {
    return side == WarningSide::none ? Json(nullptr) : Json(to_string(side));
}

Json json_of(const Figure& figure) {
    Json json;
    json["key"] = figure.key;
    json["name"] = figure.name;
    json["unit"] = figure.unit;
    json["decimals"] = figure.decimals;
    json["value"] = number(figure.value);
    return json;
}

Json json_of(const std::vector<Figure>& figures) {
    Json json = Json::array();
    for (const Figure& figure : figures) {
        json.push_back(json_of(figure));
    }
    return json;
}

Json json_of(const Criterion& criterion) {
    Json json = json_of(criterion.measured);
    json["bound"] = to_string(criterion.bound);
    json["limit"] = criterion.limit;
    json["source"] = criterion.source;
    json["met"] = criterion.asked ? Json(criterion.met()) : Json(nullptr);
    return json;
}

Json json_of(const WarningBeside& warning) {
    Json json;
    json["text"] = warning_text(warning);
    json["two_wheel_lift_time_s"] = warning.lifted ? number(warning.lift_off_s) : Json(nullptr);
    json["falling_side"] = side(warning.falling_side);
    json["state_at_lift_off"] = warning.lifted ? Json(to_string(warning.state_at_lift_off)) : Json(nullptr);
    json["side_at_lift_off"] = side(warning.side_at_lift_off);
    json["lead_time_s"] = number(warning.lead_s);
    json["advisory_time_s"] = number(warning.first_advisory_s);
    json["warning_time_s"] = number(warning.first_warning_s);
    json["warning_side"] = side(warning.first_warning_side);
    return json;
}

Json json_of(const ProcedureStep& step) {
    Json json;
    json["series"] = step.series;
    json["name"] = step.name;
    json["figures"] = json_of(step.figures);
    json["criteria"] = Json::array();
    for (const Criterion& criterion : step.criteria) {
        json["criteria"].push_back(json_of(criterion));
    }
    json["ecu"] = json_of(step.warning);
    return json;
}

std::string csv_columns(const ProcedureStep& step) {
    CsvRow row;
    row.text("series").text("step");
    for (const Figure& figure : step.figures) {
        row.text(figure.key);
    }
    for (const Criterion& criterion : step.criteria) {
        row.text(criterion.measured.key)
            .text(criterion.measured.key + "_limit")
            .text(criterion.measured.key + "_met");
    }
    row.text("two_wheel_lift_time_s").text("falling_side").text("ecu_state_at_lift_off");
    row.text("ecu_lead_time_s")
        .text("ecu_advisory_time_s")
        .text("ecu_warning_time_s")
        .text("ecu_warning_side");
    return row.line();
}

std::string csv_line(const ProcedureStep& step) {
    CsvRow row;
    row.text(step.series).text(step.name);
    for (const Figure& figure : step.figures) {
        row.fixed(figure.value, csv_decimals);
    }
    for (const Criterion& criterion : step.criteria) {
        row.fixed(criterion.measured.value, csv_decimals).fixed(criterion.limit, csv_decimals);
        row.text(criterion.asked ? (criterion.met() ? "1" : "0") : "");
    }
    const WarningBeside& warning = step.warning;
    row.fixed(warning.lifted ? std::optional{warning.lift_off_s} : std::nullopt, 3);
    row.text(warning.lifted ? to_string(warning.falling_side) : "");
    row.text(warning.lifted ? to_string(warning.state_at_lift_off) : "");
    row.fixed(warning.lead_s, 3).fixed(warning.first_advisory_s, 3).fixed(warning.first_warning_s, 3);
    row.text(warning.first_warning_s ? to_string(warning.first_warning_side) : "");
    return row.line();
}

}  // namespace

std::string result_json(const Procedure& procedure, const std::string& vehicle,
                        const ProcedureResult& result) {
    Json json;
    json["procedure"] = procedure.name;
    json["description"] = procedure.description;
    json["sources"] = procedure.sources;
    json["vehicle"] = vehicle;
    json["outcome"] = to_string(result.outcome);
    json["verdict"] = result.verdict;
    json["before"] = json_of(result.before);
    json["results"] = json_of(result.results);
    json["steps"] = Json::array();
    for (const ProcedureStep& step : result.steps) {
        json["steps"].push_back(json_of(step));
    }
    json["notes"] = result.notes;
    const Versions versions = built_versions();
    json["versions"]["component"] = versions.component;
    json["versions"]["git_revision"] =
        versions.git_revision.empty() ? Json(nullptr) : Json(versions.git_revision);
    json["versions"]["compiler"] = versions.compiler;
    return json.dump(2) + "\n";
}

std::string steps_csv(const ProcedureResult& result) {
    if (result.steps.empty()) {
        return {};
    }
    std::string text = csv_columns(result.steps.front()) + "\n";
    for (const ProcedureStep& step : result.steps) {
        text += csv_line(step) + "\n";
    }
    return text;
}

void prepare_procedure_folder(const std::filesystem::path& folder) {
    make_folder(folder);
    for (const char* name : {"result.json", "steps.csv"}) {
        remove_file(folder / name);
    }
}

void write_procedure(const Procedure& procedure, const std::string& vehicle, const ProcedureResult& result,
                     const std::filesystem::path& folder) {
    write_file_atomically(folder / "steps.csv", steps_csv(result));
    write_file_atomically(folder / "result.json", result_json(procedure, vehicle, result));
}

}  // namespace sil
