// Lane count: how many vehicles are computed at once.
#pragma once

#include <cstddef>

namespace sil {

// As many doubles as the largest register holds, of AVX-512; with smaller registers a number takes several.
inline constexpr std::size_t lane_count = 8;

}  // namespace sil
