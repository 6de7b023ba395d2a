// Whole files: reading one, and replacing one so that nobody ever sees half of it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace sil {

// Every byte of `path`. Throws InputError that names the path and the system's reason.
std::string read_whole_file(const std::filesystem::path& path);

// Writes `content` into a temporary file beside `path` and renames it over `path`. Throws std::runtime_error
// that names the path and the system's reason; `path` is then as it was.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace sil
