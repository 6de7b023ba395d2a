// Who may know whom: the includes that each folder of the tree is allowed.
#pragma once

#include <string>
#include <vector>

namespace rsi_test {

// Why the file `path` (relative to the project, with /) may not include `header`; empty when it may.
std::string objection(const std::string& path, const std::string& header);

// "path:line: ..." for every forbidden include in the source files under `root`.
std::vector<std::string> forbidden_includes(const std::string& root);

}  // namespace rsi_test
