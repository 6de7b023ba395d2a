// Row file: one write a line, so that a line is there whole or, after a kill, without its end.
#include "sil/studies/campaign/row_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "sil/files/csv_reader.hpp"
#include "sil/files/file_io.hpp"
#include "sil/input_error.hpp"

namespace sil {
namespace {

// Whole lines only: what follows the last end of a line is no line. They lie in `text`.
std::vector<CsvLine> whole_lines(std::string_view text) {
    std::vector<CsvLine> lines;
    CsvLines all{text};
    for (CsvLine line; all.next(line) && line.is_ended;) {
        lines.push_back(line);
    }
    return lines;
}

std::optional<std::uint64_t> run_number(std::string_view text) {
    std::uint64_t number = 0U;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && rest == text.data() + text.size() ? std::optional{number} : std::nullopt;
}

// Rows by run number; of two rows of one run the first, they are the same.
std::map<std::uint64_t, std::string_view> rows_of(const std::filesystem::path& path,
                                                  const std::vector<CsvLine>& lines) {
    std::map<std::uint64_t, std::string_view> rows;
    std::vector<CsvField> cells;
    std::size_t columns = 0U;
    for (const CsvLine& line : lines) {
        split_fields(line.text, cells);
        if (columns == 0U) {
            columns = cells.size();
            continue;
        }
        const std::optional<std::uint64_t> number = run_number(cells.front().text);
        if (!number || cells.size() != columns) {
            CsvPlace{path.string()}.fail(
                line.number, 1U,
                fmt::format("is not a row of {} cells that begins with a run number", columns),
                "remove the line, and the run will be done again");
        }
        rows.emplace(*number, line.text);
    }
    return rows;
}

std::string text_of(std::string_view header, const std::map<std::uint64_t, std::string_view>& rows) {
    std::string text{header};
    text += '\n';
    for (const auto& [number, line] : rows) {
        text += line;
        text += '\n';
    }
    return text;
}

}  // namespace

RowFile::RowFile(std::filesystem::path path, const std::string& header) : path_{std::move(path)} {
    if (std::filesystem::exists(path_)) {
        take_up(header);
    } else {
        write_file_atomically(path_, header + "\n");
    }
    open();
}

RowFile::~RowFile() {
    close();
}

void RowFile::take_up(const std::string& header) {
    const std::string text = read_whole_file(path_);
    const std::vector<CsvLine> lines = whole_lines(text);
    if (!lines.empty() && lines.front().text != header) {
        CsvPlace{path_.string()}.fail(1U, 1U, "has other columns than this program writes",
                                      "use another output folder, or the program that made it");
    }
    const std::map<std::uint64_t, std::string_view> rows = rows_of(path_, lines);
    for (const auto& [number, line] : rows) {
        finished_runs_.insert(number);
    }
    const std::string good = text_of(header, rows);
    if (good != text) {
        write_file_atomically(path_, good);
    }
}

void RowFile::open() {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    if (descriptor_ < 0) {
        throw InputError(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
    }
}

void RowFile::close() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
        descriptor_ = -1;
    }
}

void RowFile::append(std::uint64_t run, const std::string& line) {
    const std::string text = line + "\n";
    const off_t end = ::lseek(descriptor_, 0, SEEK_END);
    std::size_t written = 0U;
    while (written < text.size()) {
        const ssize_t count = ::write(descriptor_, text.data() + written, text.size() - written);
        if (count < 0 && errno != EINTR) {
            const std::string reason = std::strerror(errno);
            static_cast<void>(::ftruncate(descriptor_, end));  // half a line is no row
            throw InputError(
                fmt::format("{}: cannot be written: {}. Finished runs are kept; run the "
                            "same command again when there is room.",
                            path_.string(), reason));
        }
        written += count > 0 ? static_cast<std::size_t>(count) : 0U;
    }
    finished_runs_.insert(run);
}

void RowFile::finish() {
    close();
    const std::string text = read_whole_file(path_);
    const std::vector<CsvLine> lines = whole_lines(text);
    write_file_atomically(path_, text_of(lines.front().text, rows_of(path_, lines)));
}

}  // namespace sil
