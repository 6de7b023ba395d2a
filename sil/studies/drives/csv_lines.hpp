// CSV lines: a text line by line and field by field, with the place of everything for messages.
#pragma once

#include <cstddef>
#include <string_view>
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

}  // namespace sil
