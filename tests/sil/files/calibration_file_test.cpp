// Calibration files: the committed ones are good, and every mistake is answered with file, line and key.
#include "sil/files/calibration_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "rsi/parameters.hpp"
#include "sil/files/parameter_field.hpp"
#include "tests/support/scratch_folder.hpp"

namespace calibration_file_test {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path calibrations =
    std::filesystem::path{RSI_SOURCE_DIR} / "firmware" / "calibrations";

class CalibrationFile : public ::testing::Test {
 protected:
    // The good file with the line of `key` replaced; an empty `line` leaves it out. Remembers its number.
    void replace(const std::string& key, const std::string& line) {
        text_ = test_support::text_of(calibrations / "large_suv.toml");
        std::size_t begin = text_.find("\n" + key + " ");
        ASSERT_NE(begin, std::string::npos) << key;
        ++begin;
        line_number_ =
            1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
        const std::size_t end = text_.find('\n', begin);
        text_.replace(begin, end - begin, line);
    }

    // Message of loading; empty when it succeeds.
    std::string message() {
        test_support::write_text(path_, text_);
        return message_of(path_.string());
    }

    static std::string message_of(const std::string& path) {
        try {
            sil::load_calibration(path);
        } catch (const sil::InputError& error) {
            return error.what();
        }
        return "";
    }

    void expect_refused_at_its_line(const std::string& key, const std::string& line,
                                    const std::string& reason) {
        replace(key, line);
        const std::string said = message();
        EXPECT_THAT(said, HasSubstr(path_.string() + ":" + std::to_string(line_number_) + ":")) << line;
        EXPECT_THAT(said, HasSubstr("\"" + key + "\"")) << line;
        EXPECT_THAT(said, HasSubstr(reason)) << line;
    }

    test_support::ScratchFolder folder_;
    std::filesystem::path path_{folder_.path() / "calibration.toml"};
    std::string text_;
    std::ptrdiff_t line_number_{0};
};

TEST_F(CalibrationFile, EveryCommittedOneIsAcceptedByTheComponent) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator{calibrations}) {
        if (entry.path().extension() != ".toml") {
            continue;
        }
        SCOPED_TRACE(entry.path().string());
        const rsi::Validation answer = rsi::validate(sil::load_calibration(entry.path().string()));
        EXPECT_EQ(answer.accepted, 1) << answer.field << " " << answer.reason;
        ++count;
    }
    EXPECT_GE(count, 1);
}

TEST_F(CalibrationFile, EveryNumberReachesItsOwnField) {
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        SCOPED_TRACE(field.name);
        const rsi::Parameters good = sil::load_calibration((calibrations / "large_suv.toml").string());
        // A little less than before, and 1 in place of 0: within what the component accepts.
        const float changed = good.*field.member > 0.0F ? good.*field.member * 0.9999F : 1.0F;
        replace(field.name, std::string{field.name} + " = " + std::to_string(changed));
        test_support::write_text(path_, text_);
        const rsi::Parameters loaded = sil::load_calibration(path_.string());
        EXPECT_NEAR(static_cast<double>(loaded.*field.member), static_cast<double>(changed),
                    1.0e-6 * std::abs(static_cast<double>(changed)) + 1.0e-6);
        for (const rsi::ParameterField& other : rsi::parameter_fields) {
            if (other.member != field.member) {
                EXPECT_EQ(loaded.*other.member, good.*other.member) << other.name;
            }
        }
    }
}

TEST(ParameterField, IsFoundByItsMember) {
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        EXPECT_STREQ(sil::parameter_field(field.member).name, field.name);
    }
}

TEST_F(CalibrationFile, TheSelectionsAreReadByName) {
    replace("warning_indicator", "warning_indicator = \"bank_free\"");
    ASSERT_EQ(message(), "");
    EXPECT_EQ(sil::load_calibration(path_.string()).warning_indicator, RSI_INDICATOR_BANK_FREE);
}

