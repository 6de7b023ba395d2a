// Section target: where a downloaded parameter section goes.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rsi::diagnosis {

enum class SectionAnswer : std::uint8_t {
    stored,   // good, and kept for the next start
    refused,  // and the section that was there is still there
    busy,     // the memory cannot take it now; ask again
};

class SectionTarget {
 public:
    SectionTarget(const SectionTarget&) = delete;
    SectionTarget& operator=(const SectionTarget&) = delete;

    // Bytes of a whole section.
    virtual std::size_t length() const noexcept = 0;

    // Keeps a byte of a new section until all of it is stored; `place` is below length().
    virtual void put(std::size_t place, std::uint8_t byte) noexcept = 0;

    // All of it has been put: checks it as a whole and stores it as a whole, or leaves all as it was. Asked
    // once a cycle while it is busy.
    // `reason`, where it is refused: the number that is sent as ParametersRefusal after a start with it.
    virtual SectionAnswer store(std::uint8_t& reason) noexcept = 0;

    // The memory has refused many tries, and has taken none since.
    virtual bool is_failing() const noexcept = 0;

 protected:
    SectionTarget() = default;
    ~SectionTarget() = default;
};

}  // namespace rsi::diagnosis
