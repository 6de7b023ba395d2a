// XCP slave: answers one command a cycle, and sends what is measured. By ASAM MCD-1 XCP 1.1, on classic CAN.
#pragma once

#include "rsi/language.hpp"

#include <cstdint>

#include "rsi/ecu/access/seed_and_key.hpp"
#include "rsi/ecu/xcp/daq.hpp"
#include "rsi/ecu/xcp/identifiers.hpp"
#include "rsi/ecu/xcp/packet.hpp"
#include "rsi/ecu/xcp/target.hpp"
#include "rsi/hal/can_bus.hpp"
#include "rsi/hal/clock.hpp"
#include "rsi/hal/frame_listener.hpp"

namespace rsi::xcp {

// A connected master may read. Calibration and measurement (which loads the bus) want the key: one seed and
// key for both. Disconnecting, connecting anew and a wrong key lock again.
class Slave final : public hal::FrameListener {
 public:
    // Both must outlive the slave.
    Slave(Target& target, access::SeedAndKey& access, const Identifiers& identifiers) noexcept
        : target_{target}, access_{access}, identifiers_{identifiers}, daq_{target} {}

    // Others than commands are left alone. The last of several commands within a cycle, which no master
    // sends, is answered.
    void take(const hal::CanFrame& frame) noexcept override;

    // After a step of 10 ms and its frames: answers, then samples. `missed_cycles` as for the step. How
    // many of its own frames the bus has not taken.
    std::uint32_t end_cycle(hal::CanBus& bus, const hal::Clock& clock, std::uint32_t missed_cycles) noexcept {
        access_.end_cycle();
        return has_work_ ? work(bus, clock.now(), missed_cycles) : 0U;
    }

    bool is_connected() const noexcept { return connected_; }

 private:
    std::uint32_t work(hal::CanBus& bus, hal::Time now, std::uint32_t missed_cycles) noexcept;
    bool answer(hal::Time now) noexcept;
    Error answer_in_session(Command command, hal::Time now) noexcept;
    Error answer_standard(Command command) noexcept;
    Error answer_about_pages(Command command) noexcept;
    Error answer_about_lists(Command command, hal::Time now) noexcept;

    void connect() noexcept;
    void disconnect() noexcept;
    Error status() noexcept;
    Error identification() noexcept;
    Error seed() noexcept;
    Error unlock() noexcept;
    Error upload(std::uint32_t address) noexcept;
    Error checksum() noexcept;
    Error download() noexcept;
    Error set_page() noexcept;
    Error page() noexcept;
    Error segment_info() noexcept;
    Error page_info() noexcept;
    Error copy_page() noexcept;
    Error store() noexcept;
    Error start_or_stop_list(std::uint32_t list) noexcept;
    Error start_or_stop_all() noexcept;
    Error processor_info() noexcept;
    Error event_info() noexcept;
    std::uint8_t locked_resources() const noexcept;

    Target& target_;
    access::SeedAndKey& access_;
    Identifiers identifiers_;
    Packet command_;
    Packet answer_;  // the answer if nothing is wrong
    bool has_command_{false};
    bool has_work_{false};  // a command, or a master is connected
    bool connected_{false};
    bool overload_{false};         // to be reported
    bool stored_{false};           // the same
    bool freezes_{false};          // the segment's mode; the one segment is stored in either
    Page visible_{Page::working};  // the page that the master reads
    std::uint32_t address_{0U};    // of the next upload or download (MTA)
    access::Block exchanged_{};    // seed or key, as far as it has gone over the bus
    std::uint8_t seed_left_{0U};   // bytes
    std::uint8_t key_got_{0U};     // bytes
    DaqLists daq_;                 // the largest as the last: what is near takes shorter instructions
};

}  // namespace rsi::xcp
