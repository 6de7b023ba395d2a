// Candump logs: the format of a line in both directions, and whole files.
#include "sil/files/candump_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "sil/files/file_io.hpp"
#include "sil/input_error.hpp"

namespace sil {
namespace {

constexpr std::int64_t nanoseconds_per_microsecond = 1'000;
constexpr std::int64_t nanoseconds_per_second = 1'000'000'000;
constexpr std::int64_t largest_seconds = 9'000'000'000;  // 2255; in nanoseconds it still fits 63 bits
constexpr std::uint32_t largest_standard_identifier = 0x7FFU;
constexpr std::uint32_t largest_extended_identifier = 0x1FFFFFFFU;
constexpr std::uint32_t error_frame_flag = 0x20000000U;
constexpr std::size_t classic_bytes = 8U;
constexpr std::size_t flexible_bytes = 64U;

bool is_decimal(char character) {
    return character >= '0' && character <= '9';
}

int hexadecimal_value(char character) {
    if (is_decimal(character)) {
        return character - '0';
    }
    if (character >= 'A' && character <= 'F') {
        return character - 'A' + 10;
    }
    if (character >= 'a' && character <= 'f') {
        return character - 'a' + 10;
    }
    return -1;
}

bool is_flexible_length(std::size_t bytes) {
    constexpr std::size_t lengths[] = {12U, 16U, 20U, 24U, 32U, 48U, 64U};
    return bytes <= classic_bytes ||
           std::find(std::begin(lengths), std::end(lengths), bytes) != std::end(lengths);
}

// Goes through a line from left to right. The first thing that is wrong ends the parsing by an exception that
// never leaves parse_candump_line.
class LineParser {
 public:
    explicit LineParser(std::string_view line) : line_(line) {}

    LoggedFrame parse() {
        parse_time();
        expect(' ', "a space after the time");
        parse_interface();
        expect(' ', "a space after the interface");
        parse_identifier();
        expect('#', "'#' after the identifier");
        if (accept('#')) {
            parse_flexible_payload();
        } else {
            parse_classic_payload();
        }
        parse_end();
        return logged_;
    }

 private:
    // A zero at the end, which is no character of any line that is taken.
    char current() const { return position_ < line_.size() ? line_[position_] : '\0'; }

    [[noreturn]] void fail(const std::string& message, CandumpLineKind kind = CandumpLineKind::wrong) const {
        throw CandumpLineError{position_ + 1U, message, kind};
    }

    bool accept(char character) {
        if (current() != character) {
            return false;
        }
        ++position_;
        return true;
    }

    void expect(char character, const char* what) {
        if (!accept(character)) {
            fail(fmt::format("expected {}", what));
        }
    }

    void parse_time() {
        expect('(', "'(' and the time, as in (0.010000) vcan0 123#AABB");
        std::int64_t seconds = 0;
        const std::size_t begin = position_;
        for (; is_decimal(current()); ++position_) {
            seconds = seconds * 10 + (current() - '0');
            if (seconds > largest_seconds) {
                fail(fmt::format("the time is beyond {} s", largest_seconds));
            }
        }
        if (position_ == begin) {
            fail("expected the seconds of the time");
        }
        expect('.', "'.' and six decimals of the time");
        std::int64_t microseconds = 0;
        constexpr int decimals = 6;
        constexpr int most_decimals = 9;
        for (int digit = 0; digit < most_decimals && (digit < decimals || is_decimal(current()));
             ++digit, ++position_) {
            if (!is_decimal(current())) {
                fail("the time needs six decimals");
            }
            microseconds = digit < decimals ? microseconds * 10 + (current() - '0') : microseconds;
        }
        expect(')', "')' after six to nine decimals of the time");
        logged_.frame.receive_time.nanoseconds =
            seconds * nanoseconds_per_second + microseconds * nanoseconds_per_microsecond;
    }

    void parse_interface() {
        const std::size_t begin = position_;
        while (current() > ' ' && current() < '\x7F') {
            ++position_;
        }
        if (position_ == begin) {
            fail("expected the name of the interface");
        }
        logged_.interface.assign(line_.substr(begin, position_ - begin));
    }

