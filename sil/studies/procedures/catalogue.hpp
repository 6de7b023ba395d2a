// Catalogue: all procedures by name.
#pragma once

#include <stdexcept>
#include <string_view>
#include <vector>

#include "sil/studies/procedures/procedure.hpp"

namespace sil {

// The message lists the procedures that exist.
class UnknownProcedure : public std::invalid_argument {
 public:
    using std::invalid_argument::invalid_argument;
};

Procedure sine_with_dwell_procedure();
Procedure fishhook_1a_procedure();
Procedure fishhook_1b_procedure();
Procedure j_turn_procedure();
Procedure tilt_table_procedure();
Procedure steady_circle_procedure();

// In the order in which a list should show them.
std::vector<Procedure> all_procedures();

// Throws UnknownProcedure.
Procedure find_procedure(std::string_view name);

}  // namespace sil
