#include "sil/studies/drives/drive_names.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

namespace sil {
namespace {

// Never "" or "..": the name becomes a folder.
std::string name_of(const std::filesystem::path& file) {
    const std::string name = file.stem().string();
    return name.empty() || name == "." || name == ".." ? "drive" : name;
}

}  // namespace

std::vector<std::string> drive_names(const std::vector<std::filesystem::path>& files) {
    std::map<std::string, int> uses;
    for (const std::filesystem::path& file : files) {
        ++uses[name_of(file)];
    }
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (const std::filesystem::path& file : files) {
        std::string name = name_of(file);
        if (uses[name] > 1) {
            const std::filesystem::path parent =
                std::filesystem::absolute(file).lexically_normal().parent_path();
            name = parent.filename().string() + "_" + name;
        }
        std::string free_name = name;
        for (int number = 2; !taken.insert(free_name).second; ++number) {
            free_name = fmt::format("{}_{}", name, number);
        }
        names.push_back(free_name);
    }
    return names;
}

}  // namespace sil
