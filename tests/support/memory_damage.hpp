// A bit of an object that memory has changed, and what lies beside the object.
#pragma once

#include <array>
#include <cstddef>

namespace rsi_test {

template <typename Object>
void flip(Object& object, std::size_t byte, unsigned bit) {
    auto* const bytes = reinterpret_cast<unsigned char*>(&object);
    bytes[byte] = static_cast<unsigned char>(bytes[byte] ^ (1U << bit));
}

// With room around it, in which nothing may change.
template <typename Object>
struct Fenced {
    std::array<unsigned char, 4096> before{};
    Object object{};
    std::array<unsigned char, 4096> after{};

    bool is_whole() const {
        constexpr std::array<unsigned char, 4096> empty{};
        return before == empty && after == empty;
    }
};

}  // namespace rsi_test
