// Comparison of logs: what counts as a difference, and what a person gets to read.
#include "tests/application/regression/candump_compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace {

using testing::ElementsAre;
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

// Frames of one identifier with these bytes, 10 ms apart.
Log of_bytes(const std::vector<std::uint8_t>& bytes) {
    Log log;
    for (const std::uint8_t byte : bytes) {
        sil::LoggedFrame logged;
        logged.interface = "sil";
        logged.frame.identifier = 0x123U;
        logged.frame.length = 1U;
        logged.frame.data[0] = byte;
        log.push_back(logged);
    }
    return log;
}

// The same, each byte also as an identifier of its own, so that no frame can be a changed other one.
Log of_kinds(const std::vector<std::uint8_t>& bytes) {
    Log log = of_bytes(bytes);
    for (sil::LoggedFrame& logged : log) {
        logged.frame.identifier += logged.frame.data[0];
    }
    return log;
}

// Differences, one a line.
std::vector<std::string> differences(const Log& expected, const Log& actual,
                                     const sil::CompareOptions& options = {}) {
    const sil::LogComparison comparison = sil::compare_logs(expected, actual, options);
    std::vector<std::string> lines;
    std::istringstream report{comparison.report};
    for (std::string line; std::getline(report, line);) {
        if (line.find("difference: ") != std::string::npos) {
            lines.push_back(line.substr(line.find("expected")));
        }
    }
    EXPECT_TRUE(lines.size() == comparison.differences || lines.size() == options.differences_shown);
    return lines;
}

