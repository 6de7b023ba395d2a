// Drive names: what the folders of many drives' results are called.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sil {

// A file's name without its ending. If several have the same (every run leaves a signals.csv), the folder's
// name precedes it, and if that is not enough a number follows.
std::vector<std::string> drive_names(const std::vector<std::filesystem::path>& files);

}  // namespace sil
