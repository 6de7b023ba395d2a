#include "hal/linux/file_storage.hpp"

#include <cstdio>
#include <memory>
#include <utility>

namespace rsi::hal {
namespace {

struct Close {
    void operator()(std::FILE* file) const noexcept { static_cast<void>(std::fclose(file)); }
};
using File = std::unique_ptr<std::FILE, Close>;

}  // namespace

FileStorage::FileStorage(std::string path) : path_{std::move(path)}, new_path_{path_ + ".new"} {}

bool FileStorage::read(std::uint8_t* bytes, std::size_t length) noexcept {
    const File file{std::fopen(path_.c_str(), "rbe")};
    return (file != nullptr) && (std::fread(bytes, 1U, length, file.get()) == length) &&
           (std::fgetc(file.get()) == EOF);
}

bool FileStorage::write(const std::uint8_t* bytes, std::size_t length) noexcept {
    File file{std::fopen(new_path_.c_str(), "wbe")};
    if (file == nullptr) {
        return false;
    }
    const bool written = (std::fwrite(bytes, 1U, length, file.get()) == length);
    const bool closed = (std::fclose(file.release()) == 0);
    return written && closed && (std::rename(new_path_.c_str(), path_.c_str()) == 0);
}

}  // namespace rsi::hal
