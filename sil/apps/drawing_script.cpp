#include "sil/apps/drawing_script.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

namespace sil {

std::string drawing_script(const std::string& name) {
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
    for (std::filesystem::path folder = program; folder != folder.root_path();) {
        folder = folder.parent_path();
        if (std::filesystem::exists(folder / name)) {
            return (folder / name).string();
        }
    }
    throw std::runtime_error(fmt::format(
        "there is no {} in the folders above {}; start the program from the project's build folder or from "
        "the whole unpacked release, or give --no-pictures",
        name, program.string()));
}

}  // namespace sil
