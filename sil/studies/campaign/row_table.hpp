// Row table: the rows of a campaign as a report needs them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sil/judge/index_score.hpp"

namespace sil {

// A text that many rows share, held once for all of them: a million rows know some hundred vehicles.
class Name {
 public:
    Name() : Name(std::string{}) {}
    Name(const std::string& text);  // NOLINT(google-explicit-constructor): as good as the text
    Name(const char* text) : Name(std::string{text}) {}  // NOLINT(google-explicit-constructor)

    const std::string& text() const { return *text_; }
    operator const std::string&() const { return *text_; }  // NOLINT(google-explicit-constructor)

    friend bool operator==(Name one, Name other) { return one.text_ == other.text_; }
    friend bool operator!=(Name one, Name other) { return one.text_ != other.text_; }
    // As the texts.
    friend bool operator<(Name one, Name other) {
        return one.text_ != other.text_ && *one.text_ < *other.text_;
    }

 private:
    const std::string* text_;
};

struct RecordedCampaignRun {
    std::uint64_t number{0U};
    Name vehicle{};
    Name in_class{};  // may be empty
    Name manoeuvre{};
    double largest_ltr{0.0};
    std::optional<double> two_wheel_lift_time_s{};
    std::optional<double> brief_two_wheel_lift_time_s{};
    double end_time_s{0.0};
    double distance_m{0.0};
    // The firmware's warning; see WarningJudgement.
    std::optional<double> lead_s{};
    double wrong_side_s{0.0};
    unsigned warnings{0U};
    unsigned advisories{0U};
    double unavailable_s{0.0};
    bool has_code{false};               // the firmware confirmed a diagnostic code
    std::vector<IndexScore> indices{};  // in the order of RowTable::index_names
};

struct RowTable {
    std::vector<std::string> index_names{};
    std::vector<RecordedCampaignRun> runs{};  // by number
};

// Reads the columns by their names; the indices are those that the file has. Text behind the last end of a
// line is not read. Throws InputError with file, line and column for a missing column or a cell that is
// not a number.
RowTable load_rows(const std::filesystem::path& path);

// The rows of a campaign's folder: those of its parts (campaign_part.hpp) or, without parts, of runs.csv. One
// part after the other, so that the text of one only is in memory. Throws InputError also for a part that is
// of another campaign than campaign.toml beside it, that has not as many rows as it says, or that overlaps
// another.
RowTable load_campaign_rows(const std::filesystem::path& folder);

}  // namespace sil
