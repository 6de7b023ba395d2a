// Catalogue: all manoeuvres by name.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {

// The message lists the manoeuvres that exist.
class UnknownManoeuvre : public std::invalid_argument {
 public:
    using std::invalid_argument::invalid_argument;
};

// In the order in which a list should show them.
std::vector<Manoeuvre> all_manoeuvres();
// Those in which nothing but driver and road acts on the vehicle: not `is_disturbed`.
std::vector<Manoeuvre> undisturbed_manoeuvres();

// Throws UnknownManoeuvre.
Manoeuvre find_manoeuvre(std::string_view name);

}  // namespace sil
