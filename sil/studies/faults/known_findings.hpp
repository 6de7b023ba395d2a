// Known findings: those of sil/studies/faults/known_findings.toml. The state matrix must have exactly these,
// and the search no others.
#pragma once

#include <string>
#include <vector>

#include "sil/studies/faults/fault.hpp"
#include "sil/studies/faults/finding.hpp"

namespace sil {

// A finding and its fault, of any size; for good sensors the fault's kind is `none`.
struct FindingClass {
    FindingKind kind{};
    FaultKind fault{};
    FaultPlace place{};
};
bool operator==(const FindingClass& left, const FindingClass& right);
std::string describe(const FindingClass& found);

struct CellFinding {
    FindingClass found{};
    std::string cell{};  // "gain, 0.5 | rest"
};

struct KnownFinding {
    FindingClass found{};
    std::vector<std::string> cells{};  // of the state matrix; none: only the search has it
    std::string why{};                 // begins with "open" where it is to be mended
};

const std::vector<KnownFinding>& known_findings();

bool is_known(const FindingClass& found);

// Findings that are not known, or known and not found, each in a few words; empty when the list is exact.
std::vector<std::string> differences(const std::vector<CellFinding>& found,
                                     const std::vector<KnownFinding>& known = known_findings());

}  // namespace sil
