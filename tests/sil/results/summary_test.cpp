// Summary: its keys, its nulls, and that it is written whole or not at all.
#include "sil/results/summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sil/files/file_io.hpp"
#include "sil/results/event_marks.hpp"
#include "tests/support/scratch_folder.hpp"

namespace summary_test {
namespace {

using nlohmann::ordered_json;
using test_support::ScratchFolder;
using test_support::text_of;
using test_support::write_text;

constexpr double g_mps2 = 9.80665;
constexpr double pi = 3.14159265358979323846;

sil::Summary quiet_run() {
    sil::Summary summary;
    summary.manoeuvre = "straight";
    summary.vehicle = "large_suv";
    summary.seed = 18446744073709551615U;
    summary.noise = "none";
    summary.bias_g = 0.005;
    summary.quantisation_g = 0.001;
    summary.versions = {"1.2.3", "abcdef", "GNU 12"};
    return summary;
}

sil::Summary rollover_run() {
    sil::Summary summary = quiet_run();
    summary.mirrored = true;
    summary.lock_step = true;
    summary.frames_sent = 900U;
    summary.frames_received = 600U;
    summary.events.warning = sil::EventMoment{1.69, -0.72 * g_mps2, -0.09};
    summary.events.warning_side = sil::WarningSide::left;
    summary.events.one_wheel_lift = sil::EventMoment{1.82, 0.0, 0.0};
    summary.events.front_axle_lift = sil::EventMoment{1.95, 0.0, 0.0};
    summary.events.rear_axle_lift = sil::EventMoment{1.82, 0.0, 0.0};
    sil::WarningJudgement& judgement = summary.events.judgement;
    judgement.lifted = true;
    judgement.falling_side = sil::WarningSide::right;
    judgement.side_at_lift_off = sil::WarningSide::right;
    judgement.lead_s = 0.252;
    judgement.wrong_side_s = 0.11;
    judgement.warning_s = 0.45;
    judgement.advisory_s = 0.2;
    judgement.unavailable_s = 0.3;
    judgement.warnings = 2U;
    judgement.advisories = 3U;
    judgement.largest_load_transfer_ratio = 0.999;
    summary.events.two_wheel_lift = sil::EventMoment{2.052, 0.0, 0.0};
    summary.events.ssf_crossing = sil::EventMoment{2.095, 0.0, 0.0};
    summary.events.largest_lateral_acceleration_mps2 = 0.85 * g_mps2;
    summary.events.final_roll_angle_rad = -pi / 2.0;
    return summary;
}

TEST(SummaryJson, HasExactlyTheAgreedKeysInTheirOrder) {
    const std::vector<std::string> expected{"manoeuvre",
                                            "vehicle",
                                            "mirrored",
                                            "lock_step",
                                            "seed",
                                            "noise",
                                            "bias_g",
                                            "quantisation_g",
                                            "versions",
                                            "warning_time_s",
                                            "warning_side",
                                            "warning_ay_g",
                                            "one_wheel_lift_time_s",
                                            "two_wheel_lift_time_s",
                                            "ssf_crossing_time_s",
                                            "lead_time_s",
                                            "max_ay_g",
                                            "final_roll_deg",
                                            "frames_sent",
                                            "frames_received",
                                            "in_process",
                                            "front_axle_lift_time_s",
                                            "rear_axle_lift_time_s",
                                            "max_load_transfer_ratio",
                                            "index_times_s",
                                            "falling_side",
                                            "side_at_lift_off",
                                            "wrong_side_duration_s",
                                            "load_transfer_band",
                                            "warnings",
                                            "advisories",
                                            "warning_duration_s",
                                            "advisory_duration_s",
                                            "unavailable_duration_s"};
    for (const sil::Summary& summary : {quiet_run(), rollover_run()}) {
        std::vector<std::string> keys;
        const ordered_json json = ordered_json::parse(sil::summary_json(summary));
        for (const auto& item : json.items()) {
            keys.push_back(item.key());
        }
        EXPECT_EQ(keys, expected);
    }
}

TEST(SummaryJson, AMissingEventIsNull) {
    const ordered_json json = ordered_json::parse(sil::summary_json(quiet_run()));
    for (const char* key :
         {"warning_time_s", "warning_side", "warning_ay_g", "one_wheel_lift_time_s", "two_wheel_lift_time_s",
          "ssf_crossing_time_s", "lead_time_s", "front_axle_lift_time_s", "rear_axle_lift_time_s",
          "index_times_s", "falling_side", "side_at_lift_off"}) {
        EXPECT_TRUE(json.at(key).is_null()) << key;
    }
    EXPECT_EQ(json.at("max_ay_g"), 0.0);
    EXPECT_EQ(json.at("frames_sent"), 0);
    EXPECT_EQ(json.at("load_transfer_band"), "below 0.7");
    EXPECT_EQ(json.at("wrong_side_duration_s"), 0.0);
    EXPECT_EQ(json.at("mirrored"), false);
    EXPECT_EQ(json.at("lock_step"), false);
    EXPECT_EQ(json.at("frames_received"), 0);
}

TEST(SummaryJson, OfNothingHasZeros) {
    const ordered_json json = ordered_json::parse(sil::summary_json({}));
    for (const char* key : {"seed", "bias_g", "quantisation_g", "max_ay_g", "final_roll_deg"}) {
        EXPECT_EQ(json.at(key), 0) << key;
    }
}

TEST(SummaryJson, IsIndentedAndKeepsLettersOfOtherLanguages) {
    sil::Summary summary = quiet_run();
    summary.vehicle = "gr\u00fcn";
    const std::string text = sil::summary_json(summary);
    EXPECT_EQ(text.rfind("{\n  \"manoeuvre\": \"straight\",\n", 0), 0U) << text;
    EXPECT_NE(text.find("gr\u00fcn"), std::string::npos);
}

TEST(SummaryJson, RoundsNothingToZeroButZero) {
    sil::Summary summary = quiet_run();
    for (const double lead_s : {1.0, -1.0, 1.0e-9}) {
        summary.events.judgement.lead_s = lead_s;
        EXPECT_EQ(ordered_json::parse(sil::summary_json(summary)).at("lead_time_s"), lead_s);
    }
    summary.events.judgement.lead_s = -1.0e-10;
    EXPECT_NE(sil::summary_json(summary).find("\"lead_time_s\": 0.0,"), std::string::npos) << "and not -0.0";
}

TEST(SummaryJson, GivesTheEventsInTheirUnits) {
    const ordered_json json = ordered_json::parse(sil::summary_json(rollover_run()));
    EXPECT_EQ(json.at("warning_time_s"), 1.69);
    EXPECT_EQ(json.at("warning_side"), "left");
    EXPECT_EQ(json.at("warning_ay_g"), -0.72);
    EXPECT_EQ(json.at("one_wheel_lift_time_s"), 1.82);
    EXPECT_EQ(json.at("two_wheel_lift_time_s"), 2.052);
    EXPECT_EQ(json.at("ssf_crossing_time_s"), 2.095);
    EXPECT_EQ(json.at("lead_time_s"), 0.252);
    EXPECT_EQ(json.at("falling_side"), "right");
    EXPECT_EQ(json.at("side_at_lift_off"), "right");
    EXPECT_EQ(json.at("wrong_side_duration_s"), 0.11);
    EXPECT_EQ(json.at("load_transfer_band"), "lift");
    EXPECT_EQ(json.at("warnings"), 2);
    EXPECT_EQ(json.at("advisories"), 3);
    EXPECT_EQ(json.at("warning_duration_s"), 0.45);
    EXPECT_EQ(json.at("advisory_duration_s"), 0.2);
    EXPECT_EQ(json.at("unavailable_duration_s"), 0.3);
    EXPECT_EQ(json.at("max_ay_g"), 0.85);
    EXPECT_EQ(json.at("final_roll_deg"), -90.0);
    EXPECT_EQ(json.at("frames_sent"), 900);
    EXPECT_EQ(json.at("frames_received"), 600);
    EXPECT_EQ(json.at("mirrored"), true);
    EXPECT_EQ(json.at("lock_step"), true);
    EXPECT_EQ(json.at("in_process"), false);
    EXPECT_EQ(json.at("front_axle_lift_time_s"), 1.95);
    EXPECT_EQ(json.at("rear_axle_lift_time_s"), 1.82);
    EXPECT_EQ(json.at("max_load_transfer_ratio"), 0.999);
}

TEST(SummaryJson, GivesEveryIndexItsTimeOrNull) {
    sil::Summary summary = rollover_run();
    summary.in_process = true;
    summary.index_times_s = {{"published", 1.69}, {"energy", std::nullopt}};
    const ordered_json json = ordered_json::parse(sil::summary_json(summary));
    EXPECT_EQ(json.at("in_process"), true);
    EXPECT_EQ(json.at("index_times_s").size(), 2U);
    EXPECT_EQ(json.at("index_times_s").at("published"), 1.69);
    EXPECT_TRUE(json.at("index_times_s").at("energy").is_null());
}

TEST(SummaryJson, TellsSeedAndVersions) {
    const ordered_json json = ordered_json::parse(sil::summary_json(quiet_run()));
    EXPECT_EQ(json.at("seed").get<std::uint64_t>(), 18446744073709551615U);
    EXPECT_EQ(json.at("bias_g").get<double>(), 0.005);
    EXPECT_EQ(json.at("quantisation_g").get<double>(), 0.001);
    EXPECT_EQ(json.at("versions").at("component"), "1.2.3");
    EXPECT_EQ(json.at("versions").at("git_revision"), "abcdef");
    EXPECT_EQ(json.at("versions").at("compiler"), "GNU 12");
}

TEST(SummaryJson, AnUnknownRevisionAndNumbersThatAreNotFiniteAreNull) {
    sil::Summary summary = quiet_run();
    summary.versions.git_revision.clear();
    summary.events.final_roll_angle_rad = std::numeric_limits<double>::quiet_NaN();
    summary.events.largest_lateral_acceleration_mps2 = std::numeric_limits<double>::infinity();
    const ordered_json json = ordered_json::parse(sil::summary_json(summary));
    EXPECT_TRUE(json.at("versions").at("git_revision").is_null());
    EXPECT_TRUE(json.at("final_roll_deg").is_null());
    EXPECT_TRUE(json.at("max_ay_g").is_null());
}

TEST(SummaryJson, NamesMayHoldAnyBytes) {
    sil::Summary summary = quiet_run();
    summary.manoeuvre = "quote \" backslash \\ bad utf-8 \xff";
    EXPECT_TRUE(ordered_json::accept(sil::summary_json(summary)));
}

TEST(BuiltVersions, NameComponentAndCompiler) {
    EXPECT_EQ(sil::built_versions().component, RSI_EXPECTED_VERSION);
    EXPECT_FALSE(sil::built_versions().compiler.empty());
}

TEST(WriteSummary, ReplacesTheFileAndLeavesNothingElse) {
    const ScratchFolder folder;
    const auto path = folder.path() / "summary.json";
    write_text(path, std::string(100'000U, 'x'));
    sil::write_summary(rollover_run(), path);
    EXPECT_EQ(text_of(path), sil::summary_json(rollover_run()));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteFileAtomically, AFailureNamesThePathAndLeavesTheOldFile) {
    const ScratchFolder folder;
    const auto path = folder.path() / "nowhere" / "summary.json";
    try {
        sil::write_file_atomically(path, "text");
        FAIL() << "no error";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("No such file or directory"), std::string::npos);
    }
    // A folder that stands where the file should go: the rename fails, and the temporary file must be gone.
    std::filesystem::create_directory(folder.path() / "taken");
    EXPECT_THROW(sil::write_file_atomically(folder.path() / "taken", "text"), std::runtime_error);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(EventMarks, GiveGnuplotEveryEventOrNaN) {
    const std::string quiet = sil::event_marks(quiet_run().events, 0.81, "It's quiet");
    EXPECT_NE(quiet.find("title_text = 'It''s quiet'\n"), std::string::npos);
    EXPECT_NE(quiet.find("ssf = 0.81\n"), std::string::npos);
    EXPECT_NE(quiet.find("warning_time_s = NaN\n"), std::string::npos);
    EXPECT_NE(quiet.find("two_wheel_lift_roll_deg = NaN\n"), std::string::npos);
    const std::string rollover = sil::event_marks(rollover_run().events, 0.81, "");
    EXPECT_NE(rollover.find("\nwarning_time_s = 1.69\n"), std::string::npos);
    EXPECT_NE(rollover.find("\nwarning_ay_g = -0.72\n"), std::string::npos);
    EXPECT_NE(rollover.find("\none_wheel_lift_time_s = 1.82\n"), std::string::npos);
    EXPECT_NE(rollover.find("\nssf_crossing_time_s = 2.095\n"), std::string::npos);
    EXPECT_NE(rollover.find("\nwarning_roll_deg = -5.15662016\n"), std::string::npos);  // 0.09 rad
}

TEST(EventMarks, HaveNoControlCharacterInTheTitle) {
    const std::string marks = sil::event_marks(quiet_run().events, 0.81, "one\ntwo\x1Fthree!");
    EXPECT_NE(marks.find("title_text = 'one two three!'\n"), std::string::npos) << marks;
}

TEST(EventMarks, DoNotShowTheRoundingOfSums) {
    sil::RunEvents events;
    events.end_time_s = 3.0299999999999773;
    EXPECT_NE(sil::event_marks(events, 0.81, "").find("end_time_s = 3.03\n"), std::string::npos);
}

}  // namespace
}  // namespace summary_test
