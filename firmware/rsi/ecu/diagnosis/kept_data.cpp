#include "rsi/ecu/diagnosis/kept_data.hpp"

namespace rsi::diagnosis {

void KeptData::restore() noexcept {
    KeptPayload payload{};
    const application::RecordState state = record_.read(payload);
    const bool is_known = application::has_record(state) && (payload.layout == KeptPayload::present_layout);
    is_own_failing_ = !is_known && (state != application::RecordState::never_written);
    is_failing_ = is_own_failing_;
    if (is_known) {
        codes_.restore(payload.codes);
        written_ = payload.written;
    }
}

void KeptData::store() noexcept {
    const KeptPayload payload{KeptPayload::present_layout, codes_.stored_data(), written_};
    const bool is_taken = record_.write(payload);
    pace_.tried(is_taken);
    is_own_failing_ = !is_taken && (is_own_failing_ || pace_.is_failing());
    is_failing_ = is_own_failing_ || is_section_failing_;
    if (is_taken) {
        codes_.stored();
        cycles_to_wait_ = cycles_to_store_counts;
    }
}

}  // namespace rsi::diagnosis
