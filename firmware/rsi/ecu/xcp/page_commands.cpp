// Commands about the pages of the one segment.
#include "rsi/ecu/xcp/slave.hpp"

namespace rsi::xcp {
namespace {

constexpr std::uint8_t for_control_unit = 0x01U;  // modes of SET_CAL_PAGE and GET_CAL_PAGE
constexpr std::uint8_t for_master = 0x02U;
constexpr std::uint8_t all_segments = 0x80U;
constexpr std::uint8_t freeze = 0x01U;

// The control unit and the master may use either page, together or alone; only the working page is written.
constexpr std::uint8_t reference_access = 0x0FU;
constexpr std::uint8_t working_access = 0x3FU;

}  // namespace

Error Slave::answer_about_pages(Command command) noexcept {
    switch (command) {
        case Command::set_cal_page:
            return set_page();
        case Command::get_cal_page:
            return page();
        case Command::get_pag_processor_info:
            answer_.add_byte(1U).add_byte(freeze);
            return Error::none;  // one segment
        case Command::get_segment_info:
            return segment_info();
        case Command::get_page_info:
            return page_info();
        case Command::set_segment_mode:
            if (command_.byte(2U) != 0U) {
                return Error::segment_not_valid;
            }
            freezes_ = ((command_.byte(1U) & freeze) != 0U);
            return Error::none;
        case Command::get_segment_mode:
            if (command_.byte(2U) != 0U) {
                return Error::segment_not_valid;
            }
            answer_.add_byte(0U).add_byte(freezes_ ? freeze : 0U);
            return Error::none;
        default:
            return copy_page();
    }
}

Error Slave::set_page() noexcept {
    const std::uint8_t mode = command_.byte(1U);
    const std::uint8_t number = command_.byte(3U);
    if (((mode & all_segments) == 0U) && (command_.byte(2U) != 0U)) {
        return Error::segment_not_valid;
    }
    if (number >= page_count) {
        return Error::page_not_valid;
    }
    if (((mode & for_control_unit) == 0U) && ((mode & for_master) == 0U)) {
        return Error::mode_not_valid;
    }
    const auto page = static_cast<Page>(number);
    if ((mode & for_control_unit) != 0U) {
        const Error error = target_.select(page);
        if (error != Error::none) {
            return error;
        }
    }
    if ((mode & for_master) != 0U) {
        visible_ = page;
    }
    return Error::none;
}

Error Slave::page() noexcept {
    const std::uint8_t mode = command_.byte(1U);
    if (command_.byte(2U) != 0U) {
        return Error::segment_not_valid;
    }
    if ((mode != for_control_unit) && (mode != for_master)) {
        return Error::mode_not_valid;
    }
    const Page page = (mode == for_control_unit) ? target_.selected() : visible_;
    answer_.add_zeros(2U).add_byte(static_cast<std::uint32_t>(page));
    return Error::none;
}

Error Slave::segment_info() noexcept {
    const std::uint8_t mode = command_.byte(1U);
    const std::uint8_t what = command_.byte(3U);
    if (command_.byte(2U) != 0U) {
        return Error::segment_not_valid;
    }
    if (mode == 1U) {  // pages; no address extension, mapping, compression, encryption
        answer_.add_byte(page_count).add_zeros(4U);
        return Error::none;
    }
    if ((mode != 0U) || (what > 1U)) {
        return Error::out_of_range;
    }
    const Target::Range range = target_.calibration();
    answer_.add_zeros(3U).add_word((what == 0U) ? range.address : range.length);
    return Error::none;
}

Error Slave::page_info() noexcept {
    const std::uint8_t number = command_.byte(3U);
    if (command_.byte(2U) != 0U) {
        return Error::segment_not_valid;
    }
    if (number >= page_count) {
        return Error::page_not_valid;
    }
    const bool is_working = (static_cast<Page>(number) == Page::working);
    answer_.add_byte(is_working ? working_access : reference_access).add_byte(0U);
    return Error::none;
}

Error Slave::copy_page() noexcept {
    if ((command_.byte(1U) != 0U) || (command_.byte(3U) != 0U)) {
        return Error::segment_not_valid;
    }
    if ((command_.byte(2U) >= page_count) || (command_.byte(4U) >= page_count)) {
        return Error::page_not_valid;
    }
    if (static_cast<Page>(command_.byte(4U)) == Page::reference) {
        return Error::write_protected;
    }
    const bool from_reference = (static_cast<Page>(command_.byte(2U)) == Page::reference);
    return from_reference ? target_.copy_reference() : Error::none;
}

}  // namespace rsi::xcp
