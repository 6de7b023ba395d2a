// The reader of drives from any bytes: a drive that keeps what the reader promises and can be resampled, or
// an error with file, line and column.
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sil/studies/drives/drive_columns.hpp"
#include "sil/studies/drives/drive_csv.hpp"
#include "sil/studies/drives/resample.hpp"
#include "tests/quality/fuzz/support/message.hpp"
#include "tests/quality/fuzz/support/require.hpp"

namespace {

using fuzz::require;

constexpr const char* file_name = "folder/a drive.csv";
constexpr double longest_resampled_s = 30.0;

bool is_in_range(double value) {
    return std::isnan(value) || std::fabs(value) <= 1.0e15;
}

void check_drive(sil::Drive drive) {
    require(drive.name == "a drive", "a drive is called as its file");
    require(drive.samples.size() >= 2U, "a drive has two samples");
    double before_s = -HUGE_VAL;
    for (sil::DriveSample& sample : drive.samples) {
        require(sample.time_s > before_s, "samples are in the order of time");
        before_s = sample.time_s;
        for (const sil::DriveQuantity& quantity : sil::drive_quantities()) {
            const double value = quantity.value(sample);
            require(is_in_range(value), "a value is a possible number or not available");
            require(quantity.need != sil::DriveNeed::always || !std::isnan(value),
                    "what is always needed is always there");
        }
    }
    const double first_s = drive.samples.front().time_s;
    const double last_s = drive.samples.back().time_s;
    for (const auto& lift_s : {drive.one_wheel_lift_s, drive.two_wheel_lift_s}) {
        require(!lift_s || (drive.lift_off_given && *lift_s >= first_s && *lift_s <= last_s),
                "a lift-off lies within the drive");
    }
}

// Linear interpolation and weighted means stay between the smallest and the largest sample.
void check_cycles(const sil::Drive& drive) {
    const double first_s = drive.samples.front().time_s;
    const double span_s = drive.samples.back().time_s - first_s;
    if (span_s > longest_resampled_s) {
        return;
    }
    const std::vector<sil::DriveCycle> cycles = sil::to_cycles(drive);
    require(std::fabs(static_cast<double>(cycles.size()) - 1.0 - std::floor(span_s * 100.0)) <= 1.0,
            "there is a cycle every 10 ms");
    for (const sil::DriveQuantity& quantity : sil::drive_quantities()) {
        double lowest = HUGE_VAL;
        double highest = -HUGE_VAL;
        for (sil::DriveSample sample : drive.samples) {
            lowest = std::fmin(lowest, quantity.value(sample));
            highest = std::fmax(highest, quantity.value(sample));
        }
        const double slack = 1.0e-9 * std::fmax(std::fabs(lowest), std::fabs(highest));
        for (sil::DriveCycle cycle : cycles) {
            const double value = quantity.value(cycle.sample);
            require(
                std::isnan(value) || (value >= lowest - slack - 2.0e-6 && value <= highest + slack + 2.0e-6),
                "a resampled value lies between the samples");
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text{reinterpret_cast<const char*>(data), size};
    try {
        const sil::Drive drive = sil::parse_drive_csv(text, file_name);
        check_drive(drive);
        check_cycles(drive);
    } catch (const sil::InputError& error) {
        const std::string_view message = error.what();
        fuzz::require_place(message, file_name);
        require(message.find("; ") != std::string_view::npos, "an error says what to do");
        for (const char letter : message) {
            require(static_cast<unsigned char>(letter) >= 0x20U, "an error holds no control characters");
        }
    }
    return 0;
}
