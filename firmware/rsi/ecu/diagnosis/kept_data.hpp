// Kept data: trouble memory and written identification in the memory that outlives a loss of power.
#pragma once

#include <cstdint>

#include "rsi/ecu/application/alternating_record.hpp"
#include "rsi/ecu/application/write_pace.hpp"
#include "rsi/ecu/diagnosis/data_identifiers.hpp"
#include "rsi/ecu/diagnosis/trouble_memory.hpp"

namespace rsi::diagnosis {

// Other software reads it as well, as long as the layout has this number and codes keep theirs.
struct KeptPayload {
    static constexpr std::uint8_t present_layout = 2U;

    std::uint8_t layout{present_layout};
    TroubleMemory::Stored codes{};
    WrittenData written{};
};

class KeptData {
 public:
    // Bytes of each of the two places.
    static constexpr std::size_t record_length = application::AlternatingRecord<KeptPayload>::length;

    // The places are used by this object only, take record_length bytes each, and outlive this object.
    KeptData(hal::Storage& one, hal::Storage& other) noexcept : record_{one, other} {}

    // Before the first cycle.
    [[gnu::cold]] void restore() noexcept;

    // Once a cycle: stores what is to be stored. New entries at once, though a second after the last record,
    // which may still be on its way in the background; what only counts further once a minute. A memory that
    // refuses is tried at a pace of its own.
    void end_cycle() noexcept {
        if (cycles_to_wait_ > 0U) {
            --cycles_to_wait_;
        }
        const Storing storing = codes_.storing();
        if (storing != Storing::not_needed) {
            pace_.begin_cycle();
            if ((cycles_to_wait_ <= longest_wait(storing)) && pace_.is_due()) {
                store();
            }
        }
    }

    // A change that a tester orders; false beyond the number that a start allows, so that the memory is not
    // worn out.
    bool has_orders_left() const noexcept { return orders_left_ > 0U; }
    bool takes_order() noexcept {
        const bool is_taken = has_orders_left();
        orders_left_ -= is_taken ? 1U : 0U;
        return is_taken;
    }

    // A tester waits for what he has ordered: it is tried at once, and while he waits once a second, however
    // rarely the memory has been asked before.
    void begin_order() noexcept { pace_.wait_at_most(0U); }
    void continue_order() noexcept { pace_.wait_at_most(least_cycles_between_records); }

    TroubleMemory& codes() noexcept { return codes_; }
    const TroubleMemory& codes() const noexcept { return codes_; }
    WrittenData& written() noexcept { return written_; }
    // Before the control unit is switched off in an orderly way: what is to be stored sooner or later.
    void store_the_rest() noexcept {
        if (codes_.storing() != Storing::not_needed) {
            store();
        }
    }

    // Findings of a tester's section memory, which are reported with those of this one.
    void report_section_memory(bool is_failing) noexcept {
        is_section_failing_ = is_failing;
        is_failing_ = is_own_failing_ || is_section_failing_;
    }

    // All that was to be stored at once has been taken by the memory.
    bool is_stored() const noexcept { return codes_.storing() != Storing::now; }

    // This memory or the other has refused a record for some time, or this one had at the start only what
    // could not be read; and has taken none since.
    bool is_failing() const noexcept { return is_failing_; }

 private:
    using Record = application::AlternatingRecord<KeptPayload>;

    static constexpr std::uint32_t most_orders = 100U;
    static constexpr std::uint32_t least_cycles_between_records = 100U;
    static constexpr std::uint32_t cycles_to_store_counts = 6000U;
    static constexpr std::uint32_t wait_of_new_entries =
        cycles_to_store_counts - least_cycles_between_records;

    static std::uint32_t longest_wait(Storing storing) noexcept {
        return (storing == Storing::now) ? wait_of_new_entries : 0U;
    }
    void store() noexcept;

    Record record_;
    TroubleMemory codes_{};
    WrittenData written_{};
    application::WritePace pace_{};
    bool is_own_failing_{false};
    bool is_section_failing_{false};
    bool is_failing_{false};  // one of both: asked for in every cycle
    std::uint32_t orders_left_{most_orders};
    std::uint32_t cycles_to_wait_{wait_of_new_entries};  // until what only counts is stored
};

}  // namespace rsi::diagnosis
