// Drive names: what the folders of many drives' results are called.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sil {

// A file's name without its ending. Where several have the same (every run leaves a signals.csv), the
// folder's name stands in front of it, and where that is not enough a number behind it.
std::vector<std::string> drive_names(const std::vector<std::filesystem::path>& files);

}  // namespace sil
