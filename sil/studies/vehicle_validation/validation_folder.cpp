#include "sil/studies/vehicle_validation/validation_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "sil/input_error.hpp"

namespace sil {

ValidationFolder read_validation_folder(const std::filesystem::path& folder) {
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error)) {
        throw InputError(fmt::format("{} is no folder; give the one with the drives (docs/calibration.md)",
                                     folder.string()));
    }
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
        if (entry.path().extension() == ".csv") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    ValidationFolder found;
    found.vehicle_data = folder / vehicle_data_name;
    if (!std::filesystem::exists(found.vehicle_data)) {
        throw InputError(
            fmt::format("{}: there is no {}; write there what the data sheet says (docs/calibration.md)",
                        folder.string(), vehicle_data_name));
    }
    for (const std::filesystem::path& file : files) {
        const std::string name = file.filename().string();
        (name.rfind("ramp", 0U) == 0U      ? found.ramps
         : name.rfind("dynamic", 0U) == 0U ? found.dynamics
                                           : found.checks)
            .push_back(file);
    }
    if (found.checks.empty()) {
        throw InputError(
            fmt::format("{}: there is no drive to check with: a *.csv whose name begins with neither ramp "
                        "nor dynamic, for from these the calibration comes",
                        folder.string()));
    }
    return found;
}

}  // namespace sil
