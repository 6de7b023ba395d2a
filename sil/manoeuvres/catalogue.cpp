// Catalogue: a new manoeuvre is one file and one line in each of the two lists here.
#include "sil/manoeuvres/catalogue.hpp"

namespace sil {

Manoeuvre j_turn_45();
Manoeuvre j_turn_110();
Manoeuvre straight();
Manoeuvre slalom();

std::vector<Manoeuvre> all_manoeuvres() {
    return {
        j_turn_110(),
        j_turn_45(),
        straight(),
        slalom(),
    };
}

Manoeuvre find_manoeuvre(std::string_view name) {
    std::string known;
    for (Manoeuvre& manoeuvre : all_manoeuvres()) {
        if (manoeuvre.name == name) {
            return manoeuvre;
        }
        known += (known.empty() ? "" : ", ") + manoeuvre.name;
    }
    throw UnknownManoeuvre("There is no manoeuvre '" + std::string{name} + "'. Choose one of: " + known +
                           ".");
}

}  // namespace sil
