// Procedure text: the account that a reader gets.
#pragma once

#include <string>

#include "sil/studies/procedures/procedure.hpp"

namespace sil {

// "12.3 deg", without the unit where there is none; "-" where there is no value.
std::string figure_text(const Figure& figure);

// Answer of the ECU, in a few words: "warning right, 0.42 s before lift-off".
std::string warning_text(const WarningBeside& warning);

// Each ends with an end of line.
std::string head_text(const Procedure& procedure, const VehicleParameters& vehicle);
std::string step_text(const ProcedureStep& step);
std::string result_text(const ProcedureResult& result);

}  // namespace sil
