// Bad drives: every fault is reported with file, line and column, and with what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "sil/studies/drives/drive_csv.hpp"
#include "tests/sil/drives/drive_text.hpp"

namespace {

using testing_drives::good_lines;
using testing_drives::text_of_lines;
using Lines = std::vector<std::string>;

std::string error_of(const std::string& text) {
    try {
        static_cast<void>(sil::parse_drive_csv(text, "folder/drive.csv"));
    } catch (const sil::InputError& error) {
        return error.what();
    }
    return "no error";
}

void replace(std::string& text, const std::string& what, const std::string& by) {
    const std::size_t position = text.find(what);
    ASSERT_NE(position, std::string::npos);
    text.replace(position, what.size(), by);
}

struct Fault {
    std::string name;
    std::function<void(Lines&)> spoil;  // a good drive of 20 rows
    std::string place;                  // LINE:COLUMN
    std::vector<std::string> said;
};

class BadDrive : public testing::TestWithParam<Fault> {};

TEST_P(BadDrive, IsToldWithLineAndColumnAndRemedy) {
    Lines lines = good_lines();
    GetParam().spoil(lines);
    const std::string error = error_of(text_of_lines(lines));
    EXPECT_EQ(error.rfind("folder/drive.csv:" + GetParam().place + ": ", 0U), 0U) << error;
    EXPECT_THAT(error, testing::HasSubstr("; ")) << "a remedy is missing";
    for (const std::string& part : GetParam().said) {
        EXPECT_THAT(error, testing::HasSubstr(part));
    }
}

const std::vector<Fault> faults{
    {"MissingTime",
     [](Lines& l) { replace(l[0], "time_s", "clock"); },
     "1:1",
     {"time", "time_s or time_ms", "clock"}},
    {"MissingLateralAcceleration",
     [](Lines& l) { replace(l[0], "lateral_acceleration_mps2", "ay"); },
     "1:1",
     {"lateral_acceleration_mps2 or lateral_acceleration_g", "ay"}},
    {"MissingRollRate", [](Lines& l) { replace(l[0], "roll_rate_degps", "p"); }, "1:1", {"roll_rate_degps"}},
    {"MissingRollAngleAndYawRate",
     [](Lines& l) {
         replace(l[0], "roll_angle_deg", "phi");
         replace(l[0], "yaw_rate_degps", "r");
     },
     "1:1",
     {"roll_angle", "speed", "yaw_rate"}},
    {"UnknownUnit",
     [](Lines& l) { replace(l[0], "roll_rate_degps", "roll_rate_rpm"); },
     "1:61",
     {"roll_rate_rpm", "roll_rate_degps or roll_rate_radps"}},
    {"NoUnit",
     [](Lines& l) { replace(l[0], "speed_kmh", "speed"); },
     "1:92",
     {"speed_mps, speed_kmh or speed_mph"}},
    {"UnitInBrackets", [](Lines& l) { replace(l[0], "speed_kmh", "Speed [km/h]"); }, "1:92", {"speed_kmh"}},
    {"SameQuantityTwice",
     [](Lines& l) { replace(l[0], "speed_kmh", "roll_rate_radps"); },
     "1:92",
     {"roll_rate_degps and roll_rate_radps"}},
    {"SameColumnTwice",
     [](Lines& l) { replace(l[0], "speed_kmh", "roll_angle_deg"); },
     "1:92",
     {"roll_angle_deg"}},
    {"OneWheelLoadOnly",
     [](Lines& l) { replace(l[0], "speed_kmh", "wheel_load_front_left_n"); },
     "1:1",
     {"only 1 of the four wheel loads"}},
    {"NotANumber",
     [](Lines& l) { l[5] = "0.04,nan,9.81,0.25,1.5,36,0"; },
     "6:6",
     {"lateral_acceleration_mps2", "nan"}},
    {"Infinity",
     [](Lines& l) { l[5] = "0.04,0.5,-inf,0.25,1.5,36,0"; },
     "6:10",
     {"vertical_acceleration_mps2", "-inf", "leave the field empty"}},
    {"AWord", [](Lines& l) { l[7] = "0.06,0.5,9.81, abc,1.5,36,0"; }, "8:16", {"roll_rate_degps", "abc"}},
    {"HalfANumber", [](Lines& l) { l[7] = "0.06,0.5,9.81,0.2x,1.5,36,0"; }, "8:15", {"0.2x"}},
    {"BeyondAnyDouble", [](Lines& l) { l[7] = "0.06,0.5,9.81,1e999,1.5,36,0"; }, "8:15", {"1e999"}},
    {"APlaceholderForNothing",
     [](Lines& l) { l[7] = "0.06,0.5,9.81,0.2,1.5,1e20,0"; },
     "8:23",
     {"speed_kmh", "1e20"}},
    {"RequiredValueMissing",
     [](Lines& l) { l[9] = "0.08,,9.81,0.25,1.5,36,0"; },
     "10:6",
     {"lateral_acceleration_mps2 has no value"}},
    {"TimeRunsBack", [](Lines& l) { std::swap(l[10], l[11]); }, "12:1", {"runs back from 0.1 s to 0.09 s"}},
    {"TimeStandsStill", [](Lines& l) { l[11] = l[10]; }, "12:1", {"stands still at 0.09 s"}},
    {"AnHourOfSilence",
     [](Lines& l) { l[20] = "9999,0.5,9.81,0.25,1.5,36,0"; },
     "21:1",
     {"gap", "cut the recording"}},
    {"LongerThanMemory",
     [](Lines& l) {
         for (std::size_t row = 6U; row <= 20U; ++row) {
             l[row] = std::to_string(3000U * (row - 5U)) + ",0.5,9.81,0.25,1.5,36,0";
         }
     },
     "21:1",
     {"longer than 12 h", "cut the recording"}},
    {"TooFewFields", [](Lines& l) { l[4] = "0.03,0.5,9.81,0.25"; }, "5:19", {"4 fields", "7 columns"}},
    {"TooManyFields", [](Lines& l) { l[4] += ",1"; }, "5:29", {"8 fields", "7 columns"}},
    {"DecimalCommas",
     [](Lines& l) { l[4] = "0,03,0,5,9,81,0,25,1,5,36,0"; },
     "5:17",
     {"a point, not a comma"}},
    {"Semicolons",
     [](Lines& l) {
         for (char& c : l[0]) {
             c = c == ',' ? ';' : c;
         }
     },
     "1:7",
     {"semicolons"}},
    {"Tabs",
     [](Lines& l) {
         for (char& c : l[0]) {
             c = c == ',' ? '\t' : c;
         }
     },
     "1:7",
     {"tabs"}},
    {"NoRows", [](Lines& l) { l.resize(1U); }, "1:1", {"no rows"}},
    {"OneRow", [](Lines& l) { l.resize(2U); }, "2:1", {"only one row"}},
    {"OnlyRemarks", [](Lines& l) { l = {"# recorded by hand"}; }, "1:1", {"no header"}},
    {"MillisecondsCalledSeconds",
     [](Lines& l) {
         for (std::size_t i = 1U; i < l.size(); ++i) {
             l[i] = std::to_string(10 * i) + l[i].substr(4U);
         }
     },
     "1:1",
     {"0.1 Hz", "50 Hz to 1 kHz", "time_ms"}},
    {"SecondsCalledMilliseconds", [](Lines& l) { replace(l[0], "time_s", "time_ms"); }, "1:1", {"time_s"}},
    {"GCalledMetres",
     [](Lines& l) {
         for (std::size_t i = 1U; i < l.size(); ++i) {
             replace(l[i], "9.81", "1.00");
         }
     },
     "1:34",
     {"vertical_acceleration_g", "about +9.81"}},
    {"RollAngleColumnWithoutValues",
     [](Lines& l) {
         replace(l[0], "speed_kmh", "x");
         for (std::size_t i = 1U; i < l.size(); ++i) {
             replace(l[i], "1.5", "");
         }
     },
     "1:1",
     {"no row has a value for roll_angle"}},
    {"LiftOffIsNoNumber",
     [](Lines& l) { l.insert(l.begin(), "# two_wheel_lift_time_s: soon"); },
     "1:26",
     {"soon", "`none`"}},
    {"LiftOffOutsideTheDrive",
     [](Lines& l) { l.insert(l.begin(), "# one_wheel_lift_time_ms: 900"); },
     "1:27",
     {"0.9 s", "0.19 s"}},
};

INSTANTIATE_TEST_SUITE_P(Faults, BadDrive, testing::ValuesIn(faults),
                         [](const auto& fault) { return fault.param.name; });

TEST(TruncatedDrive, IsRefusedWhereverItWasCut) {
    const std::string whole = text_of_lines(good_lines());
    ASSERT_EQ(error_of(whole), "no error");
    // Within the last row, down to a number that lost its last digit and to the lost line end alone.
    const std::size_t last_row = whole.rfind('\n', whole.size() - 2U) + 1U;
    for (std::size_t size = last_row + 1U; size < whole.size(); ++size) {
        const std::string place = "21:" + std::to_string(size - last_row + 1U) + ":";
        EXPECT_EQ(error_of(whole.substr(0U, size)).rfind("folder/drive.csv:" + place, 0U), 0U) << size;
    }
    EXPECT_THAT(error_of(whole.substr(0U, 30U)), testing::HasSubstr("cut off"));
}

TEST(EmptyDrive, IsCalledEmpty) {
    for (const char* text : {"", "\n\n", "\xEF\xBB\xBF", "\r\n"}) {
        EXPECT_THAT(error_of(text), testing::StartsWith("folder/drive.csv:1:1: the file is empty; ")) << text;
    }
}

TEST(UnreadableDrive, IsNamedWithTheReason) {
    for (const char* path : {"/no/such/drive.csv", "/tmp"}) {
        try {
            static_cast<void>(sil::read_drive_csv(path));
            ADD_FAILURE() << path;
        } catch (const sil::InputError& error) {
            EXPECT_THAT(error.what(), testing::StartsWith(std::string{path} + ": cannot be read: "));
        }
    }
}

TEST(BinaryFile, IsRefusedInPrintableCharacters) {
    std::string text;
    for (int index = 0; index < 2000; ++index) {
        text += static_cast<char>((index * 7919 + index / 13) % 256);
    }
    const std::string error = error_of(text);
    EXPECT_THAT(error, testing::StartsWith("folder/drive.csv:"));
    for (const char character : error) {
        EXPECT_TRUE(character >= ' ' && character <= '~') << static_cast<int>(character);
    }
}

}  // namespace
