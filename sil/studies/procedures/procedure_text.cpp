#include "sil/studies/procedures/procedure_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sil {
namespace {

std::string with_unit(double value, int decimals, const std::string& unit) {
    return fmt::format("{:.{}f}{}{}", value, decimals, unit.empty() ? "" : " ", unit);
}

std::string named(const Figure& figure) {
    return fmt::format("{} {}", figure.name, figure_text(figure));
}

std::string state_and_side(WarningState state, WarningSide side) {
    return side == WarningSide::none ? to_string(state)
                                     : fmt::format("{} {}", to_string(state), to_string(side));
}

std::string warning_at_lift_off(const WarningBeside& warning) {
    if (warning.lead_s) {
        return fmt::format("warning {}, {:.2f} s before lift-off", to_string(warning.falling_side),
                           *warning.lead_s);
    }
    const std::string reported = state_and_side(warning.state_at_lift_off, warning.side_at_lift_off);
    return fmt::format("NOT warned: {} as the vehicle falls to the {}", reported,
                       to_string(warning.falling_side));
}

std::string criterion_text(const Criterion& criterion) {
    const std::string value = figure_text(criterion.measured);
    const std::string limit =
        with_unit(criterion.limit, criterion.measured.decimals, criterion.measured.unit);
    const char* verdict = !criterion.asked ? "not asked" : (criterion.met() ? "met" : "NOT met");
    return fmt::format("{} {} ({} {}): {}", criterion.measured.name, value, to_string(criterion.bound), limit,
                       verdict);
}

}  // namespace

std::string figure_text(const Figure& figure) {
    return figure.value ? with_unit(*figure.value, figure.decimals, figure.unit) : "-";
}

std::string warning_text(const WarningBeside& warning) {
    if (warning.lifted) {
        return warning_at_lift_off(warning);
    }
    if (warning.first_warning_s) {
        return fmt::format("{}, no two wheels lift",
                           state_and_side(WarningState::warning, warning.first_warning_side));
    }
    return warning.first_advisory_s ? "advisory" : "nothing";
}

std::string head_text(const Procedure& procedure, const VehicleParameters& vehicle) {
    return fmt::format("{}: {}\nafter {}\nvehicle: {}\n\n", procedure.name, procedure.description,
                       fmt::join(procedure.sources, "; "), vehicle.name);
}

std::string step_text(const ProcedureStep& step) {
    std::string text = fmt::format("{}, {}\n", step.series, step.name);
    std::string figures;
    for (const Figure& figure : step.figures) {
        figures += (figures.empty() ? "  " : ", ") + named(figure);
    }
    text += figures + "\n";
    for (const Criterion& criterion : step.criteria) {
        text += fmt::format("  {}\n", criterion_text(criterion));
    }
    return text + fmt::format("  ECU: {}\n", warning_text(step.warning));
}

std::string result_text(const ProcedureResult& result) {
    std::string text = "\n";
    for (const auto* figures : {&result.before, &result.results}) {
        for (const Figure& figure : *figures) {
            text += fmt::format("  {:<40} {}\n", figure.name, figure_text(figure));
        }
    }
    text += fmt::format("  {:<40} {}: {}\n", "verdict", to_string(result.outcome), result.verdict);
    const auto lifts = std::count_if(result.steps.begin(), result.steps.end(),
                                     [](const ProcedureStep& step) { return step.warning.lifted; });
    const auto warned =
        std::count_if(result.steps.begin(), result.steps.end(),
                      [](const ProcedureStep& step) { return step.warning.lead_s.has_value(); });
    text +=
        fmt::format("  {:<40} {} of {} two-wheel lift-offs warned of, right side\n", "ECU", warned, lifts);
    for (const std::string& note : result.notes) {
        text += fmt::format("  note: {}\n", note);
    }
    return text;
}

}  // namespace sil