    void parse_identifier() {
        const std::size_t begin = position_;
        std::uint32_t identifier = 0U;
        constexpr std::size_t standard_digits = 3U;
        constexpr std::size_t extended_digits = 8U;
        for (; hexadecimal_value(current()) >= 0 && position_ - begin < extended_digits; ++position_) {
            identifier = (identifier << 4U) | static_cast<std::uint32_t>(hexadecimal_value(current()));
        }
        const std::size_t digits = position_ - begin;
        if (digits != standard_digits && digits != extended_digits) {
            position_ = begin;
            fail("the identifier needs 3 hexadecimal digits (standard) or 8 (extended)");
        }
        const bool extended = digits == extended_digits;
        if (identifier > (extended ? largest_extended_identifier : largest_standard_identifier)) {
            position_ = begin;
            fail(extended ? "an extended identifier ends at 1FFFFFFF (an error frame is no data frame)"
                          : "a standard identifier ends at 7FF",
                 (identifier & error_frame_flag) != 0U ? CandumpLineKind::error_frame
                                                       : CandumpLineKind::wrong);
        }
        logged_.frame.identifier = identifier;
        logged_.frame.extended = extended;
    }

    void parse_classic_payload() {
        if (current() == 'R' || current() == 'r') {
            fail("this is a remote frame; only data frames can be read", CandumpLineKind::remote_frame);
        }
        parse_bytes(classic_bytes);
        if (logged_.frame.length == classic_bytes && accept('_')) {
            parse_raw_length_code();
        }
    }

    // A frame of 8 bytes may have been sent with a code from 9 to 15, which means 8, too.
    void parse_raw_length_code() {
        if (hexadecimal_value(current()) <= static_cast<int>(classic_bytes)) {
            fail("expected a raw length code from 9 to F after '_'");
        }
        ++position_;
    }

    void parse_flexible_payload() {
        const int flags = hexadecimal_value(current());
        if (flags < 0) {
            fail("expected one hexadecimal digit of CAN FD flags after '##'");
        }
        ++position_;
        logged_.frame.flexible_data_rate = true;
        logged_.fd_flags = static_cast<std::uint8_t>(static_cast<unsigned>(flags) & canonical_fd_flags);
        parse_bytes(flexible_bytes);
        if (!is_flexible_length(logged_.frame.length)) {
            fail(fmt::format("CAN FD has no frames of {} bytes", logged_.frame.length));
        }
    }

    void parse_bytes(std::size_t limit) {
        std::size_t length = 0U;
        while (hexadecimal_value(current()) >= 0) {
            if (length == limit) {
                fail(fmt::format("more than {} data bytes", limit));
            }
            const int high = hexadecimal_value(current());
            ++position_;
            const int low = hexadecimal_value(current());
            if (low < 0) {
                fail("half a data byte: the number of hexadecimal digits is odd");
            }
            ++position_;
            logged_.frame.data[length] = static_cast<std::uint8_t>(high * 16 + low);
            ++length;
        }
        logged_.frame.length = static_cast<std::uint8_t>(length);
    }

    void parse_end() {
        const std::string_view rest = line_.substr(position_);
        if (rest == " R" || rest == " T") {
            return;
        }
        if (!rest.empty()) {
            fail("expected the end of the line or a hexadecimal digit");
        }
    }

