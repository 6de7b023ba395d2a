#include "rsi/ecu/xcp/slave.hpp"

namespace rsi::xcp {
namespace {

constexpr std::uint8_t calibration_resource = 0x01U;
constexpr std::uint8_t daq_resource = 0x04U;
constexpr std::uint8_t optional_mode = 0x80U;  // GET_COMM_MODE_INFO is there; Intel, bytes, no block mode
constexpr std::uint8_t layer_version = 0x01U;
constexpr std::uint8_t driver_version = 0x01U;

constexpr std::size_t block_length = access::Block{}.size();
constexpr std::size_t piece_length = packet_length - 2U;  // of a seed or key in one packet

// A command's least number of bytes, with its code, and whether it needs the key.
constexpr std::uint8_t key = 0x80U;
constexpr std::uint8_t first_in_form = 0xD3U;
constexpr std::array<std::uint8_t, 45> form{{
    6U | key,  // D3 ALLOC_ODT_ENTRY
    5U | key,  // D4 ALLOC_ODT
    4U | key,  // D5 ALLOC_DAQ
    1U | key,  // D6 FREE_DAQ
    4U,        // D7 GET_DAQ_EVENT_INFO
    1U,       1U, 1U, 1U, 1U,
    2U | key,  // DD START_STOP_SYNCH
    4U | key,  // DE START_STOP_DAQ_LIST
    4U,        // DF GET_DAQ_LIST_MODE
    8U | key,  // E0 SET_DAQ_LIST_MODE
    8U | key,  // E1 WRITE_DAQ
    6U | key,  // E2 SET_DAQ_PTR
    4U | key,  // E3 CLEAR_DAQ_LIST
    5U | key,  // E4 COPY_CAL_PAGE
    3U,        // E5 GET_SEGMENT_MODE
    3U | key,  // E6 SET_SEGMENT_MODE
    4U,        // E7 GET_PAGE_INFO
    5U,        // E8 GET_SEGMENT_INFO
    1U,        // E9
    3U,        // EA GET_CAL_PAGE
    4U | key,  // EB SET_CAL_PAGE
    1U,       1U, 1U, 1U,
    2U | key,  // F0 DOWNLOAD
    1U,       1U,
    8U,        // F3 BUILD_CHECKSUM
    8U,        // F4 SHORT_UPLOAD
    2U,        // F5 UPLOAD
    8U,        // F6 SET_MTA
    3U,        // F7 UNLOCK
    3U,        // F8 GET_SEED
    2U | key,  // F9 SET_REQUEST
    2U,        // FA GET_ID
    1U,       1U, 1U, 1U, 1U,
}};

// The code alone of an unknown command.
std::uint8_t form_of(std::uint8_t code) noexcept {
    return (code >= first_in_form) ? form[static_cast<std::size_t>(code) - first_in_form] : std::uint8_t{1U};
}

}  // namespace

void Slave::take(const hal::CanFrame& frame) noexcept {
    if ((frame.identifier != identifiers_.command) || frame.extended || frame.flexible_data_rate ||
        (frame.length == 0U)) {
        return;
    }
    command_ = Packet{};
    command_.add_bytes(frame.data.data(), frame.length);
    has_command_ = true;
    has_work_ = true;
}

std::uint32_t Slave::work(hal::CanBus& bus, hal::Time now, std::uint32_t missed_cycles) noexcept {
    const std::uint32_t failures_before = bus.statistics().send_failures;
    if (has_command_) {
        has_command_ = false;
        if (answer(now)) {
            static_cast<void>(
                send_packet(bus, identifiers_.answer, answer_));  // the master repeats its command
        }
    }
    overload_ = !daq_.sample(bus, identifiers_.answer, now, missed_cycles) || overload_;
    const auto tell = [&](bool& pending, Event event) {
        if (pending) {
            Packet packet{event_code};
            packet.add_byte(static_cast<std::uint32_t>(event));
            pending = !send_packet(bus, identifiers_.answer, packet);
        }
    };
    tell(overload_, Event::daq_overload);
    tell(stored_, Event::store_cal);
    has_work_ = connected_;
    return bus.statistics().send_failures - failures_before;
}

// False where a slave keeps silent: without a connection it hears nothing but CONNECT.
bool Slave::answer(hal::Time now) noexcept {
    answer_ = Packet{answer_code};
    const auto command = static_cast<Command>(command_.byte(0U));
    if (command == Command::connect) {
        // Mode 1 is for slaves whose identifiers a user sets; byte 1 missing is mode 0.
        if (command_.byte(1U) != 0U) {
            return false;
        }
        connect();
        return true;
    }
    if (!connected_) {
        return false;
    }
    Error error = Error::syntax;
    const std::uint8_t wanted = form_of(command_.byte(0U));
    if (command_.length() >= (wanted & ~static_cast<std::uint32_t>(key))) {
        error = (((wanted & key) != 0U) && !access_.is_unlocked()) ? Error::access_locked
                                                                   : answer_in_session(command, now);
    }
    if (error != Error::none) {
        answer_ = Packet{error_code};
        answer_.add_byte(static_cast<std::uint32_t>(error));
    }
    return true;
}

// The codes lie in three blocks.
Error Slave::answer_in_session(Command command, hal::Time now) noexcept {
    if (command > Command::set_cal_page) {
        return answer_standard(command);
    }
    return (command > Command::clear_daq_list) ? answer_about_pages(command)
                                               : answer_about_lists(command, now);
}

Error Slave::answer_standard(Command command) noexcept {
    switch (command) {
        case Command::disconnect:
            disconnect();
            return Error::none;
        case Command::get_status:
            return status();
        case Command::synch:
            return Error::synch;
        case Command::get_comm_mode_info:
            answer_.add_zeros(6U).add_byte(driver_version);
            return Error::none;
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
                return Error::out_of_range;  // no address extension
            }
            address_ = command_.word(4U);
            return Error::none;
        case Command::upload:
            return upload(address_);
        case Command::short_upload:
            if (command_.byte(3U) != 0U) {
                return Error::out_of_range;
            }
            return upload(command_.word(4U));
        case Command::build_checksum:
            return checksum();
        case Command::download:
            return download();
        default:
            return Error::unknown;
    }
}

