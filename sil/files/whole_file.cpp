// Writing: temporary file, then rename.
#include "sil/files/whole_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>

#include "sil/input_error.hpp"

namespace sil {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
    throw std::runtime_error(fmt::format(
        "cannot write {}: {}; check that the folder exists and may be written", path.string(), reason));
}

}  // namespace

std::string read_whole_file(const std::filesystem::path& path) {
    errno = 0;
    std::ifstream file{path, std::ios::binary};
    if (!file || std::filesystem::is_directory(path)) {
        throw InputError(fmt::format("{}: cannot be read: {}; check the name and the rights", path.string(),
                                     file ? "it is a folder" : std::strerror(errno)));
    }
    return {std::istreambuf_iterator<char>{file}, std::istreambuf_iterator<char>{}};
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
