#include "sil/studies/identification/calibration_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "calibration_template.hpp"
#include "rsi/parameters.hpp"
#include "sil/studies/identification/calibration_default.hpp"

namespace sil {
namespace {

std::string names(const std::vector<PreparedDrive>& drives) {
    std::string text;
    for (const PreparedDrive& drive : drives) {
        text += (text.empty() ? "" : ", ") + drive.name;
    }
    return text;
}

// A name that the user chose must not end the comment.
std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U; }, ' ');
    return text;
}

constexpr std::string_view doubt_mark = "# Doubt: ";

std::string doubts(const Identification& result) {
    std::string text;
    for (const std::string& warning : result.warnings) {
        text += one_line(std::string{doubt_mark} + warning) + "\n";
    }
    return text;
}

std::string head(const Identification& result) {
    return one_line(
               fmt::format("# Calibration of the rollover-warning component for the {}, by rsi-sil identify.",
                           result.vehicle.name)) +
           "\n" +
           one_line("# Slow ramps: " + names(result.ramps) + "; dynamic drives: " + names(result.dynamics)) +
           ".\n"
           "# Values without a remark are defaults, the same for every vehicle. Every key is needed; "
           "rsi/rsi.h says\n"
           "# what each one is, rsi/parameters.hpp which range it has.\n" +
           doubts(result);
}

}  // namespace

std::vector<std::string> doubts_in(const std::string& calibration) {
    std::vector<std::string> found;
    std::istringstream lines{calibration};
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind(doubt_mark, 0U) == 0U) {
            found.push_back(line.substr(doubt_mark.size()));
        }
    }
    return found;
}

std::string value_text(const IdentifiedValue& value) {
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        if (value.key == field.name) {
            return fmt::format("\"{}\"", field.choices[static_cast<std::size_t>(value.value)]);
        }
    }
    std::string number = fmt::format("{:.6g}", value.value);
    return number.find_first_of(".e") == std::string::npos ? number + ".0" : number;
}

std::string calibration_text(const Identification& result) {
    std::string text = head(result);
    std::size_t written = 0U;
    bool in_head = true;
    std::istringstream lines{calibration_template};
    for (std::string line; std::getline(lines, line);) {
        in_head = in_head && !line.empty();
        if (in_head) {
            continue;
        }
        const auto found =
            std::find_if(result.values.begin(), result.values.end(),
                         [&line](const IdentifiedValue& value) { return value.key == key_in(line); });
        if (found == result.values.end()) {
            text += line + "\n";
        } else {
            text += fmt::format("{} = {}  # {}\n", found->key, value_text(*found), found->origin);
            ++written;
        }
    }
    if (written != result.values.size()) {
        throw std::logic_error("the calibration template lacks a parameter that was identified");
    }
    return text;
}

}  // namespace sil
