// Measured page: a page of the documentation that holds the figures of a run.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

namespace sil {

struct GeneratedPage {
    std::filesystem::path written{};  // empty: not asked for
    std::filesystem::path checked{};
};

// --document and --check.
void add_page_options(CLI::App& command, GeneratedPage& page);

// Throws std::runtime_error with the first difference when the page holds other figures.
void write_or_check(const GeneratedPage& page, const std::string& document);

}  // namespace sil
