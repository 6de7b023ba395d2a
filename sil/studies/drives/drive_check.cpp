#include "sil/studies/drives/drive_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sil/units.hpp"

namespace sil {
namespace {

// 50 Hz to 1 kHz, with room for clocks that are not quite right.
constexpr double shortest_step_s = 0.00095;
constexpr double longest_step_s = 0.021;

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2U);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double median_step_s(const Drive& drive) {
    std::vector<double> steps_s;
    for (std::size_t index = 1U; index < drive.samples.size(); ++index) {
        steps_s.push_back(drive.samples[index].time_s - drive.samples[index - 1U].time_s);
    }
    return median(std::move(steps_s));
}

bool has_values(const DriveHeader& header, const char* quantity) {
    const DriveHeader::Column* column = header.find(quantity);
    return column != nullptr && column->available;
}

void check_rate(const Drive& drive, const DriveHeader& header, const CsvPlace& place) {
    const double step_s = median_step_s(drive);
    if (step_s < shortest_step_s || step_s > longest_step_s) {
        place.fail(header.line, header.find("time")->column,
                   fmt::format("the rows are {:.6g} ms apart (median), which is {:.4g} Hz", step_s * 1.0e3,
                               1.0 / step_s),
                   "record at 50 Hz to 1 kHz; is the unit of the time right (time_s, time_ms)?");
    }
}

void check_gravity(const Drive& drive, const DriveHeader& header, const CsvPlace& place) {
    std::vector<double> forces_mps2;
    for (const DriveSample& sample : drive.samples) {
        if (sample.time_s > drive.samples.front().time_s + upright_time_s) {
            break;
        }
        if (!std::isnan(sample.vertical_specific_force_mps2)) {
            forces_mps2.push_back(sample.vertical_specific_force_mps2);
        }
    }
    if (forces_mps2.empty()) {
        return;
    }
    const double force_mps2 = median(std::move(forces_mps2));
    if (force_mps2 < 0.5 * g_mps2 || force_mps2 > 2.0 * g_mps2) {
        place.fail(
            header.line, header.find("vertical_acceleration")->column,
            fmt::format("the vertical acceleration is {:.4g} m/s^2 in the first second (median), but an "
                        "accelerometer shows about +9.81 m/s^2",
                        force_mps2),
            "is the unit right (vertical_acceleration_mps2, vertical_acceleration_g), does it point upwards, "
            "is gravity in it? If not, leave the column out");
    }
}

void check_lift_off(const Drive& drive, const DriveHeader& header, const CsvPlace& place) {
    for (const DriveHeader::GivenTime& given : header.given_times) {
        const double first_s = drive.samples.front().time_s;
        const double last_s = drive.samples.back().time_s;
        if (given.time_s < first_s || given.time_s > last_s) {
            place.fail(
                given.line, given.column,
                fmt::format("a lift-off is given at {:.6g} s, but the rows go from {:.6g} s to {:.6g} s",
                            given.time_s, first_s, last_s),
                "give it on the clock of the rows, or `none` when it did not happen within them");
        }
    }
}

}  // namespace

void check_drive(const Drive& drive, const DriveHeader& header, const CsvPlace& place) {
    if (drive.samples.size() < 2U) {
        place.fail(header.line + drive.samples.size(), 1U,
                   drive.samples.empty() ? "there are no rows below the header" : "there is only one row",
                   "a drive needs one row every 1 ms to 20 ms");
    }
    if (!has_values(header, "roll_angle") &&
        !(has_values(header, "speed") && has_values(header, "yaw_rate"))) {
        place.fail(header.line, 1U, "no row has a value for roll_angle, nor for both speed and yaw_rate",
                   "one of the two is needed; see docs/drives.md");
    }
    check_rate(drive, header, place);
    check_gravity(drive, header, place);
    check_lift_off(drive, header, place);
}

}  // namespace sil
