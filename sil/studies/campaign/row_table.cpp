// Row table: CSV to numbers, strictly.
#include "sil/studies/campaign/row_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <string_view>
#include <unordered_set>

#include "sil/files/csv_reader.hpp"
#include "sil/files/file_io.hpp"
#include "sil/files/toml_table.hpp"
#include "sil/input_error.hpp"
#include "sil/printable.hpp"
#include "sil/studies/campaign/campaign_part.hpp"
#include "sil/studies/campaign/fingerprint.hpp"
#include "sil/studies/campaign/row.hpp"

namespace sil {
namespace {

constexpr const char* remedy = "do the campaign again, or take the folder of one that this program made";

// Every column NAME_threshold_100ms is of an index.
std::vector<std::string> index_names(const std::vector<std::string>& columns) {
    constexpr std::string_view ending = "_threshold_100ms";
    std::vector<std::string> names;
    for (const std::string& column : columns) {
        if (column.size() > ending.size() &&
            column.compare(column.size() - ending.size(), ending.size(), ending) == 0) {
            names.push_back(column.substr(0U, column.size() - ending.size()));
        }
    }
    return names;
}

// One row after the other, each of whose cells is read in a place that the names of the columns gave.
class RowReader {
 public:
    RowReader(const CsvPlace& place, const CsvLine& header) : place_{place} {
        std::vector<CsvField> names;
        split_fields(header.text, names);
        for (const CsvField& name : names) {
            columns_.emplace_back(name.text);
        }
        run_ = column("run");
        vehicle_ = column("vehicle");
        class_ = column("class");
        manoeuvre_ = column("manoeuvre");
        largest_ltr_ = column("largest_ltr");
        two_wheel_lift_ = column("two_wheel_lift_time_s");
        brief_lift_ = column("brief_two_wheel_lift_time_s");
        end_ = column("end_time_s");
        distance_ = column("distance_m");
        lead_ = column("lead_time_s");
        wrong_side_ = column("wrong_side_duration_s");
        warnings_ = column("warnings");
        advisories_ = column("advisories");
        unavailable_ = column("unavailable_duration_s");
        codes_ = column("diagnostic_codes");
        if (columns_.back() != row_check_name) {
            place_.fail(1U, 1U, fmt::format("the last column is not {}", row_check_name), remedy);
        }
        for (const std::string& name : index_names(columns_)) {
            indices_.push_back({column(name + "_threshold"), column(name + "_threshold_100ms"),
                                column(name + "_threshold_200ms"), column(name + "_lead_time_s")});
        }
    }

    const std::vector<std::string>& columns() const { return columns_; }

    RecordedCampaignRun read(const CsvLine& line) {
        split_fields(line.text, cells_);
        line_ = line.number;
        if (cells_.size() != columns_.size()) {
            place_.fail(line_, 1U, fmt::format("has {} cells, not {}", cells_.size(), columns_.size()),
                        remedy);
        }
        const CsvField& check = cells_.back();
        const std::size_t before_check = line.text.size() - check.text.size() - 1U;
        if (check.text != fingerprint_of(line.text.substr(0U, before_check))) {
            place_.fail(line_, check.column,
                        "is not the fingerprint of this row: it was changed after it was written", remedy);
        }
        RecordedCampaignRun run;
        run.number = static_cast<std::uint64_t>(number(run_));
        run.vehicle = text(vehicle_);
        run.in_class = text(class_);
        run.manoeuvre = text(manoeuvre_);
        run.largest_ltr = number(largest_ltr_);
        run.two_wheel_lift_time_s = time(two_wheel_lift_);
        run.brief_two_wheel_lift_time_s = time(brief_lift_);
        run.end_time_s = number(end_);
        run.distance_m = number(distance_);
        run.lead_s = time(lead_);
        run.wrong_side_s = number(wrong_side_);
        run.warnings = static_cast<unsigned>(number(warnings_));
        run.advisories = static_cast<unsigned>(number(advisories_));
        run.unavailable_s = number(unavailable_);
        run.has_code = !cells_[codes_].text.empty();
        run.indices.reserve(indices_.size());
        for (const IndexPlaces& index : indices_) {
            run.indices.push_back({number(index.threshold), number(index.threshold_100ms),
                                   number(index.threshold_200ms), time(index.lead)});
        }
        return run;
    }

 private:
    struct IndexPlaces {
        std::size_t threshold;
        std::size_t threshold_100ms;
        std::size_t threshold_200ms;
        std::size_t lead;
    };

    std::size_t column(std::string_view name) const {
        const auto found = std::find(columns_.begin(), columns_.end(), name);
        if (found == columns_.end()) {
            place_.fail(1U, 1U, fmt::format("there is no column {}", name), remedy);
        }
        return static_cast<std::size_t>(found - columns_.begin());
    }

    std::string text(std::size_t column) const { return std::string{cells_[column].text}; }

