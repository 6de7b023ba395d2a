#include "rsi/ecu/diagnosis/section_store.hpp"

namespace rsi::diagnosis {

bool SectionStore::restore() noexcept {
    const application::RecordState state = record_.read(bytes_);
    refusal_ = application::refusal_of(state);
    if (!application::has_record(state)) {
        return false;
    }
    const application::ParametersRefusal refusal = check();
    refusal_ = (refusal != application::ParametersRefusal::none) ? refusal : refusal_;
    return refusal == application::ParametersRefusal::none;
}

SectionAnswer SectionStore::store(std::uint8_t& reason) noexcept {
    if (!record_.is_due()) {
        return SectionAnswer::busy;
    }
    const application::ParametersRefusal refusal = check();
    reason = static_cast<std::uint8_t>(refusal);
    if (refusal != application::ParametersRefusal::none) {
        return SectionAnswer::refused;
    }
    return record_.write(bytes_) ? SectionAnswer::stored : SectionAnswer::busy;
}

application::ParametersRefusal SectionStore::check() noexcept {
    rsi::Parameters parameters{};
    return (authority_ != nullptr)
               ? application::read_parameter_section(bytes_.data(), length(), *authority_, parameters).refusal
               : application::read_parameter_section(bytes_.data(), length(), parameters).refusal;
}

}  // namespace rsi::diagnosis
