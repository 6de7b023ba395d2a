// Candump logs: the very lines of candump, a round trip for any frame, and malformed input of every kind.
#include "sil/files/candump_log.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <random>
#include <string>

#include "sil/input_error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using test_support::ScratchFolder;
using test_support::text_of;
using test_support::write_text;

sil::LoggedFrame frame_of(std::int64_t time_us, std::uint32_t identifier, std::initializer_list<int> bytes) {
    sil::LoggedFrame logged;
    logged.interface = "vcan0";
    logged.frame.receive_time.nanoseconds = time_us * 1000;
    logged.frame.identifier = identifier;
    for (const int byte : bytes) {
        logged.frame.data[logged.frame.length++] = static_cast<std::uint8_t>(byte);
    }
    return logged;
}

void expect_equal(const sil::LoggedFrame& a, const sil::LoggedFrame& b) {
    EXPECT_EQ(a.interface, b.interface);
    EXPECT_EQ(a.fd_flags, b.fd_flags);
    EXPECT_EQ(a.frame.receive_time.nanoseconds, b.frame.receive_time.nanoseconds);
    EXPECT_EQ(a.frame.identifier, b.frame.identifier);
    EXPECT_EQ(a.frame.extended, b.frame.extended);
    EXPECT_EQ(a.frame.flexible_data_rate, b.frame.flexible_data_rate);
    EXPECT_EQ(a.frame.length, b.frame.length);
    EXPECT_EQ(a.frame.data, b.frame.data);
}

