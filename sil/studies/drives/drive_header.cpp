#include "sil/studies/drives/drive_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "sil/printable.hpp"
#include "sil/results/signal_csv.hpp"

namespace sil {
namespace {

constexpr const char* where_documented = "see docs/drives.md for the columns";

bool belongs_to_a_run(const std::string& name) {
    static const std::vector<std::string> names = signal_csv_columns();
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t most = 10U;
    std::string text;
    for (std::size_t index = 0U; index < std::min(most, names.size()); ++index) {
        text += (index > 0U ? ", " : "") + printable(names[index]);
    }
    return names.size() > most ? text + ", ..." : text;
}

void refuse_other_separators(const CsvLine& line, const CsvPlace& place) {
    const std::size_t position = line.text.find_first_of(";\t");
    if (line.text.find(',') == std::string_view::npos && position != std::string_view::npos) {
        const bool is_tab = line.text[position] == '\t';
        place.fail(line.number, position + 1U,
                   fmt::format("the fields are separated by {}", is_tab ? "tabs" : "semicolons"),
                   "separate them by commas, with a point in the decimals");
    }
}

void add_column(DriveHeader& header, std::size_t index, const CsvField& field, Drive& drive,
                const CsvPlace& place) {
    const DriveColumn column = read_column_name(field.text);
    const std::string name = printable(field.text);
    switch (column.kind) {
        case DriveColumn::Kind::unknown:
            if (!belongs_to_a_run(name)) {
                drive.ignored_columns.push_back(name);
            }
            return;
        case DriveColumn::Kind::wrong_unit:
            place.fail(header.line, field.column,
                       fmt::format("column {} has no unit that is known for {}", name, column.quantity->name),
                       fmt::format("call it {}, or something else to have it ignored",
                                   admitted_names(*column.quantity)));
        case DriveColumn::Kind::known:
            break;
    }
    if (const DriveHeader::Column* other = header.find(column.quantity->name)) {
        place.fail(header.line, field.column,
                   fmt::format("columns {} and {} both give {}", other->name, name, column.quantity->name),
                   "keep one of them, or give the other a name of its own");
    }
    header.columns.push_back({index, column.quantity, column.factor, name, field.column});
}

std::string missing(const char* quantity) {
    for (const DriveQuantity& candidate : drive_quantities()) {
        if (std::string_view{candidate.name} == quantity) {
            return admitted_names(candidate);
        }
    }
    return quantity;
}

void check_presence(const DriveHeader& header, const Drive& drive, const CsvPlace& place) {
    const std::string unknown =
        drive.ignored_columns.empty() ? "" : " (not understood: " + listed(drive.ignored_columns) + ")";
    std::size_t wheel_loads = 0U;
    std::string missing_load;
    for (const DriveQuantity& quantity : drive_quantities()) {
        const bool is_there = header.find(quantity.name) != nullptr;
        if (!is_there && quantity.need == DriveNeed::always) {
            place.fail(header.line, 1U, fmt::format("there is no column for {}{}", quantity.name, unknown),
                       fmt::format("name one {}; {}", admitted_names(quantity), where_documented));
        }
        if (std::string_view{quantity.name}.substr(0U, 10U) == "wheel_load") {
            wheel_loads += is_there ? 1U : 0U;
            missing_load = is_there ? missing_load : admitted_names(quantity);
        }
    }
    if (header.find("roll_angle") == nullptr &&
        (header.find("speed") == nullptr || header.find("yaw_rate") == nullptr)) {
        place.fail(header.line, 1U,
                   fmt::format("there is no column for roll_angle, nor both speed and yaw_rate{}", unknown),
                   fmt::format("name one {}, or one {} and one {}; {}", missing("roll_angle"),
                               missing("speed"), missing("yaw_rate"), where_documented));
    }
    if (wheel_loads != 0U && wheel_loads != std::size_t{wheel_count}) {
        place.fail(header.line, 1U, fmt::format("only {} of the four wheel loads are there", wheel_loads),
                   fmt::format("add {}, or leave all four out", missing_load));
    }
}

struct Remark {
    std::string_view key;
    CsvField value;
};

Remark split_remark(std::string_view line) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) {
        return {};
    }
    std::vector<CsvField> halves;
    split_fields(line.substr(1U, colon - 1U), halves);
    const std::string_view key = halves.front().text;
    split_fields(line.substr(colon + 1U), halves);
    CsvField value = halves.front();
    value.column += colon + 1U;
    return {key, value};
}

bool read_key(std::string_view key, std::string_view name, double& factor) {
    if (key.substr(0U, name.size()) != name) {
        return false;
    }
    const std::string_view unit = key.substr(name.size());
    factor = unit == "_ms" ? 1.0e-3 : 1.0;
    return unit == "_s" || unit == "_ms";
}

}  // namespace

std::size_t DriveHeader::time_index() const {
    return find("time")->index;
}

void DriveHeader::note_available(DriveSample& sample) {
    for (Column& column : columns) {
        column.available = column.available || !std::isnan(column.quantity->value(sample));
    }
}

const DriveHeader::Column* DriveHeader::find(const char* quantity) const {
    const auto found = std::find_if(columns.begin(), columns.end(), [quantity](const Column& column) {
        return std::string_view{column.quantity->name} == quantity;
    });
    return found != columns.end() ? &*found : nullptr;
}

void read_column_names(const CsvLine& line, DriveHeader& header, Drive& drive, const CsvPlace& place) {
    refuse_other_separators(line, place);
    std::vector<CsvField> fields;
    split_fields(line.text, fields);
    header.line = line.number;
    header.field_count = fields.size();
    for (std::size_t index = 0U; index < fields.size(); ++index) {
        add_column(header, index, fields[index], drive, place);
    }
    check_presence(header, drive, place);
}

void read_remark(const CsvLine& line, DriveHeader& header, Drive& drive, const CsvPlace& place) {
    const Remark remark = split_remark(line.text);
    double factor = 1.0;
    std::optional<double>* target = nullptr;
    if (read_key(remark.key, "one_wheel_lift_time", factor)) {
        target = &drive.one_wheel_lift_s;
    } else if (read_key(remark.key, "two_wheel_lift_time", factor)) {
        target = &drive.two_wheel_lift_s;
    } else {
        return;
    }
    drive.lift_off_given = true;
    if (remark.value.text == "none") {
        return;
    }
    const std::optional<double> value = finite_number(remark.value.text);
    if (!value) {
        place.fail(
            line.number, remark.value.column,
            fmt::format("{} is '{}', which is no finite number", remark.key, printable(remark.value.text)),
            "give the time on the drive's clock, or `none` when it did not happen");
    }
    *target = *value * factor;
    header.given_times.push_back({*value * factor, line.number, remark.value.column});
}

}  // namespace sil
