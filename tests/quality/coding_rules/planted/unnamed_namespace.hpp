// An unnamed namespace in a header.
// Caught by: google-build-namespaces
#pragma once

#include <cstdint>

namespace planted {
namespace {

constexpr std::uint32_t limit = 7U;

}  // namespace

constexpr std::uint32_t twice_the_limit() {
    return 2U * limit;
}

}  // namespace planted
