#include "sil/studies/drives/whole_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace sil {
namespace {

void expect(const std::error_code& error, const std::filesystem::path& path) {
    if (error) {
        throw std::runtime_error(
            fmt::format("cannot write {}: {}; check that the folder above exists and may be written",
                        path.string(), error.message()));
    }
}

// An earlier result, and nothing else.
void remove_earlier(const std::filesystem::path& folder, const std::vector<std::string>& contents) {
    std::error_code error;
    const std::filesystem::directory_iterator entries{folder, error};
    expect(error, folder);
    for (const std::filesystem::directory_entry& entry : entries) {
        const std::string name = entry.path().filename().string();
        if (std::find(contents.begin(), contents.end(), name) == contents.end()) {
            throw std::runtime_error(fmt::format(
                "{} is already there, and {} in it is no result of a replay; choose another --output, or "
                "move it away",
                folder.string(), name));
        }
    }
    std::filesystem::remove_all(folder, error);
    expect(error, folder);
}

}  // namespace

WholeFolder::WholeFolder(std::filesystem::path folder, const std::vector<std::string>& contents)
    : folder_{std::move(folder)} {
    std::error_code error;
    if (std::filesystem::exists(folder_, error)) {
        remove_earlier(folder_, contents);
    }
    partial_ = folder_;
    partial_ += ".partial";
    std::filesystem::remove_all(partial_, error);
    std::filesystem::create_directories(partial_, error);
    expect(error, partial_);
}

WholeFolder::~WholeFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(partial_, ignored);
}

void WholeFolder::commit() {
    std::error_code error;
    std::filesystem::rename(partial_, folder_, error);
    expect(error, folder_);
}

}  // namespace sil
