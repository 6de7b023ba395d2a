// Alternating record: written to two places in turn, so that a loss of power during a write leaves the
// previous record.
//
//   offset  bytes
//        0      n  payload
//        n      4  magic, "RSID"
//    n + 4      4  sequence number: the larger one is the newer record
//    n + 8      4  CRC-32 of every byte before
//
// Little-endian, whatever the target.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "rsi/ecu/application/crc32.hpp"
#include "rsi/ecu/application/little_endian.hpp"
#include "rsi/hal/storage.hpp"

namespace rsi::application {

// Findings of a read in the two places.
enum class RecordState : std::uint8_t {
    never_written,
    unreadable,  // neither place has a good record, and one has been written
    doubtful,    // the newest good record; a newer one may be lost
    good,
};

// A good record has been read.
constexpr bool has_record(RecordState state) noexcept {
    return (state == RecordState::good) || (state == RecordState::doubtful);
}

// `Payload` consists of bytes only: no padding, and the same layout on every target.
template <typename Payload>
class AlternatingRecord {
    static_assert(std::is_trivially_copyable<Payload>::value && (alignof(Payload) == 1U));

 public:
    static constexpr std::size_t length = sizeof(Payload) + 12U;

    // Both must outlive this object, which owns them exclusively.
    AlternatingRecord(hal::Storage& one, hal::Storage& other) noexcept : places_{&one, &other} {}

    // Before the first write: reads the newest good record. `payload` is unchanged where there is none.
    [[gnu::cold]] RecordState read(Payload& payload) noexcept {
        bool found = false;
        bool lost = false;
        for (std::size_t place = 0U; place < places_.size(); ++place) {
            Record record{};
            const hal::Reading reading = places_[place]->read(record.data(), record.size());
            const bool good = (reading == hal::Reading::stored) && is_good(record);
            lost = lost || (!good && (reading != hal::Reading::never_written));
            const std::uint32_t sequence = u32_at(record.data(), sequence_at);
            if (good && (!found || is_newer(sequence, sequence_))) {
                found = true;
                sequence_ = sequence;
                next_ = 1U - place;
                std::memcpy(&payload, record.data(), sizeof payload);
            }
        }
        if (found) {
            return lost ? RecordState::doubtful : RecordState::good;
        }
        return lost ? RecordState::unreadable : RecordState::never_written;
    }

    // False if the storage is busy; try again later. A write must have finished in the background before the
    // next one begins, so that never both places are incomplete: the caller waits, or the platform refuses
    // the one place while the other is still written.
    bool write(const Payload& payload) noexcept {
        Record record{};
        put_u32(record.data(), magic_at, magic);
        put_u32(record.data(), sequence_at, sequence_ + 1U);
        std::memcpy(record.data(), &payload, sizeof payload);
        put_u32(record.data(), checksum_at, crc32(record.data(), checksum_at));
        const bool taken = places_[next_]->write(record.data(), record.size());
        if (taken) {
            ++sequence_;
            next_ = 1U - next_;
        }
        return taken;
    }

 private:
    using Record = std::array<std::uint8_t, length>;
    static constexpr std::uint32_t magic = 0x44495352U;  // "RSID"
    static constexpr std::size_t magic_at = sizeof(Payload);
    static constexpr std::size_t sequence_at = magic_at + 4U;
    static constexpr std::size_t checksum_at = sequence_at + 4U;

    static bool is_good(const Record& record) noexcept {
        return (u32_at(record.data(), magic_at) == magic) &&
               (u32_at(record.data(), checksum_at) == crc32(record.data(), checksum_at));
    }

    // Correct across a wrap-around of the sequence number.
    static bool is_newer(std::uint32_t sequence, std::uint32_t than) noexcept {
        return (sequence - than) < 0x8000'0000U;
    }

    std::array<hal::Storage*, 2> places_;
    std::uint32_t sequence_{0U};
    std::size_t next_{0U};
};

}  // namespace rsi::application
