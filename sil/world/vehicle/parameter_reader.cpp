// Parameter reader: every failure names file, line and key, and says what to do.
#include "sil/world/vehicle/parameter_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>

#include "sil/printable.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil {
namespace {

std::string place(const std::filesystem::path& file, const toml::source_region& where) {
    return file.string() + ":" + std::to_string(where.begin.line) + ": ";
}

std::string in_words(double value) {
    std::ostringstream words;
    words << value;
    return words.str();
}

}  // namespace

toml::table parse_parameter_file(const std::filesystem::path& file) {
    if (!std::ifstream{file}.good()) {
        throw ParameterError(file.string() + ": cannot be read. Check the path and the permissions.");
    }
    try {
        return toml::parse_file(file.string());
    } catch (const toml::parse_error& error) {
        throw ParameterError(place(file, error.source()) +
                             "not valid TOML: " + std::string{error.description()} + ". Correct this line.");
    }
}

ParameterTable::ParameterTable(const std::filesystem::path& file, const toml::table& table, std::string name)
    : file_{file}, table_{table}, name_{std::move(name)} {}

std::string ParameterTable::full_name(std::string_view key) const {
    return name_.empty() ? std::string{key} : name_ + "." + std::string{key};
}

void ParameterTable::fail(const toml::source_region& where, std::string_view key,
                          const std::string& what) const {
    throw ParameterError(place(file_, where) + "'" + full_name(printable(key)) + "' " + what);
}

const toml::node& ParameterTable::find(std::string_view key, std::string_view what) {
    known_keys_.emplace_back(key);
    const toml::node* node = table_.get(key);
    if (node == nullptr) {
        const std::string where = name_.empty() ? "at the top of the file" : "to the table [" + name_ + "]";
        fail(table_.source(), key, "is missing. Add " + std::string{what} + " of this name " + where + ".");
    }
    return *node;
}

double ParameterTable::number(std::string_view key, Range range) {
    const toml::node& node = find(key, "a number");
    if (!node.is_number()) {
        fail(node.source(), key, "is not a number. Write a plain number in SI units.");
    }
    const double value = node.value<double>().value_or(0.0);
    const std::string allowed =
        " Give a number from " + in_words(range.lowest) + " to " + in_words(range.highest) + ".";
    if (!std::isfinite(value)) {
        fail(node.source(), key, "is not finite." + allowed);
    }
    if (value < range.lowest || value > range.highest) {
        fail(node.source(), key, "is " + in_words(value) + ", which is out of range." + allowed);
    }
    return value;
}

std::string ParameterTable::text(std::string_view key) {
    const toml::node& node = find(key, "a text");
    if (!node.is_string()) {
        fail(node.source(), key, "is not a text. Write it between quotation marks.");
    }
    return node.value<std::string>().value_or("");
}

ParameterTable ParameterTable::table(std::string_view key) {
    const toml::node& node = find(key, "a table");
    const toml::table* inner = node.as_table();
    if (inner == nullptr) {
        fail(node.source(), key, "is not a table. Write [" + full_name(key) + "] and its keys below.");
    }
    return ParameterTable{file_, *inner, full_name(key)};
}

void ParameterTable::refuse_unknown_keys() const {
    for (const auto& [key, node] : table_) {
        if (std::find(known_keys_.begin(), known_keys_.end(), key.str()) == known_keys_.end()) {
            std::string known;
            for (const std::string& name : known_keys_) {
                known += (known.empty() ? "" : ", ") + name;
            }
            fail(key.source(), key.str(),
                 "is not known. Remove it or correct its spelling; known here: " + known + ".");
        }
    }
}

}  // namespace sil
