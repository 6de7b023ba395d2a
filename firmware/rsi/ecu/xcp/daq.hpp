// Lists of what is measured (dynamic DAQ): allotted, written, started by the master; sampled after each step.
#pragma once

#include <array>
#include <cstdint>

#include "rsi/ecu/xcp/packet.hpp"
#include "rsi/ecu/xcp/target.hpp"
#include "rsi/hal/can_bus.hpp"
#include "rsi/hal/clock.hpp"

namespace rsi::xcp {

// Each part of a list (ODT) is one frame. As no more of them can be allotted, no cycle sends more frames: at
// 135 bits, the longest that a frame of eight bytes gets by stuffing, they take 54 % of a bus at 500 kbit/s.
inline constexpr std::uint32_t most_lists = 4U;
inline constexpr std::uint32_t most_parts = 20U;
inline constexpr std::uint32_t most_entries = 64U;
static_assert(most_parts * 135U * 100U * 100U / 500'000U == 54U, "share of a bus, in percent, at 100 Hz");
inline constexpr std::uint32_t largest_entry = packet_length - 1U;  // bytes
inline constexpr std::uint32_t timestamp_length = 2U;               // bytes, in a list's first part
inline constexpr std::int64_t nanoseconds_per_tick = 100'000;

// Event channels: every cycle, and every tenth.
inline constexpr std::uint32_t event_count = 2U;
inline constexpr std::uint32_t cycles_of_slow_event = 10U;

inline constexpr std::uint8_t timestamp_mode = 0x10U;  // of a list's mode

inline std::uint32_t ticks_of(hal::Time time) noexcept {
    return static_cast<std::uint32_t>(time.nanoseconds / nanoseconds_per_tick);
}

class DaqLists {
 public:
    explicit DaqLists(const Target& target) noexcept : target_{target} {}

    // Stops all, and nothing is allotted any more.
    void release() noexcept;

    Error allot_lists(std::uint32_t count) noexcept;
    Error allot_parts(std::uint32_t list, std::uint32_t count) noexcept;
    Error allot_entries(std::uint32_t list, std::uint32_t part, std::uint32_t count) noexcept;

    // Stops the list and empties its entries.
    Error clear(std::uint32_t list) noexcept;

    // Place of the next write; it moves on by one entry.
    Error point_to(std::uint32_t list, std::uint32_t part, std::uint32_t entry) noexcept;
    Error write(std::uint32_t address, std::uint32_t size) noexcept;

    // `mode`: with timestamps or without (timestamp_mode). The list sends every `prescaler` times of its
    // event.
    Error set_mode(std::uint32_t list, std::uint8_t mode, std::uint32_t event,
                   std::uint8_t prescaler) noexcept;
    // As GET_DAQ_LIST_MODE answers.
    Error mode(std::uint32_t list, Packet& answer) const noexcept;

    Error stop(std::uint32_t list) noexcept;
    Error start(std::uint32_t list) noexcept;
    Error select(std::uint32_t list) noexcept;
    // As START_STOP_SYNCH's modes. Starting none is an error; one selected list that cannot start keeps all
    // still.
    void stop_all() noexcept;
    Error start_selected() noexcept;
    void stop_selected() noexcept;

    // The number that a list's first part bears; of a list that there is.
    std::uint32_t first_part(std::uint32_t list) const noexcept { return lists_[list].first; }
    std::uint32_t count() const noexcept { return list_count_; }
    bool is_running() const noexcept { return running_ > 0U; }

    // After a step: sends what is due. False when a frame was not taken by the bus, or cycles were missed, so
    // that samples are missing.
    bool sample(hal::CanBus& bus, std::uint32_t identifier, hal::Time now,
                std::uint32_t missed_cycles) noexcept;

 private:
    struct List {
        std::uint8_t first{0U};  // part
        std::uint8_t parts{0U};
        std::uint8_t mode{0U};
        std::uint8_t event{0U};
        std::uint8_t prescaler{1U};
        std::uint8_t waits{0U};  // so many times of the event are still left out
        bool selected{false};
        bool running{false};
    };
    struct Part {
        std::uint8_t first{0U};  // entry
        std::uint8_t entries{0U};
    };
    // Address and, in the upper byte, size; 0: empty.
    using Entry = std::uint32_t;

    bool is_list(std::uint32_t list) const noexcept { return list < list_count_; }
    bool can_start(const List& list) const noexcept;
    std::uint32_t bytes_of(const Part& part) const noexcept;
    void run(List& list, bool running) noexcept;
    bool send(hal::CanBus& bus, std::uint32_t identifier, const List& list, hal::Time now) const noexcept;
    bool is_due(List& list, bool slow_event) const noexcept;

    const Target& target_;
    std::uint32_t list_count_{0U};
    std::uint32_t part_count_{0U};
    std::uint32_t entry_count_{0U};
    std::uint32_t next_entry_{0U};  // to be written; next_entry_ == end_entry_: none
    std::uint32_t end_entry_{0U};
    std::uint32_t pointed_part_{0U};
    std::uint32_t running_{0U};
    std::uint32_t cycles_{0U};  // since the slow event
    std::array<List, most_lists> lists_{};
    std::array<Part, most_parts> parts_{};
    std::array<Entry, most_entries> entries_{};
};

// A frame with such a packet.
bool send_packet(hal::CanBus& bus, std::uint32_t identifier, const Packet& packet) noexcept;

}  // namespace rsi::xcp
