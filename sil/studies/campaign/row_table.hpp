// Row table: the rows of runs.csv as a report needs them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sil {

struct RecordedIndex {
    double peak{0.0};                // up to two-wheel lift-off
    double peak_100ms_before{0.0};   // up to 0.1 s before it
    std::optional<double> time_s{};  // first at level 1
};

struct RecordedCampaignRun {
    std::uint64_t number{0U};
    std::string vehicle{};
    std::string manoeuvre{};
    double largest_ltr{0.0};
    std::optional<double> two_wheel_lift_time_s{};
    std::optional<double> brief_two_wheel_lift_time_s{};
    std::optional<double> warning_time_s{};
    std::vector<RecordedIndex> indices{};  // in the order of RowTable::index_names
};

struct RowTable {
    std::vector<std::string> index_names{};
    std::vector<RecordedCampaignRun> runs{};  // by number
};

// Reads the columns by their names; the indices are those that the file has. What follows the last end of a
// line is not read. Throws InputError with file, line and column for a missing column or a cell that is
// not a number.
RowTable load_rows(const std::filesystem::path& path);

}  // namespace sil
