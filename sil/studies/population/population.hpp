// Population: drawn vehicles with their calibrations and the settings of their campaigns, in one folder.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace sil {

struct PopulationRequest {
    std::uint64_t vehicles{400U};
    std::uint64_t seed{1U};
    std::filesystem::path output{};
    unsigned jobs{1U};
};

struct PopulationProgress {
    std::uint64_t finished{0U};  // vehicles in the folder, those of earlier calls included
    std::uint64_t total{0U};
    std::uint64_t begun_with{0U};
    double elapsed_s{0.0};  // of this call
};

// Called after each finished vehicle, by one thread at a time.
using PopulationListener = std::function<void(const PopulationProgress&)>;

// Takes the folder up where an earlier call with the same seed left it. Leaves vehicles.csv, a folder for
// each kind of file, and settings_HALF_VARIANT.toml once all vehicles are done; their bytes depend on number,
// seed and the path of the folder alone. Returns early, every finished vehicle kept, once `stop` is true. A
// vehicle whose identification fails has the reason in its row, and no calibration. Throws InputError when
// the folder holds another population or cannot be written.
PopulationProgress make_population(const PopulationRequest& request, const std::atomic<bool>& stop,
                                   const PopulationListener& listener = {});

// Who is in the folder and whose identification failed, class by class, in words.
std::string describe_population(const std::filesystem::path& population);

}  // namespace sil
