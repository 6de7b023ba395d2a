// Drive text: invented drives as CSV, for tests of their reading.
#pragma once

#include <string>
#include <vector>

namespace testing_drives {

// Lines of a good drive: header and `rows` rows, 10 ms apart from 0.00 s, of a vehicle that stands still on a
// level road. The columns are time_s, lateral_acceleration_mps2, vertical_acceleration_mps2, roll_rate_degps,
// roll_angle_deg, speed_kmh, yaw_rate_degps. Line numbers count from 1: the header is lines[0], line 1.
std::vector<std::string> good_lines(int rows = 20);

// Each ended by "\n".
std::string text_of_lines(const std::vector<std::string>& lines);

}  // namespace testing_drives
