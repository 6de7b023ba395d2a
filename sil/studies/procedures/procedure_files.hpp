// Procedure files: what a procedure leaves.
#pragma once

#include <filesystem>
#include <string>

#include "sil/studies/procedures/procedure.hpp"

namespace sil {

// A JSON object: procedure, description, sources, vehicle, outcome, verdict, before and results (lists of
// figures), steps, notes, versions. A step has series, name, figures, criteria and ecu. Values that are not
// there are null; numbers are rounded to nine decimals.
std::string result_json(const Procedure& procedure, const std::string& vehicle,
                        const ProcedureResult& result);

// A header and a row a step: series, step, the keys of its figures; for each criterion its key (if no figure
// has it), KEY_limit and KEY_met (1, 0, empty where the rule does not ask); what the ECU said.
std::string steps_csv(const ProcedureResult& result);

// result.json and steps.csv. Throws std::runtime_error with path and reason.
void write_procedure(const Procedure& procedure, const std::string& vehicle, const ProcedureResult& result,
                     const std::filesystem::path& folder);

// Makes the folder and removes those of an earlier procedure: they must not be taken for those of this one,
// should it fail.
void prepare_procedure_folder(const std::filesystem::path& folder);

}  // namespace sil
