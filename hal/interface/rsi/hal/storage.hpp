// Storage: a few bytes that outlive a loss of power.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rsi::hal {

enum class Reading : std::uint8_t {
    stored,         // the bytes are what was stored last, or what has become of it
    never_written,  // nothing has been stored since the memory was made: a new control unit
    unreadable,     // a record is there, but of another length, or the memory does not give it
};

// One record of a fixed length: EEPROM, a page of flash memory, a file. The caller protects a record by a
// check word: power may go while it is written.
class Storage {
 public:
    Storage(const Storage&) = delete;
    Storage& operator=(const Storage&) = delete;

    // Called before the first cycle. Fills `bytes` where it answers `stored`; else they are undefined. A
    // memory that cannot tell a new record from a lost one answers `unreadable`, because what counts attempts
    // begins anew on `never_written`.
    virtual Reading read(std::uint8_t* bytes, std::size_t length) noexcept = 0;

    // Called within a cycle, so it returns at once: what takes longer goes on in the background, from a copy.
    // False where the record cannot be taken now; the caller tries again later.
    virtual bool write(const std::uint8_t* bytes, std::size_t length) noexcept = 0;

 protected:
    Storage() = default;
    ~Storage() = default;
};

}  // namespace rsi::hal
