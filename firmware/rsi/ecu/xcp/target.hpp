// Target: what the slave sees and changes of the control unit.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rsi/ecu/xcp/packet.hpp"

namespace rsi::xcp {

// The one segment of calibration memory.
enum class Page : std::uint8_t { working = 0, reference = 1 };
inline constexpr std::uint8_t page_count = 2U;

// Addresses are the target's own; both pages have the same ones. No call blocks, allocates or throws.
class Target {
 public:
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    // False, and nothing is read, where not all of `count` bytes at `address` may be read.
    virtual bool read(std::uint32_t address, Page page, std::uint8_t* bytes,
                      std::size_t count) const noexcept = 0;

    // CRC-32 (zip, Ethernet) over as many bytes; false as read().
    virtual bool checksum(std::uint32_t address, Page page, std::size_t count,
                          std::uint32_t& sum) const noexcept = 0;

    // Into the working page. none: it was taken.
    virtual Error write(std::uint32_t address, const std::uint8_t* bytes, std::size_t count) noexcept = 0;

    // Which page the control unit works with from a cycle's start on. none, or why it goes on with the other.
    virtual Error select(Page page) noexcept = 0;
    virtual Page selected() const noexcept = 0;

    // The reference page's content into the working page.
    virtual Error copy_reference() noexcept = 0;

    // The working page, beyond a loss of power.
    virtual Error store() noexcept = 0;

    struct Range {
        std::uint32_t address;
        std::uint32_t length;
    };
    virtual Range calibration() const noexcept = 0;  // the segment
    virtual Range name() const noexcept = 0;         // the text that GET_ID answers with, to be read there

 protected:
    Target() = default;
    ~Target() = default;
};

}  // namespace rsi::xcp
