#include "sil/files/calibration_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "rsi/parameters.hpp"
#include "sil/printable.hpp"

namespace sil {
namespace {

class CalibrationReader {
 public:
    explicit CalibrationReader(const std::string& path) : path_{path}, table_{parse(path)} {}

    // "key=value" in place of what the file says.
    void change(const std::string& text) {
        const std::size_t equals = text.find('=');
        const std::string key = text.substr(0U, text.find_last_not_of(" =", equals) + 1U);
        if (equals == std::string::npos || !is_known(key)) {
            throw CalibrationError(fmt::format(
                "\"{}\" must be KEY=VALUE with a key of {}, such as sprung_cg_height_m=1.1", text, path_));
        }
        const std::string value = text.substr(equals + 1U);
        toml::table changed = parsed_or_quoted(value);
        if (changed.size() != 1U) {
            throw CalibrationError(fmt::format("\"{}\": {} is not one value", text, value));
        }
        table_.insert_or_assign(key, std::move(*changed.get("value")));
        changes_[key] = text;
    }

    rsi::Parameters read() const {
        refuse_unknown_keys();
        rsi::Parameters parameters{};
        for (const rsi::ParameterField& field : rsi::parameter_fields) {
            parameters.*field.member = number(field.name);
        }
        for (const rsi::SelectionField& field : rsi::selection_fields) {
            parameters.*field.member = selection(field);
        }
        refuse_invalid(parameters);
        return parameters;
    }

 private:
    static toml::table parse(const std::string& path) {
        try {
            return toml::parse_file(path);
        } catch (const toml::parse_error& error) {
            const auto line = error.source().begin.line;
            if (line == 0) {
                throw CalibrationError(
                    fmt::format("{}: cannot be read: {}. Name a calibration file such as "
                                "firmware/calibrations/large_suv.toml.",
                                path, error.description()));
            }
            throw CalibrationError(fmt::format("{}:{}: not valid TOML: {}", path, line, error.description()));
        }
    }

    static toml::table parsed_or_quoted(const std::string& value) {
        try {
            return toml::parse("value = " + value);
        } catch (const toml::parse_error&) {
            return toml::table{{"value", value}};
        }
    }

    static bool is_known(std::string_view key) {
        const auto named = [key](const auto& field) { return key == field.name; };
        return std::any_of(rsi::parameter_fields.begin(), rsi::parameter_fields.end(), named) ||
               std::any_of(rsi::selection_fields.begin(), rsi::selection_fields.end(), named);
    }

    void refuse_unknown_keys() const {
        for (const auto& [key, node] : table_) {
            if (!is_known(key.str())) {
                fail(node, key.str(),
                     "is not a parameter of the component; remove it or correct its name (firmware/rsi/rsi.h "
                     "lists them)");
            }
        }
    }

    const toml::node& find(const char* key) const {
        const toml::node* node = table_.get(key);
        if (node == nullptr) {
            throw CalibrationError(
                fmt::format("{}: key \"{}\" is missing; every parameter must be given", path_, key));
        }
        return *node;
    }

    float number(const char* key) const {
        const toml::node& node = find(key);
        const auto value = node.value<double>();
        if (!value || !node.is_number()) {
            fail(node, key, "must be a number");
        }
        return static_cast<float>(*value);
    }

    std::int32_t selection(const rsi::SelectionField& field) const {
        const toml::node& node = find(field.name);
        const std::vector<std::string_view> choices(field.choices, field.choices + field.choice_count);
        const auto value = node.value<std::string_view>();
        const auto found = std::find(choices.begin(), choices.end(), value.value_or(""));
        if (found == choices.end()) {
            fail(node, field.name, fmt::format("must be one of \"{}\"", fmt::join(choices, "\", \"")));
        }
        return static_cast<std::int32_t>(found - choices.begin());
    }

    void refuse_invalid(const rsi::Parameters& parameters) const {
        const rsi::Validation answer = rsi::validate(parameters);
        if (answer.accepted == 0) {
            fail(find(answer.field), answer.field, answer.reason + range_of(answer.field));
        }
    }

    static std::string range_of(std::string_view name) {
        for (const rsi::ParameterField& field : rsi::parameter_fields) {
            if (name == field.name) {
                return fmt::format(" (range {} to {})", field.minimum, field.maximum);
            }
        }
        return {};
    }

    [[noreturn]] void fail(const toml::node& node, std::string_view key, const std::string& what) const {
        const auto changed = changes_.find(std::string{key});
        if (changed != changes_.end()) {
            throw CalibrationError(fmt::format("{}: \"{}\" {}", changed->second, printable(key), what));
        }
        throw CalibrationError(
            fmt::format("{}:{}: \"{}\" {}", path_, node.source().begin.line, printable(key), what));
    }

    std::string path_;
    toml::table table_;
    std::map<std::string, std::string> changes_{};  // as they were asked for, by key
};

}  // namespace

rsi::Parameters load_calibration(const std::string& path) {
    return load_calibration(path, {});
}

rsi::Parameters load_calibration(const std::string& path, const std::vector<std::string>& changes) {
    CalibrationReader reader{path};
    for (const std::string& change : changes) {
        reader.change(change);
    }
    return reader.read();
}

}  // namespace sil