// Three frames a cycle as the ECU sends them, with a counter in the payload.
Log cycles(int count) {
    Log log;
    for (int cycle = 0; cycle < count; ++cycle) {
        for (const std::uint32_t identifier : {0x0D0U, 0x230U, 0x231U}) {
            sil::LoggedFrame logged;
            logged.interface = "sil";
            logged.frame.receive_time = rsi::hal::Time::from_milliseconds(10 * cycle);
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
    options.describe = [](const rsi::hal::CanFrame& frame) {
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

// As above; here each of the two is a changed frame, for the next ones are as expected, or stand where they
// did.
TEST(CompareLogs, AChangedFrameComesBeforeAnOmission) {
    EXPECT_THAT(differences(of_bytes({0, 1, 2, 7, 1, 8, 9}), of_bytes({7, 1, 8, 7, 1, 8, 9})),
                ElementsAre("expected frame 1, actual frame 1: other content",
                            "expected frame 3, actual frame 3: other content"));
}

TEST(CompareLogs, AnAddedFrameBeforeEqualOnesIsOneDifference) {
    EXPECT_THAT(differences(of_kinds({1, 1, 1, 2}), of_kinds({9, 1, 1, 1, 2})),
                ElementsAre("expected frame 1, actual frame 1: 1 too many"));
}

TEST(CompareLogs, ThreeEqualFramesTellAnOmission) {
    EXPECT_THAT(differences(of_kinds({1, 2, 3, 4, 5, 6, 7}), of_kinds({2, 3, 4, 99, 6, 7})),
                ElementsAre("expected frame 1, actual frame 1: 1 missing",
                            "expected frame 5, actual frame 4: another identifier"));
    EXPECT_THAT(differences(of_kinds({1, 2, 3, 4, 5, 6}), of_kinds({2, 3, 99, 4, 5, 6})),
                ElementsAre("expected frame 1, actual frame 1: another identifier",
                            "expected frame 2, actual frame 2: another identifier",
                            "expected frame 3, actual frame 3: another identifier"));
}

TEST(CompareLogs, FewerEqualFramesTellAnOmissionWhereALogEnds) {
    EXPECT_THAT(differences(of_kinds({1, 2, 3}), of_kinds({1, 3})),
                ElementsAre("expected frame 2, actual frame 2: 1 missing"));
    EXPECT_THAT(differences(of_kinds({1, 2, 3}), of_kinds({1, 3, 7, 8})),
                ElementsAre("expected frame 2, actual frame 2: 1 missing",
                            "expected frame 4, actual frame 3: 1 too many",
                            "expected frame 4, actual frame 4: 1 too many"));
    EXPECT_THAT(differences(of_kinds({1, 3, 7, 8}), of_kinds({1, 2, 3})),
                ElementsAre("expected frame 2, actual frame 2: 1 too many",
                            "expected frame 3, actual frame 4: 1 missing",
                            "expected frame 4, actual frame 4: 1 missing"));
}

TEST(CompareLogs, UpToThirtyTwoFramesAreOneDifference) {
    std::vector<std::uint8_t> all(50U);
    std::iota(all.begin(), all.end(), std::uint8_t{0U});
    const auto without = [&all](std::ptrdiff_t count) {
        std::vector<std::uint8_t> some = all;
        some.erase(some.begin() + 5, some.begin() + 5 + count);
        return of_kinds(some);
    };
    EXPECT_THAT(differences(of_kinds(all), without(32)),
                ElementsAre("expected frame 6, actual frame 6: 32 missing"));
    EXPECT_THAT(differences(without(32), of_kinds(all)),
                ElementsAre("expected frame 6, actual frame 6: 32 too many"));
    EXPECT_GT(sil::compare_logs(of_kinds(all), without(33)).differences, 1U);
    EXPECT_GT(sil::compare_logs(without(33), of_kinds(all)).differences, 1U);
}

TEST(CompareLogs, EachFrameOfADifferenceIsShown) {
    EXPECT_EQ(
        sil::compare_logs(of_bytes({1, 2, 3, 4, 5, 6, 7, 8, 9}), of_bytes({1, 2, 5, 6, 7, 8, 9})).report,
        "the logs differ in 1 places (9 frames expected, 7 found; '-' expected, '+' found)\n"
        "first difference: expected frame 3, actual frame 3: 2 missing\n"
        "    (0.000000) sil 123#01\n"
        "    (0.000000) sil 123#02\n"
        "  - (0.000000) sil 123#03\n"
        "  - (0.000000) sil 123#04\n"
        "    (0.000000) sil 123#05\n"
        "    (0.000000) sil 123#06\n"
        "    (0.000000) sil 123#07\n");
    EXPECT_EQ(
        sil::compare_logs(of_bytes({1, 2, 3, 4, 5, 6, 7}), of_bytes({1, 2, 3, 4, 8, 9, 5, 6, 7})).report,
        "the logs differ in 1 places (7 frames expected, 9 found; '-' expected, '+' found)\n"
        "first difference: expected frame 5, actual frame 5: 2 too many\n"
        "    (0.000000) sil 123#02\n"
        "    (0.000000) sil 123#03\n"
        "    (0.000000) sil 123#04\n"
        "  + (0.000000) sil 123#08\n"
        "  + (0.000000) sil 123#09\n"
        "    (0.000000) sil 123#05\n"
        "    (0.000000) sil 123#06\n"
        "    (0.000000) sil 123#07\n");
}

// The part of a report below the frames.
std::string marks_below(const std::string& expected, const std::string& actual) {
    const std::string report = sil::compare_logs(log_of({expected}), log_of({actual})).report;
    return report.substr(report.find('\n', report.find("\n  + ") + 1U) + 1U);
}

TEST(CompareLogs, MarksBytesThatBothHave) {
    const std::string before(4U + std::string("(0.000000) sil 123#").size(), ' ');
    EXPECT_EQ(marks_below("(0.000000) sil 123#001122", "(0.000000) sil 123#011122"), before + "^^\n");
    EXPECT_EQ(marks_below("(0.000000) sil 123#0011", "(0.000000) sil 123#01"), before + "^^\n");
    EXPECT_EQ(marks_below("(0.000000) sil 123#01", "(0.000000) sil 123#0011"), before + "^^\n");
    EXPECT_EQ(marks_below("(0.000000) sil 123#01", "(0.000000) sil 123#0111"), "");
    EXPECT_EQ(marks_below("(0.000000) sil 123#01", "(0.000001) sil 123#01"), "");
    const std::string long_one = "(0.000000) sil 123##0" + std::string(126U, '1');
    EXPECT_EQ(marks_below(long_one + "00", long_one + "FF"), before + std::string(2U + 126U, ' ') + "^^\n");
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
    for (const char* other : {"(0.000000) sil 00000123#FF", "(0.000000) sil 123##0FF",
                              "(0.000000) sil 124#FF", "(0.000000) sil 00000124##0FF"}) {
        EXPECT_THAT(differences(plain, log_of({other})),
                    ElementsAre("expected frame 1, actual frame 1: another identifier"));
        EXPECT_EQ(marks_below("(0.000000) sil 123#00", other), "")
            << "bytes of unlike frames are not compared";
    }
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
    EXPECT_EQ(sil::compare_logs(expected, {}, options).differences, 2U);
    EXPECT_EQ(sil::compare_logs({}, actual, options).differences, 2U);
    EXPECT_TRUE(sil::compare_logs({}, {}, options).equal);
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

TEST(CompareLogs, TenDifferencesAreShown) {
    const auto compared = [](std::size_t count) {
        return sil::compare_logs(of_bytes(std::vector<std::uint8_t>(count, 0U)),
                                 of_bytes(std::vector<std::uint8_t>(count, 1U)));
    };
    EXPECT_EQ(compared(10U).differences, 10U);
    EXPECT_EQ(compared(10U).report.find("more"), std::string::npos);
    EXPECT_NE(compared(10U).report.find("\ndifference: expected frame 10, "), std::string::npos);
    EXPECT_EQ(compared(11U).differences, 11U);
    EXPECT_NE(compared(11U).report.find("... and 1 differences more\n"), std::string::npos);
    EXPECT_EQ(compared(11U).report.find("expected frame 11, "), std::string::npos);
}

}  // namespace
