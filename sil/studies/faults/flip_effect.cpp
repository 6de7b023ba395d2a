#include "sil/studies/faults/flip_effect.hpp"

#include <algorithm>
#include <array>

namespace sil {
namespace {

constexpr std::size_t tolerated_cycles = 5U;  // 50 ms
constexpr std::size_t reported_within = 10U;  // 100 ms

// Whether `side` is warned of within 50 ms of the cycle.
bool is_warned(const std::vector<Statement>& statements, std::size_t cycle, WarningSide side) {
    const std::size_t begin = cycle - std::min(cycle, tolerated_cycles);
    const std::size_t end = std::min(cycle + tolerated_cycles + 1U, statements.size());
    for (std::size_t near = begin; near < end; ++near) {
        if (statements[near].side == side) {
            return true;
        }
    }
    return false;
}

bool says_more(const Statement& statement, const Statement& undisturbed) {
    return (statement.state == WarningState::unavailable && undisturbed.state != WarningState::unavailable) ||
           statement.degradation != undisturbed.degradation || (statement.codes & ~undisturbed.codes).any() ||
           !statement.sound;
}

bool is_reported(const std::vector<Statement>& statements, const std::vector<Statement>& undisturbed,
                 std::size_t cycle) {
    const std::size_t begin = cycle - std::min(cycle, reported_within);
    const std::size_t end = std::min(cycle + reported_within + 1U, statements.size());
    for (std::size_t near = begin; near < end; ++near) {
        if (says_more(statements[near], undisturbed[near])) {
            return true;
        }
    }
    return false;
}

// Whether the warning that is due in this cycle comes before its end.
bool comes_later(const std::vector<Statement>& statements, const std::vector<Statement>& undisturbed,
                 std::size_t cycle) {
    const WarningSide side = undisturbed[cycle].side;
    for (std::size_t later = cycle; later < statements.size() && undisturbed[later].side == side; ++later) {
        if (statements[later].side == side) {
            return true;
        }
    }
    return false;
}

FlipEffect effect_in_cycle(const std::vector<Statement>& statements,
                           const std::vector<Statement>& undisturbed, std::size_t cycle) {
    const WarningSide said = statements[cycle].side;
    const WarningSide due = undisturbed[cycle].side;
    const bool is_false = said != WarningSide::none && !is_warned(undisturbed, cycle, said);
    const bool is_missing = due != WarningSide::none && !is_warned(statements, cycle, due);
    if (!is_false && !is_missing) {
        return (statements[cycle] == undisturbed[cycle]) ? FlipEffect::none : FlipEffect::in_time;
    }
    if (is_reported(statements, undisturbed, cycle)) {
        return FlipEffect::told;
    }
    if (is_false) {
        return FlipEffect::false_warning;
    }
    return comes_later(statements, undisturbed, cycle) ? FlipEffect::late : FlipEffect::missing;
}

}  // namespace

bool Statement::operator==(const Statement& other) const {
    return state == other.state && side == other.side && degradation == other.degradation &&
           codes == other.codes && sound == other.sound;
}

const char* to_string(FlipEffect effect) {
    constexpr std::array<const char*, flip_effect_count> names{"none", "in time", "told",
                                                               "late", "missing", "false"};
    return names[static_cast<std::size_t>(effect)];
}

FlipEffect effect_of(const std::vector<Statement>& statements, const std::vector<Statement>& undisturbed,
                     std::size_t begin) {
    FlipEffect worst = FlipEffect::none;
    for (std::size_t cycle = begin; cycle < statements.size(); ++cycle) {
        worst = std::max(worst, effect_in_cycle(statements, undisturbed, cycle));
    }
    return worst;
}

}  // namespace sil
