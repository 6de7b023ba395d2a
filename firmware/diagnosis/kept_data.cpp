#include "diagnosis/kept_data.hpp"

namespace diagnosis {

void KeptData::restore() noexcept {
    KeptPayload payload{};
    if (record_.read(payload) && (payload.code_count == trouble_code_count)) {
        codes_.restore(payload.codes);
        written_ = payload.written;
    }
    cycles_to_wait_ = wait_of_new_entries;
}

void KeptData::store() noexcept {
    const KeptPayload payload{static_cast<std::uint8_t>(trouble_code_count), codes_.stored_data(), written_};
    if (record_.write(payload)) {
        codes_.stored();
        cycles_to_wait_ = cycles_to_store_counts;
    }
}

}  // namespace diagnosis
