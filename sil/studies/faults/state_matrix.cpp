#include "sil/studies/faults/state_matrix.hpp"

#include "sil/studies/faults/good_sensors.hpp"
#include "sil/studies/faults/turned_housings.hpp"

namespace sil {
namespace {

std::vector<StateRow> rows_of_all_faults() {
    std::vector<StateRow> rows;
    for (const std::vector<Fault>& faults :
         {all_faults(), further_faults(), mass_faults(), coupled_faults(), tolerances()}) {
        for (const Fault& fault : faults) {
            rows.push_back({fault, {}, {}});
        }
    }
    return rows;
}

StateCell inject(const DrivingState& state, const Fault& each_sign, const RightRuns& right,
                 const rsi::Parameters& calibration) {
    StateCell cell;
    for (const Fault& fault : in_each_sign(each_sign)) {
        const FaultyRun faulty = run_with_fault(state, fault, calibration);
        cell.push_back({describe(fault), measure(state, fault, right.of(fault), faulty),
                        findings_of(state, fault, right.of(fault), faulty, state.ordinary_end)});
    }
    return cell;
}

void inject_rows(StateMatrix& matrix, const DrivingState& state, const rsi::Parameters& calibration) {
    const RightRuns right{state, calibration};
    for (StateRow& row : matrix.rows) {
        const bool wanted = state.with_frame_faults || is_signal_fault(row.fault.kind);
        row.cells.push_back(wanted ? inject(state, row.fault, right, calibration) : StateCell{});
    }
}

using Record = std::vector<std::vector<DrivingState>> (*)(const VehicleParameters& vehicle,
                                                          const std::vector<SensorOptions>& sensors);

// In every state from the ECU's start on. The states are those of the usual sensors.
std::vector<DrivingState> try_lasting(const std::vector<TurnedHousing>& lasting, Record record,
                                      const VehicleParameters& vehicle, const rsi::Parameters& calibration,
                                      std::vector<StateRow>& rows) {
    std::vector<SensorOptions> sensors{recording_sensors(vehicle)};
    for (const TurnedHousing& each : lasting) {
        sensors.push_back(each.options);
        rows.push_back({each.fault, {}, {}});
    }
    const std::vector<std::vector<DrivingState>> states = record(vehicle, sensors);
    const std::size_t first = rows.size() + 1U - sensors.size();
    for (std::size_t state = 0U; state < states.front().size(); ++state) {
        const FaultyRun right = run_with_fault(states.front()[state], Fault{}, calibration);
        for (std::size_t index = 1U; index < sensors.size(); ++index) {
            DrivingState wrong = states[index][state];
            wrong.fault_begin = 0U;
            StateRow& row = rows[first + index - 1U];
            FaultyRun run = run_with_fault(wrong, Fault{}, calibration);
            run.visible = 0U;
            row.cells.push_back({{describe(row.fault), measure(wrong, Fault{}, right, run),
                                  silent_findings(wrong, right, run)}});
        }
    }
    return states.front();
}

// The first set of sensors is the usual one.
void try_good_sensors(StateMatrix& matrix, const std::vector<std::vector<DrivingState>>& drives,
                      const std::vector<GoodSensors>& good, const rsi::Parameters& calibration) {
    for (std::size_t state = 0U; state < drives.front().size(); ++state) {
        const FaultyRun right = run_with_fault(drives.front()[state], Fault{}, calibration);
        for (std::size_t index = 0U; index < matrix.rows_of_good_sensors.size(); ++index) {
            StateRow& row = matrix.rows_of_good_sensors[index];
            const DrivingState& drive = drives[index + 1U][state];
            FaultyRun other = run_with_fault(drive, Fault{}, good[index].calibration);
            other.visible = 0U;
            row.cells.push_back({{row.sensors, measure(drive, Fault{}, right, other),
                                  findings_of_good_sensors(drive, right, other)}});
        }
    }
}

void collect(const std::vector<StateRow>& rows, const std::vector<DrivingState>& states,
             std::vector<CellFinding>& found) {
    for (const StateRow& row : rows) {
        for (std::size_t state = 0U; state < row.cells.size(); ++state) {
            for (const StateOutcome& outcome : row.cells[state]) {
                for (const FindingKind kind : outcome.findings) {
                    found.push_back(
                        {{kind, row.fault.kind, row.fault.place}, outcome.name + " | " + states[state].name});
                }
            }
        }
    }
}

}  // namespace

StateMatrix run_state_matrix(const VehicleParameters& vehicle, const rsi::Parameters& calibration) {
    const std::vector<GoodSensors> good = good_sensors(recording_sensors(vehicle), calibration);
    std::vector<SensorOptions> sensors{recording_sensors(vehicle)};
    for (const GoodSensors& each : good) {
        sensors.push_back(each.options);
    }
    const std::vector<std::vector<DrivingState>> states = record_states(vehicle, sensors);
    const std::vector<std::vector<DrivingState>> drives = record_drives_of_good_sensors(vehicle, sensors);

    StateMatrix matrix;
    matrix.states = states.front();
    matrix.rows = rows_of_all_faults();
    for (const DrivingState& state : matrix.states) {
        inject_rows(matrix, state, calibration);
    }
    const SensorOptions usual = recording_sensors(vehicle);
    try_lasting(turned_housings(usual), record_states, vehicle, calibration, matrix.rows);
    matrix.states_of_offsets =
        try_lasting(lasting_offsets(usual), record_ten_minutes, vehicle, calibration, matrix.rows_of_offsets);
    for (const GoodSensors& each : good) {
        matrix.rows_of_good_sensors.push_back({Fault{}, each.name, {}});
    }
    matrix.states_of_good_sensors = states.front();
    matrix.states_of_good_sensors.insert(matrix.states_of_good_sensors.end(), drives.front().begin(),
                                         drives.front().end());
    try_good_sensors(matrix, states, good, calibration);
    try_good_sensors(matrix, drives, good, calibration);
    return matrix;
}

std::vector<CellFinding> findings_in(const StateMatrix& matrix) {
    std::vector<CellFinding> found;
    collect(matrix.rows, matrix.states, found);
    collect(matrix.rows_of_offsets, matrix.states_of_offsets, found);
    collect(matrix.rows_of_good_sensors, matrix.states_of_good_sensors, found);
    return found;
}

}  // namespace sil
