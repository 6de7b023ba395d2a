// Comparison of logs: what counts as a difference, and what a person gets to read.
#include "sil/files/candump_compare.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using Log = std::vector<sil::LoggedFrame>;

Log log_of(const std::vector<std::string>& lines) {
    Log log;
    for (const std::string& line : lines) {
        const auto parsed = sil::parse_candump_line(line);
        EXPECT_TRUE(parsed.frame) << line;
        log.push_back(parsed.frame.value_or(sil::LoggedFrame{}));
    }
    return log;
}

// Three frames a cycle as the ECU sends them, with a counter in the payload.
Log cycles(int count) {
    Log log;
    for (int cycle = 0; cycle < count; ++cycle) {
        for (const std::uint32_t identifier : {0x0D0U, 0x230U, 0x231U}) {
            sil::LoggedFrame logged;
            logged.interface = "sil";
            logged.frame.receive_time = hal::Time::from_milliseconds(10 * cycle);
            logged.frame.identifier = identifier;
            logged.frame.length = 8U;
            logged.frame.data[1] = static_cast<std::uint8_t>(cycle % 15);
            logged.frame.data[2] = static_cast<std::uint8_t>(cycle / 4);
            log.push_back(logged);
        }
    }
    return log;
}

TEST(CompareLogs, EqualLogsAgree) {
    const sil::LogComparison comparison = sil::compare_logs(cycles(50), cycles(50));
    EXPECT_TRUE(comparison.equal);
    EXPECT_EQ(comparison.differences, 0U);
    EXPECT_EQ(comparison.report, "the logs agree: 150 frames\n");
}

TEST(CompareLogs, AChangedPayloadIsShownWithContextMeaningAndMarkedBytes) {
    const Log expected = log_of({"(0.010000) sil 0D0#1100", "(0.010000) sil 230#2200",
                                 "(0.020000) sil 0D0#33445566", "(0.020000) sil 230#4400"});
    Log actual = expected;
    actual[2].frame.data[1] = 0xFF;
    actual[2].frame.data[3] = 0xEE;
    sil::CompareOptions options;
    options.context_frames = 1U;
    options.describe = [](const hal::CanFrame& frame) {
        return frame.identifier == 0x0D0U ? std::string("RolloverWarning") : std::string();
    };
    const sil::LogComparison comparison = sil::compare_logs(expected, actual, options);
    EXPECT_FALSE(comparison.equal);
    EXPECT_EQ(comparison.differences, 1U);
    EXPECT_EQ(comparison.report,
              "the logs differ in 1 places (4 frames expected, 4 found; '-' expected, '+' found)\n"
              "first difference: expected frame 3, actual frame 3: other content\n"
              "    (0.010000) sil 230#2200\n"
              "  - (0.020000) sil 0D0#33445566   RolloverWarning\n"
              "  + (0.020000) sil 0D0#33FF55EE   RolloverWarning\n"
              "                         ^^  ^^\n"
              "    (0.020000) sil 230#4400\n");
}

TEST(CompareLogs, AMissingFrameIsOneDifference) {
    Log actual = cycles(50);
    actual.erase(actual.begin() + 70);
    const sil::LogComparison comparison = sil::compare_logs(cycles(50), actual);
    EXPECT_EQ(comparison.differences, 1U) << comparison.report;
    EXPECT_NE(comparison.report.find("expected frame 71, actual frame 71: 1 missing"), std::string::npos)
        << comparison.report;
}

TEST(CompareLogs, AMissingCycleIsOneDifference) {
    Log actual = cycles(50);
    actual.erase(actual.begin() + 60, actual.begin() + 63);
    const sil::LogComparison comparison = sil::compare_logs(cycles(50), actual);
    EXPECT_EQ(comparison.differences, 1U) << comparison.report;
    EXPECT_NE(comparison.report.find("3 missing"), std::string::npos) << comparison.report;
}

TEST(CompareLogs, AnAddedFrameIsOneDifference) {
    Log actual = cycles(50);
    sil::LoggedFrame added = actual[30];
    added.frame.identifier = 0x123U;
    actual.insert(actual.begin() + 30, added);
    const sil::LogComparison comparison = sil::compare_logs(cycles(50), actual);
    EXPECT_EQ(comparison.differences, 1U) << comparison.report;
    EXPECT_NE(comparison.report.find("1 too many"), std::string::npos) << comparison.report;
}

TEST(CompareLogs, FramesThatFollowEachOtherWithChangedPayloadsAreCountedOneByOne) {
    Log actual = cycles(50);
    for (std::size_t index = 60U; index < 66U; ++index) {
        actual[index].frame.data[7] = 0x55;
    }
    EXPECT_EQ(sil::compare_logs(cycles(50), actual).differences, 6U);
}

