// Warnings: what a user should know about a fit, in plain words.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sil {

struct Identification;
struct PreparedDrive;

// Doubt about a drive's straight start: it has none, or its sensors are not at zero there.
std::optional<std::string> straight_start_doubt(const PreparedDrive& drive);

std::vector<std::string> identification_warnings(const Identification& result);

}  // namespace sil
