#include "sil/files/csv_reader.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "sil/input_error.hpp"

namespace sil {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view blanks = " \t";

CsvField trimmed(std::string_view line, std::size_t begin, std::size_t end) {
    while (begin < end && blanks.find(line[begin]) != std::string_view::npos) {
        ++begin;
    }
    while (begin < end && blanks.find(line[end - 1U]) != std::string_view::npos) {
        --end;
    }
    CsvField field{line.substr(begin, end - begin), begin + 1U};
    if (field.text.size() >= 2U && field.text.front() == '"' && field.text.back() == '"') {
        field.text = field.text.substr(1U, field.text.size() - 2U);
        ++field.column;
    }
    return field;
}

}  // namespace

CsvLines::CsvLines(std::string_view text) : rest_{text} {
    if (rest_.substr(0U, byte_order_mark.size()) == byte_order_mark) {
        rest_.remove_prefix(byte_order_mark.size());
    }
}

bool CsvLines::next(CsvLine& line) {
    while (!rest_.empty()) {
        const std::size_t end = rest_.find('\n');
        const bool is_ended = end != std::string_view::npos;
        std::string_view text = rest_.substr(0U, end);
        rest_.remove_prefix(is_ended ? end + 1U : rest_.size());
        ++number_;
        if (is_ended && !text.empty() && text.back() == '\r') {
            text.remove_suffix(1U);
        }
        if (text.find_first_not_of(blanks) != std::string_view::npos) {
            line = {text, number_, is_ended};
            return true;
        }
    }
    return false;
}

void split_fields(std::string_view line, std::vector<CsvField>& fields) {
    fields.clear();
    std::size_t begin = 0U;
    for (;;) {
        const std::size_t comma = line.find(',', begin);
        if (comma == std::string_view::npos) {
            fields.push_back(trimmed(line, begin, line.size()));
            return;
        }
        fields.push_back(trimmed(line, begin, comma));
        begin = comma + 1U;
    }
}

std::optional<double> finite_number(std::string_view text) {
    if (text.size() > 1U && text.front() == '+' && text[1U] != '-') {
        text.remove_prefix(1U);
    }
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    const bool is_good = error == std::errc{} && rest == end && std::isfinite(value);
    return is_good ? std::optional{value} : std::nullopt;
}

void CsvPlace::fail(std::size_t line, std::size_t column, const std::string& what,
                    const std::string& remedy) const {
    throw InputError(fmt::format("{}:{}:{}: {}; {}", file_, line, column, what, remedy));
}

}  // namespace sil
