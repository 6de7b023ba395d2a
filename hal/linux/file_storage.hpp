// File storage: a record in a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "rsi/hal/storage.hpp"

namespace rsi::hal {

// A record is written beside the old one and takes its name at the end, so that a process that is killed
// leaves one of the two. It is in the kernel's hands then: a machine that loses its power may lose it.
class FileStorage final : public Storage {
 public:
    // The file need not be there; its folder must.
    explicit FileStorage(std::string path);

    // `never_written` without a file, `unreadable` where it cannot be opened or has another length.
    Reading read(std::uint8_t* bytes, std::size_t length) noexcept override;
    // False where the file cannot be written.
    bool write(const std::uint8_t* bytes, std::size_t length) noexcept override;

 private:
    std::string path_;
    std::string new_path_;
};

}  // namespace rsi::hal
