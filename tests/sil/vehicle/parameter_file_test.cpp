// Parameter files: what is wrong is named by file, line and key, with what to do.
#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

std::string good_text() {
    const std::ifstream file{RSI_SOURCE_DIR "/sil/vehicles/large_suv.toml"};
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::size_t line_of(const std::string& text, const std::string& part) {
    const std::size_t position = text.find(part);
    return 1U + static_cast<std::size_t>(
                    std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
}

class ParameterFile : public testing::Test {
 protected:
    static std::string replaced(const std::string& from, const std::string& to) {
        std::string text = good_text();
        const std::size_t position = text.find(from);
        EXPECT_NE(position, std::string::npos);
        return text.replace(position, from.size(), to);
    }

    std::string error_of(const std::string& text) const {
        test_support::write_text(path_, text);
        try {
            sil::load_vehicle(path_);
        } catch (const sil::InputError& error) {
            return error.what();
        }
        return "no error";
    }

    void expect_error(const std::string& text, const std::string& at, const std::string& key,
                      const std::string& advice) const {
        const std::string message = error_of(text);
        EXPECT_NE(message.find(path_.string() + ":" + std::to_string(line_of(text, at)) + ":"),
                  std::string::npos)
            << message;
        EXPECT_NE(message.find("\"" + key + "\""), std::string::npos) << message;
        EXPECT_NE(message.find(advice), std::string::npos) << message;
    }

    test_support::ScratchFolder folder_;
    std::filesystem::path path_{folder_.path() / "vehicle.toml"};
};

TEST_F(ParameterFile, BothVehiclesLoad) {
    EXPECT_EQ(sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/large_suv.toml").name, "large SUV");
    const sil::VehicleParameters ordinary =
        sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/ordinary_suv.toml");
    EXPECT_NEAR(sil::static_stability_factor(ordinary), 1.1, 0.01);
}

TEST_F(ParameterFile, TheLargeSuvHasTheStaticStabilityFactorOfThePaper) {
    EXPECT_NEAR(
        sil::static_stability_factor(sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/large_suv.toml")), 0.81,
        0.001);
}

TEST_F(ParameterFile, AnUnknownKeyIsNamedWithThoseThatExist) {
    const std::string text = replaced("[mass]\n", "[mass]\nspring_kg = 3.0\n");
    expect_error(text, "spring_kg = 3.0", "mass.spring_kg", "sprung_kg");
}

TEST_F(ParameterFile, AKeyThatCannotBePrintedCutsNoMessageShort) {
    const std::string text = replaced("[mass]\n", "[mass]\n\"a\\u0000b\" = 3.0\n");
    expect_error(text, "u0000", "mass.a?b", "sprung_kg");
}

TEST_F(ParameterFile, AnUnknownTableIsNamed) {
    const std::string text = good_text() + "\n[masses]\nx = 1.0\n";
    expect_error(text, "[masses]", "masses", "not known");
}

TEST_F(ParameterFile, AMissingKeyIsNamedWithItsTable) {
    expect_error(replaced("sprung_kg = 2060.0\n", ""), "[mass]", "mass.sprung_kg", "add a number");
}

TEST_F(ParameterFile, AMissingTableIsNamed) {
    EXPECT_NE(error_of(replaced("[steering]\nratio = 20.0\nlag_s = 0.0\ncompliance_radpn = 0.0\n", ""))
                  .find("\"steering\""),
              std::string::npos);
}

TEST_F(ParameterFile, LagAndComplianceOfTheSteeringMayBeLeftOut) {
    test_support::write_text(path_, replaced("lag_s = 0.0\ncompliance_radpn = 0.0\n", ""));
    EXPECT_EQ(sil::load_vehicle(path_).steering.lag_s, 0.0);
    EXPECT_EQ(sil::load_vehicle(path_).steering.compliance_radpn, 0.0);
    test_support::write_text(
        path_, replaced("lag_s = 0.0\ncompliance_radpn = 0.0", "lag_s = 0.05\ncompliance_radpn = 1e-6"));
    EXPECT_EQ(sil::load_vehicle(path_).steering.lag_s, 0.05);
    EXPECT_EQ(sil::load_vehicle(path_).steering.compliance_radpn, 1e-6);
    expect_error(replaced("\nlag_s = 0.0", "\nlag_s = 1.5"), "lag_s", "steering.lag_s", "from 0 to 1");
    expect_error(replaced("compliance_radpn = 0.0", "compliance_radpn = 1.0"), "compliance_radpn",
                 "steering.compliance_radpn", "from 0 to 0.0001");
}

TEST_F(ParameterFile, ProgressionFrictionAndFrameMayBeLeftOut) {
    std::string text = good_text();
    for (const char* const line :
         {"progression_pm2 = 0.0\n", "dry_friction = 0.0\n", "progression_pm2 = 0.0\n",
          "dry_friction = 0.0\n", "frame_torsion_nmprad = 0.0\n", "frame_damping_nmsprad = 0.0\n",
          "frame_rear_share = 0.0\n"}) {
        const std::size_t position = text.find(line);
        ASSERT_NE(position, std::string::npos) << line;
        text.erase(position, std::string{line}.size());
    }
    test_support::write_text(path_, text);
    const sil::RearSuspensionParameters rear = sil::load_vehicle(path_).rear_suspension;
    EXPECT_EQ(rear.spring_damper.progression_pm2, 0.0);
    EXPECT_EQ(rear.spring_damper.dry_friction, 0.0);
    EXPECT_EQ(rear.frame_torsion_nmprad, 0.0);
    expect_error(replaced("frame_rear_share = 0.0", "frame_rear_share = 0.8"), "frame_rear_share",
                 "rear_suspension.frame_rear_share", "from 0 to 0.7");
}

TEST_F(ParameterFile, ATextInPlaceOfANumberIsRefused) {
    expect_error(replaced("ratio = 20.0", "ratio = \"20\""), "ratio = \"20\"", "steering.ratio",
                 "plain number");
}

TEST_F(ParameterFile, NotANumberIsRefused) {
    expect_error(replaced("ratio = 20.0", "ratio = nan"), "ratio = nan", "steering.ratio", "from 1 to 60");
}

TEST_F(ParameterFile, InfinityIsRefused) {
    expect_error(replaced("ratio = 20.0", "ratio = inf"), "ratio = inf", "steering.ratio",
                 "not a finite number");
}

TEST_F(ParameterFile, AValueOutOfRangeIsRefusedWithTheRange) {
    expect_error(replaced("ratio = 20.0", "ratio = -20.0"), "ratio = -20.0", "steering.ratio",
                 "from 1 to 60");
}

TEST_F(ParameterFile, BrokenTomlIsRefusedWithItsLine) {
    const std::string text = replaced("ratio = 20.0", "ratio = = 20.0");
    const std::string message = error_of(text);
    EXPECT_NE(message.find(path_.string() + ":" + std::to_string(line_of(text, "ratio = ="))),
              std::string::npos)
        << message;
}

TEST_F(ParameterFile, AFileThatIsNotThereIsNamed) {
    try {
        sil::load_vehicle("/nowhere/vehicle.toml");
        FAIL() << "no error";
    } catch (const sil::InputError& error) {
        EXPECT_NE(std::string{error.what()}.find("/nowhere/vehicle.toml"), std::string::npos);
    }
}

}  // namespace
