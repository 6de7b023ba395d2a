#include "sil/studies/faults/fault_matrix.hpp"

#include <array>
#include <stdexcept>

#include "sil/simulation/pace.hpp"
#include "sil/studies/faults/known_undetected.hpp"

namespace sil {
namespace {

std::size_t due_warning(const Scene& scene, const rsi::Parameters& calibration) {
    const FaultyRun right = run_with_fault(scene, Fault{}, calibration);
    for (std::size_t cycle = 0U; cycle < right.answers.size(); ++cycle) {
        if (right.answers[cycle]->state == WarningState::warning) {
            return cycle;
        }
    }
    throw std::runtime_error("the ECU does not warn in the scene \"" + scene.name +
                             "\": the calibration does not belong to the vehicle");
}

std::vector<Scene> all_scenes(const VehicleParameters& vehicle, const rsi::Parameters& calibration) {
    std::vector<Scene> scenes = record_scenes(vehicle);
    const Scene before_turn = scenes.back();
    for (Scene& scene : scenes_at_warning(before_turn, due_warning(before_turn, calibration))) {
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

void inject_all(FaultMatrix& matrix, std::size_t scene_index, const rsi::Parameters& calibration) {
    const Scene& scene = matrix.scenes[scene_index];
    const RightRuns right{scene, calibration};
    const bool new_column = scene_index == 0U || matrix.scenes[scene_index - 1U].name != scene.name;
    for (FaultRow& row : matrix.rows) {
        if (new_column) {
            row.cells.emplace_back();
        }
        for (const Fault& fault : in_each_sign(row.fault)) {
            Injection injection{fault, scene_index, {}, {}};
            injection.reaction =
                measure(scene, fault, right.of(fault), run_with_fault(scene, fault, calibration));
            injection.verdict = judge(expectation_of(fault, scene.kind), injection.reaction);
            row.cells.back().push_back(std::move(injection));
        }
    }
}

// How large an error may be: shares of that of the matrix.
constexpr std::array size_shares{0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 3.0};

std::vector<Fault> errors_of_all_sizes() {
    std::vector<Fault> errors;
    for (const Fault& fault : all_faults()) {
        for (const Fault& each : in_each_sign(fault)) {
            if (fault.kind == FaultKind::offset || fault.kind == FaultKind::drift) {
                for (const double share : size_shares) {
                    errors.push_back({each.kind, each.place, each.magnitude * share});
                }
            }
        }
    }
    return errors;
}

// In each scene in which the error is there while the warning is due.
void inject_sizes(FaultMatrix& matrix, const rsi::Parameters& calibration) {
    const std::vector<Fault> errors = errors_of_all_sizes();
    matrix.sizes.assign(errors.size(), {});
    for (std::size_t index = 0U; index < matrix.scenes.size(); ++index) {
        const Scene& scene = matrix.scenes[index];
        if (scene.kind < SceneKind::before_turn || scene.kind >= SceneKind::over) {
            continue;
        }
        const RightRuns right{scene, calibration};
        for (std::size_t error = 0U; error < errors.size(); ++error) {
            const Fault& fault = errors[error];
            matrix.sizes[error].push_back(
                {fault,
                 index,
                 measure(scene, fault, right.of(fault), run_with_fault(scene, fault, calibration)),
                 {}});
        }
    }
}

void count(const Injection& injection, InjectionCount& counted) {
    const bool good = injection.verdict.shortfalls.empty();
    const bool known_undetected = !injection.verdict.known_undetected.empty();
    const bool silenced = silences_a_warning(injection.reaction);
    ++counted.all;
    counted.as_expected += good && !known_undetected ? 1U : 0U;
    counted.invisible += good && !known_undetected && !injection.reaction.visible ? 1U : 0U;
    counted.known_undetected += good && known_undetected ? 1U : 0U;
    counted.with_due_warning += injection.reaction.warning_due ? 1U : 0U;
    counted.silenced += silenced ? 1U : 0U;
    counted.silenced_known_undetected += silenced && good && known_undetected ? 1U : 0U;
}

}  // namespace

FaultMatrix run_fault_matrix(const VehicleParameters& vehicle, const rsi::Parameters& calibration) {
    FaultMatrix matrix;
    matrix.scenes = all_scenes(vehicle, calibration);
    for (const std::vector<Fault>& faults : {all_faults(), mass_faults()}) {
        for (const Fault& fault : faults) {
            matrix.rows.push_back({fault, {}});
        }
    }
    for (std::size_t scene = 0U; scene < matrix.scenes.size(); ++scene) {
        inject_all(matrix, scene, calibration);
    }
    inject_sizes(matrix, calibration);
    const Scene& turn = matrix.scenes.back();
    matrix.lead_ms = static_cast<int>(turn.two_wheel_lift.value_or(0U) - due_warning(turn, calibration)) * 10;
    return matrix;
}

InjectionCount count_injections(const FaultMatrix& matrix) {
    InjectionCount counted;
    for (const FaultRow& row : matrix.rows) {
        for (const FaultCell& cell : row.cells) {
            for (const Injection& injection : cell) {
                count(injection, counted);
            }
        }
    }
    return counted;
}

}  // namespace sil
