// Text files line by line, for programs of the tests on every target: buffered, because every access by
// semihosting stops the processor.
#pragma once

#include <cstddef>

#include "tests/targets/support/program.hpp"

namespace target {

class LineReader {
 public:
    explicit LineReader(Handle file) : file_(file) {}

    // The next line without its line feed, ended by a zero. False at the end, and when a line is too long.
    template <std::size_t size>
    bool next(char (&line)[size]) {
        std::size_t length = 0U;
        char character = '\0';
        while (take(character)) {
            if (character == '\n') {
                line[length] = '\0';
                return true;
            }
            if (length + 1U == size) {
                return false;
            }
            line[length] = character;
            ++length;
        }
        return false;
    }

    // Everything has been read.
    bool at_end() { return (position_ == size_) && !fill(); }

 private:
    bool fill() {
        size_ = read(file_, buffer_, sizeof(buffer_));
        position_ = 0U;
        return size_ > 0U;
    }

    bool take(char& character) {
        if ((position_ == size_) && !fill()) {
            return false;
        }
        character = buffer_[position_];
        ++position_;
        return true;
    }

    Handle file_;
    char buffer_[4096];
    std::size_t position_{0U};
    std::size_t size_{0U};
};

class TextWriter {
 public:
    explicit TextWriter(Handle file) : file_(file) {}

    void put(const char* text, std::size_t length) {
        for (std::size_t index = 0U; index < length; ++index) {
            if (used_ == sizeof(buffer_)) {
                flush();
            }
            buffer_[used_] = text[index];
            ++used_;
        }
    }

    // Writes what remains and closes the file. False when anything could not be kept.
    bool close() {
        flush();
        return target::close(file_) && good_;
    }

 private:
    void flush() {
        good_ = (write(file_, buffer_, used_) == used_) && good_;
        used_ = 0U;
    }

    Handle file_;
    char buffer_[4096];
    std::size_t used_{0U};
    bool good_{true};
};

}  // namespace target
