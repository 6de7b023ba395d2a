// XCP slave: answers one command a cycle, and sends what is measured. By ASAM MCD-1 XCP 1.1, on classic CAN.
#pragma once

#include <cstdint>

#include "access/seed_and_key.hpp"
#include "hal/interface/can_bus.hpp"
#include "hal/interface/clock.hpp"
#include "xcp/daq.hpp"
#include "xcp/identifiers.hpp"
#include "xcp/packet.hpp"
#include "xcp/target.hpp"

namespace xcp {

// Whoever is connected may read. Calibration and measurement (which loads the bus) want the key: one seed and
// key for both. Disconnecting, connecting anew and a wrong key lock again.
class Slave {
 public:
    // Both must outlive the slave.
    Slave(Target& target, access_control::SeedAndKey& access, const Identifiers& identifiers) noexcept
        : target_{target}, access_{access}, identifiers_{identifiers}, daq_{target} {}

    // Every frame that the control unit receives; others than commands are left alone. Of several commands
    // within a cycle, which no master sends, the last is answered.
    void look_at(const hal::CanFrame& frame) noexcept {
        if ((frame.identifier == identifiers_.command) && !frame.extended && !frame.flexible_data_rate) {
            keep(frame);
        }
    }

    // After a step of 10 ms and its frames: answers, then samples. `missed_cycles` as the step was told.
    void end_cycle(hal::CanBus& bus, hal::Time now, std::uint32_t missed_cycles) noexcept {
        access_.end_cycle();
        if (has_command_ || connected_) {
            work(bus, now, missed_cycles);
        }
    }

    bool is_connected() const noexcept { return connected_; }

 private:
    void keep(const hal::CanFrame& frame) noexcept;
    void work(hal::CanBus& bus, hal::Time now, std::uint32_t missed_cycles) noexcept;
    bool answer(hal::Time now, Packet& packet) noexcept;
    Packet answer_in_session(Command command, hal::Time now) noexcept;
    Packet answer_standard(Command command) noexcept;
    Packet answer_about_pages(Command command) noexcept;
    Packet answer_about_lists(Command command, hal::Time now) noexcept;
    Packet change_lists(Command command) noexcept;

    Packet connect() noexcept;
    void disconnect() noexcept;
    Packet status() const noexcept;
    Packet identification() noexcept;
    Packet seed() noexcept;
    Packet unlock() noexcept;
    Packet upload(std::uint32_t address) noexcept;
    Packet checksum() noexcept;
    Packet download() noexcept;
    Packet set_page() noexcept;
    Packet page() const noexcept;
    Packet segment_info() const noexcept;
    Packet page_info() const noexcept;
    Packet copy_page() noexcept;
    Packet store() noexcept;
    Packet list_mode() const noexcept;
    Packet start_or_stop_list() noexcept;
    Error start_or_stop_all() noexcept;
    Packet processor_info() const noexcept;
    Packet event_info() const noexcept;
    std::uint8_t locked_resources() const noexcept;

    Target& target_;
    access_control::SeedAndKey& access_;
    Identifiers identifiers_;
    DaqLists daq_;
    Packet command_{};
    bool has_command_{false};
    bool connected_{false};
    bool overload_{false};               // to be told
    bool stored_{false};                 // the same
    bool freezes_{false};                // the segment's mode; the one segment is stored in either
    Page visible_{Page::working};        // the page that the master reads
    std::uint32_t address_{0U};          // of the next upload or download (MTA)
    access_control::Block exchanged_{};  // seed or key, as far as it has gone over the bus
    std::uint8_t seed_left_{0U};         // bytes
    std::uint8_t key_got_{0U};           // bytes
};

}  // namespace xcp
