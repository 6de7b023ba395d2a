#include "diagnosis/kept_data.hpp"

#include <cstring>

#include "hal/interface/saturating_count.hpp"

namespace diagnosis {
namespace {

constexpr std::uint32_t least_cycles_between_records = 100U;
constexpr std::uint32_t cycles_to_store_counts = 6000U;

constexpr std::size_t states_at = 1U;
constexpr std::size_t vehicle_number_at = states_at + TroubleMemory::stored_length;
constexpr std::size_t programming_date_at = vehicle_number_at + 17U;
static_assert(programming_date_at + 4U == kept_payload_length);

}  // namespace

void KeptData::restore() noexcept {
    Record::Payload payload{};
    if (record_.read(payload) && (payload[0] == trouble_code_count)) {
        codes_.restore(payload.data() + states_at);
        std::memcpy(written_.vehicle_number.data(), payload.data() + vehicle_number_at,
                    written_.vehicle_number.size());
        std::memcpy(written_.programming_date.data(), payload.data() + programming_date_at,
                    written_.programming_date.size());
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
    Record::Payload payload{};
    payload[0] = static_cast<std::uint8_t>(trouble_code_count);
    codes_.write(payload.data() + states_at);
    std::memcpy(payload.data() + vehicle_number_at, written_.vehicle_number.data(),
                written_.vehicle_number.size());
    std::memcpy(payload.data() + programming_date_at, written_.programming_date.data(),
                written_.programming_date.size());
    if (record_.write(payload)) {
        codes_.stored();
        cycles_since_store_ = 0U;
    }
}

}  // namespace diagnosis
