// Row table: the rows of runs.csv as a report needs them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sil {

// See IndexScore.
struct RecordedIndex {
    double threshold{0.0};
    double threshold_100ms{0.0};
    double threshold_200ms{0.0};
    std::optional<double> lead_s{};  // with the threshold at 1
};

struct RecordedCampaignRun {
    std::uint64_t number{0U};
    std::string vehicle{};
    std::string in_class{};  // may be empty
    std::string manoeuvre{};
    double largest_ltr{0.0};
    std::optional<double> two_wheel_lift_time_s{};
    std::optional<double> brief_two_wheel_lift_time_s{};
    double end_time_s{0.0};
    double distance_m{0.0};
    // Of the firmware's warning; see WarningJudgement.
    std::optional<double> lead_s{};
    double wrong_side_s{0.0};
    unsigned warnings{0U};
    unsigned advisories{0U};
    double unavailable_s{0.0};
    bool has_code{false};                  // the firmware confirmed a diagnostic code
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
