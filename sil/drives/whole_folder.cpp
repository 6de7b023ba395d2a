#include "sil/drives/whole_folder.hpp"

#include <fmt/format.h>

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

}  // namespace

WholeFolder::WholeFolder(std::filesystem::path folder, const char* mark) : folder_{std::move(folder)} {
    partial_ = folder_;
    partial_ += ".partial";
    std::error_code error;
    if (std::filesystem::exists(folder_, error)) {
        if (!std::filesystem::exists(folder_ / mark, error) && !std::filesystem::is_empty(folder_, error)) {
            throw std::runtime_error(
                fmt::format("{} exists and is no result of a replay (there is no {} in it); choose another "
                            "--output, or remove it",
                            folder_.string(), mark));
        }
        std::filesystem::remove_all(folder_, error);
        expect(error, folder_);
    }
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
