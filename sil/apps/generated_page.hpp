// Generated page: a page of the documentation that holds the figures of a run, and its data file.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

namespace sil {

struct GeneratedPage {
    std::filesystem::path written{};  // empty: not asked for
    std::filesystem::path checked{};
    std::filesystem::path data{};  // written or checked with the page
};

// --document, --check and --data.
void add_page_options(CLI::App& command, GeneratedPage& page);

// Throws std::runtime_error with the first difference when page or data hold other figures.
void write_or_check(const GeneratedPage& page, const std::string& document, const std::string& data);

// For a page that holds more than this run: throws std::runtime_error when it does not hold `part`, which is
// called `what` and written by `renewed_by`. Without a page (an empty path) nothing is compared.
void require_in_page(const std::filesystem::path& page, const std::string& part, const std::string& what,
                     const std::string& renewed_by);

}  // namespace sil
