// Answer writer: the words that a program on the target gives back to the host.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "tests/targets/support/program.hpp"

namespace budgets {

class AnswerWriter {
 public:
    // Text that does not fit is dropped, and save() reports it.
    void add(uint32_t word) {
        if (count_ < most_words) {
            words_[count_] = word;
        }
        ++count_;
    }

    bool save(const char* path) const {
        const target::Handle file = target::open_to_write(path);
        if ((file == target::no_file) || (count_ > most_words)) {
            return false;
        }
        const size_t size = count_ * sizeof(uint32_t);
        const bool written = (target::write(file, words_, size) == size);
        return target::close(file) && written;
    }

 private:
    static constexpr size_t most_words = 65536U;
    uint32_t words_[most_words];
    size_t count_;
};

}  // namespace budgets
