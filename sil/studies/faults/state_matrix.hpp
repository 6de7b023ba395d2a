// State matrix: faults at rest, at a crawl, from the ECU's start on and long before they matter; second
// senders; and sensors that are good, though slow, coarse, late or noisy.
#pragma once

#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/studies/faults/driving_state.hpp"
#include "sil/studies/faults/finding.hpp"
#include "sil/studies/faults/judgement.hpp"
#include "sil/studies/faults/known_findings.hpp"

namespace sil {

struct StateOutcome {
    std::string name{};  // of the fault, with its size and sign, or of the sensors
    Reaction reaction{};
    std::vector<FindingKind> findings{};
};

// All signs of one fault in one state; empty where it is not injected.
using StateCell = std::vector<StateOutcome>;

struct StateRow {
    Fault fault{};                   // kind `none`: good sensors
    std::string sensors{};           // those
    std::vector<StateCell> cells{};  // one a state
};

struct StateMatrix {
    std::vector<DrivingState> states{};
    std::vector<StateRow> rows{};
    std::vector<DrivingState> states_of_offsets{};
    std::vector<StateRow> rows_of_offsets{};
    std::vector<DrivingState> states_of_good_sensors{};
    std::vector<StateRow> rows_of_good_sensors{};
};

// Runs them all in process. Throws std::invalid_argument when the calibration is refused.
StateMatrix run_state_matrix(const VehicleParameters& vehicle, const rsi::Parameters& calibration);

// All of its findings.
std::vector<CellFinding> findings_in(const StateMatrix& matrix);

// docs/reports/safety/fault_states.md.
std::string state_matrix_document(const StateMatrix& matrix);

// docs/reports/data/fault_states.csv: a row for each run.
std::string state_matrix_data(const StateMatrix& matrix);

}  // namespace sil
