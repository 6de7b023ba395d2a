// A page of the documentation from its template.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace sil {

// Replaces each {{name}} by its value. Throws std::invalid_argument when the template asks for a value that
// is not given, or a given one is not asked for.
std::string fill_template(std::string_view page, const std::map<std::string, std::string>& values);

}  // namespace sil
