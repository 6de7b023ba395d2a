#include "sil/studies/drives/drive_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "sil/files/csv_reader.hpp"
#include "sil/files/file_io.hpp"
#include "sil/printable.hpp"
#include "sil/studies/drives/drive.hpp"
#include "sil/studies/drives/drive_header.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

// 50 Hz to 1 kHz, with room for clocks that are not quite right.
constexpr double shortest_step_s = 0.00095;
constexpr double longest_step_s = 0.021;

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2U);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double median_step_s(const Drive& drive) {
    std::vector<double> steps_s;
    for (std::size_t index = 1U; index < drive.samples.size(); ++index) {
        steps_s.push_back(drive.samples[index].time_s - drive.samples[index - 1U].time_s);
    }
    return median(std::move(steps_s));
}

bool has_values(const DriveHeader& header, const char* quantity) {
    const DriveHeader::Column* column = header.find(quantity);
    return column != nullptr && column->available;
}

void check_rate(const Drive& drive, const DriveHeader& header, const CsvPlace& place) {
    const double step_s = median_step_s(drive);
    if (step_s < shortest_step_s || step_s > longest_step_s) {
        place.fail(header.line, header.find("time")->column,
                   fmt::format("the rows are {:.6g} ms apart (median), which is {:.4g} Hz", step_s * 1.0e3,
                               1.0 / step_s),
                   "record at 50 Hz to 1 kHz; is the unit of the time right (time_s, time_ms)?");
    }
}

void check_gravity(const Drive& drive, const DriveHeader& header, const CsvPlace& place) {
    std::vector<double> forces_mps2;
    for (const DriveSample& sample : drive.samples) {
        if (sample.time_s > drive.samples.front().time_s + upright_time_s) {
            break;
        }
        if (!std::isnan(sample.vertical_acceleration_mps2)) {
            forces_mps2.push_back(sample.vertical_acceleration_mps2);
        }
    }
    if (forces_mps2.empty()) {
        return;
    }
    const double force_mps2 = median(std::move(forces_mps2));
    if (force_mps2 < 0.5 * g_mps2 || force_mps2 > 2.0 * g_mps2) {
        place.fail(
            header.line, header.find("vertical_acceleration")->column,
            fmt::format("the vertical acceleration is {:.4g} m/s^2 in the first second (median), but an "
                        "accelerometer shows about +9.81 m/s^2",
                        force_mps2),
            "is the unit right (vertical_acceleration_mps2, vertical_acceleration_g), does it point upwards, "
            "is gravity in it? If not, leave the column out");
    }
}

void check_lift_off(const Drive& drive, const DriveHeader& header, const CsvPlace& place) {
    for (const DriveHeader::GivenTime& given : header.given_times) {
        const double first_s = drive.samples.front().time_s;
        const double last_s = drive.samples.back().time_s;
        if (given.time_s < first_s || given.time_s > last_s) {
            place.fail(
                given.line, given.column,
                fmt::format("a lift-off is given at {:.6g} s, but the rows go from {:.6g} s to {:.6g} s",
                            given.time_s, first_s, last_s),
                "give it on the clock of the rows, or `none` when it did not happen within them");
        }
    }
}

// Needs at least two rows, a sampling rate of 50 Hz to 1 kHz (by the median step), roll angle or both speed
// and yaw rate in at least one row, a vertical acceleration that contains gravity, and lift-off times within
// the drive. Throws InputError at the header's line (a lift-off's own).
void check_drive(const Drive& drive, const DriveHeader& header, const CsvPlace& place) {
    if (drive.samples.size() < 2U) {
        place.fail(header.line + drive.samples.size(), 1U,
                   drive.samples.empty() ? "there are no rows below the header" : "there is only one row",
                   "a drive needs one row every 1 ms to 20 ms");
    }
    if (!has_values(header, "roll_angle") &&
        !(has_values(header, "speed") && has_values(header, "yaw_rate"))) {
        place.fail(header.line, 1U, "no row has a value for roll_angle, nor for both speed and yaw_rate",
                   "one of the two is needed; see docs/drives.md");
    }
    check_rate(drive, header, place);
    check_gravity(drive, header, place);
    check_lift_off(drive, header, place);
}

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
