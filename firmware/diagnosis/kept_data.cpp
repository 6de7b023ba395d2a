#include "diagnosis/kept_data.hpp"

#include "hal/interface/saturating_count.hpp"

namespace diagnosis {
namespace {

constexpr std::uint32_t least_cycles_between_records = 100U;
constexpr std::uint32_t cycles_to_store_counts = 6000U;

}  // namespace

void KeptData::restore() noexcept {
    KeptPayload payload{};
    if (record_.read(payload) && (payload.code_count == trouble_code_count)) {
        codes_.restore(payload.codes);
        written_ = payload.written;
    }
    cycles_since_store_ = least_cycles_between_records;
}

void KeptData::end_cycle() noexcept {
    hal::count_up(cycles_since_store_);
    const Storing storing = codes_.storing();
    const bool is_due =
        ((storing == Storing::now) && (cycles_since_store_ >= least_cycles_between_records)) ||
        ((storing == Storing::later) && (cycles_since_store_ >= cycles_to_store_counts));
    if (is_due) {
        store();
    }
}

void KeptData::store() noexcept {
    const KeptPayload payload{static_cast<std::uint8_t>(trouble_code_count), codes_.stored_data(), written_};
    if (record_.write(payload)) {
        codes_.stored();
        cycles_since_store_ = 0U;
    }
}

}  // namespace diagnosis
