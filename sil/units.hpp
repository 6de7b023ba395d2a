// Units: the factors between SI and what people read, and pi.
#pragma once

namespace sil {

inline constexpr double g_mps2 = 9.80665;
inline constexpr double pi = 3.14159265358979323846;
inline constexpr double degrees_per_radian = 180.0 / pi;

}  // namespace sil
