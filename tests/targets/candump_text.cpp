#include "tests/targets/candump_text.hpp"

namespace target {
namespace {

constexpr std::int64_t nanoseconds_per_microsecond = 1'000;
constexpr std::int64_t microseconds_per_second = 1'000'000;
constexpr std::size_t most_digits_of_seconds = 9U;
constexpr std::size_t digits_of_microseconds = 6U;
constexpr std::size_t digits_of_identifier = 3U;
constexpr std::size_t most_bytes = 8U;

bool is_decimal(char character) {
    return (character >= '0') && (character <= '9');
}

int hexadecimal_value(char character) {
    if (is_decimal(character)) {
        return character - '0';
    }
    return ((character >= 'A') && (character <= 'F')) ? (character - 'A') + 10 : -1;
}

bool accept(const char*& text, char character) {
    if (*text != character) {
        return false;
    }
    ++text;
    return true;
}

// Counts the digits read; at most `most`.
std::size_t parse_decimal(const char*& text, std::size_t most, std::int64_t& value) {
    std::size_t digits = 0U;
    value = 0;
    for (; (digits < most) && is_decimal(*text); ++digits, ++text) {
        value = (value * 10) + (*text - '0');
    }
    return digits;
}

bool parse_time(const char*& text, rsi::hal::Time& time) {
    std::int64_t seconds = 0;
    std::int64_t microseconds = 0;
    const bool good = accept(text, '(') && (parse_decimal(text, most_digits_of_seconds, seconds) > 0U) &&
                      accept(text, '.') &&
                      (parse_decimal(text, digits_of_microseconds, microseconds) == digits_of_microseconds) &&
                      accept(text, ')');
    time.nanoseconds = ((seconds * microseconds_per_second) + microseconds) * nanoseconds_per_microsecond;
    return good;
}

bool parse_interface(const char*& text, char* name) {
    std::size_t length = 0U;
    for (; (length < longest_interface_name) && (*text != ' ') && (*text != '\0'); ++length, ++text) {
        name[length] = *text;
    }
    name[length] = '\0';
    return length > 0U;
}

bool parse_payload(const char*& text, rsi::hal::CanFrame& frame) {
    frame.length = 0U;
    std::uint32_t byte = 0U;
    while ((frame.length < most_bytes) && parse_hexadecimal(text, 2U, byte)) {
        frame.data[frame.length] = static_cast<std::uint8_t>(byte);
        ++frame.length;
        text += 2;
    }
    return *text == '\0';
}

// Writes the value's last `digits` digits and returns what follows them.
char* format_number(char* text, std::int64_t value, std::size_t digits, int base) {
    for (std::size_t left = digits; left > 0U; --left) {
        text[left - 1U] = "0123456789ABCDEF"[value % base];
        value /= base;
    }
    return text + digits;
}

std::size_t decimal_digits(std::int64_t value) {
    std::size_t digits = 1U;
    for (; value > 9; value /= 10) {
        ++digits;
    }
    return digits;
}

}  // namespace

bool parse_hexadecimal(const char* text, std::size_t digits, std::uint32_t& value) {
    value = 0U;
    for (std::size_t index = 0U; index < digits; ++index) {
        const int digit = hexadecimal_value(text[index]);
        if (digit < 0) {
            return false;
        }
        value = (value << 4U) | static_cast<std::uint32_t>(digit);
    }
    return true;
}

bool parse_line(const char* text, CandumpLine& line) {
    line = CandumpLine{};
    if (!parse_time(text, line.frame.receive_time) || !accept(text, ' ') ||
        !parse_interface(text, line.interface) || !accept(text, ' ') ||
        !parse_hexadecimal(text, digits_of_identifier, line.frame.identifier)) {
        return false;
    }
    text += digits_of_identifier;
    return accept(text, '#') && parse_payload(text, line.frame);
}

std::size_t format_line(const CandumpLine& line, char (&text)[longest_line]) {
    const std::int64_t microseconds = line.frame.receive_time.nanoseconds / nanoseconds_per_microsecond;
    const std::int64_t seconds = microseconds / microseconds_per_second;
    char* end = text;
    *end++ = '(';
    end = format_number(end, seconds, decimal_digits(seconds), 10);
    *end++ = '.';
    end = format_number(end, microseconds % microseconds_per_second, digits_of_microseconds, 10);
    *end++ = ')';
    *end++ = ' ';
    for (const char* name = line.interface; *name != '\0'; ++name) {
        *end++ = *name;
    }
    *end++ = ' ';
    end = format_number(end, line.frame.identifier, digits_of_identifier, 16);
    *end++ = '#';
    for (std::size_t index = 0U; (index < line.frame.length) && (index < most_bytes); ++index) {
        end = format_number(end, line.frame.data[index], 2U, 16);
    }
    *end++ = '\n';
    return static_cast<std::size_t>(end - text);
}

}  // namespace target
