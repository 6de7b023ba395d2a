// Reading: ordinary files of a bounded length only. Writing: under another name, then rename.
#include "sil/files/file_io.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "sil/input_error.hpp"

namespace sil {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason, const char* remedy) {
    throw std::runtime_error(fmt::format("cannot write {}: {}; {}", path.string(), reason, remedy));
}

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
    fail(path, std::strerror(error),
         error == ENOSPC ? "make room there, or choose another folder"
                         : "check that the folder exists and may be written");
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason,
                         const char* remedy = "check the path and the permissions") {
    throw InputError(fmt::format("{}: cannot be read: {}; {}", path.string(), reason, remedy));
}

class Descriptor {
 public:
    explicit Descriptor(int number) : number_{number} {}
    ~Descriptor() {
        if (number_ >= 0) {
            ::close(number_);
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }

 private:
    int number_;
};

// An ordinary file, opened to be read.
class OrdinaryFile {
 public:
    explicit OrdinaryFile(const std::filesystem::path& path)
        // Without O_NONBLOCK opening a pipe without a writer would block.
        : file_{::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)} {
        if (file_.number() < 0 || ::fstat(file_.number(), &status_) != 0) {
            refuse(path, std::strerror(errno));
        }
        if (S_ISDIR(status_.st_mode)) {
            refuse(path, "it is a folder");
        }
        if (!S_ISREG(status_.st_mode)) {
            refuse(path, "it is a device or a pipe and no ordinary file",
                   "write what comes from there into a file, and give that");
        }
    }

    int number() const { return file_.number(); }
    std::uint64_t stated_bytes() const { return static_cast<std::uint64_t>(status_.st_size); }

 private:
    Descriptor file_;
    struct stat status_{};
};

// How many bytes were read into `block`; 0 at the end, negative after a failure.
ssize_t read_some(int descriptor, std::vector<char>& block) {
    ssize_t count = 0;
    do {
        count = ::read(descriptor, block.data(), block.size());
    } while (count < 0 && errno == EINTR);
    return count;
}

// True place of the file to be replaced: a link stays a link.
std::filesystem::path place_of(const std::filesystem::path& path) {
    if (path.empty()) {
        fail(path, "the name is empty", "give one");
    }
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        return path;
    }
    if (std::filesystem::is_directory(status)) {
        fail(path, "it is a folder", "choose another name");
    }
    if (!std::filesystem::is_regular_file(status)) {
        fail(path, "it is a device or a pipe and no ordinary file", "choose another name");
    }
    const std::filesystem::path place = std::filesystem::canonical(path, error);
    return error ? path : place;
}

}  // namespace

std::string read_whole_file(const std::filesystem::path& path, std::uint64_t longest) {
    const OrdinaryFile file{path};
    // The length that a file reports is a hint: it may grow, and some of the system's say 0.
    const std::uint64_t told = file.stated_bytes();
    bool is_too_long = told > longest;
    std::string text;
    text.reserve(is_too_long ? 0U : told);
    std::vector<char> block(64U * 1024U);
    while (!is_too_long) {
        const ssize_t count = read_some(file.number(), block);
        if (count < 0) {
            refuse(path, std::strerror(errno));
        }
        if (count == 0) {
            return text;
        }
        text.append(block.data(), static_cast<std::size_t>(count));
        is_too_long = text.size() > longest;
    }
    refuse(path, fmt::format("it is longer than {} MiB", longest / (1024U * 1024U)), "give a shorter file");
}

std::string read_beginning(const std::filesystem::path& path, std::size_t most) {
    const OrdinaryFile file{path};
    std::string text;
    std::vector<char> block(most);
    for (ssize_t count = 1; count > 0 && text.size() < most;) {
        block.resize(most - text.size());
        count = read_some(file.number(), block);
        if (count < 0) {
            refuse(path, std::strerror(errno));
        }
        text.append(block.data(), static_cast<std::size_t>(count));
    }
    return text;
}

GrowingFile::GrowingFile(const std::filesystem::path& path, std::string_view ending)
    : path_{place_of(path)}, growing_{path_} {
    growing_ += ending;
    // Without O_NONBLOCK it would wait for a reader, if a pipe is there.
    descriptor_ = ::open(growing_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NONBLOCK | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
        fail(path, errno);
    }
}

GrowingFile::~GrowingFile() {
    hand_over();
    close();
}

int GrowingFile::hand_over() noexcept {
    int error = 0;
    std::size_t written = 0U;
    while (written < waiting_.size() && descriptor_ >= 0 && error == 0) {
        const ssize_t count = ::write(descriptor_, waiting_.data() + written, waiting_.size() - written);
        error = count < 0 && errno != EINTR ? errno : 0;
        written += count > 0 ? static_cast<std::size_t>(count) : 0U;
    }
    waiting_.erase(0U, written);
    return error;
}

int GrowingFile::close() noexcept {
    const int descriptor = std::exchange(descriptor_, -1);
    return descriptor >= 0 && ::close(descriptor) != 0 ? errno : 0;
}

void GrowingFile::write(std::string_view piece) {
    constexpr std::size_t enough = 8192U;
    waiting_ += piece;
    const int error = waiting_.size() < enough ? 0 : hand_over();
    if (error != 0) {
        fail(path_, error);
    }
}

void GrowingFile::finish() {
    int error = hand_over();
    if (error == 0) {
        error = close();  // some file systems tell only now that there was no room
    }
    if (error == 0 && ::rename(growing_.c_str(), path_.c_str()) != 0) {
        error = errno;
    }
    if (error != 0) {
        fail(path_, error);
    }
}

void GrowingFile::give_up() {
    close();
    ::unlink(growing_.c_str());
}

void write_file_atomically(const std::filesystem::path& path, std::string_view content) {
    // Two programs may write the same file, perhaps of two machines; none of them gets the other's half.
    char host[64] = "";
    static_cast<void>(::gethostname(host, sizeof(host) - 1U));
    GrowingFile file{path, fmt::format(".{}.{}.tmp", host, ::getpid())};
    try {
        file.write(content);
        file.finish();
    } catch (const std::runtime_error&) {
        file.give_up();
        throw;
    }
}

void make_folder(const std::filesystem::path& path) {
    if (path.empty()) {
        throw std::runtime_error("the name of the folder for the results is empty; give one");
    }
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) {
        throw std::runtime_error(
            fmt::format("cannot make the folder {}: {}; check that what is above it is a folder and may be "
                        "written, or choose another",
                        path.string(), error.message()));
    }
}

void remove_file(const std::filesystem::path& path) {
    for (const std::string_view ending : {std::string_view{}, partial_ending}) {
        std::filesystem::path file = path;
        file += ending;
        std::error_code error;
        std::filesystem::remove(file, error);
        if (error) {
            throw std::runtime_error(
                fmt::format("cannot remove {}: {}; move it away, or choose another folder", file.string(),
                            error.message()));
        }
    }
}

}  // namespace sil
