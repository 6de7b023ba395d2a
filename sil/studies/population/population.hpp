// Population: drawn vehicles with their calibrations and the settings of their campaigns, in one folder.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>

#include "sil/studies/campaign/row_workers.hpp"

namespace sil {

struct PopulationRequest {
    std::uint64_t vehicles{400U};
    std::uint64_t seed{1U};
    bool only_report{false};  // true: no vehicle is there to choose on
    std::filesystem::path output{};
    unsigned jobs{1U};
};

// Takes the folder up where an earlier call with the same seed left it. Leaves vehicles.csv, a folder for
// each kind of file, and settings_HALF_VARIANT.toml once all vehicles are done; their bytes depend on number
// and seed alone. Returns early, every finished vehicle kept, once `stop` is true. A
// vehicle whose identification fails has the reason in its row, and no calibration. Throws InputError when
// the folder holds another population or cannot be written.
RowProgress make_population(const PopulationRequest& request, const std::atomic<bool>& stop,
                            const RowListener& listener = {});

// Vehicles in the folder and failed identifications, class by class, in words.
std::string describe_population(const std::filesystem::path& population);

}  // namespace sil
