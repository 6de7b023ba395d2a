// A calibration file, written as a parameter section, reaches the firmware as it is.
#include "sil/files/parameter_section_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "rsi/parameters.hpp"
#include "sil/files/calibration_file.hpp"

namespace {

using application::ParametersRefusal;

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
    const application::ParameterSectionAnswer answer =
        application::read_parameter_section(section_.data(), section_.size(), taken);
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
    std::size_t at = application::section::values_at;
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

TEST(IntelHex, EndsAtTheLastAddress) {
    const std::vector<std::uint8_t> section(application::section::length);
    const auto last = static_cast<std::uint32_t>(0x1'0000'0000U - section.size());
    EXPECT_NO_THROW(sil::intel_hex(section, last));
    EXPECT_THROW(sil::intel_hex(section, last + 1U), sil::InputError);
}

}  // namespace
