// Writing: temporary file, then rename.
#include "sil/files/whole_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "sil/input_error.hpp"

namespace sil {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
    throw std::runtime_error(fmt::format(
        "cannot write {}: {}; check that the folder exists and may be written", path.string(), reason));
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
    throw InputError(
        fmt::format("{}: cannot be read: {}; check the path and the permissions", path.string(), reason));
}

}  // namespace

std::string read_whole_file(const std::filesystem::path& path) {
    errno = 0;
    std::ifstream file{path, std::ios::binary};
    if (!file) {
        refuse(path, std::strerror(errno));
    }
    if (std::filesystem::is_directory(path)) {
        refuse(path, "it is a folder");
    }
    std::string text;
    std::vector<char> block(64U * 1024U);
    while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
        text.append(block.data(), static_cast<std::size_t>(file.gcount()));
    }
    if (file.bad()) {
        refuse(path, std::strerror(errno));
    }
    return text;
}

void write_file_atomically(const std::filesystem::path& path, std::string_view content) {
    std::filesystem::path temporary = path;
    temporary += fmt::format(".{}.tmp", ::getpid());

    errno = 0;
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    std::error_code error;
    if (!file) {
        const std::string reason = errno != 0 ? std::strerror(errno) : "write error";
        std::filesystem::remove(temporary, error);
        fail(path, reason);
    }
    std::filesystem::rename(temporary, path, error);
    if (error) {
        const std::string reason = error.message();
        std::filesystem::remove(temporary, error);
        fail(path, reason);
    }
}

}  // namespace sil
