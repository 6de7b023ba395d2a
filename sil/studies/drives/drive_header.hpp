// Drive header: what stands above the rows of a drive's CSV.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sil/files/csv_reader.hpp"
#include "sil/studies/drives/drive_columns.hpp"

namespace sil {

struct DriveHeader {
    struct Column {
        std::size_t index;  // in a row's fields
        const DriveQuantity* quantity;
        double factor;
        std::string name;       // as the file writes it
        std::size_t column;     // where it stands in the header's line
        bool available{false};  // whether any row had a value
    };

    // A lift-off of the remarks, and where it stands.
    struct GivenTime {
        double time_s;
        std::size_t line;
        std::size_t column;
    };

    std::vector<GivenTime> given_times;
    std::vector<Column> columns;
    std::size_t field_count{0U};
    std::size_t line{1U};

    std::size_t time_index() const;
    void note_available(DriveSample& sample);
    // The column of a quantity by its name, or null.
    const Column* find(const char* quantity) const;
};

// Reads the names of the columns and checks that those are there which a drive needs. Unknown columns go
// to drive.ignored_columns, unless they are those of a run's signals.csv. Throws InputError.
void read_column_names(const CsvLine& line, DriveHeader& header, Drive& drive, const CsvPlace& place);

// A line that begins with '#'. "# one_wheel_lift_time_s: 2.34", "# two_wheel_lift_time_s: none" say when the
// wheels lifted; others are passed over. Throws InputError.
void read_remark(const CsvLine& line, DriveHeader& header, Drive& drive, const CsvPlace& place);

}  // namespace sil
