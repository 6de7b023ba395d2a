// Flip effect: what a bit that changes in memory does to the warning.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sil/studies/faults/ecu_answer.hpp"

namespace sil {

// Compared part of a cycle's answer.
struct Statement {
    WarningState state{};
    WarningSide side{};  // of a warning, else none
    Degradation degradation{};
    DiagnosticCodes codes{};
    bool sound{true};  // all frames there, and the watchdog fed

    bool operator==(const Statement& other) const;
};

// Answers of the ECU from the flip to the end of the drive, compared with the same drive without it. A
// warning is one towards a side; it is in time when the undisturbed one is there within 50 ms before or
// after.
enum class FlipEffect : std::uint8_t {
    none,           // every cycle says the same
    in_time,        // another statement in some cycle, but no other warning by more than 50 ms
    told,           // another warning, and within 100 ms of it the frames say that something is wrong
    late,           // silently: a due warning comes, but later, or pauses
    missing,        // silently: a due warning does not come, or ends too early
    false_warning,  // silently: one that is not due, or lasts longer
};
inline constexpr std::size_t flip_effect_count = 6U;
const char* to_string(FlipEffect effect);
constexpr bool is_silent(FlipEffect effect) {
    return effect >= FlipEffect::late;
}

// The worst of all cycles from `begin` on. Both have one statement a cycle.
FlipEffect effect_of(const std::vector<Statement>& statements, const std::vector<Statement>& undisturbed,
                     std::size_t begin);

}  // namespace sil
