// Storage: a few bytes that outlive a loss of power.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rsi::hal {

// One record of a fixed length: EEPROM, a page of flash memory, a file. The caller protects a record by a
// check word: power may go while it is written.
class Storage {
 public:
    Storage(const Storage&) = delete;
    Storage& operator=(const Storage&) = delete;

    // Called before the first cycle. Fills `bytes` with what was stored last; false where nothing can be
    // read.
    virtual bool read(std::uint8_t* bytes, std::size_t length) noexcept = 0;

    // Called within a cycle, so it returns at once: what takes longer goes on in the background, from a copy.
    // False where the record cannot be taken now; the caller tries again later.
    virtual bool write(const std::uint8_t* bytes, std::size_t length) noexcept = 0;

 protected:
    Storage() = default;
    ~Storage() = default;
};

}  // namespace rsi::hal
