// Calibration pages: the parameters and outputs that an XCP master can calibrate and measure.
#pragma once

#include <array>
#include <cstdint>

#include "rsi/ecu/application/parameter_section.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "rsi/ecu/application/section_record.hpp"
#include "rsi/ecu/xcp/target.hpp"
#include "rsi/parameter_change.hpp"

namespace rsi::application {

// XCP addresses. They are virtual, so that an A2L file fits a firmware version and not one link of it.
// Parameters: the values of a parameter section in its order; outputs: rsi_outputs; inputs: the rsi_inputs
// that the monitoring has let through; codes: the sets of the diagnostic codes that are set or confirmed, and
// of those that are confirmed, a bit for each code's number; change: selected page, change in progress,
// refused field, one spare byte, number of changes. Words of four bytes are little-endian.
namespace calibration_map {

inline constexpr std::uint32_t parameters_at = 0x10000U;
inline constexpr std::uint32_t parameters_length = 4U * section::value_count;
inline constexpr std::uint32_t outputs_at = 0x20000U;
inline constexpr std::uint32_t outputs_length = sizeof(rsi::Outputs);
inline constexpr std::uint32_t inputs_at = 0x24000U;
inline constexpr std::uint32_t inputs_length = sizeof(rsi::Inputs);
inline constexpr std::uint32_t codes_at = 0x28000U;
inline constexpr std::uint32_t codes_length = 2U * sizeof(monitoring::CodeSet);
inline constexpr std::uint32_t change_at = 0x30000U;
inline constexpr std::uint32_t change_length = 8U;
inline constexpr std::uint32_t epk_at = 0x40000U;
inline constexpr std::uint32_t name_at = 0x50000U;

}  // namespace calibration_map

// The working page is a parameter section in RAM, the reference page that of the image. The working page
// takes whole values only: a value that arrives in two writes is held back until it is complete. While the
// working page is selected, each write starts a change that is validated as a whole and taken over between
// two cycles. A refused change leaves the page as written and the ECU on its previous parameters; `refused
// field` names the parameter. To change several values at once, select the reference page, write, and select
// the working page.
class CalibrationPages final : public xcp::Target {
 public:
    // All must outlive the pages. `reference`: a parameter section, of which `length` bytes may be read.
    // Without `stored` (nullptr) store() is refused.
    CalibrationPages(RolloverEcu& ecu, const std::uint8_t* reference, std::size_t length,
                     SectionRecord* stored) noexcept
        : ecu_{ecu}, reference_{reference}, reference_length_{length}, stored_{stored} {}

    // Once, instead of RolloverEcu::init: starts with the stored section if it is accepted, else with the
    // reference. Has the ECU report a stored section that is refused.
    ParameterSectionAnswer init() noexcept;

    // Between two cycles: prepares a change, or hands it to the control unit; reports the memory, which
    // diagnosis may use as well.
    void begin_cycle() noexcept {
        if (stored_ != nullptr) {
            ecu_.report_calibration_storage(stored_->is_failing());
        }
        if (is_changing_) {
            go_on();
        }
    }

    bool read(std::uint32_t address, xcp::Page page, std::uint8_t* bytes,
              std::size_t count) const noexcept override;
    bool checksum(std::uint32_t address, xcp::Page page, std::size_t count,
                  std::uint32_t& sum) const noexcept override;
    xcp::Error write(std::uint32_t address, const std::uint8_t* bytes, std::size_t count) noexcept override;
    xcp::Error select(xcp::Page page) noexcept override;
    xcp::Page selected() const noexcept override { return selected_; }
    xcp::Error copy_reference() noexcept override;
    xcp::Error store() noexcept override;
    Range calibration() const noexcept override;
    Range name() const noexcept override;

 private:
    static constexpr std::uint32_t most_stores = 100U;  // of a start
    bool start_with_stored(ParameterSectionAnswer& answer) noexcept;
    void take_reference() noexcept;
    [[gnu::cold]] void go_on() noexcept;
    bool begin_change(const std::uint8_t* section) noexcept;
    std::uint8_t byte_at(std::uint32_t address, xcp::Page page) const noexcept;
    std::uint8_t change_byte(std::uint32_t place) const noexcept;
    std::uint8_t measured_byte(std::uint32_t address) const noexcept;

    RolloverEcu& ecu_;
    const std::uint8_t* reference_;
    std::size_t reference_length_;
    SectionRecord* stored_;
    SectionBytes working_{};
    bool is_usable_{false};  // the reference has the form of a section; its values may be refused
    xcp::Page selected_{xcp::Page::working};
    rsi::ParameterChange change_{};
    bool is_changing_{false};
    std::uint8_t refused_field_{0U};  // 0: none, else 1 + index in parameter_fields, then selection_fields
    std::uint32_t changes_{0U};       // taken over since the start
    std::uint32_t stores_left_{most_stores};
    std::array<std::uint8_t, 4> piece_{};  // of a value that is incomplete
    std::uint32_t piece_ends_at_{0U};      // offset from parameters_at; a multiple of 4: no incomplete value
};

}  // namespace rsi::application
