// Fault matrix: every fault in every scene.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/faults/judgement.hpp"
#include "sil/vehicle/parameters.hpp"

namespace sil {

struct FaultCell {
    Reaction reaction{};
    std::vector<std::string> shortfalls{};  // empty: as expected
    std::optional<std::size_t> known{};     // why it falls short: the first entry of known_shortfalls()
};

struct FaultRow {
    Fault fault{};
    std::vector<FaultCell> cells{};  // one a scene
};

struct FaultMatrix {
    std::vector<Scene> scenes{};
    std::vector<FaultRow> rows{};
};

// Runs them all in process. Throws std::invalid_argument when the calibration is refused.
FaultMatrix run_fault_matrix(const VehicleParameters& vehicle, const rsi::Parameters& calibration);

struct CellCount {
    std::size_t all{0U};
    std::size_t as_expected{0U};
    std::size_t surprising{0U};  // fall short and are not known to
};
CellCount count_cells(const FaultMatrix& matrix);

// Entries of known_shortfalls() that no cell needs any longer, by their sentence and kind.
std::vector<std::string> needless_entries(const FaultMatrix& matrix);

// docs/safety/fault_matrix.md.
std::string fault_matrix_document(const FaultMatrix& matrix);

}  // namespace sil
