// The candump reader from any bytes: line by line it reads what it writes, a wrong line is an error with a
// place, and a whole file agrees with its lines.
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "rsi/hal/well_formed.hpp"
#include "sil/files/candump_log.hpp"
#include "sil/input_error.hpp"
#include "tests/quality/fuzz/support/memory_file.hpp"
#include "tests/quality/fuzz/support/message.hpp"
#include "tests/quality/fuzz/support/require.hpp"

namespace {

using fuzz::require;

bool same(const sil::LoggedFrame& a, const sil::LoggedFrame& b) {
    return a.frame.identifier == b.frame.identifier && a.frame.extended == b.frame.extended &&
           a.frame.flexible_data_rate == b.frame.flexible_data_rate && a.frame.length == b.frame.length &&
           a.frame.data == b.frame.data && a.frame.receive_time == b.frame.receive_time &&
           a.interface == b.interface && a.fd_flags == b.fd_flags;
}

// True when the line holds a frame.
bool check_line(std::string_view line) {
    const sil::ParsedCandumpLine parsed = sil::parse_candump_line(line);
    if (!parsed.frame) {
        require(!parsed.error.message.empty(), "an error says what is wrong");
        require(parsed.error.column >= 1U && parsed.error.column <= line.size() + 1U,
                "an error's column lies in the line or behind it");
        return false;
    }
    require(rsi::hal::is_well_formed(parsed.frame->frame), "a frame is one that a bus can carry");
    const std::string written = sil::format_candump_line(*parsed.frame);
    const sil::ParsedCandumpLine again = sil::parse_candump_line(written);
    require(again.frame && same(*again.frame, *parsed.frame), "a frame that was written reads as the same");
    require(sil::format_candump_line(*again.frame) == written, "and is written as the same");
    return true;
}

// Read as another recorder's: whatever is wrong costs its line, and is counted.
void check_sifted(std::string_view text, std::size_t frames, std::size_t wrong_lines) {
    const sil::SiftedLog log = sil::sift_candump_log(text);
    require(log.frames.size() + log.left_out.damaged_times == frames, "no line costs another");
    require(log.left_out.error_frames + log.left_out.remote_frames + log.left_out.wrong == wrong_lines,
            "every line that is left out is counted");
    require(log.left_out.text("log").empty() == (wrong_lines + log.left_out.damaged_times == 0U), "and said");
}

void check_file(std::string_view text, std::size_t frames, std::size_t first_wrong_line) {
    static fuzz::MemoryFile file;
    file.write(text.data(), text.size());
    try {
        const std::vector<sil::LoggedFrame> read = sil::read_candump_log(file.path());
        require(first_wrong_line == 0U, "a file with a wrong line is refused");
        require(read.size() == frames, "a file has the frames of its lines");
    } catch (const sil::InputError& error) {
        require(first_wrong_line != 0U, "a file without a wrong line is read");
        const std::string place = file.path() + ":" + std::to_string(first_wrong_line) + ":";
        require(std::string_view{error.what()}.substr(0U, place.size()) == place,
                "an error names the file and its first wrong line");
        fuzz::require_place(error.what(), file.path());
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text{reinterpret_cast<const char*>(data), size};
    std::size_t frames = 0U;
    std::size_t first_wrong_line = 0U;
    std::size_t wrong_lines = 0U;
    std::string_view rest = text;
    for (std::size_t number = 1U; !rest.empty(); ++number) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = rest.substr(0U, end);
        rest.remove_prefix(std::min(end + 1U, rest.size()));
        const bool good = check_line(line);
        frames += good ? 1U : 0U;
        const bool is_empty = line.empty() || line == "\r";
        wrong_lines += !good && !is_empty ? 1U : 0U;
        if (wrong_lines == 1U && first_wrong_line == 0U) {
            first_wrong_line = number;
        }
    }
    check_sifted(text, frames, wrong_lines);
    check_file(text, frames, first_wrong_line);
    return 0;
}
