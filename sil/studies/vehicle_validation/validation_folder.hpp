// Validation folder: the drives of a real vehicle, and what each of them is for.
#pragma once

#include <filesystem>
#include <vector>

namespace sil {

inline constexpr const char* vehicle_data_name = "vehicle.toml";

struct ValidationFolder {
    std::filesystem::path vehicle_data{};           // vehicle.toml
    std::vector<std::filesystem::path> ramps{};     // ramp*.csv
    std::vector<std::filesystem::path> dynamics{};  // dynamic*.csv
    std::vector<std::filesystem::path> checks{};    // every other *.csv
};

// By the names of the files, each list in their order. Throws InputError when there is no such folder, no
// vehicle.toml, or no drive to check with.
ValidationFolder read_validation_folder(const std::filesystem::path& folder);

}  // namespace sil
