// Warnings: what a user should know about a fit, in plain words.
#pragma once

#include <string>
#include <vector>

namespace sil {

struct Identification;

std::vector<std::string> identification_warnings(const Identification& result);

}  // namespace sil
