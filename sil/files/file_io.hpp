// Whole files: reading one, and writing one so that its name never stands for half of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace sil {

// More than a drive of a day, or a log of an hour on a full bus; not so much that memory would end.
inline constexpr std::uint64_t longest_file_bytes = 1024U * 1024U * 1024U;

// Every byte of `path`. Throws InputError that names the path and the reason: the system's; that it is no
// ordinary file (a device or a pipe may have no end, or no writer); or that it is longer than
// `longest`.
std::string read_whole_file(const std::filesystem::path& path, std::uint64_t longest = longest_file_bytes);

// Its first bytes, at most so many: what kind of file it is. Throws as read_whole_file does.
std::string read_beginning(const std::filesystem::path& path, std::size_t most);

// Suffix of a file that is not whole yet.
inline constexpr std::string_view partial_ending = ".partial";

// A file that is written piece by piece. It grows beside `path`, with an ending behind its name, and bears
// the name only when it is whole; until then `path` is as it was. All of it throws std::runtime_error that
// names the path and the reason.
class GrowingFile {
 public:
    // A link is followed. Anything there that is no ordinary file (a device, a pipe, a folder) is refused.
    explicit GrowingFile(const std::filesystem::path& path, std::string_view ending = partial_ending);
    // An unfinished file stays as far as it got, for inspection.
    ~GrowingFile();
    GrowingFile(const GrowingFile&) = delete;
    GrowingFile& operator=(const GrowingFile&) = delete;

    // The system gets whole pieces only, some 8 KiB at a time: whatever ends the program, what is there
    // consists of whole pieces, and only the latest of them are missing.
    void write(std::string_view piece);

    void finish();

    // Removes what there is.
    void give_up();

 private:
    // Zero, or the system's error.
    int hand_over() noexcept;
    int close() noexcept;

    std::filesystem::path path_;
    std::filesystem::path growing_;
    std::string waiting_{};
    int descriptor_{-1};
};

// Writes `content` as a GrowingFile of which nothing is left if it cannot be written.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

// Makes a folder and those above it, unless they are there. Throws std::runtime_error that names the path and
// the reason.
void make_folder(const std::filesystem::path& path);

// Removes a file of an earlier run, if there is one, whole or partial. Throws std::runtime_error
// that names the path and the reason.
void remove_file(const std::filesystem::path& path);

}  // namespace sil