TEST(FormatCandumpLine, WritesWhatCandumpWrites) {
    EXPECT_EQ(sil::format_candump_line(frame_of(1'234'000'010, 0x0D0, {0xAB, 0x01})),
              "(1234.000010) vcan0 0D0#AB01");
    EXPECT_EQ(sil::format_candump_line(frame_of(0, 0x7F0, {})), "(0.000000) vcan0 7F0#");

    sil::LoggedFrame extended = frame_of(1, 0x1ABCDE, {0xFF});
    extended.frame.extended = true;
    EXPECT_EQ(sil::format_candump_line(extended), "(0.000001) vcan0 001ABCDE#FF");

    sil::LoggedFrame flexible = frame_of(2, 0x123, {1, 2});
    flexible.frame.flexible_data_rate = true;
    flexible.fd_flags = 5U;  // as a kernel that marks CAN FD in the flags
    EXPECT_EQ(sil::format_candump_line(flexible), "(0.000002) vcan0 123##10102");
}

TEST(FormatCandumpLine, CutsOffWhatDoesNotFitTheKind) {
    sil::LoggedFrame logged = frame_of(-1, 0xFFFFFFFF, {});
    logged.frame.length = 9U;
    EXPECT_EQ(sil::format_candump_line(logged), "(0.000000) vcan0 7FF#0000000000000000");
    logged.frame.extended = true;
    logged.frame.flexible_data_rate = true;
    logged.frame.length = 65U;
    EXPECT_EQ(sil::format_candump_line(logged), "(0.000000) vcan0 1FFFFFFF##0" + std::string(128U, '0'));
}

TEST(ParseCandumpLine, ReadsLinesThatCandumpWrote) {
    const auto parsed = sil::parse_candump_line("(1436509052.249713) can0 044#2A366C2BBA");
    ASSERT_TRUE(parsed.frame);
    sil::LoggedFrame expected = frame_of(1'436'509'052'249'713, 0x044, {0x2A, 0x36, 0x6C, 0x2B, 0xBA});
    expected.interface = "can0";
    expect_equal(*parsed.frame, expected);
}

TEST(ParseCandumpLine, CanFdFlagsAreReadInTheirCanonicalForm) {
    const auto without = sil::parse_candump_line("(0.000000) vcan0 123##1AABB");
    const auto with = sil::parse_candump_line("(0.000000) vcan0 123##5AABB");
    ASSERT_TRUE(without.frame && with.frame);
    expect_equal(*without.frame, *with.frame);
    EXPECT_EQ(with.frame->fd_flags, 1U);
    EXPECT_TRUE(with.frame->frame.flexible_data_rate);
    EXPECT_EQ(with.frame->frame.length, 2U);
}

TEST(ParseCandumpLine, AcceptsLowerCaseCarriageReturnAndTheDirection) {
    for (const char* line :
         {"(0.000001) vcan0 0d0#ab", "(0.000001) vcan0 0D0#AB\r", "(0.000001) vcan0 0D0#AB R",
          "(0.000001) vcan0 0D0#AB T", "(0000.000001) vcan0 0D0#AB"}) {
        const auto parsed = sil::parse_candump_line(line);
        ASSERT_TRUE(parsed.frame) << line;
        expect_equal(*parsed.frame, frame_of(1, 0x0D0, {0xAB}));
    }
}

TEST(ParseCandumpLine, TakesEachHexadecimalDigitAndNoOtherCharacter) {
    const auto parsed = sil::parse_candump_line("(0.000000) vcan0 123#09AFaf");
    ASSERT_TRUE(parsed.frame);
    expect_equal(*parsed.frame, frame_of(0, 0x123, {0x09, 0xAF, 0xAF}));
    for (const char other : {'/', ':', ';', '@', 'G', '`', 'g'}) {
        const auto refused = sil::parse_candump_line("(0.000000) vcan0 123#0" + std::string(1U, other));
        EXPECT_FALSE(refused.frame) << other;
        EXPECT_EQ(refused.error.message, "half a data byte: the number of hexadecimal digits is odd");
        EXPECT_EQ(refused.error.column, 23U);
    }
}

TEST(ParseCandumpLine, TakesTimesUpToNineThousandMillionSeconds) {
    const auto last = sil::parse_candump_line("(9000000000.999999) vcan0 123#");
    ASSERT_TRUE(last.frame);
    EXPECT_EQ(last.frame->frame.receive_time.nanoseconds, 9'000'000'000'999'999'000);
    EXPECT_EQ(last.frame->line, 0U) << "it is from no file";
    const auto beyond = sil::parse_candump_line("(9000000001.000000) vcan0 123#");
    EXPECT_FALSE(beyond.frame);
    EXPECT_EQ(beyond.error.message, "the time is beyond 9000000000 s");
}

TEST(CandumpLine, AnyFrameSurvivesTheRoundTrip) {
    std::mt19937_64 random(1U);
    constexpr std::uint8_t flexible_lengths[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64};
    for (int count = 0; count < 20'000; ++count) {
        sil::LoggedFrame logged;
        logged.interface = "can" + std::to_string(random() % 100U);
        logged.frame.receive_time.nanoseconds =
            static_cast<std::int64_t>(random() % 9'000'000'000'000'000U) * 1000;
        logged.frame.extended = random() % 2U == 0U;
        logged.frame.identifier =
            static_cast<std::uint32_t>(random()) & (logged.frame.extended ? 0x1FFFFFFFU : 0x7FFU);
        logged.frame.flexible_data_rate = random() % 2U == 0U;
        logged.frame.length = logged.frame.flexible_data_rate ? flexible_lengths[random() % 16U]
                                                              : static_cast<std::uint8_t>(random() % 9U);
        logged.fd_flags =
            logged.frame.flexible_data_rate ? static_cast<std::uint8_t>(random() % 4U) : std::uint8_t{0U};
        for (std::size_t index = 0U; index < logged.frame.length; ++index) {
            logged.frame.data[index] = static_cast<std::uint8_t>(random());
        }
        const auto parsed = sil::parse_candump_line(sil::format_candump_line(logged));
        ASSERT_TRUE(parsed.frame) << sil::format_candump_line(logged) << ": " << parsed.error.message;
        expect_equal(*parsed.frame, logged);
    }
}

struct Malformed {
    const char* line;
    std::size_t column;
    const char* message;  // a part of it
};

void PrintTo(const Malformed& malformed, std::ostream* stream) {
    *stream << '"' << malformed.line << '"';
}

class MalformedCandumpLine : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedCandumpLine, IsRefusedWithPlaceAndReason) {
    const auto parsed = sil::parse_candump_line(GetParam().line);
    ASSERT_FALSE(parsed.frame) << GetParam().line;
    EXPECT_EQ(parsed.error.column, GetParam().column) << GetParam().line << ": " << parsed.error.message;
    EXPECT_NE(parsed.error.message.find(GetParam().message), std::string::npos) << parsed.error.message;
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, MalformedCandumpLine,
    testing::Values(Malformed{"", 1U, "expected '('"}, Malformed{"vcan0 123#00", 1U, "expected '('"},
                    Malformed{"(.000000) vcan0 123#00", 2U, "seconds"},
                    Malformed{"(-1.000000) vcan0 123#00", 2U, "seconds"},
                    Malformed{"(99999999999.000000) vcan0 123#00", 11U, "beyond"},
                    Malformed{"(99999999999999999999999999.000000) vcan0 123#00", 11U, "beyond"},
                    Malformed{"(1.00000) vcan0 123#00", 9U, "six decimals"},
                    Malformed{"(1.0000000", 11U, "')' after six to nine decimals"},
                    Malformed{"(1.0000000000) vcan0 123#00", 13U, "')' after six to nine decimals"},
                    Malformed{"(1.000000)vcan0 123#00", 11U, "space"},
                    Malformed{"(1.000000)  123#00", 12U, "name of the interface"},
                    Malformed{"(1.000000) vcan0", 17U, "space"},
                    Malformed{"(1.000000) vcan0 12#00", 18U, "3 hexadecimal digits"},
                    Malformed{"(1.000000) vcan0 1234#00", 18U, "3 hexadecimal digits"},
                    Malformed{"(1.000000) vcan0 800#00", 18U, "7FF"},
                    Malformed{"(1.000000) vcan0 20000080#00", 18U, "1FFFFFFF"},
                    Malformed{"(1.000000) vcan0 123456789#00", 26U, "'#'"},
                    Malformed{"(1.000000) vcan0 123", 21U, "'#'"},
                    Malformed{"(1.000000) vc\x7F"
                              "an0 123#R",
                              14U, "a space after the interface"},
                    Malformed{"(1.000000) vcan0", 17U, "a space after the interface"},
                    Malformed{"(1.000000) vcan0 123#R", 22U, "remote"},
                    Malformed{"(1.000000) vcan0 123#r", 22U, "remote"},
                    Malformed{"(1.000000) vcan0 123#001", 25U, "odd"},
                    Malformed{"(1.000000) vcan0 123#00.11", 24U, "end of the line"},
                    Malformed{"(1.000000) vcan0 123#00 11", 24U, "end of the line"},
                    Malformed{"(1.000000) vcan0 123#112233445566778899", 38U, "more than 8"},
                    Malformed{"(1.000000) vcan0 123#1122334455667788_8", 39U, "raw length code"},
                    Malformed{"(1.000000) vcan0 123#1122334455667788_", 39U, "raw length code"},
                    Malformed{"(1.000000) vcan0 123#1122334455667788_9A", 40U, "end of the line"},
                    Malformed{"(1.000000) vcan0 123#11223344556677_9", 36U, "end of the line"},
                    Malformed{"(1.000000) vcan0 123##", 23U, "flags"},
                    Malformed{"(1.000000) vcan0 123##1112233445566778899", 42U, "9 bytes"}));

TEST(ParseCandumpLine, LeavesOutWhatIsBelowAMicrosecond) {
    for (const char* time : {"(1.234567)", "(1.2345678)", "(1.23456789)", "(1.234567999)"}) {
        const auto parsed = sil::parse_candump_line(std::string{time} + " vcan0 123#00");
        ASSERT_TRUE(parsed.frame) << time << ": " << parsed.error.message;
        EXPECT_EQ(parsed.frame->frame.receive_time.nanoseconds, 1'234'567'000) << time;
    }
}

TEST(IsCandumpLog, KnowsALineAndANoteOfLostFrames) {
    EXPECT_TRUE(sil::is_candump_log("(0.010000) can0 120#00\n"));
    EXPECT_TRUE(sil::is_candump_log("\n \r\n(0.010000) can0 120#00\n"));
    EXPECT_TRUE(sil::is_candump_log("\nDROPCOUNT: dropped 5 CAN frames on 'can0' socket\n"));
    for (const char* other : {"", " \n", "time_s,speed_mps\n", "DROP", "x(0.010000) can0 120#00\n"}) {
        EXPECT_FALSE(sil::is_candump_log(other)) << other;
    }
}

TEST(ParseCandumpLine, TakesARawLengthCodeFor8Bytes) {
    for (const char* end : {"", "_9", "_F R", "_a T"}) {
        const auto parsed =
            sil::parse_candump_line(std::string{"(0.000000) vcan0 123#1122334455667788"} + end);
        ASSERT_TRUE(parsed.frame) << end;
        EXPECT_EQ(parsed.frame->frame.length, 8U);
    }
}

TEST(ParseCandumpLine, TakesNoMoreBytesThanCanFdHas) {
    const std::string longest = "(0.000000) vcan0 123##0" + std::string(128U, '1');
    ASSERT_TRUE(sil::parse_candump_line(longest).frame);
    EXPECT_EQ(sil::parse_candump_line(longest).frame->frame.length, 64U);
    const auto beyond = sil::parse_candump_line(longest + "11");
    EXPECT_FALSE(beyond.frame);
    EXPECT_EQ(beyond.error.message, "more than 64 data bytes");
}

TEST(ParseCandumpLine, RandomBytesAreNeverMoreThanAnError) {
    std::mt19937_64 random(2U);
    for (int count = 0; count < 20'000; ++count) {
        std::string line(random() % 120U, '\0');
        std::generate(line.begin(), line.end(), [&random] { return static_cast<char>(random()); });
        const auto parsed = sil::parse_candump_line(line);
        EXPECT_FALSE(parsed.frame);
        EXPECT_FALSE(parsed.error.message.empty());
    }
}

TEST(ParseCandumpLine, AChangedByteGivesAnErrorOrAnotherFrameThatCanBeWritten) {
    std::mt19937_64 random(3U);
    const std::string original = "(12.345678) vcan0 12345678##1112233445566778899AABBCC";
    for (int count = 0; count < 20'000; ++count) {
        std::string line = original;
        line[random() % line.size()] = static_cast<char>(random());
        line.resize(random() % 4U == 0U ? random() % line.size() : line.size());
        const auto parsed = sil::parse_candump_line(line);
        if (parsed.frame) {
            const auto again = sil::parse_candump_line(sil::format_candump_line(*parsed.frame));
            ASSERT_TRUE(again.frame) << line;
            expect_equal(*again.frame, *parsed.frame);
        } else {
            EXPECT_LE(parsed.error.column, line.size() + 1U);
        }
    }
}

TEST(CandumpLog, AWrittenLogIsReadBack) {
    const ScratchFolder folder;
    const auto path = folder.path() / "candump.log";
    sil::CandumpLogWriter writer(path);
    writer.write(frame_of(10'000, 0x120, {1, 2, 3}));
    writer.write(frame_of(20'000, 0x121, {}));
    writer.close();
    EXPECT_EQ(text_of(path), "(0.010000) vcan0 120#010203\n(0.020000) vcan0 121#\n");
    const auto frames = sil::read_candump_log(path);
    ASSERT_EQ(frames.size(), 2U);
    expect_equal(frames[0], frame_of(10'000, 0x120, {1, 2, 3}));
    expect_equal(frames[1], frame_of(20'000, 0x121, {}));
}

TEST(CandumpLog, CanUtilsReadsTheSameFramesFromIt) {
    if (std::system("command -v log2asc > /dev/null") != 0) {
        GTEST_SKIP() << "log2asc of Debian's can-utils is not installed";
    }
    const ScratchFolder folder;
    const std::string log = (folder.path() / "candump.log").string();
    const std::string asc = (folder.path() / "candump.asc").string();
    sil::LoggedFrame extended = frame_of(20'000, 0x1ABCDEF0, {0xAB});
    extended.frame.extended = true;
    sil::LoggedFrame flexible = frame_of(30'000, 0x124, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
    flexible.frame.flexible_data_rate = true;
    sil::CandumpLogWriter writer(log);
    writer.write(frame_of(10'000, 0x120, {1, 2, 0xF3}));
    writer.write(extended);
    writer.write(flexible);
    writer.close();
    ASSERT_EQ(std::system(("log2asc -I '" + log + "' -O '" + asc + "' vcan0").c_str()), 0);
    const std::string text = text_of(asc);
    EXPECT_NE(text.find("1  120             Rx   d 3 01 02 F3"), std::string::npos) << text;
    EXPECT_NE(text.find("1  1ABCDEF0x       Rx   d 1 AB"), std::string::npos) << text;
    EXPECT_NE(text.find(" 12 00 01 02 03 04 05 06 07 08 09 0A 0B "), std::string::npos) << text;
}

std::string error_of_reading(const std::filesystem::path& path) {
    try {
        sil::read_candump_log(path);
    } catch (const sil::InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(ReadCandumpLog, AnErrorTellsFileLineAndColumn) {
    const ScratchFolder folder;
    const auto path = folder.path() / "bad.log";
    write_text(path, "(0.010000) vcan0 120#00\n\n(0.020000) vcan0 12#00\n");
    EXPECT_EQ(error_of_reading(path),
              path.string() + ":3:18: the identifier needs 3 hexadecimal digits (standard) or 8 (extended)");
}

TEST(SiftCandumpLog, AnythingButADataFrameCostsItsLineAndIsCounted) {
    const std::string good = "(0.010000) can0 120#00\n";
    const auto log = sil::sift_candump_log(good + "(0.020000) can0 20000080#0000000000000000\n" + good +
                                           "(0.020000) can0 120#R8\n(0.020000) can0 18FEF100#r\n" + good +
                                           "DROPCOUNT: dropped 5 CAN frames on 'can0' socket\n" +
                                           "(0.030000) can0 00123#81:00:12345678#1122\n\n" + good);
    ASSERT_EQ(log.frames.size(), 4U);
    EXPECT_EQ(log.frames[3].line, 10U);
    EXPECT_EQ(log.left_out.error_frames, 1U);
    EXPECT_EQ(log.left_out.remote_frames, 2U);
    EXPECT_EQ(log.left_out.wrong, 2U);
    EXPECT_EQ(log.left_out.text("a.log"),
              "a.log: left out: 1 error frames; 2 remote frames; 2 lines that are no frames, the first "
              "a.log:7:1: expected '(' and the time, as in (0.010000) vcan0 123#AABB\n");
}

TEST(SiftCandumpLog, AnIdentifierBeyondThatOfAnErrorFrameIsWrong) {
    const auto log = sil::sift_candump_log("(0.010000) can0 820#00\n(0.010000) can0 4FFFFFFF#00\n");
    EXPECT_EQ(log.left_out.wrong, 2U);
    EXPECT_EQ(log.left_out.error_frames, 0U);
}

std::string log_of(std::initializer_list<const char*> times) {
    std::string text;
    for (const char* time : times) {
        text += std::string{"("} + time + ") can0 120#00\n";
    }
    return text;
}

TEST(SiftCandumpLog, AFrameWhoseTimeAloneJumpsAwayIsLeftOutAndCounted) {
    for (const char* damaged : {"1060.040001", "998.999999", "0.020000", "9000000000.999999"}) {
        const auto log = sil::sift_candump_log(
            log_of({"1000.0", "1000.000000", damaged, "1000.030000", "1000.040000", damaged, "1000.060000"}));
        ASSERT_EQ(log.frames.size(), 4U) << damaged;
        EXPECT_EQ(log.frames[1].line, 4U);
        EXPECT_EQ(log.left_out.damaged_times, 2U);
        EXPECT_EQ(log.left_out.text("a.log"),
                  "a.log: left out: 1 lines that are no frames, the first a.log:1:8: the time needs six "
                  "decimals; 2 frames whose time jumps away from those beside them, the first a.log:3\n");
    }
}

TEST(SiftCandumpLog, AStepOfTheClockAndLittleDisorderCostNoFrame) {
    for (const auto& times :
         {log_of({"1.000000", "61.000000", "1.010000"}), log_of({"2.000000", "1.000000", "2.010000"}),
          log_of({"1.000000", "5000.000000", "5000.010000"}), log_of({"5000.000000", "1.000000"}),
          log_of({"1.000000", "5000.000000"}), log_of({"1.000000", "5000.000000", "9000.000000"})}) {
        const auto log = sil::sift_candump_log(times);
        EXPECT_EQ(log.left_out.text("a.log"), "") << times;
        EXPECT_EQ(log.frames.size(), static_cast<std::size_t>(std::count(times.begin(), times.end(), '\n')));
    }
}

TEST(SiftCandumpLog, NothingIsSaidOfAWholeLog) {
    const auto log = sil::sift_candump_log("(0.010000) can0 120#00\n");
    EXPECT_EQ(log.frames.size(), 1U);
    EXPECT_EQ(log.left_out.text("a.log"), "");
}

TEST(ReadCandumpLog, AMissingFileAFolderAndAnEmptyFileAreTold) {
    const ScratchFolder folder;
    const auto missing = folder.path() / "missing.log";
    EXPECT_EQ(
        error_of_reading(missing),
        missing.string() + ": cannot be read: No such file or directory; check the path and the permissions");
    EXPECT_EQ(
        error_of_reading(folder.path()),
        folder.path().string() + ": cannot be read: it is a folder; check the path and the permissions");
    write_text(folder.path() / "empty.log", "");
    EXPECT_TRUE(sil::read_candump_log(folder.path() / "empty.log").empty());
}

TEST(ReadCandumpLog, TheLastLineNeedsNoEnd) {
    const ScratchFolder folder;
    write_text(folder.path() / "a.log", "(0.010000) vcan0 120#00\r\n(0.020000) vcan0 121#01");
    EXPECT_EQ(sil::read_candump_log(folder.path() / "a.log").size(), 2U);
}

TEST(ReadCandumpLog, SkipsEmptyLinesOfEitherEnd) {
    EXPECT_EQ(sil::parse_candump_log("\n\r\n(0.010000) vcan0 120#00\r\n\r\n", "a.log").size(), 1U);
}

TEST(ReadCandumpLog, FramesKnowTheirLineAndMayComeInAnyOrderOfTime) {
    const ScratchFolder folder;
    write_text(folder.path() / "a.log",
               "(0.020000) vcan0 120#\n\n(0.020000) vcan0 121#\n(0.010000) vcan0 122#\n");
    const auto frames = sil::read_candump_log(folder.path() / "a.log");
    ASSERT_EQ(frames.size(), 3U);
    EXPECT_EQ(frames[0].line, 1U);
    EXPECT_EQ(frames[1].line, 3U);
    EXPECT_EQ(frames[2].line, 4U);
}

TEST(CandumpLogWriter, AFileThatCannotBeWrittenIsNamed) {
    const ScratchFolder folder;
    EXPECT_THROW(sil::CandumpLogWriter(folder.path() / "nowhere" / "a.log"), std::runtime_error);
}

}  // namespace
