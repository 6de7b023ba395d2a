#include "sil/files/calibration_file.hpp"

#include <fmt/format.h>

#include <string_view>

#include "rsi/parameters.hpp"
#include "sil/files/toml_table.hpp"

namespace sil {
namespace {

TomlTable known_table(const std::string& path) {
    TomlTable table =
        TomlTable::load(path, "name a calibration file such as firmware/calibrations/large_suv.toml");
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        table.allow(field.name);
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        table.allow(field.name);
    }
    return table;
}

std::string range_of(std::string_view name) {
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        if (name == field.name) {
            return fmt::format(" (range {} to {})", field.minimum, field.maximum);
        }
    }
    return {};
}

rsi::Parameters read(TomlTable& table) {
    table.refuse_unknown_keys();
    rsi::Parameters parameters{};
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        parameters.*field.member = static_cast<float>(table.any_number(field.name));
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        parameters.*field.member = static_cast<std::int32_t>(
            table.choice(field.name, {field.choices, field.choices + field.choice_count}));
    }
    const rsi::Validation answer = rsi::validate(parameters);
    if (answer.accepted == 0) {
        table.fail(answer.field, answer.reason + range_of(answer.field));
    }
    return parameters;
}

}  // namespace

rsi::Parameters load_calibration(const std::string& path, const std::vector<std::string>& changes) {
    TomlTable table = known_table(path);
    for (const std::string& change : changes) {
        table.change(change, "sprung_cg_height_m=1.1");
    }
    return read(table);
}

}  // namespace sil
