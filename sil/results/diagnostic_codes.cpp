#include "sil/results/diagnostic_codes.hpp"

namespace sil {

std::vector<std::string> list_of_codes(std::uint64_t codes) {
    std::vector<std::string> names;
    for (std::size_t code = 1U; code < rsi::monitoring::diagnostic_code_count; ++code) {
        if (((codes >> code) & 1U) != 0U) {
            names.emplace_back(rsi::can_dbc::RolloverDiagnosis::name_of(
                static_cast<rsi::can_dbc::RolloverDiagnosis::Code>(code)));
        }
    }
    return names;
}

std::string code_names(std::uint64_t codes) {
    std::string names;
    for (const std::string& name : list_of_codes(codes)) {
        names += (names.empty() ? "" : "; ") + name;
    }
    return names;
}

void CodeListener::take(const rsi::can_dbc::RolloverDiagnosis& diagnosis) {
    using Status = rsi::can_dbc::RolloverDiagnosis::CodeStatus;
    ++now_;
    const auto reported = static_cast<std::size_t>(diagnosis.code);
    if (reported == 0U) {
        reported_.fill({});
        return;
    }
    reported_.at(reported) = {now_, diagnosis.code_status == Status::set,
                              diagnosis.code_status == Status::confirmed};
}

CodeSets CodeListener::codes() const {
    CodeSets codes;
    for (std::size_t code = 1U; code < code_count; ++code) {
        const Reported& reported = reported_[code];
        const std::uint64_t bit = std::uint64_t{1U} << code;
        const bool recent = now_ - reported.at <= code_count;
        codes.set |= recent && (reported.set || reported.confirmed) ? bit : 0U;
        codes.confirmed |= recent && reported.confirmed ? bit : 0U;
    }
    return codes;
}

}  // namespace sil
