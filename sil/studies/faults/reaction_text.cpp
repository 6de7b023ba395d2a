// Reactions as text.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "sil/studies/faults/judgement.hpp"

namespace sil {
namespace {

using Reactions = std::vector<Reaction>;
using Time = std::optional<int> Reaction::*;

std::string of_how_many(std::size_t count, const Reactions& reactions) {
    return count == reactions.size() ? "" : fmt::format(" ({} of {})", count, reactions.size());
}

std::size_t count_of(const Reactions& reactions, const std::function<bool(const Reaction&)>& is_so) {
    return static_cast<std::size_t>(std::count_if(reactions.begin(), reactions.end(), is_so));
}

std::optional<int> slowest(const Reactions& reactions, Time time) {
    std::optional<int> found;
    for (const Reaction& reaction : reactions) {
        if (reaction.*time) {
            found = std::max(found.value_or(*(reaction.*time)), *(reaction.*time));
        }
    }
    return found;
}

int longest(const Reactions& reactions, int Reaction::* time) {
    int found = 0;
    for (const Reaction& reaction : reactions) {
        found = std::max(found, reaction.*time);
    }
    return found;
}

// Different errors of one fault are found by different checks.
std::string code_names(const Reactions& reactions) {
    std::vector<std::string> names;
    for (const Reaction& reaction : reactions) {
        if (reaction.code && std::find(names.begin(), names.end(), reaction.code_name) == names.end()) {
            names.push_back(reaction.code_name);
        }
    }
    return fmt::format("{}", fmt::join(names, " or "));
}

// "warning -80 to +20", "no warning (1 of 3)".
std::vector<std::string> describe_warning(const Reactions& reactions) {
    std::vector<std::string> parts;
    std::vector<int> losses;
    for (const Reaction& reaction : reactions) {
        if (reaction.lead_loss) {
            losses.push_back(*reaction.lead_loss);
        }
    }
    if (!losses.empty()) {
        const auto [least, most] = std::minmax_element(losses.begin(), losses.end());
        parts.push_back(*least == *most ? fmt::format("warning {:+}", *most)
                                        : fmt::format("warning {:+} to {:+}", *least, *most));
    }
    const std::size_t missed = count_of(reactions, [](const Reaction& each) { return each.warning_missed; });
    if (missed > 0U) {
        parts.push_back("no warning" + of_how_many(missed, reactions));
    }
    return parts;
}

}  // namespace

std::string describe(const std::vector<Reaction>& reactions) {
    std::vector<std::string> parts;
    const auto add = [&](const std::string& what, Time time) {
        const std::optional<int> found = slowest(reactions, time);
        if (found) {
            const std::size_t count =
                count_of(reactions, [time](const Reaction& each) { return (each.*time).has_value(); });
            parts.push_back(fmt::format("{} {}{}", what, *found, of_how_many(count, reactions)));
        }
    };
    add("unavailable", &Reaction::unavailable);
    add("observer", &Reaction::observer);
    add("motion lost", &Reaction::motion_lost);
    add(code_names(reactions), &Reaction::code);
    if (parts.empty()) {
        const bool visible = count_of(reactions, [](const Reaction& each) { return each.visible; }) > 0U;
        parts.emplace_back(visible ? "nothing" : "not visible");
    }
    const auto add_longest = [&](const char* what, int Reaction::* time) {
        if (longest(reactions, time) > 0) {
            parts.push_back(fmt::format("{} {}", what, longest(reactions, time)));
        }
    };
    add_longest("false warning for", &Reaction::false_warning);
    const std::vector<std::string> warning = describe_warning(reactions);
    parts.insert(parts.end(), warning.begin(), warning.end());
    add_longest("**ready without a code**", &Reaction::silence);
    const std::optional<int> recovery = slowest(reactions, &Reaction::recovery);
    if (recovery) {
        parts.push_back(fmt::format("back {}", *recovery));
    }
    if (slowest(reactions, &Reaction::healing).value_or(0) > 0) {
        parts.push_back(fmt::format("codes gone {}", *slowest(reactions, &Reaction::healing)));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace sil
