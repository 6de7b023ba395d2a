// Commands about the lists of what is measured.
#include "rsi/ecu/xcp/slave.hpp"

namespace rsi::xcp {
namespace {

// Dynamic lists, prescaler, timestamps; an event reports an overload.
constexpr std::uint8_t daq_properties = 0x01U | 0x02U | 0x10U | 0x80U;
// Two bytes in units of 100 us, where a list's mode asks for them.
constexpr std::uint8_t timestamp_format = (0x05U << 4U) | timestamp_length;
constexpr std::uint8_t whole_bytes = 0xFFU;  // no bit of them

struct EventChannel {
    std::uint8_t period_ms;
    std::uint8_t priority;
};
constexpr std::uint8_t unit_1_ms = 6U;
constexpr std::array<EventChannel, event_count> events{{{10U, 1U}, {100U, 0U}}};

}  // namespace

Error Slave::answer_about_lists(Command command, hal::Time now) noexcept {
    const std::uint32_t list = command_.half_word(2U);  // of a command that names one
    switch (command) {
        case Command::clear_daq_list:
            return daq_.clear(list);
        case Command::set_daq_ptr:
            return daq_.point_to(list, command_.byte(4U), command_.byte(5U));
        case Command::write_daq:
            if ((command_.byte(1U) != whole_bytes) || (command_.byte(3U) != 0U)) {
                return Error::out_of_range;
            }
            return daq_.write(command_.word(4U), command_.byte(2U));
        case Command::set_daq_list_mode:
            return daq_.set_mode(list, command_.byte(1U), command_.half_word(4U), command_.byte(6U));
        case Command::get_daq_list_mode:
            return daq_.mode(list, answer_);
        case Command::start_stop_daq_list:
            return start_or_stop_list(list);
        case Command::start_stop_synch:
            return start_or_stop_all();
        case Command::get_daq_clock:
            answer_.add_zeros(3U).add_word(ticks_of(now));
            return Error::none;
        case Command::get_daq_processor_info:
            return processor_info();
        case Command::get_daq_resolution_info:
            answer_.add_byte(1U)
                .add_byte(largest_entry)
                .add_zeros(2U)  // no stimulation
                .add_byte(timestamp_format)
                .add_half_word(1U);
            return Error::none;
        case Command::get_daq_event_info:
            return event_info();
        case Command::free_daq:
            daq_.release();
            return Error::none;
        case Command::alloc_daq:
            return daq_.allot_lists(list);  // as many
        case Command::alloc_odt:
            return daq_.allot_parts(list, command_.byte(4U));
        case Command::alloc_odt_entry:
            return daq_.allot_entries(list, command_.byte(4U), command_.byte(5U));
        default:
            return Error::unknown;
    }
}

Error Slave::start_or_stop_list(std::uint32_t list) noexcept {
    Error error = Error::mode_not_valid;
    if (command_.byte(1U) == 0U) {
        error = daq_.stop(list);
    } else if (command_.byte(1U) == 1U) {
        error = daq_.start(list);
    } else if (command_.byte(1U) == 2U) {
        error = daq_.select(list);
    } else {
        // There is no other.
    }
    if (error == Error::none) {
        answer_.add_byte(daq_.first_part(list));
    }
    return error;
}

Error Slave::start_or_stop_all() noexcept {
    Error error = Error::none;
    if (command_.byte(1U) == 0U) {
        daq_.stop_all();
    } else if (command_.byte(1U) == 1U) {
        error = daq_.start_selected();
    } else if (command_.byte(1U) == 2U) {
        daq_.stop_selected();
    } else {
        error = Error::mode_not_valid;
    }
    return error;
}

// Samples bear the number of their part alone (absolute ODT number).
Error Slave::processor_info() noexcept {
    answer_.add_byte(daq_properties).add_half_word(daq_.count()).add_half_word(event_count).add_zeros(2U);
    return Error::none;
}

Error Slave::event_info() noexcept {
    constexpr std::uint8_t for_measurement = 0x04U;
    const std::uint32_t event = command_.half_word(2U);
    if (event >= event_count) {
        return Error::out_of_range;
    }
    answer_.add_byte(for_measurement)
        .add_byte(most_lists)
        .add_byte(0U)  // the A2L has its name
        .add_byte(events[event].period_ms)
        .add_byte(unit_1_ms)
        .add_byte(events[event].priority);
    return Error::none;
}

}  // namespace rsi::xcp
