// Recording reader: the host's file, read whole and taken apart word by word.
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "tests/targets/support/program.hpp"

namespace budgets {

class RecordingReader {
 public:
    // False when the file cannot be read, does not fit or does not begin with `magic`.
    bool load(const char* path, uint32_t magic) {
        const target::Handle file = target::open_to_read(path);
        if (file == target::no_file) {
            return false;
        }
        size_ = target::read(file, bytes_, sizeof(bytes_));
        target::close(file);
        position_ = 0U;
        return (size_ < sizeof(bytes_)) && (take<uint32_t>() == magic);
    }

    // Beyond the end: zeros, and complete() is false.
    template <typename Value>
    Value take() {
        Value value{};
        if (position_ + sizeof(Value) <= size_) {
            memcpy(&value, bytes_ + position_, sizeof(Value));
        }
        position_ += sizeof(Value);
        return value;
    }

    bool complete() const { return position_ == size_; }

 private:
    alignas(8) unsigned char bytes_[3U * 1024U * 1024U];
    size_t size_;
    size_t position_;
};

}  // namespace budgets
