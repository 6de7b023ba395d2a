// `rsi-sil replay` as a user starts it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/sil/drives/drive_text.hpp"
#include "tests/sil/drives/recorded_drive.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

namespace fs = std::filesystem;
using test_support::text_of;
using test_support::write_text;
using testing_drives::good_lines;
using testing_drives::text_of_lines;

class ReplayProgram : public testing::Test {
 protected:
    fs::path path(const std::string& name) const { return scratch_.path() / name; }
    fs::path results(const std::string& name) const { return path("out") / name; }

    // Exit status; what was said is in `out` and `err`.
    int replay(const std::string& files, const std::string& options = "--no-pictures") {
        const std::string command = "cd '" + scratch_.path().string() + "' && '" + RSI_SIL_PROGRAM +
                                    "' replay " + files + " --parameters '" + RSI_PROJECT_FOLDER +
                                    "/firmware/calibrations/large_suv.toml' --output out " + options +
                                    " > out.txt 2> err.txt";
        const int status = std::system(command.c_str());
        out = text_of(path("out.txt"));
        err = text_of(path("err.txt"));
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    std::string out;
    std::string err;

 private:
    test_support::ScratchFolder scratch_;
};

TEST_F(ReplayProgram, LeavesAFolderWithEveryResultAndATable) {
    const testing_drives::RecordedDrive run =
        testing_drives::record_drive(testing_drives::hard_turn(), 3.0, path("."));
    ASSERT_EQ(replay("signals.csv", ""), 0) << err;
    for (const char* name : {"summary.json", "warnings.csv", "diagnosis.csv", "indices.csv", "events.gp",
                             "report.html", "replay.svg", "replay.png"}) {
        EXPECT_TRUE(fs::exists(results("signals") / name)) << name;
    }
    EXPECT_EQ(text_of(results("signals") / "replay.svg").find("NaN"), std::string::npos);
    const auto summary = nlohmann::json::parse(text_of(results("signals") / "summary.json"));
    EXPECT_NEAR(summary["warning_time_s"].get<double>(), run.events.warning->time_s, 1e-9);
    EXPECT_EQ(summary["kind"], "csv");
    EXPECT_THAT(text_of(results("table.csv")), testing::HasSubstr("signals.csv,signals,"));
    EXPECT_THAT(out, testing::HasSubstr("1 drives: 1 "));
}

// Without a roll angle most of what is drawn can be missing.
TEST_F(ReplayProgram, DrawsADriveThatLacksMostSignals) {
    std::vector<std::string> lines{
        "time_s,lateral_acceleration_mps2,roll_rate_degps,speed_mps,yaw_rate_degps"};
    for (int index = 10; index < 60; ++index) {
        lines.push_back("0." + std::to_string(index) + ",0.1,0,10,0");
    }
    write_text(path("bare.csv"), text_of_lines(lines));
    ASSERT_EQ(replay("bare.csv", ""), 0) << err;
    EXPECT_EQ(err, "[1/1] bare.csv\n");
    EXPECT_THAT(text_of(results("bare") / "replay.svg"), testing::HasSubstr("|LTR|, wheel loads: none"));
}

TEST_F(ReplayProgram, KnowsALogByItsContent) {
    static_cast<void>(testing_drives::record_drive(testing_drives::hard_turn(), 3.0, path(".")));
    std::string log = text_of(path("candump.log"));
    const std::size_t second = log.find('\n') + 1U;
    log.insert(second, log.substr(0U, second).replace(1U, 1U, "7000"));
    write_text(path("log.csv"), "DROPCOUNT: dropped 5 CAN frames on 'can0' socket\n" + log);
    ASSERT_EQ(replay("log.csv signals.csv"), 0) << err;
    const auto of_log = nlohmann::json::parse(text_of(results("log") / "summary.json"));
    const auto of_signals = nlohmann::json::parse(text_of(results("signals") / "summary.json"));
    EXPECT_EQ(of_log["kind"], "candump");
    EXPECT_NEAR(of_log["warning_time_s"].get<double>(), of_signals["warning_time_s"].get<double>(), 0.0101);
}

TEST_F(ReplayProgram, GoesOnAfterABadFileAndSaysWhichItWas) {
    write_text(path("a.csv"), text_of_lines(good_lines(50)));
    write_text(path("b.csv"), text_of_lines(good_lines(50)).substr(0U, 300U));
    write_text(path("c.csv"), text_of_lines(good_lines(50)));
    EXPECT_EQ(replay("a.csv b.csv c.csv"), 1);
    EXPECT_THAT(err, testing::HasSubstr("b.csv:8:"));
    EXPECT_THAT(err, testing::HasSubstr("1 of 3 files could not be replayed"));
    EXPECT_TRUE(fs::exists(results("a") / "summary.json"));
    EXPECT_FALSE(fs::exists(results("b")));
    EXPECT_FALSE(fs::exists(results("b.partial")));
    EXPECT_TRUE(fs::exists(results("c") / "summary.json"));
    EXPECT_THAT(text_of(results("table.csv")), testing::HasSubstr("b.csv,b,,,,,,,,,failed,,\n"));
}

TEST_F(ReplayProgram, ResultsOfAnEarlierReplayDoNotOutliveAFailure) {
    write_text(path("a.csv"), text_of_lines(good_lines(50)));
    ASSERT_EQ(replay("a.csv"), 0);
    write_text(path("a.csv"), "time_s\n0\n");
    EXPECT_EQ(replay("a.csv"), 1);
    EXPECT_FALSE(fs::exists(results("a")));
}

TEST_F(ReplayProgram, SetChangesAParameter) {
    static_cast<void>(testing_drives::record_drive(testing_drives::hard_turn(), 3.0, path(".")));
    ASSERT_EQ(replay("signals.csv"), 0) << err;
    const auto as_it_is = nlohmann::json::parse(text_of(results("signals") / "summary.json"));
    ASSERT_EQ(replay("signals.csv", "--no-pictures --set warning_on=0.99 --set warning_indicator=published"),
              0)
        << err;
    const auto changed = nlohmann::json::parse(text_of(results("signals") / "summary.json"));
    EXPECT_EQ(changed["warning_indicator"], "published");
    EXPECT_NE(changed["warning_time_s"], as_it_is["warning_time_s"]);
    EXPECT_EQ(replay("signals.csv", "--no-pictures --set no_such_key=1"), 1);
    EXPECT_THAT(err, testing::HasSubstr("\"no_such_key=1\" must be KEY=VALUE"));
}

// A second without samples.
TEST_F(ReplayProgram, SaysThatADriveWasNotAvailable) {
    std::vector<std::string> lines = good_lines(400);
    lines.erase(lines.begin() + 150, lines.begin() + 250);
    write_text(path("gap.csv"), text_of_lines(lines));
    ASSERT_EQ(replay("gap.csv"), 0) << err;
    EXPECT_THAT(out, testing::HasSubstr("1 drives: 1 unavailable\n"));
    EXPECT_THAT(out, testing::HasSubstr("unavailable (imu lost"));
    const auto summary = nlohmann::json::parse(text_of(results("gap") / "summary.json"));
    EXPECT_GT(summary["unavailable_duration_s"].get<double>(), 0.9);
    EXPECT_THAT(summary["confirmed_codes"].dump(), testing::HasSubstr("imu lost"));
    EXPECT_THAT(text_of(results("gap") / "diagnosis.csv"), testing::HasSubstr(",unavailable,imu lost"));
}

TEST_F(ReplayProgram, WritesTheSameBytesTwice) {
    write_text(path("a.csv"), text_of_lines(good_lines(200)));
    ASSERT_EQ(replay("a.csv"), 0);
    const std::string first = text_of(results("a") / "indices.csv") + text_of(results("a") / "summary.json");
    ASSERT_EQ(replay("a.csv"), 0);
    EXPECT_EQ(text_of(results("a") / "indices.csv") + text_of(results("a") / "summary.json"), first);
}

TEST_F(ReplayProgram, TellsIgnoredColumnsOnce) {
    std::string text = text_of_lines(good_lines(50));
    text.replace(text.find("speed_kmh"), 9U, "gear");
    write_text(path("a.csv"), text);
    write_text(path("b.csv"), text);
    ASSERT_EQ(replay("a.csv b.csv"), 0);
    const std::string remark = "columns that a replay does not use: gear";
    EXPECT_THAT(err, testing::HasSubstr(remark));
    EXPECT_EQ(err.find(remark), err.rfind(remark));
}

TEST_F(ReplayProgram, LeavesOutLinesOfALogThatAreNoFramesAndSaysSo) {
    const std::string frames =
        "(0.000000) vcan0 120#0000000000000000\n(0.020000) vcan0 120#0000000000000000\n";
    write_text(
        path("mixed.log"),
        "(0.000000) vcan0 20000080#0000000000000000\n(0.000000) vcan0 121#R\n(0.000000) vcan0 120#0\n" +
            frames);
    write_text(path("pure.log"), frames);
    ASSERT_EQ(replay("mixed.log pure.log"), 0) << err;
    EXPECT_THAT(err, testing::HasSubstr("mixed.log: left out: 1 error frames; 1 remote frames; 1 lines that "
                                        "are no frames, the first mixed.log:3:"));
    EXPECT_EQ(text_of(results("mixed") / "indices.csv"), text_of(results("pure") / "indices.csv"));
}

TEST_F(ReplayProgram, RefusesALogOfNothingButBadLines) {
    write_text(path("bad.log"), "(0.010000) vcan0 120#0\n");
    EXPECT_EQ(replay("bad.log"), 1);
    EXPECT_THAT(err, testing::HasSubstr("the first bad.log:1:"));
    EXPECT_THAT(err, testing::HasSubstr("bad.log: there is no sensor frame in this log"));
}

TEST_F(ReplayProgram, WithoutFilesOrWithUnknownOptionsShowsTheWay) {
    EXPECT_EQ(replay(""), 2);
    EXPECT_THAT(err, testing::HasSubstr("rsi-sil replay --help"));
    EXPECT_EQ(replay("a.csv", "--threshold 1"), 2);
}

}  // namespace
