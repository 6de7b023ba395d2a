// CSV reader: a text line by line and field by field, with the place of everything for messages.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sil {

struct CsvField {
    std::string_view text;   // without blanks and quotation marks around it
    std::size_t column{1U};  // where it begins in its line, characters counted from 1
};

struct CsvLine {
    std::string_view text;   // without its end
    std::size_t number{0U};  // counted from 1
    bool is_ended{true};     // false for a last line without line feed
};

// Goes through a text once. A byte order mark at its beginning, carriage returns before line feeds and empty
// lines are passed over.
class CsvLines {
 public:
    explicit CsvLines(std::string_view text);

    // False at the end; `line` is then left alone.
    bool next(CsvLine& line);

 private:
    std::string_view rest_;
    std::size_t number_{0U};
};

// Fields between commas. A quotation mark only counts around a whole field, and no field holds a comma: there
// are only names and numbers in these files.
void split_fields(std::string_view line, std::vector<CsvField>& fields);

// The field as a finite number with a decimal point, or nothing.
std::optional<double> finite_number(std::string_view text);

// Errors of one file.
class CsvPlace {
 public:
    explicit CsvPlace(std::string file) : file_{std::move(file)} {}

    // Throws InputError: "FILE:LINE:COLUMN: what; remedy".
    [[noreturn]] void fail(std::size_t line, std::size_t column, const std::string& what,
                           const std::string& remedy) const;

 private:
    std::string file_;
};

}  // namespace sil