TEST(CompareLogs, AChangedFrameThatLooksLikeALaterOneIsNotTakenForAnOmission) {
    const Log expected = log_of({"(0.000000) sil 123#00", "(0.010000) sil 123#01", "(0.020000) sil 123#02",
                                 "(0.030000) sil 123#03", "(0.040000) sil 123#04", "(0.050000) sil 123#05"});
    Log actual = expected;
    actual[1].frame.data[0] = 4U;  // as frame 5
    actual[2].frame.data[0] = 0x99U;
    EXPECT_EQ(sil::compare_logs(expected, actual).differences, 2U);
}

TEST(CompareLogs, ExchangedFramesDiffer) {
    Log actual = cycles(10);
    std::swap(actual[3], actual[4]);
    EXPECT_FALSE(sil::compare_logs(cycles(10), actual).equal);
}

TEST(CompareLogs, ALogThatEndsEarlyOrIsEmptyDiffers) {
    const sil::LogComparison cut = sil::compare_logs(cycles(10), cycles(9));
    EXPECT_EQ(cut.differences, 3U) << cut.report;
    EXPECT_NE(cut.report.find("1 missing"), std::string::npos) << cut.report;
    EXPECT_FALSE(sil::compare_logs(cycles(1), {}).equal);
    EXPECT_FALSE(sil::compare_logs({}, cycles(1)).equal);
    EXPECT_TRUE(sil::compare_logs({}, {}).equal);
}

TEST(CompareLogs, KindAndLengthCount) {
    const Log plain = log_of({"(0.000000) sil 123#00"});
    EXPECT_FALSE(sil::compare_logs(plain, log_of({"(0.000000) sil 00000123#00"})).equal);
    EXPECT_FALSE(sil::compare_logs(plain, log_of({"(0.000000) sil 123##000"})).equal);
    EXPECT_FALSE(sil::compare_logs(plain, log_of({"(0.000000) sil 124#00"})).equal);
    const sil::LogComparison longer = sil::compare_logs(plain, log_of({"(0.000000) sil 123#0000"}));
    EXPECT_NE(longer.report.find("1 bytes expected, 2 found"), std::string::npos) << longer.report;
}

TEST(CompareLogs, InterfacesAndTheKernelsCanFdBitDoNotCount) {
    EXPECT_TRUE(
        sil::compare_logs(log_of({"(0.000000) vcan0 123##100"}), log_of({"(0.000000) can1 123##500"})).equal);
    EXPECT_FALSE(
        sil::compare_logs(log_of({"(0.000000) vcan0 123##100"}), log_of({"(0.000000) vcan0 123##000"}))
            .equal);
}

TEST(CompareLogs, TimesMayDifferByTheToleranceAndNoMore) {
    const Log expected = log_of({"(1.000000) sil 123#00"});
    sil::CompareOptions options;
    options.time_tolerance_us = 500;
    EXPECT_TRUE(sil::compare_logs(expected, log_of({"(1.000500) sil 123#00"}), options).equal);
    EXPECT_TRUE(sil::compare_logs(expected, log_of({"(0.999500) sil 123#00"}), options).equal);
    const sil::LogComparison late = sil::compare_logs(expected, log_of({"(1.000501) sil 123#00"}), options);
    EXPECT_FALSE(late.equal);
    EXPECT_NE(late.report.find("time differs by 501 us, tolerance 500 us"), std::string::npos) << late.report;
    EXPECT_FALSE(sil::compare_logs(expected, log_of({"(1.000001) sil 123#00"})).equal);
}

TEST(CompareLogs, TimesCanCountFromTheFirstFrame) {
    const Log expected = log_of({"(1.000000) sil 123#00", "(1.010000) sil 123#01"});
    const Log actual = log_of({"(1700000000.500000) sil 123#00", "(1700000000.510000) sil 123#01"});
    sil::CompareOptions options;
    EXPECT_FALSE(sil::compare_logs(expected, actual, options).equal);
    options.times_relative_to_first = true;
    EXPECT_TRUE(sil::compare_logs(expected, actual, options).equal);
}

TEST(CompareLogs, ManyDifferencesAreCountedButNotAllShown) {
    Log actual = cycles(100);
    for (sil::LoggedFrame& logged : actual) {
        logged.frame.data[7] = 0x55;
    }
    sil::CompareOptions options;
    options.differences_shown = 2U;
    const sil::LogComparison comparison = sil::compare_logs(cycles(100), actual, options);
    EXPECT_EQ(comparison.differences, 300U);
    EXPECT_NE(comparison.report.find("... and 298 differences more\n"), std::string::npos);
    EXPECT_LT(comparison.report.size(), 1500U);
}

}  // namespace
