// Summary facts: what a run came to, as people read it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sil/results/summary.hpp"

namespace sil {

// "in real time", ...
const char* pace_name(bool in_process, bool lock_step);

// Names and values, for a table. An event that is missing is "did not happen".
std::vector<std::pair<std::string, std::string>> summary_facts(const Summary& summary);

}  // namespace sil