TEST_F(CalibrationFile, AMissingFileIsNamedAndAnExampleGiven) {
    const std::string said = message_of("/nowhere/at_all.toml");
    EXPECT_THAT(said, HasSubstr("/nowhere/at_all.toml"));
    EXPECT_THAT(said, HasSubstr("large_suv.toml"));
}

TEST_F(CalibrationFile, AFolderInPlaceOfAFileIsNamed) {
    EXPECT_THAT(message_of(folder_.path().string()), HasSubstr(folder_.path().string()));
}

TEST_F(CalibrationFile, AnEmptyFileLacksAKey) {
    text_ = "";
    EXPECT_THAT(message(), HasSubstr("is missing"));
}

TEST_F(CalibrationFile, InvalidTomlIsRefusedWithItsLine) {
    replace("track_width_m", "track_width_m = = 1.6");
    const std::string said = message();
    EXPECT_THAT(said, HasSubstr(path_.string() + ":" + std::to_string(line_number_) + ":"));
    EXPECT_THAT(said, HasSubstr("not valid TOML"));
}

TEST_F(CalibrationFile, AKeyThatStandsTwiceIsRefusedWithItsLine) {
    replace("track_width_m", "track_width_m = 1.6\ntrack_width_m = 1.7");
    const std::string said = message();
    EXPECT_THAT(said, HasSubstr(path_.string() + ":" + std::to_string(line_number_ + 1) + ":"));
    EXPECT_THAT(said, HasSubstr("track_width_m"));
}

TEST_F(CalibrationFile, AnUnknownKeyIsRefusedWithItsLine) {
    replace("track_width_m", "track_width_m = 1.6\ntrack_widht_m = 1.7");
    const std::string said = message();
    EXPECT_THAT(said, HasSubstr(path_.string() + ":" + std::to_string(line_number_ + 1) + ":"));
    EXPECT_THAT(said, HasSubstr("\"track_widht_m\" is not known here"));
}

TEST_F(CalibrationFile, AKeyThatCannotBePrintedCutsNoMessageShort) {
    replace("track_width_m", "track_width_m = 1.6\n\"a\\u0000b\" = 1.7");
    EXPECT_THAT(message(), HasSubstr("\"a?b\" is not known here; remove it"));
}

TEST_F(CalibrationFile, AnUnknownTableIsRefusedWithItsLine) {
    replace("recovery_s", "recovery_s = 0.1\n[vehicle]\nmass = 3");
    const std::string said = message();
    EXPECT_THAT(said, HasSubstr(path_.string() + ":" + std::to_string(line_number_ + 1) + ":"));
    EXPECT_THAT(said, HasSubstr("\"vehicle\""));
}

TEST_F(CalibrationFile, EachMissingKeyIsNamed) {
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        replace(field.name, "");
        const std::string said = message();
        EXPECT_THAT(said, HasSubstr(path_.string()));
        EXPECT_THAT(said, HasSubstr(":1: \"" + std::string{field.name} + "\" is missing; add "));
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        replace(field.name, "");
        EXPECT_THAT(message(), HasSubstr(":1: \"" + std::string{field.name} + "\" is missing; add "));
    }
}

TEST_F(CalibrationFile, AValueThatIsNoNumberIsRefused) {
    for (const char* value : {"\"1.6\"", "true", "[1.6]", "{ value = 1.6 }", "2020-01-01"}) {
        expect_refused_at_its_line("track_width_m", std::string{"track_width_m = "} + value,
                                   "must be a number");
    }
}

TEST_F(CalibrationFile, AnIntegerIsANumber) {
    replace("imu_y_m", "imu_y_m = 1");
    ASSERT_EQ(message(), "");
    EXPECT_EQ(sil::load_calibration(path_.string()).imu_y_m, 1.0F);
}

