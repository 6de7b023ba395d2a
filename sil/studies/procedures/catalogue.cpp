// Catalogue: a new procedure is one file and one line here and in the header.
#include "sil/studies/procedures/catalogue.hpp"

#include <string>

namespace sil {

std::vector<Procedure> all_procedures() {
    return {sine_with_dwell_procedure(), fishhook_1a_procedure(), fishhook_1b_procedure(),
            j_turn_procedure(),          tilt_table_procedure(),  steady_circle_procedure()};
}

Procedure find_procedure(std::string_view name) {
    std::string known;
    for (Procedure& procedure : all_procedures()) {
        if (procedure.name == name) {
            return procedure;
        }
        known += (known.empty() ? "" : ", ") + procedure.name;
    }
    throw UnknownProcedure("There is no procedure '" + std::string{name} + "'. Choose one of: " + known +
                           ".");
}

}  // namespace sil
