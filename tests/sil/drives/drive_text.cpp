#include "tests/sil/drives/drive_text.hpp"

#include <array>
#include <cstdio>

namespace testing_drives {

std::vector<std::string> good_lines(int rows) {
    std::vector<std::string> lines{
        "time_s,lateral_acceleration_mps2,vertical_acceleration_mps2,roll_rate_degps,roll_angle_deg,speed_"
        "kmh,"
        "yaw_rate_degps"};
    for (int row = 0; row < rows; ++row) {
        std::array<char, 80> line{};
        std::snprintf(line.data(), line.size(), "%.2f,0.5,9.81,0.25,1.5,36,0", 0.01 * row);
        lines.emplace_back(line.data());
    }
    return lines;
}

std::string text_of_lines(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += line + "\n";
    }
    return text;
}

}  // namespace testing_drives
