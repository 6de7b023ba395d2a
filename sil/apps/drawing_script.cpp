#include "sil/apps/drawing_script.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <stdexcept>

extern char** environ;

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

bool is_drawn(std::string script, const std::filesystem::path& folder) {
    std::string argument = std::filesystem::absolute(folder).string();
    char* arguments[] = {script.data(), argument.data(), nullptr};
    pid_t child = 0;
    int status = 1;
    return posix_spawn(&child, script.c_str(), nullptr, nullptr, arguments, environ) == 0 &&
           waitpid(child, &status, 0) == child && status == 0;
}

}  // namespace sil
