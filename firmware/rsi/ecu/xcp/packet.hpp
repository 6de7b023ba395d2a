// Packet: one command, answer, event or sample of XCP on CAN, as many bytes as a classic frame has.
#pragma once

#include "rsi/language.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace rsi::xcp {

inline constexpr std::size_t packet_length = 8U;

// The first byte of what the slave sends; a smaller one is the number of a list's part (ODT).
inline constexpr std::uint8_t answer_code = 0xFFU;
inline constexpr std::uint8_t error_code = 0xFEU;
inline constexpr std::uint8_t event_code = 0xFDU;

// Those that this slave knows, by ASAM MCD-1 XCP 1.1.
enum class Command : std::uint8_t {
    connect = 0xFF,
    disconnect = 0xFE,
    get_status = 0xFD,
    synch = 0xFC,
    get_comm_mode_info = 0xFB,
    get_id = 0xFA,
    set_request = 0xF9,
    get_seed = 0xF8,
    unlock = 0xF7,
    set_mta = 0xF6,
    upload = 0xF5,
    short_upload = 0xF4,
    build_checksum = 0xF3,
    download = 0xF0,
    set_cal_page = 0xEB,
    get_cal_page = 0xEA,
    get_pag_processor_info = 0xE9,
    get_segment_info = 0xE8,
    get_page_info = 0xE7,
    set_segment_mode = 0xE6,
    get_segment_mode = 0xE5,
    copy_cal_page = 0xE4,
    clear_daq_list = 0xE3,
    set_daq_ptr = 0xE2,
    write_daq = 0xE1,
    set_daq_list_mode = 0xE0,
    get_daq_list_mode = 0xDF,
    start_stop_daq_list = 0xDE,
    start_stop_synch = 0xDD,
    get_daq_clock = 0xDC,
    get_daq_processor_info = 0xDA,
    get_daq_resolution_info = 0xD9,
    get_daq_event_info = 0xD7,
    free_daq = 0xD6,
    alloc_daq = 0xD5,
    alloc_odt = 0xD4,
    alloc_odt_entry = 0xD3,
};

enum class Error : std::uint8_t {
    synch = 0x00,
    daq_active = 0x11,
    unknown = 0x20,
    syntax = 0x21,
    out_of_range = 0x22,
    write_protected = 0x23,
    access_denied = 0x24,
    access_locked = 0x25,
    page_not_valid = 0x26,
    mode_not_valid = 0x27,
    segment_not_valid = 0x28,
    sequence = 0x29,
    daq_config = 0x2A,
    memory_overflow = 0x30,
    temporarily_not_accessible = 0x33,
    none = 0xFF,  // of this slave only: nothing is wrong
};

enum class Event : std::uint8_t { store_cal = 0x03, daq_overload = 0x06 };

// Numbers of several bytes are little-endian ("Intel"), whatever the target.
class Packet {
 public:
    Packet() = default;
    explicit constexpr Packet(std::uint8_t first) noexcept : bytes_{{first}}, length_{1U} {}

    std::uint8_t length() const noexcept { return length_; }
    const std::array<std::uint8_t, packet_length>& bytes() const noexcept { return bytes_; }

    // 0 where the packet has ended; `place` within a frame.
    std::uint8_t byte(std::size_t place) const noexcept { return bytes_[place]; }
    std::uint32_t half_word(std::size_t place) const noexcept {
        return static_cast<std::uint32_t>(byte(place)) | (static_cast<std::uint32_t>(byte(place + 1U)) << 8U);
    }
    std::uint32_t word(std::size_t place) const noexcept {
        return half_word(place) | (half_word(place + 2U) << 16U);
    }

    // Bytes beyond the packet are left out.
    Packet& add_byte(std::uint32_t value) noexcept {
        if (length_ < packet_length) {
            bytes_[length_] = static_cast<std::uint8_t>(value);
            ++length_;
        }
        return *this;
    }
    Packet& add_half_word(std::uint32_t value) noexcept { return add_byte(value).add_byte(value >> 8U); }
    Packet& add_word(std::uint32_t value) noexcept {
        return add_half_word(value).add_half_word(value >> 16U);
    }

    Packet& add_bytes(const std::uint8_t* bytes, std::size_t count) noexcept {
        for (std::size_t place = 0U; place < count; ++place) {
            add_byte(bytes[place]);
        }
        return *this;
    }

    // Within the packet.
    Packet& add_zeros(std::uint8_t count) noexcept {
        length_ = static_cast<std::uint8_t>(length_ + count);
        return *this;
    }

 private:
    std::array<std::uint8_t, packet_length> bytes_{};
    std::uint8_t length_{0U};
};

}  // namespace rsi::xcp
