// Damage: how many bytes of an object change its answer when each in turn is wrong.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>

namespace rsi_test {

// `still_answers_right`: what is to be done with a copy whose byte is damaged, and whether its answer is the
// sound object's. An Object is its bytes: it owns nothing.
template <typename Object, typename StillAnswersRight>
std::size_t bytes_whose_damage_shows(const Object& sound, const StillAnswersRight& still_answers_right) {
    std::size_t count = 0U;
    for (std::size_t byte = 0U; byte < sizeof(Object); ++byte) {
        std::array<unsigned char, sizeof(Object)> memory{};
        std::memcpy(memory.data(), &sound, memory.size());
        const unsigned damage = (memory[byte] > 1U) ? 0x15U : 1U;  // a possible bool stays one
        memory[byte] = static_cast<unsigned char>(memory[byte] ^ damage);
        Object damaged;
        std::memcpy(static_cast<void*>(&damaged), memory.data(), memory.size());
        count += still_answers_right(damaged) ? 0U : 1U;
    }
    return count;
}

}  // namespace rsi_test
