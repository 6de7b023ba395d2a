#include "hal/linux/file_storage.hpp"

#include <cerrno>
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

Reading FileStorage::read(std::uint8_t* bytes, std::size_t length) noexcept {
    errno = 0;
    const File file{std::fopen(path_.c_str(), "rbe")};
    if (file == nullptr) {
        return (errno == ENOENT) ? Reading::never_written : Reading::unreadable;
    }
    const bool is_whole = (std::fread(bytes, 1U, length, file.get()) == length) &&
                          (std::fgetc(file.get()) == EOF) && (std::ferror(file.get()) == 0);
    return is_whole ? Reading::stored : Reading::unreadable;
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
