// Contradiction: a value that is wrong in a sound frame, where the other sensors show it, and how soon.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "sil/studies/faults/fault.hpp"
#include "sil/studies/faults/scene.hpp"

namespace sil {

// It need not show there: the vehicle's motion does not separate it from the right value.
inline constexpr int hidden = -1;

// A lapse of any length: only the beginning shows.
inline constexpr int any_time_ms = std::numeric_limits<int>::max();

struct Contradiction {
    FaultKind kind{};
    FaultPlace place{};
    // One for each kind of scene but `over`, from the least visible error to the reaction.
    std::array<int, scene_count - 1U> limits_ms{};
    std::string why{};  // parts of the time, or the reason that nothing shows
    int lapse_ms{0};    // after the first code and while the fault is there, no longer without one
    int wrong_ms{100};  // where it is hidden, the longest time of a wrong statement
    int late_ms{100};   // where it is hidden, how much later a due warning may come
    int sign{0};        // of the error of which it is stated; 0: of either
};

// Every kind of fault that lets a value contradict others, of every signal that can have it: those of
// sil/studies/faults/contradictions.toml.
const std::vector<Contradiction>& contradictions();

// That of the scene; of `over`, in which the fault begins between them, the longer one of `before_turn` and
// `steering`.
int limit_of(const Contradiction& stated, SceneKind scene);

// Throws std::logic_error when there is none.
const Contradiction& contradiction_of(const Fault& fault);

}  // namespace sil
