#include "diagnosis/kept_data.hpp"

namespace diagnosis {
namespace {

constexpr std::uint32_t least_cycles_between_records = 100U;
constexpr std::uint32_t cycles_to_store_counts = 6000U;
constexpr std::uint32_t cycles_to_wait_for_new = cycles_to_store_counts - least_cycles_between_records;

}  // namespace

void KeptData::restore() noexcept {
    KeptPayload payload{};
    if (record_.read(payload) && (payload.code_count == trouble_code_count)) {
        codes_.restore(payload.codes);
        written_ = payload.written;
    }
    cycles_to_wait_ = cycles_to_wait_for_new;
}

void KeptData::store_when_due() noexcept {
    const std::uint32_t most = (codes_.storing() == Storing::now) ? cycles_to_wait_for_new : 0U;
    if (cycles_to_wait_ <= most) {
        store();
    }
}

void KeptData::store() noexcept {
    const KeptPayload payload{static_cast<std::uint8_t>(trouble_code_count), codes_.stored_data(), written_};
    if (record_.write(payload)) {
        codes_.stored();
        cycles_to_wait_ = cycles_to_store_counts;
    }
}

}  // namespace diagnosis
