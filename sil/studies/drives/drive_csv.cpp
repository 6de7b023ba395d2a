#include "sil/studies/drives/drive_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "sil/files/csv_reader.hpp"
#include "sil/files/whole_file.hpp"
#include "sil/printable.hpp"
#include "sil/studies/drives/drive_check.hpp"
#include "sil/studies/drives/drive_header.hpp"

namespace sil {
namespace {

// Beyond this no quantity of a vehicle lies in any unit; times may be those of the calendar.
constexpr double largest_value = 1.0e9;
constexpr double largest_time = 1.0e15;
// A longer silence is no drive, but two recordings on clocks of their own.
constexpr double longest_gap_s = 3600.0;
// More do not fit into the memory of every machine.
constexpr double longest_drive_s = 12.0 * 3600.0;

class DriveCsvParser {
 public:
    DriveCsvParser(std::string_view text, const std::filesystem::path& file)
        : lines_{text}, place_{file.string()} {
        drive_.name = file.stem().string();
    }

    Drive parse() {
        CsvLine line;
        if (!next(line)) {
            place_.fail(1U, 1U, "the file is empty", "was the recording or the copy finished?");
        }
        if (!read_header(line)) {
            place_.fail(1U, 1U, "there is no header",
                        "the first line that is no '#' remark must name the columns; see docs/drives.md");
        }
        while (next(line)) {
            read_row(line);
        }
        check_drive(drive_, header_, place_);
        return std::move(drive_);
    }

 private:
    // A line that does not end was cut off, wherever that happened: even a number that reads well may lack
    // its last digits.
    bool next(CsvLine& line) {
        if (!lines_.next(line)) {
            return false;
        }
        if (!line.is_ended) {
            place_.fail(line.number, line.text.size() + 1U,
                        "the last line has no line end: the file was cut off",
                        "copy the file again, or delete this line; if it is whole, end it with a line feed");
        }
        return true;
    }

    bool read_header(CsvLine line) {
        while (line.text.front() == '#') {
            read_remark(line, header_, drive_, place_);
            if (!next(line)) {
                return false;
            }
        }
        read_column_names(line, header_, drive_, place_);
        return true;
    }

    void read_row(const CsvLine& line) {
        split_fields(line.text, fields_);
        if (fields_.size() != header_.field_count) {
            const bool too_few = fields_.size() < header_.field_count;
            place_.fail(
                line.number, too_few ? line.text.size() + 1U : fields_[header_.field_count].column,
                fmt::format("{} fields, but the header names {} columns", fields_.size(),
                            header_.field_count),
                "give every row a field for each column, empty where an optional value is not available; "
                "decimals need a point, not a comma");
        }
        DriveSample sample;
        for (const DriveHeader::Column& column : header_.columns) {
            column.quantity->value(sample) = read_value(line, column, fields_[column.index]);
        }
        check_time(line, sample.time_s);
        header_.note_available(sample);
        drive_.samples.push_back(sample);
    }

    double read_value(const CsvLine& line, const DriveHeader::Column& column, const CsvField& field) const {
        if (field.text.empty()) {
            if (column.quantity->need == DriveNeed::always) {
                place_.fail(
                    line.number, field.column, fmt::format("{} has no value", column.name),
                    "this column needs one in every row; leave out rows without it (a gap is allowed)");
            }
            return DriveSample::not_available;
        }
        const std::optional<double> value = finite_number(field.text);
        if (!value) {
            place_.fail(
                line.number, field.column,
                fmt::format("{} is '{}', which is no finite number", column.name, printable(field.text)),
                column.quantity->need == DriveNeed::always
                    ? "leave out rows without this value (a gap is allowed)"
                    : "leave the field empty where the value is not available");
        }
        const double limit = column.quantity == &drive_quantities().front() ? largest_time : largest_value;
        if (std::fabs(*value) > limit) {
            place_.fail(line.number, field.column,
                        fmt::format("{} is {}, beyond anything possible", column.name, printable(field.text)),
                        "is the unit in the header right, or does the number stand for 'not available'? "
                        "Then leave the field empty");
        }
        return *value * column.factor;
    }

    void check_time(const CsvLine& line, double time_s) const {
        if (drive_.samples.empty()) {
            return;
        }
        const double previous_s = drive_.samples.back().time_s;
        const std::size_t column = fields_[header_.time_index()].column;
        if (!(time_s > previous_s)) {
            place_.fail(
                line.number, column,
                time_s < previous_s
                    ? fmt::format("the time runs back from {:.9g} s to {:.9g} s", previous_s, time_s)
                    : fmt::format("the time stands still at {:.9g} s", time_s),
                "a drive needs one recording, in the order of time, each row later than the one before");
        }
        if (time_s - previous_s > longest_gap_s) {
            place_.fail(line.number, column, fmt::format("a gap of {:.0f} s", time_s - previous_s),
                        "cut the recording in two before this line");
        }
        if (time_s - drive_.samples.front().time_s > longest_drive_s) {
            place_.fail(line.number, column,
                        fmt::format("the drive is longer than {:.0f} h", longest_drive_s / 3600.0),
                        "cut the recording in two before this line");
        }
    }

    CsvLines lines_;
    CsvPlace place_;
    Drive drive_;
    DriveHeader header_;
    std::vector<CsvField> fields_;
};

}  // namespace

Drive read_drive_csv(const std::filesystem::path& path) {
    return parse_drive_csv(read_whole_file(path), path);
}

Drive parse_drive_csv(std::string_view text, const std::filesystem::path& file) {
    return DriveCsvParser{text, file}.parse();
}

}  // namespace sil
