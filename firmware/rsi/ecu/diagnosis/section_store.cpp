#include "rsi/ecu/diagnosis/section_store.hpp"

namespace rsi::diagnosis {

bool SectionStore::restore() noexcept {
    return storage_.read(bytes_.data(), length()) && (check() == application::ParametersRefusal::none);
}

SectionAnswer SectionStore::store(std::uint8_t& reason) noexcept {
    const application::ParametersRefusal refusal = check();
    reason = static_cast<std::uint8_t>(refusal);
    if (refusal != application::ParametersRefusal::none) {
        return SectionAnswer::refused;
    }
    return storage_.write(bytes_.data(), length()) ? SectionAnswer::stored : SectionAnswer::busy;
}

application::ParametersRefusal SectionStore::check() noexcept {
    rsi::Parameters parameters{};
    return (authority_ != nullptr)
               ? application::read_parameter_section(bytes_.data(), length(), *authority_, parameters).refusal
               : application::read_parameter_section(bytes_.data(), length(), parameters).refusal;
}

}  // namespace rsi::diagnosis
