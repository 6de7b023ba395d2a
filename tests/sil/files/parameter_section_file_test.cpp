// A calibration file, written as a parameter section, reaches the firmware as it is.
#include "sil/files/parameter_section_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include "rsi/parameters.hpp"
#include "sil/files/calibration_file.hpp"

namespace {

using rsi::application::ParametersRefusal;

std::string calibration_file(const std::string& vehicle) {
    return RSI_SOURCE_DIR "/firmware/calibrations/" + vehicle + ".toml";
}

bool same(const rsi::Parameters& a, const rsi::Parameters& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

class ParameterSectionOf : public testing::TestWithParam<std::string> {
 protected:
    rsi::Parameters calibration_{sil::load_calibration(calibration_file(GetParam()))};
    std::vector<std::uint8_t> section_{sil::parameter_section(calibration_, GetParam())};
};

TEST_P(ParameterSectionOf, IsTakenByTheFirmwareBitForBit) {
    rsi::Parameters taken{};
    const rsi::application::ParameterSectionAnswer answer =
        rsi::application::read_parameter_section(section_.data(), section_.size(), taken);
    EXPECT_EQ(answer.refusal, ParametersRefusal::none) << sil::explain(answer);
    EXPECT_TRUE(same(taken, calibration_));
    EXPECT_EQ(sil::section_name(section_), GetParam());
}

TEST_P(ParameterSectionOf, IsPrintedAsTheCalibrationThatItCameFrom) {
    const std::string path =
        testing::TempDir() + "/printed_" + GetParam() + std::to_string(getpid()) + ".toml";
    {
        std::ofstream file{path};
        file << sil::calibration_toml(calibration_);
    }
    EXPECT_TRUE(same(sil::load_calibration(path), calibration_));
    std::remove(path.c_str());
}

std::vector<std::string> calibrated_vehicles() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(RSI_SOURCE_DIR "/firmware/calibrations")) {
        if (entry.path().extension() == ".toml") {
            names.push_back(entry.path().stem().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Calibrations, ParameterSectionOf, testing::ValuesIn(calibrated_vehicles()),
                         [](const auto& test) { return test.param; });

// Each value by itself, so that two exchanged ones cannot hide.
TEST(AParameterSection, CarriesEachValueInAPlaceOfItsOwn) {
    const rsi::Parameters base = sil::load_calibration(calibration_file("large_suv"));
    const std::vector<std::uint8_t> before = sil::parameter_section(base, "");
    std::size_t at = rsi::application::section::values_at;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        rsi::Parameters changed = base;
        changed.*field.member = 1.5F * base.*field.member + 0.125F;
        const std::vector<std::uint8_t> after = sil::parameter_section(changed, "");
        const auto differs = std::mismatch(before.begin(), before.end(), after.begin());
        const auto place = static_cast<std::size_t>(differs.first - before.begin());
        EXPECT_TRUE(place >= at && place < at + 4U) << field.name << " at " << place;
        at += 4U;
    }
}

TEST(AParameterSection, HasANameOfAtMost48PrintableCharacters) {
    const rsi::Parameters parameters = sil::load_calibration(calibration_file("van"));
    const std::string longest(48U, 'x');
    EXPECT_EQ(sil::section_name(sil::parameter_section(parameters, longest)), longest);
    EXPECT_EQ(sil::section_name(sil::parameter_section(parameters, "")), "");
    for (const std::string& bad :
         {std::string(49U, 'x'), std::string{"two\nlines"}, std::string{"gr\xC3\xBCn"}}) {
        EXPECT_THROW(sil::parameter_section(parameters, bad), sil::InputError) << bad;
    }
}

rsi::Parameters large_suv() {
    return sil::load_calibration(calibration_file("large_suv"));
}

TEST(AParameterSection, TakesEachPrintableCharacterInItsName) {
    EXPECT_EQ(sil::section_name(sil::parameter_section(large_suv(), " ~")), " ~");
    EXPECT_THROW(sil::parameter_section(large_suv(), "\x7F"), sil::InputError);
    EXPECT_THROW(sil::parameter_section(large_suv(), "\x1F"), sil::InputError);
}

TEST(SectionSource, HasEachByteSixteenALine) {
    const std::vector<std::uint8_t> section = sil::parameter_section(large_suv(), "name");
    const std::string text = sil::section_source(section);
    EXPECT_NE(text.find("\"name\""), std::string::npos);
    std::string expected = "rsi_parameter_section[" + std::to_string(section.size()) + "] = {\n";
    for (std::size_t at = 0U; at < section.size(); ++at) {
        char byte[8];
        std::snprintf(byte, sizeof byte, " 0x%02X,", unsigned{section[at]});
        expected += (at % 16U == 0U ? "   " : "") + std::string{byte};
        expected += at % 16U == 15U || at + 1U == section.size() ? "\n" : "";
    }
    EXPECT_NE(text.find(expected + "};\n"), std::string::npos) << text;
}

TEST(SectionSource, HasNoEmptyLineAfterTheLastByte) {
    const std::string text = sil::section_source(std::vector<std::uint8_t>(128U));
    const std::string end = " 0x00,\n};\n";
    EXPECT_EQ(text.substr(text.size() - end.size()), end);
}

TEST(CalibrationToml, KeepsTheSignOfZero) {
    rsi::Parameters changed = large_suv();
    const rsi::ParameterField& field = rsi::parameter_fields[0];
    const auto line_of = [&](float value) {
        changed.*field.member = value;
        const std::string text = sil::calibration_toml(changed);
        return text.substr(0U, text.find('\n'));
    };
    const std::string name = field.name;
    EXPECT_EQ(line_of(-0.0F), name + " = -0.0");
    EXPECT_EQ(line_of(0.0F), name + " = 0.0");
    EXPECT_EQ(line_of(2.0F), name + " = 2");
    EXPECT_EQ(line_of(-2.0F), name + " = -2");
    EXPECT_EQ(line_of(1.0F), name + " = 1");
    EXPECT_EQ(line_of(-1.0F), name + " = -1");
}

TEST(CalibrationHeader, HasEachValue) {
    const rsi::Parameters parameters = large_suv();
    const std::string text = sil::calibration_header(parameters, "Large_suv9");
    EXPECT_NE(text.find("static const rsi_parameters Large_suv9_parameters = {\n"), std::string::npos);
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        const std::string start = "    ." + std::string{field.name} + " = ";
        const std::size_t at = text.find(start);
        ASSERT_NE(at, std::string::npos) << field.name;
        EXPECT_EQ(std::strtof(text.c_str() + at + start.size(), nullptr), parameters.*field.member)
            << field.name;
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        const std::int32_t value = parameters.*field.member;
        EXPECT_NE(text.find("    ." + std::string{field.name} + " = " + std::to_string(value) + ", /* " +
                            field.choices[value] + " */\n"),
                  std::string::npos)
            << field.name;
    }
}

TEST(CalibrationHeader, NeedsANameThatCTakes) {
    for (const char* good : {"a", "z", "A", "Z", "_", "x0", "x9", "aZ_09"}) {
        EXPECT_NO_THROW(sil::calibration_header(large_suv(), good)) << good;
    }
    for (const char* bad : {"", "0", "9a", "a-b", "a`", "a{", "a@", "a[", "a/", "a:", "a b"}) {
        EXPECT_THROW(sil::calibration_header(large_suv(), bad), sil::InputError) << bad;
    }
}

// A new segment of 64 KiB begins within these bytes.
TEST(IntelHex, HasTheUpperAddressBeforeTheRecordsOfEachSegment) {
    EXPECT_EQ(sil::intel_hex({1U, 2U, 3U}, 0x1'FFFEU),
              ":020000040001F9\n:02FFFE000102FE\n:020000040002F8\n:0100000003FC\n:00000001FF\n");
}

TEST(IntelHex, HasSixteenBytesARecord) {
    std::vector<std::uint8_t> bytes(17U);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{0U});
    EXPECT_EQ(sil::intel_hex(bytes, 0xFF01'0000U),
              ":02000004FF01FA\n:10000000000102030405060708090A0B0C0D0E0F78\n:0100100010DF\n:00000001FF\n");
}

TEST(IntelHex, EndsAtTheLastAddress) {
    const std::vector<std::uint8_t> section(rsi::application::section::length);
    const auto last = static_cast<std::uint32_t>(0x1'0000'0000U - section.size());
    EXPECT_NO_THROW(sil::intel_hex(section, last));
    EXPECT_THROW(sil::intel_hex(section, last + 1U), sil::InputError);
}

}  // namespace
