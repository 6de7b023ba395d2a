#include "rsi/ecu/xcp/daq.hpp"

namespace rsi::xcp {
namespace {

constexpr std::uint32_t size_shift = 24U;
constexpr std::uint32_t largest_address = (1UL << size_shift) - 1U;

}  // namespace

bool send_packet(hal::CanBus& bus, std::uint32_t identifier, const Packet& packet) noexcept {
    hal::CanFrame frame{};
    frame.identifier = identifier;
    frame.length = packet.length();
    for (std::size_t place = 0U; place < packet_length; ++place) {
        frame.data[place] = packet.bytes()[place];
    }
    return bus.send(frame) == hal::SendResult::sent;
}

void DaqLists::release() noexcept {
    lists_ = {};
    parts_ = {};
    entries_ = {};
    list_count_ = 0U;
    part_count_ = 0U;
    entry_count_ = 0U;
    end_entry_ = 0U;
    running_ = 0U;
}

// In the order of lists, parts, entries; each once after release().
Error DaqLists::allot_lists(std::uint32_t count) noexcept {
    if (list_count_ > 0U) {
        return Error::sequence;
    }
    if (count > most_lists) {
        return Error::memory_overflow;
    }
    list_count_ = count;
    return Error::none;
}

Error DaqLists::allot_parts(std::uint32_t list, std::uint32_t count) noexcept {
    if (!is_list(list)) {
        return Error::out_of_range;
    }
    if ((entry_count_ > 0U) || (lists_[list].parts > 0U)) {
        return Error::sequence;
    }
    if (count > most_parts - part_count_) {
        return Error::memory_overflow;
    }
    lists_[list].first = static_cast<std::uint8_t>(part_count_);
    lists_[list].parts = static_cast<std::uint8_t>(count);
    part_count_ += count;
    return Error::none;
}

Error DaqLists::allot_entries(std::uint32_t list, std::uint32_t part, std::uint32_t count) noexcept {
    if (!is_list(list) || (part >= lists_[list].parts)) {
        return Error::out_of_range;
    }
    Part& allotted = parts_[lists_[list].first + part];
    if (allotted.entries > 0U) {
        return Error::sequence;
    }
    if ((count > largest_entry) || (count > most_entries - entry_count_)) {
        return Error::memory_overflow;
    }
    allotted.first = static_cast<std::uint8_t>(entry_count_);
    allotted.entries = static_cast<std::uint8_t>(count);
    entry_count_ += count;
    return Error::none;
}

Error DaqLists::clear(std::uint32_t list) noexcept {
    if (!is_list(list)) {
        return Error::out_of_range;
    }
    List& cleared = lists_[list];
    run(cleared, false);
    cleared.selected = false;
    for (std::uint32_t part = 0U; part < cleared.parts; ++part) {
        const Part& emptied = parts_[cleared.first + part];
        for (std::uint32_t entry = 0U; entry < emptied.entries; ++entry) {
            entries_[emptied.first + entry] = 0U;
        }
    }
    return Error::none;
}

Error DaqLists::point_to(std::uint32_t list, std::uint32_t part, std::uint32_t entry) noexcept {
    if (!is_list(list) || (part >= lists_[list].parts)) {
        return Error::out_of_range;
    }
    if (lists_[list].running) {
        return Error::daq_active;
    }
    const std::uint32_t number = lists_[list].first + part;
    const Part& pointed = parts_[number];
    if (entry >= pointed.entries) {
        return Error::out_of_range;
    }
    pointed_part_ = number;
    next_entry_ = pointed.first + entry;
    end_entry_ = static_cast<std::uint32_t>(pointed.first) + pointed.entries;
    return Error::none;
}

Error DaqLists::write(std::uint32_t address, std::uint32_t size) noexcept {
    if (next_entry_ >= end_entry_) {
        return Error::sequence;
    }
    std::array<std::uint8_t, largest_entry> unused{};
    if ((size == 0U) || (size > largest_entry) || (address > largest_address) ||
        !target_.read(address, Page::working, unused.data(), size)) {
        return Error::access_denied;
    }
    entries_[next_entry_] = (size << size_shift) | address;
    if (bytes_of(parts_[pointed_part_]) > largest_entry) {
        entries_[next_entry_] = 0U;
        return Error::daq_config;
    }
    ++next_entry_;
    return Error::none;
}

std::uint32_t DaqLists::bytes_of(const Part& part) const noexcept {
    std::uint32_t bytes = 0U;
    for (std::uint32_t entry = 0U; entry < part.entries; ++entry) {
        bytes += entries_[part.first + entry] >> size_shift;
    }
    return bytes;
}

Error DaqLists::set_mode(std::uint32_t list, std::uint8_t mode, std::uint32_t event,
                         std::uint8_t prescaler) noexcept {
    if (!is_list(list) || (event >= event_count) || (prescaler == 0U)) {
        return Error::out_of_range;
    }
    if ((mode & ~static_cast<std::uint32_t>(timestamp_mode)) != 0U) {
        return Error::mode_not_valid;
    }
    List& changed = lists_[list];
    if (changed.running) {
        return Error::daq_active;
    }
    changed.mode = mode;
    changed.event = static_cast<std::uint8_t>(event);
    changed.prescaler = prescaler;
    return Error::none;
}

Error DaqLists::mode(std::uint32_t list, Packet& answer) const noexcept {
    if (!is_list(list)) {
        return Error::out_of_range;
    }
    const List& asked = lists_[list];
    const std::uint32_t selected = asked.selected ? 0x01U : 0U;
    const std::uint32_t running = asked.running ? 0x40U : 0U;
    answer.add_byte(selected | running | asked.mode).add_zeros(2U);
    answer.add_half_word(asked.event).add_byte(asked.prescaler).add_zeros(1U);
    return Error::none;
}

// Every entry is written, and the timestamp has room beside those of the first part.
bool DaqLists::can_start(const List& list) const noexcept {
    bool good = (list.parts > 0U);
    for (std::uint32_t part = 0U; part < list.parts; ++part) {
        const Part& checked = parts_[list.first + part];
        for (std::uint32_t entry = 0U; entry < checked.entries; ++entry) {
            good = good && (entries_[checked.first + entry] != 0U);
        }
    }
    const std::uint32_t stamp = (list.mode == timestamp_mode) ? timestamp_length : 0U;
    return good && (stamp + bytes_of(parts_[list.first]) <= largest_entry);
}

void DaqLists::run(List& list, bool running) noexcept {
    if (running != list.running) {
        running_ = running ? running_ + 1U : running_ - 1U;
        list.running = running;
        list.waits = 0U;
        next_entry_ = end_entry_;  // nothing is written into a list that runs
    }
}

Error DaqLists::stop(std::uint32_t list) noexcept {
    if (!is_list(list)) {
        return Error::out_of_range;
    }
    run(lists_[list], false);
    return Error::none;
}

Error DaqLists::start(std::uint32_t list) noexcept {
    if (!is_list(list)) {
        return Error::out_of_range;
    }
    if (!can_start(lists_[list])) {
        return Error::daq_config;
    }
    run(lists_[list], true);
    return Error::none;
}

Error DaqLists::select(std::uint32_t list) noexcept {
    if (!is_list(list)) {
        return Error::out_of_range;
    }
    lists_[list].selected = true;
    return Error::none;
}

void DaqLists::stop_all() noexcept {
    for (List& list : lists_) {
        run(list, false);
        list.selected = false;
    }
}

Error DaqLists::start_selected() noexcept {
    bool any = false;
    bool all = true;
    for (const List& list : lists_) {
        if (list.selected) {
            any = true;
            all = can_start(list) && all;
        }
    }
    if (!any || !all) {
        return Error::daq_config;
    }
    for (List& list : lists_) {
        if (list.selected) {
            run(list, true);
            list.selected = false;
        }
    }
    return Error::none;
}

void DaqLists::stop_selected() noexcept {
    for (List& list : lists_) {
        if (list.selected) {
            run(list, false);
            list.selected = false;
        }
    }
}

bool DaqLists::is_due(List& list, bool slow_event) const noexcept {
    if (!list.running || ((list.event != 0U) && !slow_event)) {
        return false;
    }
    if (list.waits > 0U) {
        --list.waits;
        return false;
    }
    list.waits = static_cast<std::uint8_t>(list.prescaler - 1U);
    return true;
}

bool DaqLists::sample(hal::CanBus& bus, std::uint32_t identifier, hal::Time now,
                      std::uint32_t missed_cycles) noexcept {
    if (!is_running()) {
        return true;
    }
    ++cycles_;
    const bool slow_event = (cycles_ >= cycles_of_slow_event);
    if (slow_event) {
        cycles_ = 0U;
    }
    bool complete = (missed_cycles == 0U);
    for (List& list : lists_) {
        if (is_due(list, slow_event)) {
            complete = send(bus, identifier, list, now) && complete;
        }
    }
    return complete;
}

// All parts, whether the bus takes them or not: a later one may find room again.
bool DaqLists::send(hal::CanBus& bus, std::uint32_t identifier, const List& list,
                    hal::Time now) const noexcept {
    bool all = true;
    for (std::uint32_t part = 0U; part < list.parts; ++part) {
        const std::uint32_t number = list.first + part;
        Packet packet{static_cast<std::uint8_t>(number)};
        if ((part == 0U) && (list.mode == timestamp_mode)) {
            packet.add_half_word(ticks_of(now));
        }
        const Part& sent = parts_[number];
        for (std::uint32_t entry = 0U; entry < sent.entries; ++entry) {
            const Entry what = entries_[sent.first + entry];
            std::array<std::uint8_t, largest_entry> bytes{};
            const std::size_t size = what >> size_shift;
            static_cast<void>(target_.read(what & largest_address, Page::working, bytes.data(), size));
            packet.add_bytes(bytes.data(), size);
        }
        all = send_packet(bus, identifier, packet) && all;
    }
    return all;
}

}  // namespace rsi::xcp
