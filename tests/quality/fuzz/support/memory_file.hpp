// A file that lives in memory, for readers that want a path.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/quality/fuzz/support/require.hpp"

namespace fuzz {

class MemoryFile {
 public:
    MemoryFile() : descriptor_{memfd_create("fuzz", 0U)} {
        require(descriptor_ >= 0, "a file in memory can be made");
        path_ = "/proc/self/fd/" + std::to_string(descriptor_);
    }
    ~MemoryFile() { close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const std::string& path() const { return path_; }

    void write(const void* bytes, std::size_t size) {
        require(pwrite(descriptor_, bytes, size, 0) == static_cast<ssize_t>(size), "the file can be written");
        if (size < size_) {  // only then: it takes as long as the writing
            require(ftruncate(descriptor_, static_cast<off_t>(size)) == 0, "the file can be shortened");
        }
        size_ = size;
    }

 private:
    int descriptor_;
    std::string path_;
    std::size_t size_{0U};
};

}  // namespace fuzz
