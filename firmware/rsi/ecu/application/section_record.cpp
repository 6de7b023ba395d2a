#include "rsi/ecu/application/section_record.hpp"

namespace rsi::application {

template class AlternatingRecord<SectionBytes>;

bool SectionRecord::write(const SectionBytes& bytes) noexcept {
    const bool is_taken = record_.write(bytes);
    pace_.tried(is_taken);
    return is_taken;
}

bool SectionRecord::is_due() noexcept {
    constexpr std::uint32_t most_cycles_between_tries = 100U;
    pace_.begin_cycle();
    pace_.wait_at_most(most_cycles_between_tries);
    return pace_.is_due();
}

}  // namespace rsi::application
