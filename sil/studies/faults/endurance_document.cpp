// The endurance page.
#include <fmt/format.h>

#include "page_templates.hpp"
#include "sil/studies/faults/endurance.hpp"
#include "sil/studies/faults/page_template.hpp"

namespace sil {

std::string endurance_row(const EnduranceSettings& settings, const EnduranceResult& result) {
    return fmt::format(
        "| {:g} | {} | {} ({}) | {} | {} | {} | {} | {} / {} / {} | {} | {} | {} | {} | {} of {} | {:.3f} | "
        "{:.3f} |\n",
        settings.hours, settings.seed, result.faults, result.pairs, result.stops, result.rollovers,
        result.warnings_due, result.due_with_fault, result.due_with_fault_warned,
        result.due_with_fault_reported, result.due_with_fault_silenced, result.silenced_by.size(),
        result.longest_silence_ms,
        result.incomplete_cycles + result.undefined_cycles + result.unfed_cycles + result.bad_outputs,
        fmt::format("{}{}", result.longest_recovery_ms,
                    result.not_recovered_from.empty()
                        ? ""
                        : fmt::format(", {} not", result.not_recovered_from.size())),
        result.recovered_at_standstill, result.over_at_standstill, result.largest_roll_centre_deviation_m,
        result.largest_roll_centre_movement_m);
}

std::string endurance_document(const std::string& rows) {
    return fill_template(endurance_template, {{"rows", rows}});
}

}  // namespace sil
