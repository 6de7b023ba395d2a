// Parameter reader: takes checked numbers out of a TOML file and knows which keys nobody asked for.
#pragma once

#include <toml++/toml.h>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sil {

struct Range {
    double lowest;
    double highest;
};

// One table of the file, whose name is empty for the file itself. All failures throw ParameterError.
class ParameterTable {
 public:
    ParameterTable(const std::filesystem::path& file, const toml::table& table, std::string name);

    double number(std::string_view key, Range range);
    std::string text(std::string_view key);
    ParameterTable table(std::string_view key);

    // To be called after the last key has been read: refuses any other.
    void refuse_unknown_keys() const;

 private:
    const toml::node& find(std::string_view key, std::string_view what);
    std::string full_name(std::string_view key) const;
    [[noreturn]] void fail(const toml::source_region& where, std::string_view key,
                           const std::string& what) const;

    std::filesystem::path file_;
    const toml::table& table_;
    std::string name_;
    std::vector<std::string> known_keys_;
};

// Parses the file. Throws ParameterError if it cannot be read or is not TOML.
toml::table parse_parameter_file(const std::filesystem::path& file);

}  // namespace sil
