// Section store: a downloaded parameter section in the memory that outlives a loss of power, instead of that
// of the image from the next start on.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rsi/ecu/application/section_record.hpp"
#include "rsi/ecu/diagnosis/section_target.hpp"

namespace rsi::diagnosis {

class SectionStore final : public SectionTarget {
 public:
    // Both must outlive this object. Without `authority` the build allows sections without a seal, and
    // length() is that of one.
    explicit SectionStore(application::SectionRecord& record,
                          application::SectionAuthority* authority = nullptr) noexcept
        : record_{record}, authority_{authority} {}

    // Before the first cycle, unless the calibration pages of the same record are initialised. True when a
    // section has been stored and is good: then section() has it, until the next download begins. The ECU
    // checks it all the same.
    [[gnu::cold]] bool restore() noexcept;
    // Fault found by restore(), for RolloverEcu::report_stored_section; `none` also where nothing is stored.
    application::ParametersRefusal refusal() const noexcept { return refusal_; }
    const std::uint8_t* section() const noexcept { return bytes_.data(); }

    std::size_t length() const noexcept override {
        return (authority_ != nullptr) ? application::seal::sealed_length : application::section::length;
    }
    void put(std::size_t place, std::uint8_t byte) noexcept override { bytes_[place] = byte; }
    SectionAnswer store(std::uint8_t& reason) noexcept override;
    bool is_failing() const noexcept override { return record_.is_failing(); }

 private:
    application::ParametersRefusal check() noexcept;

    application::SectionRecord& record_;
    application::SectionAuthority* authority_;
    application::SectionBytes bytes_{};  // the seal stays zero in a build without
    application::ParametersRefusal refusal_{application::ParametersRefusal::none};
};

}  // namespace rsi::diagnosis
