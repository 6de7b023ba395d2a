// Fault matrix: every fault in every scene.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/faults/judgement.hpp"
#include "sil/vehicle/parameters.hpp"

namespace sil {

struct FaultCell {
    Reaction reaction{};
    std::vector<std::string> shortfalls{};  // empty: as expected
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
    std::size_t with_due_warning{0U};
    std::size_t silenced{0U};  // of these: "ready" without a code instead
};
CellCount count_cells(const FaultMatrix& matrix);

// docs/safety/fault_matrix.md.
std::string fault_matrix_document(const FaultMatrix& matrix);

}  // namespace sil
