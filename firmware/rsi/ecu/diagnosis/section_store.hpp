// Section store: a downloaded parameter section in the memory that outlives a loss of power, instead of that
// of the image from the next start on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/ecu/application/section_authority.hpp"
#include "rsi/ecu/diagnosis/section_target.hpp"
#include "rsi/hal/storage.hpp"

namespace rsi::diagnosis {

class SectionStore final : public SectionTarget {
 public:
    // Both must outlive this object. `storage` takes a record of length() bytes. Without `authority` the
    // build allows sections without a seal, and length() is that of one.
    explicit SectionStore(hal::Storage& storage, application::SectionAuthority* authority = nullptr) noexcept
        : storage_{storage}, authority_{authority} {}

    // Before the first cycle. True when a section has been stored and is good: then section() has it, until
    // the next download begins. The ECU checks it all the same.
    [[gnu::cold]] bool restore() noexcept;
    const std::uint8_t* section() const noexcept { return bytes_.data(); }

    std::size_t length() const noexcept override {
        return (authority_ != nullptr) ? application::seal::sealed_length : application::section::length;
    }
    void put(std::size_t place, std::uint8_t byte) noexcept override { bytes_[place] = byte; }
    SectionAnswer store(std::uint8_t& reason) noexcept override;

 private:
    application::ParametersRefusal check() noexcept;

    hal::Storage& storage_;
    application::SectionAuthority* authority_;
    std::array<std::uint8_t, application::seal::sealed_length> bytes_{};
};

}  // namespace rsi::diagnosis
