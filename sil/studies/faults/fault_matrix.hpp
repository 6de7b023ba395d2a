// Fault matrix: every fault in every scene.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/studies/faults/judgement.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

struct Injection {
    Fault fault{};
    std::size_t scene{0U};  // of FaultMatrix::scenes
    Reaction reaction{};
    Verdict verdict{};
};

// All signs of one fault in all scenes of one name.
using FaultCell = std::vector<Injection>;

struct FaultRow {
    Fault fault{};
    std::vector<FaultCell> cells{};  // one a column
};

struct FaultMatrix {
    std::vector<Scene> scenes{};  // of a name one after the other
    std::vector<FaultRow> rows{};
    std::vector<FaultCell> sizes{};  // offsets and drifts, each size of them in each J-turn
    int lead_ms{0};                  // in those without a fault
};

// Runs them all in process. Throws std::invalid_argument when the calibration is refused.
FaultMatrix run_fault_matrix(const VehicleParameters& vehicle, const rsi::Parameters& calibration);

// Counts of injections.
struct InjectionCount {
    std::size_t all{0U};
    std::size_t as_expected{0U};
    std::size_t invisible{0U};         // of these: no value was ever wrong by the least visible error
    std::size_t known_undetected{0U};  // late or silent because of a known undetected error
    std::size_t with_due_warning{0U};  //
    std::size_t silenced{0U};          // of these: "ready" without a code, for a cycle or more
    std::size_t silenced_known_undetected{0U};  // of those: by such an error
};
InjectionCount count_injections(const FaultMatrix& matrix);

// docs/reports/safety/fault_matrix.md.
std::string fault_matrix_document(const FaultMatrix& matrix);

// docs/reports/data/fault_matrix.csv: a row for each injection.
std::string fault_matrix_data(const FaultMatrix& matrix);

}  // namespace sil
