// Resampling: a drive at any rate in the firmware's cycle.
#include "sil/studies/drives/resample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace {

using Signal = std::function<double(double)>;

sil::Drive drive_at(double rate_hz, double duration_s, const Signal& lateral, double start_s = 0.0) {
    sil::Drive drive;
    const int last = static_cast<int>(std::lround(duration_s * rate_hz));
    for (int index = 0; index <= last; ++index) {
        sil::DriveSample sample;
        sample.time_s = start_s + index / rate_hz;
        sample.lateral_acceleration_mps2 = lateral(sample.time_s);
        sample.roll_angle_rad = 0.1;
        drive.samples.push_back(sample);
    }
    return drive;
}

double lateral_of(const sil::DriveCycle& cycle) {
    return cycle.sample.lateral_acceleration_mps2;
}

TEST(Resampling, At100HzTheSamplesStayAsTheyAre) {
    const sil::Drive drive = drive_at(100.0, 2.0, [](double t) { return std::sin(50.0 * t); }, 3.0);
    const auto cycles = sil::to_cycles(drive);
    ASSERT_EQ(cycles.size(), drive.samples.size());
    for (std::size_t index = 0U; index < cycles.size(); ++index) {
        EXPECT_TRUE(cycles[index].has_frames);
        EXPECT_EQ(lateral_of(cycles[index]), drive.samples[index].lateral_acceleration_mps2);
        EXPECT_NEAR(cycles[index].sample.time_s, 3.0 + 0.01 * static_cast<double>(index), 1e-9);
    }
}

// A straight line has no content above 50 Hz and must come out without delay.
TEST(Resampling, ARampKeepsItsTimingAtEveryRate) {
    for (const double rate_hz : {50.0, 60.0, 99.5, 100.5, 125.0, 200.0, 500.0, 1000.0}) {
        const auto cycles = sil::to_cycles(drive_at(rate_hz, 2.0, [](double t) { return 10.0 * t; }));
        ASSERT_GE(cycles.size(), 200U) << rate_hz;
        ASSERT_LE(cycles.size(), 201U) << rate_hz;
        // At the ends the triangle is cut, at rates that do not divide it is not quite even: within 1.5 ms.
        for (std::size_t index = 2U; index + 2U < cycles.size(); ++index) {
            EXPECT_NEAR(lateral_of(cycles[index]), 10.0 * 0.01 * static_cast<double>(index), 0.015)
                << rate_hz << " " << index;
        }
    }
}

TEST(Resampling, RatesThatDivideEvenlyDelayNothingAtAll) {
    for (const double rate_hz : {50.0, 200.0, 500.0, 1000.0}) {
        const auto cycles = sil::to_cycles(drive_at(rate_hz, 1.0, [](double t) { return 10.0 * t; }));
        for (std::size_t index = 2U; index + 2U < cycles.size(); ++index) {
            EXPECT_NEAR(lateral_of(cycles[index]), 0.1 * static_cast<double>(index), 1e-9) << rate_hz;
        }
    }
}

// The triangle of weights over 20 ms is a low-pass with gain sinc^2(f * 10 ms): 0.88 at 20 Hz (0.875 in
// closed form) and zero at 100 Hz, which a sampling at 100 Hz would turn into a constant error.
TEST(Resampling, A100HzVibrationRecordedAt1KhzDoesNotBecomeABias) {
    const double pi = 3.14159265358979323846;
    const auto vibrating =
        sil::to_cycles(drive_at(1000.0, 1.0, [pi](double t) { return std::cos(200.0 * pi * t); }));
    const auto slow =
        sil::to_cycles(drive_at(1000.0, 1.0, [pi](double t) { return std::cos(40.0 * pi * t); }));
    for (std::size_t index = 2U; index + 2U < vibrating.size(); ++index) {
        EXPECT_NEAR(lateral_of(vibrating[index]), 0.0, 1e-3);
        EXPECT_NEAR(lateral_of(slow[index]), 0.875 * std::cos(0.4 * pi * static_cast<double>(index)), 5e-3);
    }
}

TEST(Resampling, At200HzACycleIsHalfItsSampleAndAQuarterOfEachNeighbour) {
    sil::Drive drive = drive_at(200.0, 0.1, [](double) { return 0.0; });
    drive.samples[10].lateral_acceleration_mps2 = 8.0;  // at 0.05 s
    drive.samples[13].lateral_acceleration_mps2 = 4.0;  // at 0.065 s, between 0.06 and 0.07 s
    const auto cycles = sil::to_cycles(drive);
    EXPECT_NEAR(lateral_of(cycles[5]), 4.0, 1e-9);
    EXPECT_NEAR(lateral_of(cycles[4]), 0.0, 1e-9);
    EXPECT_NEAR(lateral_of(cycles[6]), 1.0, 1e-9);
    EXPECT_NEAR(lateral_of(cycles[7]), 1.0, 1e-9);
}

TEST(Resampling, AShortGapIsBridgedAndALongOneIsSilent) {
    const sil::Drive whole = drive_at(100.0, 1.0, [](double t) { return 10.0 * t; });
    for (const int missing : {1, 2, 3, 4, 10}) {
        sil::Drive drive = whole;
        const auto first = drive.samples.begin() + 50;
        drive.samples.erase(first, first + missing);
        const auto cycles = sil::to_cycles(drive);
        ASSERT_EQ(cycles.size(), whole.samples.size());
        const bool bridged = (missing + 1) * 0.010 <= 0.035;
        for (std::size_t index = 0U; index < cycles.size(); ++index) {
            const bool is_missing = index >= 50U && index < 50U + static_cast<std::size_t>(missing);
            EXPECT_EQ(cycles[index].has_frames, bridged || !is_missing) << missing << " " << index;
            if (cycles[index].has_frames) {
                EXPECT_NEAR(lateral_of(cycles[index]), 0.1 * static_cast<double>(index), 1e-9);
            } else {
                EXPECT_TRUE(std::isnan(lateral_of(cycles[index])));
            }
        }
    }
}

TEST(Resampling, AfterAGapOffTheGridTheNearestSampleIsTaken) {
    sil::Drive drive = drive_at(100.0, 0.3, [](double) { return 1.0; });
    const sil::Drive later = drive_at(100.0, 0.3, [](double) { return 2.0; }, 0.4963);
    drive.samples.insert(drive.samples.end(), later.samples.begin(), later.samples.end());
    const auto cycles = sil::to_cycles(drive);
    EXPECT_TRUE(cycles[30].has_frames);
    EXPECT_FALSE(cycles[31].has_frames);
    EXPECT_FALSE(cycles[49].has_frames);  // 0.49 s, 6.3 ms before the next sample
    EXPECT_TRUE(cycles[50].has_frames);
    EXPECT_EQ(lateral_of(cycles[50]), 2.0);
}

TEST(Resampling, MissingValuesStayMissing) {
    sil::Drive drive = drive_at(50.0, 0.2, [](double) { return 1.0; });
    drive.samples[5].lateral_acceleration_mps2 = sil::DriveSample::not_available;  // at 0.1 s
    const auto cycles = sil::to_cycles(drive);
    for (std::size_t index = 0U; index < cycles.size(); ++index) {
        EXPECT_EQ(std::isnan(lateral_of(cycles[index])), index >= 9U && index <= 11U) << index;
        EXPECT_NEAR(cycles[index].sample.roll_angle_rad, 0.1, 1e-12);
        EXPECT_TRUE(std::isnan(cycles[index].sample.speed_mps));
    }
}

}  // namespace
