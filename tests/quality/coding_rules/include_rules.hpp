// Rules of dependency: the includes that each folder of the tree is allowed, and the paths in its CMake
// files.
#pragma once

#include <string>
#include <vector>

namespace rsi_test {

// Why the file `path` (relative to the project, with /) may not include `header`; empty when it may.
std::string objection(const std::string& path, const std::string& header);

// Why the CMake file `path` may not have the line `line`, because of a path in it; empty when it may.
std::string cmake_objection(const std::string& path, const std::string& line);

// "path:line: ..." for every forbidden include in the source files under `root`, and every forbidden path in
// the CMake files.
std::vector<std::string> forbidden_includes(const std::string& root);

// "path:line: ..." for an include of each pair of folders that lies on a circle. A folder stands for all that
// is in it, and is compared with those beside it, at every depth under `root`.
std::vector<std::string> folder_circles(const std::string& root);

// The headers of the product that only tests include, or nothing but their own source.
std::vector<std::string> headers_without_user(const std::string& root);

}  // namespace rsi_test