TEST_F(CalibrationFile, NumbersThatAreNotFiniteAreRefused) {
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        for (const char* value : {"nan", "-nan", "inf", "-inf", "1e300"}) {
            expect_refused_at_its_line(field.name, std::string{field.name} + " = " + value,
                                       "is not a finite number");
        }
    }
}

TEST_F(CalibrationFile, NumbersOutOfRangeAreRefusedWithTheRange) {
    expect_refused_at_its_line("track_width_m", "track_width_m = 0.5", "is below its range (range 0.8 to 3)");
    expect_refused_at_its_line("track_width_m", "track_width_m = 3.5", "is above its range (range 0.8 to 3)");
    expect_refused_at_its_line("forgetting_factor", "forgetting_factor = 1.1", "is above its range");
}

TEST_F(CalibrationFile, NumbersThatContradictEachOtherAreRefused) {
    expect_refused_at_its_line("advisory_off", "advisory_off = 0.95", "must not exceed advisory_on");
    expect_refused_at_its_line("fixed_roll_centre_height_m", "fixed_roll_centre_height_m = 1.5",
                               "must lie below sprung_cg_height_m");
}

TEST_F(CalibrationFile, AChoiceThatDoesNotExistIsRefusedWithThoseThatDo) {
    for (const char* value : {"\"best\"", "1", "\"\"", "[\"published\"]"}) {
        expect_refused_at_its_line("warning_indicator", std::string{"warning_indicator = "} + value,
                                   R"(must be one of "published", "bank_free")");
    }
    expect_refused_at_its_line("estimator", "estimator = \"kalman\"", "must be one of \"published\"");
}

TEST_F(CalibrationFile, AChangeStandsInPlaceOfWhatTheFileSays) {
    const std::string path = (calibrations / "large_suv.toml").string();
    const rsi::Parameters as_it_is = sil::load_calibration(path);
    const rsi::Parameters changed =
        sil::load_calibration(path, {"sprung_cg_height_m=1.1", "warning_indicator=bank_free",
                                     "estimator = \"published\"", "imu_y_m= -1"});
    EXPECT_EQ(changed.sprung_cg_height_m, 1.1F);
    EXPECT_EQ(changed.warning_indicator, RSI_INDICATOR_BANK_FREE);
    EXPECT_EQ(changed.estimator, RSI_ESTIMATOR_PUBLISHED);
    EXPECT_EQ(changed.imu_y_m, -1.0F);
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        const std::string name = field.name;
        if (name != "sprung_cg_height_m" && name != "imu_y_m") {
            EXPECT_EQ(changed.*field.member, as_it_is.*field.member) << name;
        }
    }
}

TEST_F(CalibrationFile, AChangeThatCannotBeIsRefusedByItsOwnText) {
    const std::string path = (calibrations / "large_suv.toml").string();
    const auto said = [&path](const std::string& change) -> std::string {
        try {
            sil::load_calibration(path, {change});
        } catch (const sil::InputError& error) {
            return error.what();
        }
        return "";
    };
    for (const char* change : {"", "=", "1.1", "=1.1", "no_such_key=1", "sprung_cg_height_m"}) {
        EXPECT_THAT(said(change), HasSubstr("must be KEY=VALUE with a key of " + path)) << change;
    }
    EXPECT_THAT(said("imu_y_m=1\nimu_x_m=2"), HasSubstr("is not one value"));
    EXPECT_THAT(said("imu_y_m=high"), HasSubstr("imu_y_m=high: \"imu_y_m\" must be a number"));
    EXPECT_THAT(said("imu_y_m="), HasSubstr("imu_y_m=: \"imu_y_m\" must be a number"));
    EXPECT_THAT(said("track_width_m=0.5"),
                HasSubstr("track_width_m=0.5: \"track_width_m\" is below its range"));
    EXPECT_THAT(said("estimator=best"), HasSubstr("estimator=best: \"estimator\" must be one of"));
}

}  // namespace
}  // namespace calibration_file_test
