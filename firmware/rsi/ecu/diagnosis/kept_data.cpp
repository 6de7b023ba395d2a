#include "rsi/ecu/diagnosis/kept_data.hpp"

namespace rsi::diagnosis {

void KeptData::restore() noexcept {
    KeptPayload payload{};
    if (record_.read(payload) && (payload.layout == KeptPayload::present_layout)) {
        codes_.restore(payload.codes);
        written_ = payload.written;
    }
}

void KeptData::store() noexcept {
    const KeptPayload payload{KeptPayload::present_layout, codes_.stored_data(), written_};
    if (record_.write(payload)) {
        codes_.stored();
        cycles_to_wait_ = cycles_to_store_counts;
    }
}

}  // namespace rsi::diagnosis
