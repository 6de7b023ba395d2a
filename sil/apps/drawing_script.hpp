// Drawing script: a script of the project that draws what a command has left in a folder.
#pragma once

#include <filesystem>
#include <string>

namespace sil {

// The path of a script of the project that draws, by its name in the project: looked for in the folders above
// this program, which lies in a build folder (build/release/sil) or in a release (programs). Throws
// std::runtime_error when there is none.
std::string drawing_script(const std::string& name);

// Runs the script of that path for the folder. False when it cannot be started, or fails.
bool is_drawn(std::string script, const std::filesystem::path& folder);

}  // namespace sil
