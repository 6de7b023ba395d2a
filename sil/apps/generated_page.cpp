#include "sil/apps/generated_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sil/files/file_io.hpp"

namespace sil {
namespace {

// The first line in which two texts differ, for a message.
std::string first_difference(const std::string& held, const std::string& measured) {
    std::size_t begin = 0U;
    std::size_t position = 0U;
    while (position < held.size() && position < measured.size() && held[position] == measured[position]) {
        if (held[position] == '\n') {
            begin = position + 1U;
        }
        ++position;
    }
    const auto line = [begin](const std::string& text) {
        return text.substr(std::min(begin, text.size()), text.find('\n', begin) - begin);
    };
    return fmt::format("  the document: {}\n  measured:     {}", line(held), line(measured));
}

void check(const std::filesystem::path& file, const std::string& measured) {
    const std::string held = read_whole_file(file);
    if (held != measured) {
        throw std::runtime_error(fmt::format(
            "{} holds other figures than this run; sil/studies/faults/run --document renews it.\n{}",
            file.string(), first_difference(held, measured)));
    }
}

}  // namespace

void add_page_options(CLI::App& command, GeneratedPage& page) {
    command.add_option("--document", page.written, "Write the figures as a page");
    command.add_option("--check", page.checked, "Compare the figures with a page; other ones fail");
    command.add_option("--data", page.data, "CSV file beside the page: a row for each run");
}

void write_or_check(const GeneratedPage& page, const std::string& document, const std::string& data) {
    if (!page.written.empty()) {
        write_file_atomically(page.written, document);
        if (!page.data.empty()) {
            write_file_atomically(page.data, data);
        }
    }
    if (page.checked.empty()) {
        return;
    }
    check(page.checked, document);
    if (!page.data.empty()) {
        check(page.data, data);
    }
}

void require_in_page(const std::filesystem::path& page, const std::string& part, const std::string& what,
                     const std::string& renewed_by) {
    if (!page.empty() && read_whole_file(page).find(part) == std::string::npos) {
        throw std::runtime_error(
            fmt::format("{} does not hold these {}; {} renews it", page.string(), what, renewed_by));
    }
}

}  // namespace sil