void Slave::connect() noexcept {
    disconnect();
    connected_ = true;
    visible_ = Page::working;
    address_ = 0U;
    answer_.add_byte(calibration_resource | daq_resource)
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
    daq_.release();
}

std::uint8_t Slave::locked_resources() const noexcept {
    return access_.is_unlocked() ? std::uint8_t{0U}
                                 : static_cast<std::uint8_t>(calibration_resource | daq_resource);
}

Error Slave::status() noexcept {
    const std::uint32_t running = daq_.is_running() ? 0x40U : 0U;
    answer_.add_byte(running).add_byte(locked_resources()).add_zeros(3U);
    return Error::none;
}

// Text (0), and the A2L's name without an ending (1): one and the same, read by uploads.
Error Slave::identification() noexcept {
    if (command_.byte(1U) > 1U) {
        answer_.add_zeros(7U);
        return Error::none;
    }
    const Target::Range name = target_.name();
    address_ = name.address;
    answer_.add_zeros(3U).add_word(name.length);
    return Error::none;
}

// In pieces: how much is left with this one, and its bytes. Nothing is left to be unlocked where a seed has
// no length.
Error Slave::seed() noexcept {
    const std::uint8_t resource = command_.byte(2U);
    const bool is_first = (command_.byte(1U) == 0U);
    if (is_first) {
        if ((resource != calibration_resource) && (resource != daq_resource)) {
            return Error::out_of_range;
        }
        key_got_ = 0U;
        seed_left_ = 0U;
        if (access_.is_unlocked()) {
            answer_.add_byte(0U);
            return Error::none;
        }
        if (!access_.give_seed(exchanged_)) {
            return Error::temporarily_not_accessible;
        }
        seed_left_ = static_cast<std::uint8_t>(block_length);
    } else if (seed_left_ == 0U) {
        return Error::sequence;
    } else {
        // The next piece.
    }
    // As many as have room.
    answer_.add_byte(seed_left_).add_bytes(&exchanged_[block_length - seed_left_], seed_left_);
    seed_left_ = static_cast<std::uint8_t>(seed_left_ + 2U - answer_.length());
    return Error::none;
}

// The same way back; the byte before each piece says how much is left with it.
Error Slave::unlock() noexcept {
    const std::size_t left = block_length - key_got_;
    const std::size_t piece = (left < piece_length) ? left : piece_length;
    if ((command_.byte(1U) != left) || (command_.length() < 2U + piece)) {
        key_got_ = 0U;
        return Error::sequence;
    }
    for (std::size_t place = 0U; place < piece; ++place) {
        exchanged_[key_got_ + place] = command_.byte(2U + place);
    }
    key_got_ = static_cast<std::uint8_t>(key_got_ + piece);
    if (key_got_ == block_length) {
        key_got_ = 0U;
        const access::KeyAnswer answer = access_.take_key(exchanged_);
        if (answer == access::KeyAnswer::no_seed) {
            return Error::sequence;
        }
        if (answer != access::KeyAnswer::unlocked) {
            disconnect();  // as the standard has it
            return Error::access_locked;
        }
    }
    answer_.add_byte(locked_resources());
    return Error::none;
}

Error Slave::upload(std::uint32_t address) noexcept {
    std::array<std::uint8_t, packet_length> bytes{};
    const std::size_t count = command_.byte(1U);
    if ((count == 0U) || (count > packet_length - 1U)) {
        return Error::out_of_range;
    }
    if (!target_.read(address, visible_, bytes.data(), count)) {
        return Error::access_denied;
    }
    address_ = address + static_cast<std::uint32_t>(count);
    answer_.add_bytes(bytes.data(), count);
    return Error::none;
}

Error Slave::checksum() noexcept {
    constexpr std::uint32_t type_crc_32 = 0x09U;
    const std::uint32_t count = command_.word(4U);
    std::uint32_t sum = 0U;
    if (!target_.checksum(address_, visible_, count, sum)) {
        return Error::access_denied;
    }
    address_ += count;
    answer_.add_byte(type_crc_32).add_zeros(2U).add_word(sum);
    return Error::none;
}

Error Slave::download() noexcept {
    const std::size_t count = command_.byte(1U);
    if ((count == 0U) || (count > piece_length)) {
        return Error::out_of_range;
    }
    if (command_.length() < 2U + count) {
        return Error::syntax;
    }
    if (visible_ != Page::working) {
        return Error::write_protected;
    }
    const Error error = target_.write(address_, &command_.bytes()[2U], count);
    if (error == Error::none) {
        address_ += static_cast<std::uint32_t>(count);
    }
    return error;
}

Error Slave::store() noexcept {
    constexpr std::uint8_t store_cal = 0x01U;
    if (command_.byte(1U) != store_cal) {
        return Error::out_of_range;
    }
    const Error error = target_.store();
    stored_ = (error == Error::none);
    return error;
}

}  // namespace rsi::xcp