    double number(std::size_t column) const {
        const CsvField& field = cells_[column];
        const std::optional<double> value = finite_number(field.text);
        if (!value) {
            place_.fail(
                line_, field.column,
                fmt::format("column {} wants a number, not \"{}\"", columns_[column], printable(field.text)),
                remedy);
        }
        return *value;
    }

    std::optional<double> time(std::size_t column) const {
        return cells_[column].text.empty() ? std::nullopt : std::optional{number(column)};
    }

    const CsvPlace& place_;
    std::vector<std::string> columns_{};
    std::size_t run_, vehicle_, class_, manoeuvre_, largest_ltr_, two_wheel_lift_, brief_lift_, end_,
        distance_;
    std::size_t lead_, wrong_side_, warnings_, advisories_, unavailable_, codes_;
    std::vector<IndexPlaces> indices_{};
    std::size_t line_{0U};
    std::vector<CsvField> cells_{};
};

bool by_number(const RecordedCampaignRun& one, const RecordedCampaignRun& other) {
    return one.number < other.number;
}

// Appends the rows below `lines`, which stands before the header.
void read_rows(CsvLines& lines, const std::filesystem::path& path, RowTable& table) {
    CsvLine line;
    if (!lines.next(line)) {
        throw InputError(fmt::format("{}: there are no rows; run the campaign first", path.string()));
    }
    const CsvPlace place{path.string()};
    RowReader reader{place, line};
    table.index_names = index_names(reader.columns());
    // A line that the file ends without ending it was cut off.
    while (lines.next(line) && line.is_ended) {
        table.runs.push_back(reader.read(line));
    }
}

// Campaign of the parts by campaign.toml.
std::string wanted_fingerprint(const std::filesystem::path& folder) {
    TomlTable top = TomlTable::load(folder / "campaign.toml");
    return top.table("made_with").text("parts");
}

void read_part(const FoundPart& part, RowTable& table) {
    const std::string text = read_whole_file(part.path);
    CsvLines lines{text};
    CsvLine head;
    lines.next(head);
    const std::size_t before = table.runs.size();
    read_rows(lines, part.path, table);
    bool is_whole = table.runs.size() - before == part.head.count;
    for (std::size_t row = 0U; is_whole && row < part.head.count; ++row) {
        is_whole = table.runs[before + row].number == part.head.first + row;
    }
    if (!is_whole) {
        throw InputError(
            fmt::format("{} has not the rows that its first line tells; remove it and make it again",
                        part.path.string()));
    }
}

void check_parts(const std::vector<FoundPart>& parts, const std::string& wanted) {
    const FoundPart* before = nullptr;
    for (const FoundPart& part : parts) {
        if (part.head.fingerprint != wanted) {
            throw InputError(
                fmt::format("{} is of another campaign than campaign.toml beside it: {}, not {} (settings, "
                            "vehicle files and "
                            "program make the difference). Move it to another folder, or make it again",
                            part.path.string(), part.head.fingerprint, wanted));
        }
        if (before != nullptr && part.head.first < before->head.first + before->head.count) {
            throw InputError(fmt::format("{} and {} have the same runs; remove one of them",
                                         before->path.string(), part.path.string()));
        }
        before = &part;
    }
}

// `runs`: by number.
void refuse_a_second(const std::vector<RecordedCampaignRun>& runs, const std::filesystem::path& path) {
    const auto same = [](const RecordedCampaignRun& one, const RecordedCampaignRun& other) {
        return one.number == other.number;
    };
    const auto second = std::adjacent_find(runs.begin(), runs.end(), same);
    if (second != runs.end()) {
        throw InputError(fmt::format("{} has run {} twice; {}", path.string(), second->number, remedy));
    }
}

}  // namespace

Name::Name(const std::string& text) {
    static std::mutex mutex;
    static std::unordered_set<std::string> names;
    const std::lock_guard<std::mutex> lock{mutex};
    text_ = &*names.insert(text).first;
}

RowTable load_rows(const std::filesystem::path& path) {
    const std::string text = std::filesystem::exists(path) ? read_whole_file(path) : std::string{};
    RowTable table;
    table.runs.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')));
    CsvLines lines{text};
    read_rows(lines, path, table);
    std::sort(table.runs.begin(), table.runs.end(), by_number);
    refuse_a_second(table.runs, path);
    return table;
}

RowTable load_campaign_rows(const std::filesystem::path& folder) {
    const std::vector<FoundPart> parts = parts_of(folder);
    if (parts.empty()) {
        return load_rows(folder / "runs.csv");
    }
    check_parts(parts, wanted_fingerprint(folder));
    std::size_t rows = 0U;
    for (const FoundPart& part : parts) {
        rows += part.head.count;
    }
    RowTable table;
    table.runs.reserve(rows);
    for (const FoundPart& part : parts) {
        read_part(part, table);
    }
    return table;
}

}  // namespace sil
