#include "sil/faults/fault_matrix.hpp"

#include <stdexcept>

#include "sil/simulation/pace.hpp"

namespace sil {
namespace {

void place_fault_at_warning(Scene& scene, const rsi::Parameters& calibration) {
    const FaultyRun right = run_with_fault(scene, Fault{}, calibration);
    const auto before = static_cast<std::size_t>(before_warning_s / cycle_time_s + 0.5);
    for (std::size_t cycle = before; cycle < right.answers.size(); ++cycle) {
        if (right.answers[cycle]->state == WarningState::warning) {
            scene.fault_begin = cycle - before;
            return;
        }
    }
    throw std::runtime_error("the ECU does not warn in the scene \"" + scene.name +
                             "\": the calibration does not belong to the vehicle");
}

}  // namespace

FaultMatrix run_fault_matrix(const VehicleParameters& vehicle, const rsi::Parameters& calibration) {
    FaultMatrix matrix;
    matrix.scenes = record_scenes(vehicle);
    for (const Fault& fault : all_faults()) {
        matrix.rows.push_back({fault, {}});
    }
    for (Scene& scene : matrix.scenes) {
        if (scene.kind == SceneKind::warning) {
            place_fault_at_warning(scene, calibration);
        }
        const FaultyRun without_bank = run_with_fault(scene, Fault{}, calibration);
        const FaultyRun with_bank =
            run_with_fault(scene, Fault{FaultKind::none, FaultPlace::bank_angle, 0.0}, calibration);
        for (FaultRow& row : matrix.rows) {
            const FaultyRun& right = row.fault.place == FaultPlace::bank_angle ? with_bank : without_bank;
            FaultCell cell;
            cell.reaction = measure(scene, row.fault, right, run_with_fault(scene, row.fault, calibration));
            cell.shortfalls = shortfalls(expectation_of(row.fault, scene.kind), cell.reaction);
            row.cells.push_back(std::move(cell));
        }
    }
    return matrix;
}

CellCount count_cells(const FaultMatrix& matrix) {
    CellCount count;
    for (const FaultRow& row : matrix.rows) {
        for (const FaultCell& cell : row.cells) {
            ++count.all;
            count.as_expected += cell.shortfalls.empty() ? 1U : 0U;
            count.with_due_warning += cell.reaction.warning_due ? 1U : 0U;
            count.silenced += silences_a_warning(cell.reaction) ? 1U : 0U;
        }
    }
    return count;
}

}  // namespace sil
