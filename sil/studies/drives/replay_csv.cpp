#include "sil/studies/drives/replay_csv.hpp"

#include <iterator>

#include "rsi/output_table.hpp"
#include "sil/files/csv_writer.hpp"
#include "sil/results/output_columns.hpp"
#include "sil/results/sensor_columns.hpp"

namespace sil {
namespace {

using Cycle = ReplayCycle;

// clang-format off
constexpr int digits = 9;

constexpr CsvColumn<Cycle> load_columns[] = {
    {"measured_load_transfer_ratio", [](const Cycle& c) { return c.load_transfer_ratio; }},
    {"measured_wheel_load_front_left_n", [](const Cycle& c) { return c.sample.wheel_load_n[front_left]; }},
    {"measured_wheel_load_front_right_n", [](const Cycle& c) { return c.sample.wheel_load_n[front_right]; }},
    {"measured_wheel_load_rear_left_n", [](const Cycle& c) { return c.sample.wheel_load_n[rear_left]; }},
    {"measured_wheel_load_rear_right_n", [](const Cycle& c) { return c.sample.wheel_load_n[rear_right]; }},
};
// clang-format on

constexpr const char* word_columns[] = {"state", "side", "degradation", "codes_set", "codes_confirmed"};

const char* degradation(const Cycle& cycle) {
    return rsi::can_dbc::RolloverDiagnosis::name_of(
        cycle.ecu.of<rsi::can_dbc::RolloverDiagnosis>().degradation);
}

}  // namespace

std::vector<std::string> indices_csv_columns() {
    std::vector<std::string> names{"time_s"};
    for (const CsvColumn<SensorSample>& column : sensor_columns) {
        names.emplace_back(column.name);
    }
    for (const CsvColumn<Cycle>& column : load_columns) {
        names.emplace_back(column.name);
    }
    for (const OutputColumn& column : output_columns()) {
        names.push_back(column.name);
    }
    for (const rsi::CodeOutput& code : rsi::code_outputs) {
        names.push_back(std::string{code.name} + (code.largest > 1 ? "_number" : ""));
    }
    names.insert(names.end(), std::begin(word_columns), std::end(word_columns));
    return names;
}

std::string indices_csv(const DriveReplay& replay) {
    std::string text = csv_header(indices_csv_columns()) + "\n";
    for (const ReplayCycle& cycle : replay.cycles) {
        CsvRow row;
        row.number(cycle.sample.time_s, digits);
        row.numbers<SensorSample>(sensor_columns, cycle.sample, digits).numbers(load_columns, cycle, digits);
        for (const OutputColumn& column : output_columns()) {
            row.number(column.value(cycle.outputs), digits);
        }
        for (const rsi::CodeOutput& code : rsi::code_outputs) {
            row.number(static_cast<double>(cycle.outputs.*code.member), digits);
        }
        row.text(to_string(cycle.ecu.state())).text(to_string(cycle.ecu.side())).text(degradation(cycle));
        row.text(code_names(cycle.codes.set)).text(code_names(cycle.codes.confirmed));
        text += row.line() + "\n";
    }
    return text;
}

std::string warnings_csv(const DriveReplay& replay) {
    std::string text = "time_s,state,side\n";
    const EcuOutput* previous = nullptr;
    for (const ReplayCycle& cycle : replay.cycles) {
        if (previous == nullptr || previous->state() != cycle.ecu.state() ||
            previous->side() != cycle.ecu.side()) {
            CsvRow row;
            row.number(cycle.sample.time_s, digits).text(to_string(cycle.ecu.state()));
            text += row.text(to_string(cycle.ecu.side())).line() + "\n";
        }
        previous = &cycle.ecu;
    }
    return text;
}

std::string diagnosis_csv(const DriveReplay& replay) {
    std::string text = "time_s,degradation,codes_set,codes_confirmed\n";
    std::string previous;
    for (const ReplayCycle& cycle : replay.cycles) {
        const std::string words = CsvRow{}
                                      .text(degradation(cycle))
                                      .text(code_names(cycle.codes.set))
                                      .text(code_names(cycle.codes.confirmed))
                                      .line();
        if (words != previous) {
            text += CsvRow{}.number(cycle.sample.time_s, digits).line() + "," + words + "\n";
        }
        previous = words;
    }
    return text;
}

}  // namespace sil
