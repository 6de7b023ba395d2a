// Search report: what a fault search has found, by class.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sil/studies/faults/fault_search.hpp"
#include "sil/studies/faults/known_findings.hpp"

namespace sil {

struct FoundClass {
    FindingClass found{};
    std::vector<std::uint64_t> scenarios{};
};

struct SearchReport {
    std::uint64_t seed{0U};
    std::uint64_t scenarios{0U};
    std::uint64_t visible{0U};
    std::uint64_t told{0U};
    std::uint64_t due{0U};
    std::vector<FoundClass> found{};  // most frequent first
};

SearchReport report_on(const std::vector<SearchOutcome>& outcomes, std::uint64_t seed);

// Classes that are not known, each with a scenario; empty when all are.
std::vector<std::string> unknown_findings(const SearchReport& report);

// Findings known by searches alone that are not in these reports: remove them from the list.
std::vector<std::string> vanished_findings(const std::vector<SearchReport>& reports);

// The part of the page on one search, and docs/reports/safety/fault_search.md with these parts.
std::string search_section(const SearchReport& report);
std::string search_document(const std::string& sections);

}  // namespace sil
