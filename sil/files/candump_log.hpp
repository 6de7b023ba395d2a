// Candump logs: writing and reading the lines of `candump -L`, which canplayer replays.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rsi/hal/can_bus.hpp"
#include "sil/files/file_io.hpp"

namespace sil {

// One line: "(seconds.microseconds) interface ID#DATA", for CAN FD "ID##FLAGSDATA".
struct LoggedFrame {
    rsi::hal::CanFrame
        frame;  // its receive_time is the time of the line, in whole microseconds, not negative
    std::string interface;
    // CAN FD only: bit 0 bit-rate switch, bit 1 error state indicator. Kernels differ in whether they also
    // set bit 2, which says nothing but "CAN FD"; here it is always 0, when written and when read.
    std::uint8_t fd_flags{0U};
    std::size_t line{0U};  // where it stands in the file it was read from, counted from 1; 0: not from a file
};

inline constexpr std::uint8_t canonical_fd_flags = 0x3U;

// The line without its end. A negative time is written as zero; what does not fit the frame's kind
// (identifier bits beyond 11 or 29, bytes beyond 8 or 64) is cut off.
std::string format_candump_line(const LoggedFrame& logged);

// How a line is no data frame.
enum class CandumpLineKind : std::uint8_t { wrong, error_frame, remote_frame };

// An error in a line, to be read by a person; `column` counts from 1.
struct CandumpLineError {
    std::size_t column{1U};
    std::string message;
    CandumpLineKind kind{CandumpLineKind::wrong};
};

struct ParsedCandumpLine {
    std::optional<LoggedFrame> frame;  // empty when the line is wrong
    CandumpLineError error;
};

// The first line of a log begins with "(", or with the recorder's note of frames that it lost; no CSV header
// does.
bool is_candump_log(std::string_view text);

// Reads one line, without its line feed. Any bytes may come: what is no data frame is an error, never a
// crash. Remote frames, error frames and CAN XL are errors. A carriage return, the direction " R" or " T"
// that `candump -x` adds, the raw length code "_9" to "_F" of `candump -8`, and up to nine decimals of the
// time, of which six are kept, are accepted.
ParsedCandumpLine parse_candump_line(std::string_view line);

// All frames of a log that this project wrote, in the order of the file, whatever their times (candump may
// write two frames that arrived on two processors in the wrong order). Empty lines are skipped. Throws
// InputError "FILE:LINE:COLUMN: what is wrong", or that the file cannot be read.
std::vector<LoggedFrame> read_candump_log(const std::filesystem::path& path);

// The same of a text that was read from `file`.
std::vector<LoggedFrame> parse_candump_log(std::string_view text, const std::filesystem::path& file);

// The lines of a log that are no data frames, of which a bus has some and a recorder others.
struct LeftOutLines {
    std::size_t error_frames{0U};
    std::size_t remote_frames{0U};
    std::size_t wrong{0U};        // notes of the recorder, CAN XL, damage
    std::size_t first_wrong{0U};  // line of the first of these, counted from 1
    CandumpLineError first_error;
    std::size_t damaged_times{0U};       // frames with a time far from those of both neighbours
    std::size_t first_damaged_time{0U};  // line of the first of these

    // A line for a person; empty where nothing was left out.
    std::string text(const std::filesystem::path& file) const;
};

struct SiftedLog {
    std::vector<LoggedFrame> frames;
    LeftOutLines left_out;
};

// All frames of the log of a recorder that is not ours: whatever else is there costs its line.
SiftedLog sift_candump_log(std::string_view text);

class CandumpLogWriter {
 public:
    // Begins the file (sil/files/file_io.hpp). Throws std::runtime_error with path and reason, like all of
    // it.
    explicit CandumpLogWriter(const std::filesystem::path& path) : file_{path} {}

    void write(const LoggedFrame& logged);

    // From here on the log is there.
    void close() { file_.finish(); }

 private:
    GrowingFile file_;
};

}  // namespace sil
