#include "xcp/slave.hpp"

namespace xcp {
namespace {

constexpr std::uint8_t calibration_resource = 0x01U;
constexpr std::uint8_t daq_resource = 0x04U;
constexpr std::uint8_t optional_mode = 0x80U;  // GET_COMM_MODE_INFO is there; Intel, bytes, no block mode
constexpr std::uint8_t layer_version = 0x01U;
constexpr std::uint8_t driver_version = 0x01U;

constexpr std::size_t block_length = access_control::Block{}.size();
constexpr std::size_t piece_length = packet_length - 2U;  // of a seed or key in one packet

// The bytes that a command has at least, with its code.
std::uint8_t least_length(Command command) noexcept {
    switch (command) {
        case Command::get_id:
        case Command::set_request:
        case Command::upload:
        case Command::download:
        case Command::start_stop_synch:
            return 2U;
        case Command::get_seed:
        case Command::unlock:
        case Command::get_cal_page:
        case Command::set_segment_mode:
        case Command::get_segment_mode:
            return 3U;
        case Command::set_cal_page:
        case Command::get_page_info:
        case Command::clear_daq_list:
        case Command::get_daq_list_mode:
        case Command::start_stop_daq_list:
        case Command::get_daq_event_info:
        case Command::alloc_daq:
            return 4U;
        case Command::get_segment_info:
        case Command::copy_cal_page:
        case Command::alloc_odt:
            return 5U;
        case Command::set_daq_ptr:
        case Command::alloc_odt_entry:
            return 6U;
        case Command::set_mta:
        case Command::short_upload:
        case Command::build_checksum:
        case Command::write_daq:
        case Command::set_daq_list_mode:
            return 8U;
        default:
            return 1U;
    }
}

bool needs_key(Command command) noexcept {
    switch (command) {
        case Command::download:
        case Command::set_request:
        case Command::set_cal_page:
        case Command::set_segment_mode:
        case Command::copy_cal_page:
        case Command::clear_daq_list:
        case Command::set_daq_ptr:
        case Command::write_daq:
        case Command::set_daq_list_mode:
        case Command::start_stop_daq_list:
        case Command::start_stop_synch:
        case Command::free_daq:
        case Command::alloc_daq:
        case Command::alloc_odt:
        case Command::alloc_odt_entry:
            return true;
        default:
            return false;
    }
}

}  // namespace

void Slave::keep(const hal::CanFrame& frame) noexcept {
    if (frame.length == 0U) {
        return;
    }
    command_ = Packet{frame.data[0]};
    for (std::size_t place = 1U; place < frame.length; ++place) {
        command_.add_byte(frame.data[place]);
    }
    has_command_ = true;
}

void Slave::work(hal::CanBus& bus, hal::Time now, std::uint32_t missed_cycles) noexcept {
    if (has_command_) {
        has_command_ = false;
        Packet packet{};
        if (answer(now, packet)) {
            static_cast<void>(
                send_packet(bus, identifiers_.answer, packet));  // the master repeats its command
        }
    }
    overload_ = !daq_.sample(bus, identifiers_.answer, now, missed_cycles) || overload_;
    const auto tell = [&](bool& pending, Event event) {
        if (pending) {
            const Packet packet = Packet{event_code}.add_byte(static_cast<std::uint32_t>(event));
            pending = !send_packet(bus, identifiers_.answer, packet);
        }
    };
    tell(overload_, Event::daq_overload);
    tell(stored_, Event::store_cal);
}

// False where a slave keeps silent: without a connection it hears nothing but CONNECT.
bool Slave::answer(hal::Time now, Packet& packet) noexcept {
    const auto command = static_cast<Command>(command_.byte(0U));
    if (command == Command::connect) {
        // Mode 1 is for slaves whose identifiers a user sets; byte 1 missing is mode 0.
        if (command_.byte(1U) != 0U) {
            return false;
        }
        packet = connect();
        return true;
    }
    if (!connected_) {
        return false;
    }
    if (command_.length() < least_length(command)) {
        packet = negative(Error::syntax);
    } else if (needs_key(command) && !access_.is_unlocked()) {
        packet = negative(Error::access_locked);
    } else {
        packet = answer_in_session(command, now);
    }
    return true;
}

Packet Slave::answer_in_session(Command command, hal::Time now) noexcept {
    switch (command) {
        case Command::set_cal_page:
        case Command::get_cal_page:
        case Command::get_pag_processor_info:
        case Command::get_segment_info:
        case Command::get_page_info:
        case Command::set_segment_mode:
        case Command::get_segment_mode:
        case Command::copy_cal_page:
            return answer_about_pages(command);
        case Command::get_daq_list_mode:
        case Command::get_daq_clock:
        case Command::get_daq_processor_info:
        case Command::get_daq_resolution_info:
        case Command::get_daq_event_info:
            return answer_about_lists(command, now);
        case Command::clear_daq_list:
        case Command::set_daq_ptr:
        case Command::write_daq:
        case Command::set_daq_list_mode:
        case Command::start_stop_daq_list:
        case Command::start_stop_synch:
        case Command::free_daq:
        case Command::alloc_daq:
        case Command::alloc_odt:
        case Command::alloc_odt_entry:
            return change_lists(command);
        default:
            return answer_standard(command);
    }
}

Packet Slave::answer_standard(Command command) noexcept {
    switch (command) {
        case Command::disconnect:
            disconnect();
            return positive();
        case Command::get_status:
            return status();
        case Command::synch:
            return negative(Error::synch);
        case Command::get_comm_mode_info:
            return positive().add_word(0U).add_half_word(0U).add_byte(driver_version);
        case Command::get_id:
            return identification();
        case Command::set_request:
            return store();
        case Command::get_seed:
            return seed();
        case Command::unlock:
            return unlock();
        case Command::set_mta:
            if (command_.byte(3U) != 0U) {
                return negative(Error::out_of_range);  // no address extension
            }
            address_ = command_.word(4U);
            return positive();
        case Command::upload:
            return upload(address_);
        case Command::short_upload:
            if (command_.byte(3U) != 0U) {
                return negative(Error::out_of_range);
            }
            return upload(command_.word(4U));
        case Command::build_checksum:
            return checksum();
        case Command::download:
            return download();
        default:
            return negative(Error::unknown);
    }
}

Packet Slave::connect() noexcept {
    disconnect();
    connected_ = true;
    visible_ = Page::working;
    address_ = 0U;
    return positive()
        .add_byte(calibration_resource | daq_resource)
        .add_byte(optional_mode)
        .add_byte(packet_length)
        .add_half_word(packet_length)
        .add_byte(layer_version)
        .add_byte(layer_version);
}

void Slave::disconnect() noexcept {
    connected_ = false;
    overload_ = false;
    stored_ = false;
    seed_left_ = 0U;
    key_got_ = 0U;
    access_.lock();
    daq_.free();
}

std::uint8_t Slave::locked_resources() const noexcept {
    return access_.is_unlocked() ? std::uint8_t{0U}
                                 : static_cast<std::uint8_t>(calibration_resource | daq_resource);
}

Packet Slave::status() const noexcept {
    const std::uint32_t running = daq_.is_running() ? 0x40U : 0U;
    return positive().add_byte(running).add_byte(locked_resources()).add_byte(0U).add_half_word(0U);
}

// Text (0), and the A2L's name without an ending (1): one and the same, read by uploads.
Packet Slave::identification() noexcept {
    if (command_.byte(1U) > 1U) {
        return positive().add_byte(0U).add_half_word(0U).add_word(0U);
    }
    const Target::Range name = target_.name();
    address_ = name.address;
    return positive().add_byte(0U).add_half_word(0U).add_word(name.length);
}

// In pieces: how much is left with this one, and its bytes. Nothing is left to be unlocked where a seed has
// no length.
Packet Slave::seed() noexcept {
    const std::uint8_t resource = command_.byte(2U);
    const bool is_first = (command_.byte(1U) == 0U);
    if (is_first) {
        if ((resource != calibration_resource) && (resource != daq_resource)) {
            return negative(Error::out_of_range);
        }
        key_got_ = 0U;
        seed_left_ = 0U;
        if (access_.is_unlocked()) {
            return positive().add_byte(0U);
        }
        if (!access_.give_seed(exchanged_)) {
            return negative(Error::temporarily_not_accessible);
        }
        seed_left_ = static_cast<std::uint8_t>(block_length);
    } else if (seed_left_ == 0U) {
        return negative(Error::sequence);
    } else {
        // The next piece.
    }
    Packet packet = positive().add_byte(seed_left_);
    while ((seed_left_ > 0U) && (packet.room() > 0U)) {
        packet.add_byte(exchanged_[block_length - seed_left_]);
        --seed_left_;
    }
    return packet;
}

// The same way back; the byte before each piece says how much is left with it.
Packet Slave::unlock() noexcept {
    const std::size_t left = block_length - key_got_;
    const std::size_t piece = (left < piece_length) ? left : piece_length;
    if ((command_.byte(1U) != left) || (command_.length() < 2U + piece)) {
        key_got_ = 0U;
        return negative(Error::sequence);
    }
    for (std::size_t place = 0U; place < piece; ++place) {
        exchanged_[key_got_] = command_.byte(2U + place);
        ++key_got_;
    }
    if (key_got_ == block_length) {
        key_got_ = 0U;
        if (access_.take_key(exchanged_) != access_control::KeyAnswer::unlocked) {
            disconnect();  // as the standard has it
            return negative(Error::access_locked);
        }
    }
    return positive().add_byte(locked_resources());
}

Packet Slave::upload(std::uint32_t address) noexcept {
    std::array<std::uint8_t, packet_length> bytes{};
    const std::size_t count = command_.byte(1U);
    if ((count == 0U) || (count > packet_length - 1U)) {
        return negative(Error::out_of_range);
    }
    if (!target_.read(address, visible_, bytes.data(), count)) {
        return negative(Error::access_denied);
    }
    address_ = address + static_cast<std::uint32_t>(count);
    Packet packet = positive();
    for (std::size_t place = 0U; place < count; ++place) {
        packet.add_byte(bytes[place]);
    }
    return packet;
}

Packet Slave::checksum() noexcept {
    constexpr std::uint32_t type_crc_32 = 0x09U;
    const std::uint32_t count = command_.word(4U);
    std::uint32_t sum = 0U;
    if (!target_.checksum(address_, visible_, count, sum)) {
        return negative(Error::access_denied);
    }
    address_ += count;
    return positive().add_byte(type_crc_32).add_half_word(0U).add_word(sum);
}

Packet Slave::download() noexcept {
    const std::size_t count = command_.byte(1U);
    if ((count == 0U) || (count > piece_length)) {
        return negative(Error::out_of_range);
    }
    if (command_.length() < 2U + count) {
        return negative(Error::syntax);
    }
    if (visible_ != Page::working) {
        return negative(Error::write_protected);
    }
    std::array<std::uint8_t, piece_length> bytes{};
    for (std::size_t place = 0U; place < count; ++place) {
        bytes[place] = command_.byte(2U + place);
    }
    const Error error = target_.write(address_, bytes.data(), count);
    if (error == Error::none) {
        address_ += static_cast<std::uint32_t>(count);
    }
    return answer_to(error);
}

Packet Slave::store() noexcept {
    constexpr std::uint8_t store_cal = 0x01U;
    if (command_.byte(1U) != store_cal) {
        return negative(Error::out_of_range);
    }
    const Error error = target_.store();
    stored_ = (error == Error::none);
    return answer_to(error);
}

}  // namespace xcp
