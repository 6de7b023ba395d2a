// Row file: one write a line, so that a line is there whole or, after a kill, without its end.
#include "sil/studies/campaign/row_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "sil/files/atomic_file.hpp"
#include "sil/studies/campaign/settings.hpp"

namespace sil {
namespace {

std::string read_whole(const std::filesystem::path& path) {
    std::ifstream file{path, std::ios::binary};
    if (!file) {
        throw CampaignError(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
    }
    return {std::istreambuf_iterator<char>{file}, std::istreambuf_iterator<char>{}};
}

// Whole lines only: what follows the last end of a line is no line.
std::vector<std::string> whole_lines(const std::string& text) {
    std::vector<std::string> lines;
    std::size_t begin = 0U;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1U;
    }
    return lines;
}

std::optional<std::uint64_t> run_number(const std::string& line) {
    std::uint64_t number = 0U;
    const char* const end = line.data() + std::min(line.find(','), line.size());
    const auto [rest, error] = std::from_chars(line.data(), end, number);
    return error == std::errc{} && rest == end ? std::optional{number} : std::nullopt;
}

auto cell_count(const std::string& line) {
    return std::count(line.begin(), line.end(), ',') + 1;
}

// Rows by run number; of two rows of one run the first, they are the same.
std::map<std::uint64_t, std::string> rows_of(const std::filesystem::path& path,
                                             const std::vector<std::string>& lines) {
    std::map<std::uint64_t, std::string> rows;
    for (std::size_t i = 1U; i < lines.size(); ++i) {
        const std::optional<std::uint64_t> number = run_number(lines[i]);
        if (!number || cell_count(lines[i]) != cell_count(lines[0])) {
            throw CampaignError(fmt::format(
                "{}:{}: is not a row of {} cells that begins with a run number; remove the line, and the "
                "run will be done again",
                path.string(), i + 1U, cell_count(lines[0])));
        }
        rows.emplace(*number, lines[i]);
    }
    return rows;
}

std::string text_of(const std::string& header, const std::map<std::uint64_t, std::string>& rows) {
    std::string text = header + "\n";
    for (const auto& [number, line] : rows) {
        text += line + "\n";
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
    const std::string text = read_whole(path_);
    std::vector<std::string> lines = whole_lines(text);
    if (lines.empty()) {
        lines.push_back(header);
    }
    if (lines.front() != header) {
        throw CampaignError(
            fmt::format("{}:1: has other columns than this program writes; use another output folder, or the "
                        "program that made it",
                        path_.string()));
    }
    const std::map<std::uint64_t, std::string> rows = rows_of(path_, lines);
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
        throw CampaignError(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
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
    std::size_t written = 0U;
    while (written < text.size()) {
        const ssize_t count = ::write(descriptor_, text.data() + written, text.size() - written);
        if (count < 0 && errno != EINTR) {
            throw CampaignError(
                fmt::format("{}: cannot be written: {}. What is finished is kept; run the "
                            "same command again when there is room.",
                            path_.string(), std::strerror(errno)));
        }
        written += count > 0 ? static_cast<std::size_t>(count) : 0U;
    }
    finished_runs_.insert(run);
}

void RowFile::finish() {
    close();
    const std::vector<std::string> lines = whole_lines(read_whole(path_));
    write_file_atomically(path_, text_of(lines.front(), rows_of(path_, lines)));
}

}  // namespace sil