    std::string_view line_;
    std::size_t position_{0U};
    LoggedFrame logged_;
};

// From a frame to the next on a bus; the recorders of several processors write that much out of order.
constexpr rsi::hal::Time longest_step = rsi::hal::Time::from_milliseconds(60'000);
constexpr rsi::hal::Time longest_step_back = rsi::hal::Time::from_milliseconds(1'000);

bool is_jump(const LoggedFrame& one, const LoggedFrame& next) {
    const rsi::hal::Time from = one.frame.receive_time;
    const rsi::hal::Time to = next.frame.receive_time;
    return longest_step < to - from || longest_step_back < from - to;
}

// A frame whose time alone jumps away from both neighbours has a damaged one: the clock was not set.
void leave_out_damaged_times(SiftedLog& log) {
    std::vector<LoggedFrame> frames;
    frames.reserve(log.frames.size());
    for (std::size_t index = 0U; index < log.frames.size(); ++index) {
        LoggedFrame& frame = log.frames[index];
        const bool is_between = !frames.empty() && index + 1U < log.frames.size();
        if (!is_between || !is_jump(frames.back(), frame) || is_jump(frames.back(), log.frames[index + 1U])) {
            frames.push_back(std::move(frame));
        } else if (++log.left_out.damaged_times == 1U) {
            log.left_out.first_damaged_time = frame.line;
        }
    }
    log.frames = std::move(frames);
}

// Hands every line that is not empty to `take`, with its number.
template <typename Take>
void for_each_line(std::string_view text, const Take& take) {
    for (std::size_t number = 1U; !text.empty(); ++number) {
        const std::string_view line = text.substr(0U, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1U, text.size()));
        if (line.empty() || line == "\r") {
            continue;
        }
        ParsedCandumpLine parsed = parse_candump_line(line);
        if (parsed.frame) {
            parsed.frame->line = number;
        }
        take(number, std::move(parsed));
    }
}

}  // namespace

std::string format_candump_line(const LoggedFrame& logged) {
    const rsi::hal::CanFrame& frame = logged.frame;
    const std::int64_t time_us =
        std::max<std::int64_t>(frame.receive_time.nanoseconds, 0) / nanoseconds_per_microsecond;
    std::string line =
        fmt::format("({}.{:06}) {} ", time_us / 1'000'000, time_us % 1'000'000, logged.interface);
    auto out = std::back_inserter(line);
    if (frame.extended) {
        fmt::format_to(out, "{:08X}#", frame.identifier & largest_extended_identifier);
    } else {
        fmt::format_to(out, "{:03X}#", frame.identifier & largest_standard_identifier);
    }
    if (frame.flexible_data_rate) {
        fmt::format_to(out, "#{:X}", logged.fd_flags & canonical_fd_flags);
    }
    const std::size_t limit = frame.flexible_data_rate ? flexible_bytes : classic_bytes;
    const std::size_t length = std::min<std::size_t>(frame.length, limit);
    for (std::size_t index = 0U; index < length; ++index) {
        fmt::format_to(out, "{:02X}", frame.data[index]);
    }
    return line;
}

bool is_candump_log(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    constexpr std::string_view lost_frames = "DROPCOUNT";
    return text.substr(0U, 1U) == "(" || text.substr(0U, lost_frames.size()) == lost_frames;
}

ParsedCandumpLine parse_candump_line(std::string_view line) {
    if (!line.empty() && line.back() == '\r') {
        line.remove_suffix(1U);
    }
    ParsedCandumpLine result;
    try {
        result.frame = LineParser(line).parse();
    } catch (const CandumpLineError& error) {
        result.error = error;
    }
    return result;
}

std::string LeftOutLines::text(const std::filesystem::path& file) const {
    std::string text;
    const auto add = [&text](std::size_t count, std::string_view what) {
        if (count > 0U) {
            text += fmt::format("{}{} {}", text.empty() ? "" : "; ", count, what);
        }
    };
    add(error_frames, "error frames");
    add(remote_frames, "remote frames");
    add(wrong, "lines that are no frames");
    if (wrong > 0U) {
        text += fmt::format(", the first {}:{}:{}: {}", file.string(), first_wrong, first_error.column,
                            first_error.message);
    }
    add(damaged_times, "frames whose time jumps away from those beside them");
    if (damaged_times > 0U) {
        text += fmt::format(", the first {}:{}", file.string(), first_damaged_time);
    }
    return text.empty() ? text : fmt::format("{}: left out: {}\n", file.string(), text);
}

SiftedLog sift_candump_log(std::string_view text) {
    SiftedLog log;
    for_each_line(text, [&log](std::size_t number, ParsedCandumpLine parsed) {
        if (parsed.frame) {
            log.frames.push_back(std::move(*parsed.frame));
        } else if (parsed.error.kind == CandumpLineKind::error_frame) {
            ++log.left_out.error_frames;
        } else if (parsed.error.kind == CandumpLineKind::remote_frame) {
            ++log.left_out.remote_frames;
        } else if (++log.left_out.wrong == 1U) {
            log.left_out.first_wrong = number;
            log.left_out.first_error = std::move(parsed.error);
        }
    });
    leave_out_damaged_times(log);
    return log;
}

std::vector<LoggedFrame> read_candump_log(const std::filesystem::path& path) {
    return parse_candump_log(read_whole_file(path), path);
}

std::vector<LoggedFrame> parse_candump_log(std::string_view text, const std::filesystem::path& file) {
    std::vector<LoggedFrame> frames;
    for_each_line(text, [&](std::size_t number, ParsedCandumpLine parsed) {
        if (!parsed.frame) {
            throw InputError(fmt::format("{}:{}:{}: {}", file.string(), number, parsed.error.column,
                                         parsed.error.message));
        }
        frames.push_back(std::move(*parsed.frame));
    });
    return frames;
}

void CandumpLogWriter::write(const LoggedFrame& logged) {
    file_.write(format_candump_line(logged) + '\n');
}

}  // namespace sil
